from __future__ import annotations

from math import factorial

import numpy as np
import pytest

from bodymeasure.geodesic.quadrature import Quadrature


@pytest.mark.parametrize("edges", [[0.0, 1.0], [0.0, 0.1, 0.35, 1.0]])
@pytest.mark.parametrize("count", [2, 5, 16])
def test_it_is_exact_up_to_degree_2m_minus_1(edges: list[float], count: int) -> None:
    rule = Quadrature(np.array(edges), count)
    assert rule.points.shape == rule.weights.shape == (count * (len(edges) - 1),)
    assert (rule.weights > 0.0).all()
    for degree in range(2 * count):
        assert rule.integrate(np.asarray(rule.points**degree)) == pytest.approx(
            1.0 / (degree + 1), rel=1e-14
        )


@pytest.mark.parametrize("edges", [[0.0, 1.0], [0.0, 0.1, 0.35, 1.0]])
@pytest.mark.parametrize("count", [2, 4])
def test_it_is_off_by_the_known_amount_at_degree_2m(edges: list[float], count: int) -> None:
    rule = Quadrature(np.array(edges), count)
    missing = 1.0 / (2 * count + 1) - float(rule.integrate(np.asarray(rule.points ** (2 * count))))
    constant = factorial(count) ** 4 / ((2 * count + 1) * factorial(2 * count) ** 2)
    expected = constant * float((np.diff(edges) ** (2 * count + 1)).sum())
    assert missing == pytest.approx(expected, rel=1e-9)


def test_many_functions_at_once() -> None:
    rule = Quadrature(np.array([0.0, 0.5, 1.0]), 8)
    values = np.stack([rule.points, rule.points**2], axis=1) + 1.0
    np.testing.assert_allclose(rule.integrate(values), [1.5, 4.0 / 3.0], rtol=1e-15)
    assert rule.error_estimate(values).shape == (2,)


@pytest.mark.parametrize("pole", [0.05, 0.1, 0.3, 1.0])
@pytest.mark.parametrize("pieces", [1, 3])
def test_its_error_estimate_is_close_above_the_error(pole: float, pieces: int) -> None:
    # A speed: the square root of a polynomial, whose complex roots lie `pole` beside [0, 1].
    centers = np.linspace(0.05, 0.95, 7)
    above, factors = True, []
    for center in centers:
        edges = np.linspace(0.0, 1.0, pieces + 1)
        rule, fine = Quadrature(edges, 24), Quadrature(np.linspace(0.0, 1.0, 65), 30)
        speed, exact = (np.hypot(q.points - center, pole) for q in (rule, fine))
        error = abs(float(rule.integrate(speed) - fine.integrate(exact)))
        estimate = float(rule.error_estimate(speed[:, None])[0]) + 1e-15
        # `length_error` takes ten times the estimate.
        above &= error <= 10.0 * estimate
        if error > 1e-14:
            factors.append(estimate / error)
    assert above
    assert not factors or np.median(factors) < 1e3


def test_an_estimate_of_a_polynomial_within_reach_is_rounding() -> None:
    rule = Quadrature(np.array([0.0, 1.0]), 12)
    assert rule.error_estimate(1.0 + rule.points[:, None] ** 9)[0] < 1e-28
