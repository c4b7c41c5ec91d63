"""Lines inside of a piece that keep their lengths, as the girth of a garment does."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.pattern.flat.mesh import PieceMesh
from bodymeasure.pattern.planar import shapely

# The part of a line's points that may lie on the border: an edge keeps its own length, and a line
# along it would ask for the same once more.
ALONG_EDGES = 0.2


@dataclass(frozen=True, eq=False)
class LevelLine:
    """A line across a mesh, of segments that each cross one triangle.

    Parameters
    ----------
    vertices : ndarray of int, shape (m, 4)
        The vertices between which both ends of each segment lie.
    weights : ndarray, shape (m, 4)
        The way along a segment is the sum of its vertices' places, times these.
    triangles : ndarray of int, shape (m,)
        The triangles that they cross.
    lengths : ndarray, shape (m,)
        What they measure before the piece is laid flat.
    length : float
        What all of them together have to measure in the piece.
    """

    vertices: Ints
    weights: Array
    triangles: Ints
    lengths: Array
    length: float

    def ways(self, flat: Array) -> Array:
        """Return the segments as vectors, shape (m, 2)."""
        return np.asarray(np.einsum("mk,mkc->mc", self.weights, flat[self.vertices]))

    def measured(self, flat: Array) -> float:
        """Return how long the line is in a layout."""
        return float(np.linalg.norm(self.ways(flat), axis=1).sum())


def level_line(mesh: PieceMesh, above: Array, near: float = 0.0) -> LevelLine | None:
    """Return the line on which a function of the vertices, shape (n,), is zero.

    None if it does not cross the mesh, or runs along its border, nowhere farther from it than
    `near`: between two lengths that are kept, side by side, cloth would pucker.
    """
    # No vertex lies on the line itself, but for which triangles that is it makes no difference.
    positive = above > 0.0
    corners = mesh.triangles
    crossed = positive[corners] != positive[np.roll(corners, -1, axis=1)]
    rows = np.flatnonzero(crossed.any(axis=1))
    if not len(rows):
        return None
    # Two sides of each of these triangles are crossed.
    side = np.nonzero(crossed[rows])[1].reshape(-1, 2)
    one, other = corners[rows[:, None], side], corners[rows[:, None], (side + 1) % 3]
    border = np.unique(np.concatenate([chain.vertices for chain in mesh.chains]))
    if np.isin(np.stack([one, other]), border).mean() > ALONG_EDGES:
        return None
    part = above[one] / (above[one] - above[other])
    vertices = np.stack([one[:, 0], other[:, 0], one[:, 1], other[:, 1]], axis=1)
    weights = np.stack([part[:, 0] - 1.0, -part[:, 0], 1.0 - part[:, 1], part[:, 1]], axis=1)
    places = _corners(mesh.sides[rows])
    at = np.arange(len(rows))[:, None]
    ends = (1.0 - part)[..., None] * places[at, side] + part[..., None] * places[at, (side + 1) % 3]
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    line = LevelLine(vertices, weights, rows, lengths, float(lengths.sum()))
    return line if near <= 0.0 or _farthest(mesh, line) > near else None


def _farthest(mesh: PieceMesh, line: LevelLine) -> float:
    """Return how far a line is from the border at most, in the layout."""
    sides = np.concatenate(
        [np.stack([c.vertices[:-1], c.vertices[1:]], axis=1) for c in mesh.chains]
    )
    border = shapely.multilinestrings(list(shapely.linestrings(mesh.start[sides])))
    starts = np.einsum("mk,mkc->mc", -line.weights[:, :2], mesh.start[line.vertices[:, :2]])
    return float(shapely.distance(border, shapely.points(starts)).max())


def _corners(sides: Array) -> Array:
    """Return the corners (k, 3, 2) of triangles in the plane, from their sides."""
    first, second, third = sides.T
    x = (first**2 + third**2 - second**2) / (2.0 * first)
    y = np.sqrt(np.maximum(third**2 - x**2, 0.0))
    zero = np.zeros_like(x)
    return np.stack([zero, zero, first, zero, x, y], axis=1).reshape(-1, 3, 2)
