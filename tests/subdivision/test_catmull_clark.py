import numpy as np
import pytest
from helpers.surfaces.quad_grids import grid_mesh, hilly_net, spline_matrix
from scipy.interpolate import BSpline

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.subdivision import QuadMesh, limit_positions, subdivide

# A box has only vertices of valence 3; without its lid it also has a boundary.
CORNERS = np.array([[x, y, z] for x in (0.0, 2.0) for y in (0.0, 1.0) for z in (0.0, 1.5)])
BOX = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
# Five quads around a vertex.
STAR = QuadMesh(
    np.array(
        [(0.0, 0.0, 0.3)]
        + [(np.cos(0.2 * k * np.pi), np.sin(0.2 * k * np.pi), 0.1 * (k % 3)) for k in range(10)]
    ),
    np.array([[0, 2 * k + 1, 2 * k + 2, (2 * k + 3) % 10] for k in range(5)]),
)
MESHES = [QuadMesh(CORNERS, BOX), QuadMesh(CORNERS, BOX[:-1]), STAR]


def refined(mesh: QuadMesh, steps: int) -> QuadMesh:
    for _ in range(steps):
        mesh = subdivide(mesh)
    return mesh


@pytest.mark.parametrize("steps", [0, 1, 3])
def test_on_a_regular_mesh_the_limit_is_the_bicubic_spline(steps: int) -> None:
    net = hilly_net(7, 6)
    mesh = refined(grid_mesh(net), steps)
    # The control points' first two coordinates are not linear in the spline's parameters; these are
    # found from a mesh whose coordinates are.
    i, j = np.meshgrid(np.arange(7.0), np.arange(6.0), indexing="ij")
    flat = refined(grid_mesh(np.stack([i, j, 0.0 * i], axis=-1)), steps)
    u, v = flat.vertices[:, :2].T
    inside = (u >= 1) & (u <= 5) & (v >= 1) & (v <= 4)
    assert inside.sum() == (4 * 2**steps + 1) * (3 * 2**steps + 1)
    rows, columns = spline_matrix(7, u[inside]), spline_matrix(6, v[inside])
    expected = np.einsum("pi,pj,ijc->pc", rows, columns, net)
    np.testing.assert_allclose(limit_positions(mesh)[inside], expected, rtol=0, atol=2e-15 * 8)


def test_the_boundary_becomes_the_cubic_spline_of_its_polygon() -> None:
    ring = np.array([1, 5, 7, 3])  # the corners of the missing lid
    polygon = CORNERS[ring]
    spline = BSpline(np.arange(12) - 2.0, polygon[np.arange(8) % 4], 3)
    mesh = refined(MESHES[1], 2)
    edges = mesh.edges.ends[mesh.edges.boundary]
    found = limit_positions(mesh)[np.unique(edges)]
    expected = spline(np.arange(16) / 4.0 + 1.0)
    distance = np.linalg.norm(found[:, None] - expected, axis=-1)
    assert len(found) == 16
    assert distance.min(axis=0).max() < 1e-14
    assert distance.min(axis=1).max() < 1e-14


@pytest.mark.parametrize("mesh", MESHES, ids=["box", "open box", "star"])
def test_subdivision_keeps_the_limits_and_leads_there(mesh: QuadMesh) -> None:
    limit = limit_positions(mesh)
    far = np.linalg.norm(mesh.vertices - limit, axis=-1).max()
    for step in range(1, 5):
        mesh = subdivide(mesh)
        here = limit_positions(mesh)[: len(limit)]
        np.testing.assert_allclose(here, limit, rtol=0, atol=1e-14)
        # The error falls at least by the subdominant eigenvalue, which is 0.55 for five quads and
        # less for fewer.
        distance = np.linalg.norm(mesh.vertices[: len(limit)] - limit, axis=-1).max()
        assert distance < 0.56**step * far


def test_children_follow_their_quads_from_corner_to_corner() -> None:
    mesh = MESHES[1]
    finer = subdivide(mesh)
    np.testing.assert_array_equal(finer.quads[:, 0], mesh.quads.ravel())
    middle = finer.quads[:, 2].reshape(-1, 4)
    assert (middle == middle[:, :1]).all()
    np.testing.assert_allclose(finer.vertices[middle[:, 0]], mesh.vertices[mesh.quads].mean(axis=1))
    np.testing.assert_array_equal(finer.edges.boundary.sum(), 2 * mesh.edges.boundary.sum())


def test_affine_maps_commute_with_subdivision(rng: np.random.Generator) -> None:
    matrix, shift = rng.normal(size=(3, 3)), rng.normal(size=3)
    for mesh in MESHES:
        moved = QuadMesh(mesh.vertices @ matrix + shift, mesh.quads)
        np.testing.assert_allclose(
            subdivide(moved).vertices, subdivide(mesh).vertices @ matrix + shift, atol=1e-14
        )


def _mesh(vertices: Array, quads: list[list[int]]) -> QuadMesh:
    return QuadMesh(vertices, np.array(quads))


def test_what_is_no_manifold_is_refused() -> None:
    points = np.arange(33.0).reshape(11, 3)
    fins = _mesh(points[:8], [[0, 1, 2, 3], [1, 0, 4, 5], [0, 1, 6, 7]])
    with pytest.raises(InputError, match=r"edge \(0, 1\) belongs to 3 quads; expected at most 2"):
        subdivide(fins)
    touching = _mesh(points[:7], [[0, 1, 2, 3], [0, 4, 5, 6]])
    with pytest.raises(InputError, match="4 boundary edges meet at mesh vertex 0; expected 2"):
        limit_positions(touching)


def test_arrays_of_the_wrong_kind_are_refused() -> None:
    points = np.zeros((5, 3))
    with pytest.raises(InputError, match=r"vertices have shape \(5, 2\)"):
        _mesh(points[:, :2], [[0, 1, 2, 3]])
    with pytest.raises(InputError, match=r"quads have shape \(1, 3\)"):
        _mesh(points, [[0, 1, 2]])
    with pytest.raises(InputError, match="vertices 0 to 5, but they are numbered 0 to 4"):
        _mesh(points, [[0, 1, 2, 5]])
    with pytest.raises(InputError, match="vertex 4 belongs to no quad"):
        _mesh(points, [[0, 1, 2, 3]])
