"""Patches fitted to the Catmull-Clark surface where they can only approximate it."""

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.bezier import bernstein
from bodymeasure.subdivision.patches.irregular import irregular_quads, neighborhood, subdivided
from bodymeasure.subdivision.patches.loop_schaefer import PatchNets, vertex_limits
from bodymeasure.subdivision.polygon_mesh import PolygonMesh

# Steps of subdivision that give the points to which patches are fitted: 5 by 5 on each.
STEPS = 2
# The sides of a patch in its net and in its grid of points.
_FIRST, _LAST = (slice(None), slice(None), 0), (slice(None), slice(None), -1)
_SIDES = (_FIRST, _LAST, (slice(None), 0), (slice(None), -1))


def fitted(mesh: PolygonMesh, nets: PatchNets) -> PatchNets:
    """Return the patches of a mesh, with those at irregular quads fitted to the surface.

    Parameters
    ----------
    mesh : PolygonMesh
        A mesh of quads alone.
    nets : PatchNets
        Its patches, by `loop_schaefer`.

    Returns
    -------
    PatchNets
        With the same numbers, so that neighbors share their edges still. Corners stay.

    Notes
    -----
    Each curve between two quads is fitted by least squares to points of the surface, and then the
    inner control points of each patch. The deviation falls to half or a third of that of Loop and
    Schaefer's patches, and to a tenth beside the end of a crease, of which they take no account.
    """
    irregular = irregular_quads(mesh)
    if not irregular.any():
        return nets
    grids = _limit_grids(*neighborhood(mesh, irregular))
    index = nets.index[irregular]
    basis = bernstein(3, np.linspace(0.0, 1.0, 2**STEPS + 1), 0)[:, 0]
    inner = np.linalg.pinv(basis[1:-1, 1:3])

    points = nets.points.copy()
    for side in _SIDES:
        curve = grids[side]
        rest = curve[:, 1:-1] - basis[1:-1, [0, 3]] @ curve[:, [0, -1]]
        points[index[side][:, 1:3]] = inner @ rest
    # Curves that a regular quad shares are exact already.
    exact = nets.index[~irregular]
    points[exact] = nets.points[exact]

    boundary = points[index]
    boundary[:, 1:3, 1:3] = 0.0
    rest = grids - np.einsum("ai,pijc,bj->pabc", basis, boundary, basis, optimize=True)
    points[index[:, 1:3, 1:3]] = np.einsum(
        "ia,pabc,jb->pijc", inner, rest[:, 1:-1, 1:-1], inner, optimize=True
    )
    return PatchNets(points, nets.index)


def _limit_grids(mesh: PolygonMesh, numbers: Ints) -> Array:
    """Points of the surface over some quads of a mesh on grids, (quads, count + 1, count + 1, 3).

    The count is 2^STEPS.
    """
    mesh, children, places = subdivided(mesh, numbers, STEPS)
    count = 2**STEPS
    i, j = np.rint(count * places).astype(np.int64).reshape(-1, 2).T
    corners = mesh.corners.reshape(-1, 4)[children].reshape(len(numbers), -1)
    result = np.empty((len(numbers), count + 1, count + 1, 3))
    result[:, i, j] = vertex_limits(mesh)[corners]
    return result
