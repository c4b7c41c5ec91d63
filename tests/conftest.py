import os

# Before numpy loads its linear algebra: the tests run in as many processes as there are cores, and
# on small systems more threads only get in each other's way, by a factor of five.
os.environ["OMP_NUM_THREADS"] = os.environ.get("OMP_NUM_THREADS", "1")
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
