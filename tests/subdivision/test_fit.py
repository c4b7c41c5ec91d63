"""Patches fitted to the surface at irregular quads."""

import numpy as np
import pytest
from helpers.surfaces.quad_grids import grid_mesh, hilly_net
from helpers.surfaces.solids import CUBE, blob, quad_mesh

from bodymeasure.subdivision import (
    PolygonMesh,
    fitted,
    irregular_quads,
    limit_deviation,
    loop_schaefer,
)

POINTS = hilly_net(8, 7)
GRID = quad_mesh(POINTS.reshape(-1, 3), grid_mesh(POINTS).quads)
CREASE = np.array([[22, 23], [23, 24]])
DART = PolygonMesh(GRID.vertices, GRID.corners, GRID.sizes, CREASE)
CUSP = PolygonMesh(GRID.vertices, GRID.corners, GRID.sizes, GRID.creases, tagged=(24,))


@pytest.mark.parametrize(
    ("mesh", "distance", "stretch"),
    [(CUBE, 1.8, 1.4), (blob(1), 2.0, 2.0), (DART, 8.0, 8.0), (CUSP, 1.5, 2.0)],
    ids=["cube", "blob", "dart", "cusp"],
)
def test_fitted_patches_deviate_less(mesh: PolygonMesh, distance: float, stretch: float) -> None:
    before = loop_schaefer(mesh)
    after = fitted(mesh, before)
    old, new = (limit_deviation(mesh, nets) for nets in (before, after))
    assert distance * new.distance.max() < old.distance.max()
    assert stretch * new.stretch.mean() < old.stretch.mean()
    # Neighbors share their edges as before, and corners and regular patches stay.
    np.testing.assert_array_equal(after.index, before.index)
    corners = before.index[:, ::3, ::3]
    np.testing.assert_array_equal(after.points[corners], before.points[corners])
    regular = before.index[~irregular_quads(mesh)]
    np.testing.assert_array_equal(after.points[regular], before.points[regular])


def test_regular_patches_are_left_alone() -> None:
    nets = loop_schaefer(GRID)
    assert fitted(GRID, nets) is nets
