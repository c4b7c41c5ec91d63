import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.interpolate import BPoly

from bodymeasure.bezier import bernstein

degrees = st.integers(0, 8)
parameters = st.floats(0.0, 1.0)


@given(degrees, parameters)
def test_the_basis_is_a_partition_of_unity(degree: int, t: float) -> None:
    basis = bernstein(degree, t, order=2)
    assert basis.shape == (3, degree + 1)
    assert basis[0].min() >= 0.0
    assert basis[0].sum() == pytest.approx(1.0, abs=1e-14)
    assert basis[1:].sum(axis=-1) == pytest.approx([0.0, 0.0], abs=1e-12)


@given(degrees, parameters)
def test_reversing_the_parameter_reverses_the_basis(degree: int, t: float) -> None:
    there = bernstein(degree, t, order=3)
    back = bernstein(degree, 1.0 - t, order=3)[:, ::-1]
    signs = np.array([1.0, -1.0, 1.0, -1.0])[:, None]
    np.testing.assert_allclose(there, signs * back, rtol=0.0, atol=1e-11)


@pytest.mark.parametrize("degree", range(7))
def test_values_are_binomials_times_powers(degree: int) -> None:
    t = np.linspace(-0.5, 1.5, 9)
    expected = np.stack(
        [math.comb(degree, i) * t**i * (1.0 - t) ** (degree - i) for i in range(degree + 1)],
        axis=-1,
    )
    np.testing.assert_allclose(bernstein(degree, t)[:, 0], expected, rtol=1e-13, atol=1e-13)


@pytest.mark.parametrize("degree", range(7))
def test_derivatives_agree_with_scipy(degree: int) -> None:
    t = np.linspace(0.0, 1.0, 11)
    basis = bernstein(degree, t, order=4)
    for i in range(degree + 1):
        polynomial = BPoly(np.eye(degree + 1)[i][:, None], [0.0, 1.0])
        for k in range(min(degree, 4) + 1):
            expected = polynomial.derivative(k)(t) if k else polynomial(t)
            np.testing.assert_allclose(basis[:, k, i], expected, rtol=1e-12, atol=1e-11)


def test_derivatives_beyond_the_degree_are_zero() -> None:
    assert not bernstein(2, [0.1, 0.7], order=5)[:, 3:].any()


def test_ends_are_exact() -> None:
    # Patches share a seam to the last bit only if the basis is exactly 0 and 1 there.
    assert bernstein(3, 0.0)[0].tolist() == [1.0, 0.0, 0.0, 0.0]
    assert bernstein(3, 1.0)[0].tolist() == [0.0, 0.0, 0.0, 1.0]
