import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.interpolate import BPoly

from bodymeasure.bezier import derivatives, evaluate

nets = arrays(np.float64, (4, 4, 3), elements=st.floats(-10.0, 10.0))
places = arrays(np.float64, (2,), elements=st.floats(0.0, 1.0))


def test_derivatives_of_monomials_are_known() -> None:
    # The control points of S = (u^3 v^2, u v^3, u^2), from the blossom of each monomial.
    net = np.empty((4, 4, 3))
    cube, square, line = [0, 0, 0, 1], [0, 0, 1 / 3, 1], [0, 1 / 3, 2 / 3, 1]
    net[..., 0] = np.outer(cube, square)
    net[..., 1] = np.outer(line, cube)
    net[..., 2] = np.outer(square, [1, 1, 1, 1])
    u, v = 0.3, 0.8
    result = derivatives(net, (u, v), order=3)
    powers_u = {
        1: [u, 1.0, 0.0, 0.0],
        2: [u**2, 2 * u, 2.0, 0.0],
        3: [u**3, 3 * u**2, 6 * u, 6.0],
    }
    powers_v = {2: [v**2, 2 * v, 2.0, 0.0], 3: [v**3, 3 * v**2, 6 * v, 6.0]}
    expected = np.stack(
        [
            np.outer(powers_u[3], powers_v[2]),
            np.outer(powers_u[1], powers_v[3]),
            np.outer(powers_u[2], [1.0, 0.0, 0.0, 0.0]),
        ],
        axis=-1,
    )
    np.testing.assert_allclose(result, expected, rtol=0.0, atol=1e-14)


@given(nets, places)
def test_points_agree_with_scipy(net: np.ndarray, place: np.ndarray) -> None:
    u, v = place
    curve = BPoly(net[:, None], [0.0, 1.0])(u)
    expected = BPoly(curve[:, None], [0.0, 1.0])(v)
    np.testing.assert_allclose(evaluate(net, place), expected, rtol=0.0, atol=1e-12)


@pytest.mark.parametrize("order", [1, 2, 3])
def test_each_derivative_is_the_slope_of_the_one_before(
    order: int, rng: np.random.Generator
) -> None:
    # Central differences of a cubic's derivatives have only rounding errors past order one, and
    # h^2 / 6 times the third derivative at order one: Richardson's step removes it.
    net = rng.normal(size=(4, 4, 3))
    place = np.array([0.4, 0.7])

    def slope(axis: int, h: float) -> np.ndarray:
        step = np.eye(2)[axis] * h
        ahead, behind = (derivatives(net, place + sign * step, order=order) for sign in (1, -1))
        return (ahead - behind) / (2 * h)

    exact = derivatives(net, place, order=order)
    for axis in (0, 1):
        slopes = (4 * slope(axis, 0.05) - slope(axis, 0.1)) / 3
        np.testing.assert_allclose(
            np.take(slopes, range(order), axis),
            np.take(exact, range(1, order + 1), axis),
            rtol=0.0,
            atol=1e-11,
        )


def test_swapping_u_and_v_transposes(rng: np.random.Generator) -> None:
    net, place = rng.normal(size=(4, 4, 3)), rng.random((5, 2))
    there = derivatives(net, place, order=3)
    back = derivatives(net.swapaxes(0, 1), place[:, ::-1], order=3)
    np.testing.assert_allclose(there, back.swapaxes(1, 2), rtol=0.0, atol=1e-12)


def test_degrees_may_differ(rng: np.random.Generator) -> None:
    net = rng.normal(size=(3, 6, 3))
    assert derivatives(net, (0.2, 0.3), order=3)[3].any() == np.False_
    np.testing.assert_array_equal(evaluate(net, (0.0, 1.0)), net[0, -1])


def test_a_batch_is_a_loop(rng: np.random.Generator) -> None:
    net = rng.normal(size=(2, 3, 4, 4, 3))
    places = rng.random((2, 3, 5, 7, 2))
    batch = derivatives(net, places, order=2)
    assert batch.shape == (2, 3, 5, 7, 3, 3, 3)
    for i in range(2):
        for j in range(3):
            alone = derivatives(net[i, j], places[i, j], order=2)
            np.testing.assert_allclose(batch[i, j], alone, rtol=0.0, atol=1e-13)


def test_moving_the_control_points_moves_the_surface(rng: np.random.Generator) -> None:
    net, places = rng.normal(size=(4, 4, 3)), rng.random((6, 2))
    matrix, offset = rng.normal(size=(3, 3)), rng.normal(size=3)
    moved = evaluate(net @ matrix.T + offset, places)
    np.testing.assert_allclose(
        moved, evaluate(net, places) @ matrix.T + offset, rtol=0.0, atol=1e-13
    )


def test_parameters_without_the_batch_axes_are_refused() -> None:
    with pytest.raises(ValueError, match=r"shape \(2,\) do not lead with the 1 batch axes"):
        derivatives(np.zeros((5, 4, 4, 3)), (0.5, 0.5), order=1)
