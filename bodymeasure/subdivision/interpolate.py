"""A Catmull-Clark surface through the vertices of a mesh."""

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.subdivision.patches.loop_schaefer import vertex_limits
from bodymeasure.subdivision.polygon_mesh import PolygonMesh
from bodymeasure.subdivision.polygons import refined, refined_vertices

# The distance of the surface from the vertices that is left, as a part of the mesh's size. The
# equations are well-conditioned, so that some thirty products reach it.
TOLERANCE = 1e-11
RESTART, CYCLES = 40, 5


def interpolating(mesh: PolygonMesh) -> PolygonMesh:
    """Return the mesh whose Catmull-Clark surface runs through the vertices of another.

    Parameters
    ----------
    mesh : PolygonMesh

    Returns
    -------
    PolygonMesh
        The same faces with other vertices. Curves along creases and boundaries run through their
        vertices as well, and vertices that stay where they are do so.

    Raises
    ------
    InputError
        If the equations have no solution, or none is found.

    Notes
    -----
    The limit of each vertex is a linear function of all; the equations of M. Halstead, M. Kass, T.
    DeRose, *Efficient, fair interpolation using Catmull-Clark surfaces*, SIGGRAPH 1993, section 4,
    without their measure of fairness, are solved by GMRES.
    """
    count = len(mesh.vertices)
    used = np.zeros(count, dtype=np.bool_)
    used[mesh.corners] = True
    only_quads = bool((mesh.sizes == 4).all())
    fine = mesh if only_quads else refined(mesh)

    def limits(flat: Array) -> Array:
        coarse = mesh.with_vertices(flat.reshape(count, 3))
        quads = coarse if only_quads else fine.with_vertices(refined_vertices(coarse))
        found = vertex_limits(quads)[:count]
        return np.where(used[:, None], found, coarse.vertices).ravel()

    center = mesh.vertices[used].mean(axis=0)
    wanted = np.where(used[:, None], mesh.vertices - center, 0.0).ravel()
    size = float(np.abs(wanted).max()) or 1.0
    operator = scipy.sparse.linalg.LinearOperator((3 * count, 3 * count), limits, dtype=np.float64)
    solution, _ = scipy.sparse.linalg.gmres(
        operator,
        wanted / size,
        x0=wanted / size,
        rtol=0.0,
        atol=TOLERANCE,
        restart=RESTART,
        maxiter=CYCLES,
    )
    rest = np.abs(limits(solution) - wanted / size).max()
    # Not `rest > ...`, so that NaN is refused too.
    if not rest <= 10.0 * TOLERANCE:
        raise InputError(
            f"no smooth surface through the vertices of the mesh was found; the best misses them "
            f"by {rest * size:.2g}; leave out interpolation"
        )
    return mesh.with_vertices(size * solution.reshape(count, 3) + center)
