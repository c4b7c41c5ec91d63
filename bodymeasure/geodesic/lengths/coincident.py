"""Points that coincide: equal ones, and those on one collapsed edge."""

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.lengths.compiled import CANCELLATION
from bodymeasure.geodesic.surfaces.protocol import Surface

# The parameters at which the speed along a line is evaluated: a polynomial of a degree below their
# number cannot vanish at all of them without being zero.
TIMES = np.linspace(0.0, 1.0, 17)


def distances_in_one_place(surfaces: Surface, surface_of: Ints, start: Array, end: Array) -> Array:
    """Return bounds of the distances between coincident points, and infinity for all others.

    The bound is zero for equal points. Along a line of u or of v the surface may stand still, as on
    an edge of a patch that is collapsed to a point: then the distance is zero except for
    rounding errors.

    Parameters
    ----------
    surfaces : Surface
    surface_of : ndarray of int, shape (problems,)
        The surface of each problem.
    start, end : ndarray, shape (problems, 2)

    Returns
    -------
    ndarray, shape (problems,)
    """
    in_u, in_v = (start[:, axis] != end[:, axis] for axis in (0, 1))
    distance = np.where(in_u | in_v, np.inf, 0.0)
    rows = np.flatnonzero(in_u ^ in_v)
    if len(rows):
        surface = surfaces.take(surface_of[rows])
        way = end[rows] - start[rows]
        line = start[rows, None] + way[:, None] * TIMES[:, None]
        along_v = (way[:, 0] == 0.0)[:, None]
        s_u, s_v = np.linalg.norm(surface.jet(line, 1)[1:], axis=1)
        by_u, by_v = surface.magnitude(line)
        speed, terms = np.where(along_v, s_v, s_u), np.where(along_v, by_v, by_u)
        still = (speed <= CANCELLATION * terms).all(axis=1)
        most = CANCELLATION * terms.max(axis=1) * np.abs(way).max(axis=1)
        distance[rows[still]] = most[still]
    return distance
