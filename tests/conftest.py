from __future__ import annotations

import os

import numpy as np
import pytest
from hypothesis import HealthCheck, settings

# No deadlines: shared machines stall. In CI the examples are the same each time, so that a red run
# means a change; on a developer's machine they differ and explore.
settings.register_profile(
    "local", deadline=None, max_examples=50, suppress_health_check=[HealthCheck.too_slow]
)
settings.register_profile("ci", settings.get_profile("local"), derandomize=True, print_blob=True)
settings.load_profile("ci" if os.environ.get("CI") else "local")


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(20240229)
