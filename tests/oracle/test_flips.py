"""Distances by edge flips beside libigl's exact ones."""

import numpy as np
import pytest
from helpers.surfaces.surfaces import ENNEPER, PARABOLOID

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.oracle.flips import flip_distances, has_flips
from bodymeasure.oracle.grid import grid_lines, refined_grid
from bodymeasure.oracle.libigl import exact_distance

pytestmark = pytest.mark.skipif(not has_flips(), reason="potpourri3d is not installed")

ENDS = np.array([[0.0, 0.0], [1.0, 1.0]])


@pytest.mark.parametrize("net", [ENNEPER, PARABOLOID], ids=["enneper", "paraboloid"])
def test_they_are_libigls_or_longer(net: Array) -> None:
    pytest.importorskip("igl")
    grid = refined_grid(*grid_lines(ENDS), 4, 3)
    vertices, faces, number = grid.mesh(net)
    pairs = np.random.default_rng(3).integers(0, len(vertices), (12, 2))
    pairs[0] = number[[grid.vertex(point) for point in ENDS]]
    pairs[1, 1] = pairs[1, 0]
    found = flip_distances(vertices, faces, *pairs.T)
    assert found[1] == 0.0
    for length, (source, target) in zip(found, pairs, strict=True):
        if source != target:
            exact = exact_distance(vertices, faces, source, target)
            assert exact * (1.0 - 1e-12) <= length <= exact * (1.0 + 1e-2)


def test_what_cannot_be_measured_is_told() -> None:
    vertices = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1]])
    # Three triangles on one edge.
    faces = np.array([[0, 1, 2], [1, 0, 3], [0, 1, 4]])
    with pytest.raises(InputError, match="potpourri3d"):
        flip_distances(vertices, faces, np.array([2]), np.array([4]))
