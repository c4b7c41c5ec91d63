"""Patterns as DXF files for cutting rooms, in the layers of AAMA and ASTM D6673."""

import io
import re
import unicodedata
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import MissingExtraError
from bodymeasure.pattern.files.drawn import DrawnPiece
from bodymeasure.pattern.files.layout import Nest, sheet_of
from bodymeasure.pattern.pieces.graded import GradedPattern
from bodymeasure.pattern.pieces.pattern import Pattern

if TYPE_CHECKING:
    from ezdxf.layouts.blocklayout import BlockLayout

# The layers of the standard: the cut line and the system's texts, turn points, curve points,
# notches, the mirror line, the grain, lines inside, holes, the sew line, and annotations.
BOUNDARY, TURNS, CURVES, NOTCHES, MIRROR, GRAIN = "1", "2", "3", "4", "6", "7"
INSIDE, HOLES, SEWN, WORDS = "8", "13", "14", "15"
LAYERS = (BOUNDARY, TURNS, CURVES, NOTCHES, MIRROR, GRAIN, INSIDE, HOLES, SEWN, WORDS)
# A line that turns by more than this, in degrees, has a turn point there; else a curve point.
TURN = 20.0
# The height of the system's texts, in millimeters.
TEXT = 2.5
# DXF R12 allows 31 letters in the name of a block.
LONGEST_NAME = 31


def pattern_dxf(pattern: Pattern | GradedPattern, *, allowance: float = 10.0) -> bytes:
    """Return a DXF file of a pattern: a block for each piece and size, in millimeters.

    Parameters
    ----------
    pattern : Pattern or GradedPattern
    allowance : float
        Of seams, in millimeters, where their panels do not say otherwise.

    Returns
    -------
    bytes
        A file of DXF R12, whose drawing is that of ``pattern.svg``.

    Raises
    ------
    MissingExtraError
        If ezdxf is not installed.

    Notes
    -----
    R12 has no header for the unit; ``UNITS: METRIC`` in the drawing means millimeters.
    """
    try:
        from ezdxf.document import Drawing
    except ImportError:
        raise MissingExtraError("the DXF file", "ezdxf", "pattern") from None
    sheet = sheet_of(pattern, allowance)
    # Not by `ezdxf.new`, which warns that R12 has no header for units.
    document = Drawing.new("R12")
    for layer in LAYERS:
        document.layers.add(layer)
    model = document.modelspace()
    names: set[str] = set()
    for nest in sheet.nests:
        for piece in nest.pieces:
            block = document.blocks.new(_block_name(piece, names))
            _draw(block, nest, piece)
            # The drawing's second axis points up.
            place = nest.offset * [1.0, -1.0]
            model.add_blockref(block.name, place, dxfattribs={"layer": BOUNDARY})
    style = ("UNITS: METRIC", f"STYLE NAME: {_plain(sheet.title[0])}")
    _texts(model, style, np.array([0.0, 0.0]), BOUNDARY)
    stream = io.StringIO()
    document.write(stream)
    return stream.getvalue().encode(document.output_encoding, "dxfreplace")


def _draw(block: "BlockLayout", nest: Nest, piece: DrawnPiece) -> None:
    _polyline(block, piece.cut[:-1], BOUNDARY, closed=True)
    for point, is_turn in zip(piece.cut[:-1], _turns(piece.cut[:-1]), strict=True):
        block.add_point(point, dxfattribs={"layer": TURNS if is_turn else CURVES})
    for edge in piece.edges:
        for part in edge.parts:
            _polyline(block, part, SEWN)
        if edge.is_fold:
            block.add_line(edge.parts[0][0], edge.parts[-1][-1], dxfattribs={"layer": MIRROR})
    for dart in piece.darts:
        for leg in dart.legs:
            _polyline(block, leg, INSIDE)
        block.add_point(dart.hole, dxfattribs={"layer": HOLES})
    for notch in piece.notches:
        block.add_point(notch.line[0], dxfattribs={"layer": NOTCHES})
    if nest.marks.grain is not None:
        low, high = nest.marks.grain
        block.add_line(low, high, dxfattribs={"layer": GRAIN})
    label = nest.marks.label
    for place, line in zip(label.places, label.lines, strict=True):
        _text(block, line, place, WORDS, label.height)
    left, below, _, _ = label.box
    system = (
        f"PIECE NAME: {piece.name}",
        f"SIZE: {piece.size or 'ONE'}",
        f"QUANTITY: {_quantity(piece.piece.panel.cut)}",
    )
    _texts(block, system, np.array([left, below - TEXT]), BOUNDARY)


def _polyline(block: "BlockLayout", points: Array, layer: str, *, closed: bool = False) -> None:
    block.add_polyline2d(points.tolist(), close=closed, dxfattribs={"layer": layer})


def _texts(block: Any, lines: Iterable[str], place: Array, layer: str) -> None:
    for row, line in enumerate(lines):
        _text(block, line, place - [0.0, 1.4 * TEXT * row], layer, TEXT, centered=False)


def _text(
    block: Any, line: str, place: Array, layer: str, height: float, *, centered: bool = True
) -> None:
    from ezdxf.enums import TextEntityAlignment

    text = block.add_text(_plain(line), height=height, dxfattribs={"layer": layer})
    align = TextEntityAlignment.CENTER if centered else TextEntityAlignment.LEFT
    text.set_placement(place, align=align)


def _turns(points: Array) -> Array:
    """Return whether a closed line turns at each of its points."""
    along = np.roll(points, -1, axis=0) - points
    before = np.roll(along, 1, axis=0)
    turn = before[:, 0] * along[:, 1] - before[:, 1] * along[:, 0]
    angle = np.degrees(np.arctan2(turn, (before * along).sum(axis=1)))
    return np.asarray(np.abs(angle) > TURN)


def _quantity(cut: str) -> str:
    """Return how often a piece is cut: the first number in what its label says."""
    found = re.search(r"\d+", cut)
    return found[0] if found else "1"


def _plain(words: str) -> str:
    """Return words as one line of printable letters."""
    return "".join(c if c.isprintable() else " " for c in words)


def _block_name(piece: DrawnPiece, names: set[str]) -> str:
    """Return a new name for a block, in the letters that R12 allows."""
    words = " ".join(each for each in (piece.name, piece.size) if each)
    ascii_only = unicodedata.normalize("NFKD", words).encode("ascii", "ignore").decode()
    stem = re.sub(r"[^0-9A-Z]+", "_", ascii_only.upper()).strip("_") or "PIECE"
    name, number = stem[:LONGEST_NAME], 2
    while name in names:
        end = f"_{number}"
        name, number = stem[: LONGEST_NAME - len(end)] + end, number + 1
    names.add(name)
    return name
