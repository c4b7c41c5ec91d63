"""Taut tapes over extruded profiles, with sharp kinks and without, against hulls of the profile."""

import numpy as np
import pytest
from helpers.oracles.extruded_hulls import ProfileCase, random_profile
from helpers.speed import quick

import bodymeasure as bm

# The arc length of the hull is known to this.
KNOWN = 1e-10
KINKED = ProfileCase(
    np.array([0.1, -0.2, 0.0, 0.3, -0.2, 0.0, -0.1, -0.2, -0.2, 0.0]),
    (0.123, 0.41),
    (1.203, -0.555),
    True,
)
SMOOTH = ProfileCase(np.array([0.57, 0.84, -0.31, 0.59]), (0.117, 0.444), (0.902, 0.561), True)
# Valleys and ridges of 118 degrees, from one side of which the other is the closest.
SHARP = ProfileCase(
    np.array([-0.46, -0.5, -0.41, 0.13, -0.07, -0.62, 0.06, -0.41, 0.34, -0.06]),
    (2.546, 0.385),
    (0.933, 0.367),
    True,
)


def drawn(case: ProfileCase) -> bm.TautTape:
    return bm.taut_tape(
        case.atlas,
        *case.points,
        outside="along normals" if case.above else "against normals",
        on_failure="status",
    )


@pytest.mark.parametrize("case", quick([KINKED, SMOOTH, SHARP]), ids=["kinked", "smooth", "sharp"])
@pytest.mark.parametrize("turned", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_profiles_that_were_wrong(case: ProfileCase, *, turned: bool) -> None:
    if turned:
        case = case._replace(start=case.end, end=case.start)
    tape = drawn(case)
    assert tape.status is bm.TautStatus.CONVERGED
    assert abs(tape.length - case.length) <= tape.error_estimate + KNOWN
    assert tape.error_estimate <= 2e-6 * tape.length


@pytest.mark.slow
def test_random_profiles() -> None:
    for number in range(40):
        case = random_profile(np.random.default_rng([77, number]))
        tape = drawn(case)
        assert tape.converged, number
        assert abs(tape.length - case.length) <= tape.error_estimate + KNOWN, number
        assert tape.error_estimate <= 5e-6 * tape.length, number
