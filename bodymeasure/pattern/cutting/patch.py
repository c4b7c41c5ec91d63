"""One patch cut along curves: triangles in its (u, v) that no curve crosses."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.pattern.grid import CELLS
from bodymeasure.pattern.planar import shapely

# Area in (u, v) below which a polygon is rounding.
EMPTY = 1e-15


def cut_patch(chains: list[Array], sides: list[Array]) -> Array:
    """Return triangles of a patch between the lines of its grid and curves.

    Parameters
    ----------
    chains : list of ndarray, shape (k, 2)
        Curves, which may run along sides and cross one another.
    sides : list of ndarray, shape (n,)
        The points that each side has to have, in the order of `EDGES`.

    Returns
    -------
    ndarray, shape (k, 3, 2)
        Their corners in (u, v), counterclockwise.
    """
    u0, u1, v0, v1 = (np.sort(side) for side in sides)
    border = [
        np.stack([np.zeros_like(u0), u0], axis=1),
        np.stack([np.ones_like(u1), u1], axis=1),
        np.stack([v0, np.zeros_like(v0)], axis=1),
        np.stack([v1, np.ones_like(v1)], axis=1),
    ]
    inner = np.arange(1, CELLS) / CELLS
    grid = [np.array([[x, 0.0], [x, 1.0]]) for x in inner]
    grid += [np.array([[0.0, x], [1.0, x]]) for x in inner]
    lines = shapely.multilinestrings([shapely.linestrings(line) for line in border + grid + chains])
    noded = shapely.node(lines)
    cells = shapely.get_parts(shapely.polygonize([noded]))
    cells = cells[shapely.area(cells) > EMPTY]
    triangles = shapely.get_parts(shapely.constrained_delaunay_triangles(cells))
    corners = shapely.get_coordinates(triangles).reshape(-1, 4, 2)[:, :3]
    one, other = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    doubled = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    corners = np.where((doubled < 0.0)[:, None, None], corners[:, ::-1], corners)
    return np.asarray(corners[doubled != 0.0])
