import numpy as np
import pytest

from bodymeasure.geodesic.lengths.arc_length_times import times_at
from bodymeasure.geodesic.spaces.quadrature import Quadrature

PARTS = np.linspace(0.0, 1.0, 23)


@pytest.mark.parametrize("edges", [[0.0, 1.0], [0.0, 0.2, 0.7, 1.0]])
def test_the_arc_length_of_known_speeds(edges: list[float]) -> None:
    rule = Quadrature(np.array(edges), 24)
    # Arc lengths t, t + t^2 and (exp(3 t) - 1) / 3.
    speed = np.stack([0.0 * rule.points + 1.0, 1.0 + 2.0 * rule.points, np.exp(3.0 * rule.points)])
    times = times_at(rule, speed, PARTS)
    expected = [
        PARTS,
        -0.5 + np.sqrt(0.25 + 2.0 * PARTS),
        np.log1p(PARTS * np.expm1(3.0)) / 3.0,
    ]
    np.testing.assert_allclose(times, expected, atol=1e-14)


def test_speeds_that_vary_a_thousandfold(rng: np.random.Generator) -> None:
    rule = Quadrature(np.array([0.0, 1.0]), 40)
    speed = 1e-3 + rng.random((50, 1)) * (rule.points - rng.random((50, 1))) ** 2
    times = times_at(rule, speed, PARTS)
    assert ((times >= 0.0) & (times <= 1.0)).all()
    assert (np.diff(times, axis=1) > 0.0).all()


def test_times_are_found_to_rounding_errors(rng: np.random.Generator) -> None:
    rule = Quadrature(np.array([0.0, 1.0]), 40)
    slope = rng.uniform(0.0, 3.0, (200, 1))
    times = times_at(rule, 1.0 + slope * rule.points, PARTS)
    gone = times + 0.5 * slope * times**2
    np.testing.assert_allclose(gone, (1.0 + 0.5 * slope) * PARTS, atol=2e-15)
