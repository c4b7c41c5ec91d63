"""Surfaces through the vertices of a mesh."""

import numpy as np
import pytest
from helpers.surfaces.quad_grids import grid_mesh, hilly_net
from helpers.surfaces.solids import CUBE, blob, icosphere, quad_mesh

from bodymeasure import InputError
from bodymeasure.subdivision import PolygonMesh, interpolating, loop_schaefer, refined

POINTS = hilly_net(7, 6)
GRID = quad_mesh(POINTS.reshape(-1, 3), grid_mesh(POINTS).quads)
CREASE = np.stack([18 + np.arange(4), 19 + np.arange(4)], axis=-1)
CREASED = PolygonMesh(GRID.vertices, GRID.corners, GRID.sizes, CREASE, tagged=(9,))
MESHES = {
    "cube": CUBE,
    "blob": blob(2),
    "sphere": icosphere(1),
    "boundary": GRID,
    "creases": CREASED,
}


@pytest.mark.parametrize("name", MESHES)
def test_the_surface_runs_through_all_vertices(name: str) -> None:
    mesh = MESHES[name]
    found = interpolating(mesh)
    quads = found if (found.sizes == 4).all() else refined(found)
    limits = loop_schaefer(quads).points[: len(mesh.vertices)]
    np.testing.assert_allclose(limits, mesh.vertices, rtol=0, atol=1e-9)
    assert np.abs(found.vertices - mesh.vertices).max() > 1e-3
    np.testing.assert_array_equal(found.corners, mesh.corners)
    # Vertices that stay where they are stay.
    fixed = mesh.corner_vertices
    np.testing.assert_allclose(found.vertices[fixed], mesh.vertices[fixed], rtol=0, atol=1e-10)


def test_a_flat_mesh_and_one_of_any_size_and_place_stay_what_they_are() -> None:
    flat = GRID.with_vertices(GRID.vertices * (1.0, 1.0, 0.0))
    assert np.abs(interpolating(flat).vertices[:, 2]).max() == 0.0
    far = GRID.with_vertices(1e5 * GRID.vertices + 1e7)
    expected = 1e5 * interpolating(GRID).vertices + 1e7
    np.testing.assert_allclose(interpolating(far).vertices, expected, rtol=0, atol=1e-3)


def test_vertices_without_a_face_are_left_alone() -> None:
    vertices = np.concatenate([CUBE.vertices, [[5.0, 5.0, 5.0]]])
    mesh = PolygonMesh(vertices, CUBE.corners, CUBE.sizes, CUBE.creases)
    found = interpolating(mesh).vertices
    np.testing.assert_allclose(found[:8], interpolating(CUBE).vertices, rtol=0, atol=1e-9)


def test_equations_without_a_solution_are_refused() -> None:
    with pytest.raises(InputError, match="no smooth surface through the vertices of the mesh was"):
        interpolating(CUBE.with_vertices(np.where(CUBE.vertices == 0.0, np.nan, 1.0)))
