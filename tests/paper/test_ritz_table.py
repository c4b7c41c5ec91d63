import math
from fractions import Fraction

import numpy as np
import pytest
from helpers.surfaces.random_patches import wild_patches
from helpers.surfaces.surfaces import (
    ENNEPER,
    HYPERBOLIC_PARABOLOID,
    PARABOLOID,
    PH_CYLINDER,
    bicubic,
)
from scipy.integrate import quad

from bodymeasure import InputError
from bodymeasure._typing import Array
from bodymeasure.paper.data.truth import true_diagonals
from bodymeasure.paper.method.ritz_table import solve_ritz

KNOWN = {
    "enneper": (ENNEPER, 5.0 * math.sqrt(2.0) / 3.0),
    "paraboloid": (PARABOLOID, 3.0 / math.sqrt(2.0) + math.asinh(2.0 * math.sqrt(2.0)) / 4.0),
    "hyperbolic": (HYPERBOLIC_PARABOLOID, math.sqrt(6.0) / 2.0 + math.asinh(math.sqrt(2.0)) / 2.0),
    "cylinder": (PH_CYLINDER, 5.0),
}
# A plane on which the straight line from corner to corner, x = y, runs back in u: there
# u = t + t (1 - t) (4 - 7 t), v = t.
TURNING = bicubic(
    {(1, 0): 1, (0, 1): -4, (0, 2): 11, (0, 3): -7},
    {(0, 1): 1},
    {},
)


@pytest.mark.parametrize(("net", "length"), KNOWN.values(), ids=KNOWN.keys())
def test_lengths_in_closed_form(net: Array, length: float) -> None:
    solution = solve_ritz(net[None], error_bound=1e-11, max_order=20)
    assert solution.stopped[0]
    assert solution.inside[0]
    assert solution.length[0] == pytest.approx(length, rel=1e-10)


def test_the_order_grows_until_the_change_is_under_the_bound(rng: np.random.Generator) -> None:
    nets = wild_patches(rng, 20, 1.0)
    coarse, fine = (solve_ritz(nets, error_bound=bound) for bound in (1e-3, 1e-6))
    assert (coarse.order <= fine.order).all()
    assert (fine.length <= coarse.length).all()
    for solution, bound in ((coarse, 1e-3), (fine, 1e-6)):
        np.testing.assert_array_equal(solution.stopped, solution.change <= bound)
        assert solution.stopped.sum() > 10
        assert (solution.order[~solution.stopped] == 16).all()


def test_where_the_true_path_turns_back_ritz_cannot_follow() -> None:
    truth, ritz = true_diagonals(TURNING[None]), solve_ritz(TURNING[None])
    assert truth.length[0] == pytest.approx(math.sqrt(2.0), rel=1e-9)
    assert (truth.turns_back[0], truth.along_edge[0]) == (True, False)
    assert ritz.length[0] > 1.01 * truth.length[0]
    # With u and v exchanged the path is a function again.
    turned = TURNING.swapaxes(0, 1)[None]
    assert not true_diagonals(turned).turns_back[0]
    assert solve_ritz(turned).length[0] == pytest.approx(math.sqrt(2.0), rel=1e-5)


def test_the_rule_to_stop_may_stop_too_early() -> None:
    # v = t + 3 t (1 - t) (1 - 2 t) along the straight line: odd about the middle, so that the
    # second order, which is even, changes nothing.
    net = bicubic({(1, 0): 1}, {(0, 1): 1, (1, 0): -3, (2, 0): 9, (3, 0): -6}, {})
    solution = solve_ritz(net[None])
    assert (solution.order[0], solution.stopped[0]) == (2, True)
    assert solution.length[0] > 1.1 * math.sqrt(2.0)


def test_paths_along_an_edge_are_told() -> None:
    # A plane that lies above the curve y = 4x - 3x^2, from (0, 0) to (1, 3/2): the path follows the
    # curve up to the tangent through its end, at 3x^2 - 6x + 5/2 = 0.
    net = bicubic(
        {(1, 0): 1},
        {(1, 0): 4, (2, 0): -3, (0, 1): Fraction(3, 2), (1, 1): -4, (2, 1): 3},
        {},
    )
    leaves = 1.0 - math.sqrt(6.0) / 6.0
    along = quad(lambda x: math.hypot(1.0, 4.0 - 6.0 * x), 0.0, leaves, epsabs=1e-14)[0]
    straight = math.hypot(1.0 - leaves, 1.5 - 4.0 * leaves + 3.0 * leaves**2)
    truth, ritz = true_diagonals(net[None]), solve_ritz(net[None])
    assert (truth.along_edge[0], truth.turns_back[0]) == (True, False)
    assert truth.length[0] == pytest.approx(along + straight, rel=1e-8)
    # Nothing keeps Ritz's method in the patch, and so it takes the straight line.
    assert not ritz.inside[0]
    assert ritz.length[0] == pytest.approx(math.hypot(1.0, 1.5), rel=1e-5)


def test_what_makes_no_sense_is_refused() -> None:
    with pytest.raises(InputError, match=r"error_bound is -1\.0; expected a positive number"):
        solve_ritz(ENNEPER[None], error_bound=-1.0)
    with pytest.raises(InputError, match="max_order is 1; expected a whole number of at least 2"):
        solve_ritz(ENNEPER[None], max_order=1)
