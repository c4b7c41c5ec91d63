"""Splitting, restricting and degree elevation do not move the surface."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from bodymeasure.bezier import elevate, evaluate, restrict, split

nets = arrays(np.float64, (4, 4, 3), elements=st.floats(-10.0, 10.0))
unit = st.floats(0.0, 1.0)
grid = np.stack(np.meshgrid(np.linspace(0, 1, 5), np.linspace(0, 1, 4), indexing="ij"), axis=-1)


@given(nets, unit, unit)
def test_parts_of_a_split_lie_on_the_patch(net: np.ndarray, u: float, v: float) -> None:
    parts = split(net, u, v)
    cuts_u, cuts_v = (0.0, u, 1.0), (0.0, v, 1.0)
    for i in (0, 1):
        for j in (0, 1):
            lower = np.array([cuts_u[i], cuts_v[j]])
            upper = np.array([cuts_u[i + 1], cuts_v[j + 1]])
            np.testing.assert_allclose(
                evaluate(parts[i, j], grid),
                evaluate(net, lower + grid * (upper - lower)),
                rtol=0.0,
                atol=1e-12,
            )


@given(nets, unit, unit)
def test_parts_of_a_split_share_their_edges_to_the_last_bit(
    net: np.ndarray, u: float, v: float
) -> None:
    parts = split(net, u, v)
    np.testing.assert_array_equal(parts[0, :, -1], parts[1, :, 0])
    np.testing.assert_array_equal(parts[:, 0, :, -1], parts[:, 1, :, 0])


@given(nets, unit, unit, unit, unit)
def test_a_restriction_runs_from_lower_to_upper(
    net: np.ndarray, u0: float, v0: float, u1: float, v1: float
) -> None:
    lower, upper = np.array([u0, v0]), np.array([u1, v1])
    np.testing.assert_allclose(
        evaluate(restrict(net, lower, upper), grid),
        evaluate(net, lower + grid * (upper - lower)),
        rtol=0.0,
        atol=1e-12,
    )


def test_a_restriction_to_the_whole_turned_round_reverses_the_rows(
    rng: np.random.Generator,
) -> None:
    net = rng.normal(size=(4, 4, 3))
    np.testing.assert_array_equal(restrict(net, (1.0, 0.0), (0.0, 1.0)), net[::-1])


@given(nets, st.integers(3, 6), st.integers(3, 6))
def test_elevation_keeps_the_surface(net: np.ndarray, degree_u: int, degree_v: int) -> None:
    raised = elevate(net, degree_u, degree_v)
    assert raised.shape == (degree_u + 1, degree_v + 1, 3)
    np.testing.assert_allclose(evaluate(raised, grid), evaluate(net, grid), rtol=0.0, atol=1e-12)


def test_elevation_does_not_lower_a_degree() -> None:
    with pytest.raises(ValueError, match="degree 3 cannot be written with degree 2"):
        elevate(np.zeros((4, 4, 3)), 3, 2)


def test_batches_are_loops(rng: np.random.Generator) -> None:
    net = rng.normal(size=(2, 3, 4, 4, 3))
    lower, upper = rng.random((2, 2, 3, 2))
    for index in np.ndindex(2, 3):
        for batch, alone in (
            (split(net, 0.3, 0.6), split(net[index], 0.3, 0.6)),
            (elevate(net, 5, 4), elevate(net[index], 5, 4)),
            (restrict(net, lower, upper), restrict(net[index], lower[index], upper[index])),
        ):
            np.testing.assert_allclose(batch[index], alone, rtol=0.0, atol=1e-13)
