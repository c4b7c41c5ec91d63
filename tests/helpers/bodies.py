"""The sample bodies, and what several tests need of them."""

from functools import cache

import pytest

from bodymeasure.atlas import AtlasPoint
from bodymeasure.measure import fork_point
from bodymeasure.samples import load_sample

BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")
# What holds for each of them is tried with one body by the fast tests, with the others by the slow.
QUICK_BODY = "female_average"
ONE_QUICKLY = [
    pytest.param(name, marks=() if name == QUICK_BODY else pytest.mark.slow) for name in BODIES
]


@cache
def armpits(body: str) -> tuple[AtlasPoint, AtlasPoint]:
    """The left and the right armpit of a sample body, where the arm leaves the trunk."""
    atlas = load_sample(body)
    left, right = (fork_point(atlas, ("torso", f"upper arm {side}")) for side in ("left", "right"))
    return left, right
