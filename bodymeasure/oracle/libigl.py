"""The calls into libigl; only the benchmark, for sections of meshes, imports it besides."""

from importlib.util import find_spec
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError, MissingExtraError

# The relative rounding error, since libigl adds some hundred lengths in double precision.
ROUND_OFF = 1e-9


def exact_distance(vertices: Array, faces: Ints, source: int, target: int) -> float:
    """Length of the shortest path over a polyhedron between two of its vertices.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
    faces : ndarray of int, shape (f, 3)
        A mesh that `validate_mesh` accepts; libigl ends the process on others.
    source, target : int
        Vertex numbers.

    Returns
    -------
    float

    Raises
    ------
    InputError
        If libigl cannot measure this mesh, although it is valid.
    MissingExtraError
        If libigl is not installed.

    Notes
    -----
    J. Mitchell, D. Mount and C. Papadimitriou, "The discrete geodesic problem", SIAM J. Comput.
    16 (1987): exact on the polyhedron, which is off the smooth surface by O(h^2). Given a target,
    libigl stops as soon as it is reached.
    """
    igl = _import_igl()
    ends = {"VS": np.array([source]), "VT": np.array([target])}
    try:
        # Called by keyword: positional calls put the targets among the source faces and return
        # nothing.
        distance = float(igl.exact_geodesic(vertices, faces, **ends)[0])
    except MemoryError:  # seen on cells of 1e-8 of the patch
        raise InputError("libigl ran out of memory; some triangles may be too thin") from None
    chord = float(np.linalg.norm(vertices[source] - vertices[target]))
    if not chord * (1.0 - ROUND_OFF) <= distance < np.inf:
        raise InputError(
            f"libigl gives {distance} as the distance between points {chord} apart; "
            "some triangles may be too thin"
        )
    return distance


def heat_distances(vertices: Array, faces: Ints, sources: Ints) -> Array:
    """Distances by the heat method from each of several vertices to all vertices.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
    faces : ndarray of int, shape (f, 3)
        A mesh that `validate_mesh` accepts.
    sources : ndarray of int, shape (k,)
        Vertex numbers.

    Returns
    -------
    ndarray, shape (k, n)
        NaN throughout if libigl cannot factorize the mesh's Laplacian.

    Raises
    ------
    MissingExtraError
        If libigl is not installed.

    Notes
    -----
    K. Crane, C. Weischedel and M. Wardetzky, "Geodesics in heat", ACM Trans. Graph. 32 (2013). Off
    by about 1 %, and no better on finer meshes: a check for plausibility.
    """
    igl = _import_igl()
    data = igl.HeatGeodesicsData()
    # Without it, obtuse triangles made single distances wrong by up to 80 %.
    data.use_intrinsic_delaunay = True
    try:
        igl.heat_geodesics_precompute(vertices, faces, data)
    except RuntimeError:  # "Precomputation failed": seen where four vertices lie on a circle
        return np.full((len(sources), len(vertices)), np.nan)
    return np.array([igl.heat_geodesics_solve(data, np.array([source])) for source in sources])


def closest_on_mesh(vertices: Array, faces: Ints, positions: Array) -> tuple[Array, Ints]:
    """Points of a triangle mesh that are closest to given positions.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
    faces : ndarray of int, shape (f, 3)
    positions : ndarray, shape (k, 3)

    Returns
    -------
    points : ndarray, shape (k, 3)
    face : ndarray of int, shape (k,)
        A face that each lies on.

    Raises
    ------
    MissingExtraError
        If libigl is not installed.
    """
    igl = _import_igl("a place on a mesh between its vertices")
    _, face, points = igl.point_mesh_squared_distance(positions, vertices, faces)
    return points, face


def require_libigl(feature: str = "the cross-check") -> None:
    """Raise `MissingExtraError` if libigl is not installed, before any work is shared out."""
    if find_spec("igl") is None:
        raise MissingExtraError(feature, "libigl", "oracle")


def _import_igl(feature: str = "the cross-check") -> Any:
    require_libigl(feature)
    import igl

    return igl
