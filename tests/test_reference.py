"""The reference for lengths, compared itself with closed forms and its own limits."""

import numpy as np
import pytest
from helpers.oracles.reference import chebyshev_times, reference_lengths
from helpers.surfaces.surfaces import SURFACES, Surface


@pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
def test_it_finds_the_lengths_that_are_known(surface: Surface) -> None:
    length = reference_lengths(surface.control_points[None], surface.start, surface.end)
    np.testing.assert_allclose(length, surface.length, rtol=1e-13)


def test_it_gives_no_length_that_it_does_not_know() -> None:
    # The surface has a fold along u = const, which no smooth path crosses.
    u, v = np.meshgrid([0.0, 2.0, -1.0, 1.0], np.linspace(0.0, 1.0, 4), indexing="ij")
    folded = np.stack([u, v, np.zeros_like(u)], axis=-1)
    assert np.isnan(reference_lengths(folded[None], (0.0, 0.0), (1.0, 1.0)))


def test_a_guess_may_have_any_number_of_nodes() -> None:
    surface = SURFACES[0]
    t = chebyshev_times(9)[:, None]
    bowed = t + 0.1 * np.array([1.0, -1.0]) * t * (1.0 - t)
    length = reference_lengths(
        surface.control_points[None], surface.start, surface.end, bowed[None]
    )
    np.testing.assert_allclose(length, surface.length, rtol=1e-13)
