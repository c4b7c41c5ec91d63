import numpy as np
import pytest
from helpers.surfaces.surfaces import ENNEPER, HYPERBOLIC_PARABOLOID, PARABOLOID, bicubic

from bodymeasure import Atlas, ConvergenceError, InputError, RBFCollocation, diagonals
from bodymeasure._typing import Array
from bodymeasure.geodesic import Status, solve_geodesic


def atlas(*nets: Array) -> Atlas:
    return Atlas.from_control_points(np.stack(nets), "cm")


LINE = bicubic({(1, 0): 1}, {}, {})


def test_both_diagonals_of_every_patch() -> None:
    nets = (ENNEPER, PARABOLOID, HYPERBOLIC_PARABOLOID)
    solution = diagonals(atlas(*nets))
    assert solution.shape == (3, 2)
    np.testing.assert_array_equal(solution.start, 3 * [[[0, 0], [1, 0]]])
    np.testing.assert_array_equal(solution.end, 3 * [[[1, 1], [0, 1]]])
    assert solution.length[0, 0] == pytest.approx(5 * np.sqrt(2) / 3, rel=1e-13)
    for i, net in enumerate(nets):
        for k, (start, end) in enumerate((((0, 0), (1, 1)), ((1, 0), (0, 1)))):
            one = solve_geodesic(net, start, end)
            assert solution.length[i, k] == pytest.approx(one.length, rel=1e-14)
    np.testing.assert_allclose(solution.path([0.0, 1.0])[1, 1], [[1, 0], [0, 1]], atol=1e-16)


def test_the_method_is_the_one_that_is_given() -> None:
    method = RBFCollocation(functions=14)
    assert (diagonals(atlas(ENNEPER, PARABOLOID), method=method).functions == 14).all()


def test_failures_raise_unless_statuses_are_asked_for() -> None:
    bad = atlas(ENNEPER, LINE)
    solution = diagonals(bad, on_failure="status")
    np.testing.assert_array_equal(solution.converged, [[True, True], [False, False]])
    assert np.asarray(solution.status)[0, 0] is Status.CONVERGED
    assert np.isnan(solution.length[1]).all()
    with pytest.raises(ConvergenceError, match="2 of 4 geodesics"):
        diagonals(bad)


def test_a_collapsed_patch_is_named() -> None:
    with pytest.raises(InputError, match="patch 'patch 1' is collapsed: all its control"):
        diagonals(atlas(ENNEPER, 0.0 * ENNEPER + 1.0))
