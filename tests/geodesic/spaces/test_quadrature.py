from math import factorial

import numpy as np
import pytest

from bodymeasure.geodesic.spaces.quadrature import Quadrature


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


@pytest.mark.parametrize("edges", [[0.0, 1.0], [0.0, 0.1, 0.35, 1.0]])
def test_antiderivatives_of_polynomials_are_exact(edges: list[float]) -> None:
    rule = Quadrature(np.array(edges), 6)
    for degree in range(6):
        np.testing.assert_allclose(
            rule.antiderivative @ rule.points**degree,
            rule.points ** (degree + 1) / (degree + 1),
            rtol=1e-13,
            atol=1e-15,
        )


def test_many_functions_at_once() -> None:
    rule = Quadrature(np.array([0.0, 0.5, 1.0]), 8)
    values = np.stack([rule.points, rule.points**2], axis=1) + 1.0
    np.testing.assert_allclose(rule.integrate(values), [1.5, 4.0 / 3.0], rtol=1e-15)
    assert rule.error_estimate(values).shape == (2,)


@pytest.mark.parametrize("count", [16, 24, 40, 96])
@pytest.mark.parametrize("pieces", [1, 3])
def test_its_error_estimate_is_close_above_the_error(
    count: int, pieces: int, rng: np.random.Generator
) -> None:
    # Speeds are square roots of polynomials, whose complex roots lie beside [0, 1], near and far.
    centers, beside = rng.uniform(-0.1, 1.1, 4000), 10.0 ** rng.uniform(-2.5, 0.5, 4000)
    rule = Quadrature(np.linspace(0.0, 1.0, pieces + 1), count)
    speed = np.hypot(rule.points[:, None] - centers, beside)
    # The integral of hypot(x, b) is (x hypot(x, b) + b^2 asinh(x / b)) / 2.
    ends = np.array([1.0, 0.0])[:, None] - centers
    exact, below = 0.5 * (ends * np.hypot(ends, beside) + beside**2 * np.arcsinh(ends / beside))
    exact -= below
    error = np.abs(rule.integrate(speed) - exact)
    estimate = rule.error_estimate(speed)
    # `length_error` takes nine times the estimate, and adds what is due to rounding errors.
    rounding = 1e-14 * exact
    assert np.mean(error <= 9.0 * estimate + rounding) >= (0.97 if count < 24 else 0.99)
    assert (error <= 300.0 * estimate + rounding).all()
    clear = error > 1e-13 * exact
    if clear.any():
        assert np.median(estimate[clear] / error[clear]) < 20.0


def test_an_estimate_of_nothing_to_estimate_is_zero() -> None:
    rule = Quadrature(np.array([0.0, 1.0]), 8)
    with np.errstate(invalid="ignore"):
        assert rule.error_estimate(np.zeros((8, 1)))[0] == 0.0
        assert np.isnan(rule.error_estimate(np.full((8, 1), np.nan))[0])


def test_an_estimate_of_a_polynomial_within_reach_is_rounding() -> None:
    rule = Quadrature(np.array([0.0, 1.0]), 12)
    assert rule.error_estimate(1.0 + rule.points[:, None] ** 8)[0] < 1e-28
