"""The patches that cut through themselves, as far as a triangle mesh of them shows."""

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.tessellation import grid_faces
from bodymeasure.bezier import evaluate

# Cells of the mesh along each side. A loop narrower than a cell may be missed: among 700 patches of
# the widest scatter, twice as many cells find 18 more, all of which are folded, too.
CELLS = 16


def intersects_itself(control_points: Array) -> bool:
    """Return whether two triangles of a patch's mesh that have no common corner meet.

    Parameters
    ----------
    control_points : ndarray, shape (4, 4, 3)

    Notes
    -----
    Triangles in general position meet where an edge of one goes through the other. Neighboring
    triangles, which meet in a common corner, are left to the test for folds.
    """
    side = np.linspace(0.0, 1.0, CELLS + 1)
    parameters = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1).reshape(-1, 2)
    points = evaluate(control_points, parameters)
    faces = grid_faces(np.arange((CELLS + 1) ** 2).reshape(CELLS + 1, -1))
    first, second = _near_pairs(points[faces], faces)
    triangles = points[faces]
    return bool(
        _pierced(triangles[first], triangles[second]).any()
        or _pierced(triangles[second], triangles[first]).any()
    )


def _near_pairs(triangles: Array, faces: Ints) -> tuple[Ints, Ints]:
    """Return pairs of triangles whose boxes overlap and that share no corner."""
    low, high = triangles.min(axis=1), triangles.max(axis=1)
    overlap = np.triu(np.ones((len(faces), len(faces)), bool), 1)
    for axis in range(3):
        overlap &= low[:, None, axis] <= high[None, :, axis]
        overlap &= low[None, :, axis] <= high[:, None, axis]
    first, second = np.nonzero(overlap)
    shared = (faces[first][:, :, None] == faces[second][:, None, :]).any(axis=(1, 2))
    return first[~shared], second[~shared]


def _pierced(triangles: Array, others: Array) -> Bools:
    """Return which triangles (k, 3, 3) are pierced by an edge of their partners."""
    a, b, c = triangles.swapaxes(0, 1)
    result = np.zeros(len(triangles), bool)
    for i in range(3):
        start, end = others[:, i], others[:, (i + 1) % 3]
        crosses = _side(a, b, c, start) * _side(a, b, c, end) < 0.0
        turns = [_side(start, end, p, q) for p, q in ((a, b), (b, c), (c, a))]
        same = (np.sign(turns[0]) == np.sign(turns[1])) & (np.sign(turns[1]) == np.sign(turns[2]))
        result |= crosses & same & (turns[0] != 0.0)
    return result


def _side(a: Array, b: Array, c: Array, point: Array) -> Array:
    """Return six times the volume of tetrahedra, whose sign gives the side."""
    return np.asarray((np.cross(b - a, c - a) * (point - a)).sum(axis=1))
