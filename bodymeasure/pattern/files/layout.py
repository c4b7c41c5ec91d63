"""Pieces on a sheet in millimeters: where each lies, those of all sizes over each other."""

import textwrap
from dataclasses import dataclass, field

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.pattern.files.drawn import DrawnPiece, drawn_piece
from bodymeasure.pattern.files.labels import Marks, marks_of
from bodymeasure.pattern.pieces.graded import GradedPattern
from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.pattern.planar import shapely

# The distance between pieces and to the edge of the sheet, in millimeters.
GAP = 15.0
# The side of the square by which a print is checked, and its distance to the edge of the sheet.
SQUARE, CORNER = 50.0, 5.0
# Letters in a line of words on a piece, and of those beside the square, which stand on the first
# sheet of a print in tiles.
LONGEST_LINE, LONGEST_TITLE = 30, 30
# Room above the pieces for that square and the words beside it.
ABOVE = SQUARE + CORNER + 10.0
# The height of those words, and the width that they and the square take.
TITLE, TITLE_WIDTH = 4.0, SQUARE + 80.0


@dataclass(frozen=True, eq=False)
class Nest:
    """A piece in all sizes, over each other, on the sheet.

    Parameters
    ----------
    name : str
    pieces : tuple of DrawnPiece
        One for each size.
    marks : Marks
        What is written on it, once for all sizes.
    offset : ndarray, shape (2,)
        Where the origin of its pieces lies on the sheet, in millimeters from its upper left corner.
    """

    name: str
    pieces: tuple[DrawnPiece, ...]
    marks: Marks
    offset: Array

    @property
    def size_places(self) -> Array:
        """Where each size says its name: on its cut line, farthest from those of the others."""
        rings = [shapely.linearrings(piece.cut) for piece in self.pieces]
        found = []
        for number, piece in enumerate(self.pieces):
            others = shapely.union_all(rings[:number] + rings[number + 1 :])
            away = shapely.distance(others, shapely.points(piece.cut))
            # Without another size, and where all are the same, the highest point will do.
            clear = np.isfinite(away) & (away > GAP / 100.0)
            best = away.argmax() if clear.any() else piece.cut[:, 1].argmax()
            found.append(piece.cut[best])
        return np.array(found)

    def on_sheet(self, points: Array) -> Array:
        """Return points of its pieces on the sheet, whose second axis points down."""
        return np.asarray(points * [1.0, -1.0] + self.offset)


@dataclass(frozen=True, eq=False)
class Sheet:
    """All pieces of a pattern side by side.

    Parameters
    ----------
    title : tuple of str
        What the sheet is, for the room beside the square.
    nests : tuple of Nest
    width, height : float
        In millimeters.
    corner : ndarray, shape (2,)
        The upper left corner of the square by which a print is checked, with the title beside it.
    """

    title: tuple[str, ...]
    nests: tuple[Nest, ...]
    width: float
    height: float
    corner: Array = field(default_factory=lambda: np.full(2, CORNER))

    @property
    def square(self) -> Array:
        """The corners of the square by which a print is checked."""
        side = SQUARE * np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
        return np.asarray(self.corner + side)

    @property
    def title_places(self) -> Array:
        """Where the lines of the title begin, shape (n, 2)."""
        rows = np.arange(len(self.title))
        x = np.full(len(rows), SQUARE + CORNER)
        return np.asarray(self.corner + np.stack([x, TITLE + 1.5 * TITLE * rows], axis=1))


def sizes_of(pattern: Pattern | GradedPattern) -> dict[str, Pattern]:
    """Return the pattern of each size; one that has no size has an empty name."""
    return pattern.patterns if isinstance(pattern, GradedPattern) else {"": pattern}


def sheet_of(
    pattern: Pattern | GradedPattern, allowance: float, width: float = np.inf, above: float = ABOVE
) -> Sheet:
    """Lay out the pieces of a pattern.

    Parameters
    ----------
    pattern : Pattern or GradedPattern
    allowance : float
        In millimeters, of edges that have none of their own.
    width : float
        That of the paper, in millimeters: pieces that do not fit beside others come below.
    above : float
        Room above the pieces, in millimeters.
    """
    sizes = sizes_of(pattern)
    first = next(iter(sizes.values()))
    nests = []
    x, y, deepest, widest = GAP, above + GAP, 0.0, 0.0
    for number, panel in enumerate(piece.panel for piece in first.pieces):
        drawn = tuple(
            drawn_piece(each, each.pieces[number], allowance, size) for size, each in sizes.items()
        )
        cuts = np.concatenate([piece.cut * [1.0, -1.0] for piece in drawn])
        low, high = cuts.min(axis=0), cuts.max(axis=0)
        if x > GAP and x + high[0] - low[0] + GAP > width:
            x, y, deepest = GAP, y + deepest + GAP, 0.0
        marks = marks_of(drawn, _words(panel.name, panel.cut, sizes))
        nests.append(Nest(panel.name, drawn, marks, np.array([x, y]) - low))
        x += float(high[0] - low[0]) + GAP
        deepest = max(deepest, float(high[1] - low[1]))
        widest = max(widest, x)
    title = _title(first, sizes, allowance)
    return Sheet(title, tuple(nests), max(widest, TITLE_WIDTH + 2.0 * CORNER), y + deepest + GAP)


def _words(name: str, cut: str, sizes: dict[str, Pattern]) -> tuple[str, ...]:
    """Return the words on a piece."""
    named = [size for size in sizes if size]
    what = f"{'sizes' if len(named) > 1 else 'size'} {', '.join(named)}" if named else ""
    bodies = [each.atlas.name for each in sizes.values() if each.atlas.name]
    whose = bodies[0] if len(bodies) == 1 else ""
    words = (name, f"cut {cut}" if cut else "", what, whose)
    return tuple(line for each in words for line in textwrap.wrap(each, LONGEST_LINE))


def _title(first: Pattern, sizes: dict[str, Pattern], allowance: float) -> tuple[str, ...]:
    """Return the words beside the square, short enough for the first sheet of paper."""
    named = [size for size in sizes if size]
    words = [first.definitions.name]
    words += [f"sizes {', '.join(named)}"] if named else [first.atlas.name]
    words += [f"true size; allowance {allowance:g} mm, but where the set says otherwise"]
    return tuple(line for each in words for line in textwrap.wrap(each, LONGEST_TITLE))
