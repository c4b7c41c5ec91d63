import numpy as np
import pytest

from bodymeasure.oracle.extrapolate import richardson

LEVELS = (5, 10, 15, 20)


def test_an_error_of_second_order_vanishes() -> None:
    steps = 1 / np.array(LEVELS)
    by_level = np.array([3.0, 7.0])[:, None] - np.array([0.5, -0.2])[:, None] * steps**2
    length, uncertainty = richardson(by_level, LEVELS)
    np.testing.assert_allclose(length, [3.0, 7.0], rtol=1e-15)
    # The uncertainty is not zero, since the levels could agree by chance.
    np.testing.assert_allclose(uncertainty, 0.02 * np.array([0.5, 0.2]) / 20**2, rtol=1e-9)


@pytest.mark.parametrize("order", [2.5, 3.0, 4.0])
def test_the_uncertainty_covers_other_orders(order: float) -> None:
    steps = 1 / np.array(LEVELS)
    length, uncertainty = richardson(1.0 + steps**2 + steps**order, LEVELS)
    assert 0 < abs(length - 1.0) < uncertainty < 100 * abs(length - 1.0)


def test_erratic_levels_are_uncertain() -> None:
    length, uncertainty = richardson([1.0, 1.02, 0.99, 1.01], LEVELS)
    assert uncertainty > 0.02
    assert abs(length - 1.0) < uncertainty


def test_two_levels_give_their_whole_correction() -> None:
    length, uncertainty = richardson([1.0 - 4e-2, 1.0 - 1e-2], (5, 10))
    assert length == pytest.approx(1.0, rel=1e-15)
    assert uncertainty == pytest.approx(1e-2, rel=1e-12)
