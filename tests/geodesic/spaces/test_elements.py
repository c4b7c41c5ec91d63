"""Trial spaces of elements."""

import numpy as np

from bodymeasure.geodesic.spaces.elements import ElementPolynomials, element_space
from bodymeasure.geodesic.spaces.piecewise import PiecewisePolynomials

EDGES = np.array([0.0, 0.2, 0.25, 1.0])


def test_functions_are_cardinal_and_continuous(rng: np.random.Generator) -> None:
    space = element_space(EDGES, 5)
    values = space.matrices(space.nodes)[0]
    np.testing.assert_allclose(values, np.eye(16), atol=1e-14)
    assert space.size == 15
    nodal = rng.normal(size=16)
    beside = space.matrices(np.array([0.2 - 1e-13, 0.2 + 1e-13]))[0] @ nodal
    np.testing.assert_allclose(beside, nodal[5], atol=1e-10)


def test_polynomials_are_exact_with_their_derivatives() -> None:
    space = element_space(EDGES, 5)
    t = np.linspace(0.0, 1.0, 23)
    nodal = space.nodes**5 - space.nodes**2
    found = space.matrices(t) @ nodal
    known = [t**5 - t**2, 5 * t**4 - 2 * t, 20 * t**3 - 2]
    np.testing.assert_allclose(found, known, atol=1e-11)


def test_they_are_those_of_piecewise_polynomials(rng: np.random.Generator) -> None:
    functions = element_space(EDGES, 4).functions
    assert isinstance(functions, ElementPolynomials)
    others = PiecewisePolynomials(EDGES, functions.coefficients)
    t = rng.uniform(size=(2, 7))
    np.testing.assert_allclose(functions(t[0]), others(t[0]), atol=1e-10)
    np.testing.assert_allclose(functions.values(t[0]), others.values(t[0]), atol=1e-14)
    values = rng.normal(size=(2, 2, 13))
    np.testing.assert_allclose(
        functions.combined(values, t), others.combined(values, t), atol=1e-13
    )


def test_leaving_the_patch_between_nodes() -> None:
    space = element_space(EDGES, 2)
    values = np.full((2, 2, 7), 0.5)
    # A parabola through 0, 0 and 1 on the last element dips below zero between its nodes.
    values[1, 0, -3:] = 0.0, 0.0, 1.0
    assert space.leaves_patch(values, 1e-9).tolist() == [False, True]
