import numpy as np
from helpers.surfaces.quad_grids import grid_mesh, hilly_net

from bodymeasure.subdivision import (
    children,
    fill_pinches,
    limit_positions,
    part,
    quads_within,
    subdivide,
)

MESH = grid_mesh(hilly_net(9, 9))


def test_rings_grow_by_one_quad_each_way() -> None:
    middle = np.array([40])
    for rings in (1, 2, 3):
        chosen = quads_within(MESH, middle, rings).reshape(8, 8)
        expected = np.zeros((8, 8), dtype=bool)
        expected[4 - rings : 4 + rings, 4 - rings : 4 + rings] = True
        np.testing.assert_array_equal(chosen, expected)


def test_a_part_with_a_margin_has_the_limits_of_the_whole() -> None:
    inner = quads_within(MESH, np.array([40]), 1)
    kept = quads_within(MESH, np.unique(MESH.quads[inner]), 1)
    whole, cut = MESH, part(MESH, kept)[0]
    for steps in range(3):
        of_whole = limit_positions(whole)[whole.quads[children(inner, steps)]]
        of_part = limit_positions(cut)[cut.quads[children(inner[kept], steps)]]
        np.testing.assert_allclose(of_part, of_whole, rtol=0, atol=1e-14)
        whole, cut = subdivide(whole), subdivide(cut)


def test_a_part_keeps_order_and_says_where_its_vertices_come_from() -> None:
    chosen = np.zeros(len(MESH.quads), dtype=bool)
    chosen[[3, 17, 20]] = True
    cut, numbers = part(MESH, chosen)
    np.testing.assert_array_equal(numbers[cut.quads], MESH.quads[chosen])
    np.testing.assert_array_equal(cut.vertices, MESH.vertices[numbers])


def test_quads_that_touch_at_a_vertex_are_joined() -> None:
    checkers = np.zeros((8, 8), dtype=bool)
    checkers[2, 2] = checkers[3, 3] = True
    filled = fill_pinches(MESH, checkers.ravel()).reshape(8, 8)
    assert filled.sum() == 4
    assert filled[2:4, 2:4].all()
    # Filling may make new pinches: three quads in a diagonal become two full blocks.
    checkers[4, 4] = True
    assert fill_pinches(MESH, checkers.ravel()).sum() == 7
    whole = np.ones(64, dtype=bool)
    np.testing.assert_array_equal(fill_pinches(MESH, whole), whole)
