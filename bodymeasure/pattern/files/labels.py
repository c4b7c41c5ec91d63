"""What is written on pieces, and where: words, the grain, and the fold, all inside the piece."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.pattern.files.drawn import DrawnPiece
from bodymeasure.pattern.planar import shapely

# Heights of letters in millimeters, from what is wanted to what can be read.
SIZES = (7.0, 6.0, 5.0, 4.0, 3.2, 2.5)
# The width of a letter and the distance of lines, in heights: wide fonts have some 0.6.
LETTER, LINE = 0.6, 1.4
# Places that are tried for the words and for the grain, along each side of the piece.
PLACES = 15
# In millimeters: the room around words and arrows, and the longest grain line.
ROOM, LONGEST = 4.0, 250.0
# In millimeters: the bracket at a fold stands so far inside, and ends so far before its ends.
BRACKET, BEFORE_END = 12.0, 0.2


@dataclass(frozen=True, eq=False)
class Label:
    """Words on a piece, in lines that are centered.

    Parameters
    ----------
    lines : tuple of str
    center : ndarray, shape (2,)
        In millimeters, in the piece's own axes.
    height : float
        Of the letters, in millimeters.
    """

    lines: tuple[str, ...]
    center: Array
    height: float

    @property
    def places(self) -> Array:
        """The middle of each line's foot, shape (n, 2)."""
        rows = np.arange(len(self.lines))
        y = (0.5 * len(self.lines) - rows - 0.75) * LINE * self.height
        return np.stack([np.full(len(rows), self.center[0]), self.center[1] + y], axis=1)

    @property
    def box(self) -> tuple[float, float, float, float]:
        """What the words take: the least and the largest coordinates."""
        width, height = _extent(self.lines, self.height)
        x, y = self.center.tolist()
        return x - 0.5 * width, y - 0.5 * height, x + 0.5 * width, y + 0.5 * height


@dataclass(frozen=True, eq=False)
class Marks:
    """What is written on a piece, or on those of all sizes over each other.

    Parameters
    ----------
    label : Label
    grain : ndarray, shape (2, 2), optional
        The line along the grain, from below to above; none where there is no room.
    fold : ndarray, shape (4, 2), optional
        The bracket whose ends point to the fold.
    """

    label: Label
    grain: Array | None
    fold: Array | None


def marks_of(pieces: tuple[DrawnPiece, ...], lines: tuple[str, ...]) -> Marks:
    """Return what is written on pieces that lie over each other, inside of all of them."""
    area = pieces[0].inner
    for piece in pieces[1:]:
        area = shapely.intersection(area, piece.inner)
    area = max(shapely.get_parts(area), key=shapely.area)
    fold = _fold(pieces[0])
    if fold is not None:
        bracket = shapely.buffer(shapely.polygons(fold), ROOM)
        area = max(shapely.get_parts(shapely.difference(area, bracket)), key=shapely.area)
    label = _label(shapely.buffer(area, -ROOM), area, lines)
    rest = shapely.difference(area, shapely.buffer(shapely.box(*label.box), ROOM))
    return Marks(label, _grain(shapely.buffer(rest, -ROOM)), fold)


def _extent(lines: tuple[str, ...], height: float) -> tuple[float, float]:
    longest = max((len(line) for line in lines), default=0)
    return LETTER * height * longest, LINE * height * len(lines)


def _label(area: Any, whole: Any, lines: tuple[str, ...]) -> Label:
    """Return the words as large as they fit, as near as possible to the middle of the piece."""
    middle = shapely.get_coordinates(shapely.maximum_inscribed_circle(whole))[0]
    low_x, low_y, high_x, high_y = shapely.bounds(whole).tolist()
    x, y = np.meshgrid(np.linspace(low_x, high_x, PLACES), np.linspace(low_y, high_y, PLACES))
    places = np.concatenate([middle[None], np.stack([x.ravel(), y.ravel()], axis=1)])
    shapely.prepare(area)
    for height in SIZES:
        width, tall = (0.5 * side for side in _extent(lines, height))
        boxes = shapely.box(
            places[:, 0] - width, places[:, 1] - tall, places[:, 0] + width, places[:, 1] + tall
        )
        fits = np.flatnonzero(shapely.contains(area, boxes))
        if len(fits):
            nearest = fits[np.linalg.norm(places[fits] - middle, axis=1).argmin()]
            return Label(lines, places[nearest], height)
    return Label(lines, middle, SIZES[-1])


def _grain(area: Any) -> Array | None:
    """Return the longest line along the grain that fits, no longer than is usual."""
    if shapely.is_empty(area):
        return None
    low_x, low_y, high_x, high_y = shapely.bounds(area).tolist()
    x = np.linspace(low_x, high_x, 2 * PLACES + 1)[1:-1]
    lines = np.stack([np.stack([x, x], 1), np.stack([0 * x + low_y, 0 * x + high_y], 1)], axis=2)
    parts = shapely.get_parts(shapely.intersection(area, shapely.linestrings(lines)))
    parts = parts[shapely.get_type_id(parts) == 1]
    if not len(parts):
        return None
    sizes = np.minimum(shapely.length(parts), LONGEST)
    # The one that is nearest to the middle, among those that are about as long, is taken.
    long = parts[sizes > 0.9 * sizes.max()]
    away = [abs(line.centroid.x - area.centroid.x) for line in long]
    line = shapely.get_coordinates(long[int(np.argmin(away))])
    line = line[line[:, 1].argsort()]
    center, half = line.mean(axis=0), min(0.5 * float(np.ptp(line[:, 1])), 0.5 * LONGEST)
    return np.asarray(center + np.array([[0.0, -half], [0.0, half]]))


def _fold(piece: DrawnPiece) -> Array | None:
    """Return the bracket at the fold of a piece; none if it has none."""
    edge = next((edge for edge in piece.edges if edge.is_fold), None)
    if edge is None:
        return None
    ends = np.stack([edge.parts[0][0], edge.parts[-1][-1]])
    ends = ends[ends[:, 1].argsort()]
    along = ends[1] - ends[0]
    inward = np.array([-along[1], along[0]]) / np.linalg.norm(along)
    if (shapely.get_coordinates(piece.inner.centroid)[0] - ends[0]) @ inward < 0.0:
        inward = -inward
    low, high = ends[0] + BEFORE_END * along, ends[1] - BEFORE_END * along
    return np.stack([low, low + BRACKET * inward, high + BRACKET * inward, high])
