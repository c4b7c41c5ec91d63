"""The energy and the length of paths: their derivatives against differences."""

import numpy as np
import pytest
from helpers.surfaces.surfaces import (
    ENNEPER,
    PLANE,
    TANGENT_DEVELOPABLE,
)

from bodymeasure.geodesic.lengths.functionals import Functional, energy, length_over_v
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces


@pytest.mark.parametrize(
    ("functional", "coordinates"),
    [(energy, (0, 1)), (length_over_v, (1,))],
    ids=["energy", "length"],
)
def test_derivatives_of_functionals(
    functional: Functional, coordinates: tuple[int, ...], rng: np.random.Generator
) -> None:
    space = polynomial_space(6)
    surfaces = BezierSurfaces(np.stack([ENNEPER, PLANE, TANGENT_DEVELOPABLE]))
    t = space.nodes
    values = 0.1 + 0.7 * t + rng.uniform(-0.3, 0.3, (3, 2, 1)) * t * (1.0 - t)
    here = functional(surfaces, space, values)
    np.testing.assert_allclose(here.hessian, here.hessian.transpose(0, 2, 1), atol=1e-12)
    unknowns = [(c, k) for c in coordinates for k in range(1, 6)]
    assert here.gradient.shape == (3, len(unknowns))
    for number, (coordinate, node) in enumerate(unknowns):
        slopes, bends = [], []
        for h in (4e-4, 2e-4):
            step = np.zeros_like(values)
            step[:, coordinate, node] = h
            ahead, behind = (functional(surfaces, space, values + sign * step) for sign in (1, -1))
            slopes.append((ahead.value - behind.value) / (2.0 * h))
            bends.append((ahead.gradient - behind.gradient) / (2.0 * h))
        scale = np.abs(here.hessian).max()
        for (coarse, fine), exact in (
            (slopes, here.gradient[:, number]),
            (bends, here.hessian[:, number]),
        ):
            np.testing.assert_allclose((4.0 * fine - coarse) / 3.0, exact, atol=1e-7 * scale)
