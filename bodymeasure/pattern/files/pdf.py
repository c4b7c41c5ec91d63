"""Patterns as PDF files: in tiles for a printer at home, or on one sheet for a plotter."""

import io
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.pattern.files.layout import (
    CORNER,
    SQUARE,
    TITLE,
    TITLE_WIDTH,
    Nest,
    Sheet,
    sheet_of,
)
from bodymeasure.pattern.files.svg import BESIDE, SIZE, fold_lines, grain_lines
from bodymeasure.pattern.pieces.graded import GradedPattern
from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.pattern.planar import shapely
from bodymeasure.wording import hint

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas

# Width and height of papers in millimeters.
PAPER_SIZES: dict[str, tuple[float, float]] = {
    "a4": (210.0, 297.0),
    "letter": (215.9, 279.4),
    "a0": (841.0, 1189.0),
}
PAPERS = tuple(PAPER_SIZES)
# In millimeters: what printers leave white, and what neighboring tiles have in common.
MARGIN, OVERLAP = 10.0, 10.0
POINTS = 72.0 / 25.4
# In millimeters: the distance of the places that are tried for the square.
STEP = 10.0
# In millimeters: the marks at the corners of a tile, the height of its words, a hole's radius.
MARK, WORDS, HOLE = 5.0, 3.0, 1.5
# Red, green and blue of sew lines and of what belongs to the tile.
SEW, TILE = (0.12, 0.31, 0.62), (0.45, 0.45, 0.45)
DASHES = ((), (10, 3), (6, 2), (10, 2, 2, 2), (3, 2), (12, 2, 2, 2, 2, 2), (1.5, 1.5))
FONT = "Helvetica"


class Tile(NamedTuple):
    """What one page shows of a sheet.

    Parameters
    ----------
    row, column : int
        From above and from the left, beginning with 1.
    left, top, width, height : float
        The part of the sheet, in millimeters.
    """

    row: int
    column: int
    left: float
    top: float
    width: float
    height: float


def pattern_pdf(
    pattern: Pattern | GradedPattern, *, allowance: float = 10.0, paper: str = "a4"
) -> bytes:
    """Return a PDF file of a pattern in true size, in tiles to be glued together.

    Parameters
    ----------
    pattern : Pattern or GradedPattern
    allowance : float
        Of seams, in millimeters, where their panels do not say otherwise.
    paper : {"a4", "letter", "a0"}

    Returns
    -------
    bytes
        A page for each tile that carries something. Neighbors have a strip of 10 mm in common:
        cut off the right and the lower margin at the marks, and glue the next tile on the strip.

    Raises
    ------
    InputError
        If there is no such paper.
    MissingExtraError
        If reportlab is not installed.
    """
    if paper not in PAPERS:
        raise InputError(f"no paper is named {paper!r}; {hint(str(paper), PAPERS)}")
    try:
        from reportlab.pdfgen.canvas import Canvas
    except ImportError:
        raise MissingExtraError("the PDF file", "reportlab", "pattern") from None
    width, height = PAPER_SIZES[paper]
    # One roll of paper is as wide as the pieces side by side need; tiles are glued to any width.
    most = width - 2.0 * MARGIN if paper == "a0" else np.inf
    sheet, tiles = _tiled(pattern, allowance, most, (width, height))
    stream = io.BytesIO()
    # Without the time, so that the same pattern is the same file.
    canvas = Canvas(stream, pagesize=(width * POINTS, height * POINTS), invariant=1)
    canvas.setTitle(": ".join(sheet.title[:2]))
    canvas.setCreator("bodymeasure")
    for number, tile in enumerate(tiles, start=1):
        _page(canvas, sheet, tile, height)
        _frame(canvas, tile, (width, height), f"page {number} of {len(tiles)}")
        canvas.showPage()
    canvas.save()
    return stream.getvalue()


def _tiled(
    pattern: Pattern | GradedPattern, allowance: float, most: float, paper: tuple[float, float]
) -> tuple[Sheet, list[Tile]]:
    """Return a sheet and its tiles; the square lies where a tile has room for it, or above."""
    sheet = sheet_of(pattern, allowance, most, 0.0)
    tiles = tiles_of(sheet, paper, square=False)
    around = shapely.buffer(_drawn(sheet), CORNER)
    for tile in tiles:
        right, below = tile.left + tile.width, tile.top + tile.height
        x, y = np.meshgrid(
            np.arange(tile.left + CORNER, right - TITLE_WIDTH - CORNER, STEP),
            np.arange(tile.top + CORNER, below - SQUARE - CORNER, STEP),
        )
        boxes = shapely.box(x, y, x + TITLE_WIDTH, y + SQUARE)
        free = np.argwhere(~shapely.intersects(around, boxes))
        if len(free):
            corner = np.array([x[*free[0]], y[*free[0]]])
            return replace(sheet, corner=corner), tiles
    sheet = sheet_of(pattern, allowance, most)
    return sheet, tiles_of(sheet, paper)


def _drawn(sheet: Sheet) -> Any:
    """Return all pieces of a sheet as one area."""
    cuts = [nest.on_sheet(piece.cut) for nest in sheet.nests for piece in nest.pieces]
    return shapely.union_all([shapely.polygons(cut) for cut in cuts])


def tiles_of(sheet: Sheet, paper: tuple[float, float], *, square: bool = True) -> list[Tile]:
    """Return the tiles of a sheet that carry a piece, or the square, row by row."""
    width, height = (side - 2.0 * MARGIN for side in paper)
    drawn = _drawn(sheet)
    if square:
        drawn = shapely.union_all([drawn, shapely.polygons(sheet.square)])
    _, _, right, below = shapely.bounds(drawn).tolist()
    # The first tile has the whole width; each further one adds what does not overlap.
    columns = 1 + int(np.ceil(max(right - width, 0.0) / (width - OVERLAP)))
    rows = 1 + int(np.ceil(max(below - height, 0.0) / (height - OVERLAP)))
    found = []
    for row in range(rows):
        for column in range(columns):
            left, top = column * (width - OVERLAP), row * (height - OVERLAP)
            # What lies on the strip in common only is on the neighbor, too.
            strip = np.array([column > 0, row > 0]) * OVERLAP
            box = shapely.box(left + strip[0], top + strip[1], left + width, top + height)
            if shapely.intersects(drawn, box):
                found.append(Tile(row + 1, column + 1, left, top, width, height))
    return found


def _page(canvas: "Canvas", sheet: Sheet, tile: Tile, height: float) -> None:
    """Draw the part of a sheet that a tile shows."""
    canvas.saveState()
    canvas.scale(POINTS, POINTS)
    clip = canvas.beginPath()
    clip.rect(MARGIN, MARGIN, tile.width, tile.height)
    canvas.clipPath(clip, stroke=0, fill=0)
    # From here on, places are those of the sheet with its second axis turned up.
    canvas.translate(MARGIN - tile.left, height - MARGIN + tile.top)
    window = shapely.box(tile.left, tile.top, tile.left + tile.width, tile.top + tile.height)
    _square(canvas, sheet)
    for nest in sheet.nests:
        if any(
            shapely.intersects(shapely.polygons(nest.on_sheet(piece.cut)), window)
            for piece in nest.pieces
        ):
            _nest(canvas, nest)
    canvas.restoreState()


def _nest(canvas: "Canvas", nest: Nest) -> None:
    for number, piece in enumerate(nest.pieces):
        _lines(canvas, nest, [piece.cut], 0.5, dashes=DASHES[number % len(DASHES)], closed=True)
        for edge in piece.edges:
            dashes = (12, 3, 2, 3) if edge.is_fold else ()
            _lines(canvas, nest, list(edge.parts), 0.3, SEW, dashes)
        for dart in piece.darts:
            _lines(canvas, nest, list(dart.legs), 0.3, SEW, (4, 2))
            x, y = _up(nest.on_sheet(dart.hole))
            canvas.setDash()
            canvas.circle(x, y, HOLE, stroke=1, fill=0)
        _lines(canvas, nest, [notch.line for notch in piece.notches], 0.5)
    for place, piece in zip(
        _up(nest.on_sheet(nest.size_places) + BESIDE), nest.pieces, strict=True
    ):
        if piece.size:
            _words(canvas, place, piece.size, SIZE)
    marks = nest.marks
    _lines(canvas, nest, [*grain_lines(marks), *fold_lines(marks)], 0.25)
    places = _up(nest.on_sheet(marks.label.places))
    for place, line in zip(places, marks.label.lines, strict=True):
        _words(canvas, place, line, marks.label.height, centered=True)


def _lines(
    canvas: "Canvas",
    nest: Nest,
    lines: list[Array],
    width: float,
    color: tuple[float, float, float] = (0.0, 0.0, 0.0),
    dashes: tuple[float, ...] = (),
    *,
    closed: bool = False,
) -> None:
    path = canvas.beginPath()
    for line in lines:
        points = _up(nest.on_sheet(line[:-1] if closed else line)).tolist()
        path.moveTo(*points[0])
        for point in points[1:]:
            path.lineTo(*point)
        if closed:
            path.close()
    canvas.setStrokeColorRGB(*color)
    canvas.setLineWidth(width)
    canvas.setDash(*([list(dashes)] if dashes else []))
    canvas.drawPath(path, stroke=1, fill=0)


def _up(points: Array) -> Array:
    """Return points of the sheet with their second axis turned up."""
    return np.asarray(points * [1.0, -1.0])


def _words(
    canvas: "Canvas", place: Array, words: str, height: float, *, centered: bool = False
) -> None:
    canvas.setFont(FONT, height)
    draw: Any = canvas.drawCentredString if centered else canvas.drawString
    draw(*place.tolist(), printable(words))


def printable(words: str) -> str:
    """Return words in the letters that the fonts of each PDF reader have."""
    return words.encode("cp1252", "replace").decode("cp1252")


def _square(canvas: "Canvas", sheet: Sheet) -> None:
    canvas.setLineWidth(0.2)
    canvas.setDash()
    canvas.setStrokeColorRGB(0.0, 0.0, 0.0)
    x, y = _up(sheet.square[3]).tolist()
    canvas.rect(x, y, SQUARE, SQUARE, stroke=1, fill=0)
    _words(canvas, np.array([x + 3.0, y + 3.0]), f"{SQUARE:g} mm", TITLE)
    for place, line in zip(_up(sheet.title_places), sheet.title, strict=True):
        _words(canvas, place, line, TITLE)


def _frame(canvas: "Canvas", tile: Tile, paper: tuple[float, float], page: str) -> None:
    """Draw the marks at which a tile is cut, and say which one it is."""
    width, height = paper
    canvas.saveState()
    canvas.scale(POINTS, POINTS)
    canvas.setStrokeColorRGB(*TILE)
    canvas.setFillColorRGB(*TILE)
    canvas.setLineWidth(0.2)
    canvas.setDash()
    for x in (MARGIN, width - MARGIN):
        for y in (MARGIN, height - MARGIN):
            canvas.line(x - MARK, y, x + MARK, y)
            canvas.line(x, y - MARK, x, y + MARK)
    words = f"row {tile.row}, column {tile.column} · {page}"
    _words(canvas, np.array([MARGIN + MARK + 3.0, 0.5 * MARGIN]), words, WORDS)
    canvas.restoreState()
