import gc
import os
import sys
from pathlib import Path

# This has to be set before numpy loads its linear algebra. The tests run in as many processes as
# there are cores, and more threads slow down small systems by a factor of five.
os.environ["OMP_NUM_THREADS"] = os.environ.get("OMP_NUM_THREADS", "1")
import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, settings

# Compiled modules are kept even where the environment says otherwise: without them, each process
# that a test starts would compile the package anew.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False

# There are no deadlines, since shared machines stall. In CI the examples are the same each time, so
# that a failure means a change; on a developer's machine they differ from run to run.
settings.register_profile(
    "local", deadline=None, max_examples=30, suppress_health_check=[HealthCheck.too_slow]
)
settings.register_profile("ci", settings.get_profile("local"), derandomize=True, print_blob=True)
# Its tests are all marked `browser`.
BROWSER = Path(__file__).parent / "viewer" / "browser"
PROFILE = "ci" if os.environ.get("CI") else "local"
# Each example of a slow test takes a second or more, and shrinking one that fails takes hundreds.
settings.register_profile(
    "slow",
    settings.get_profile(PROFILE),
    phases=(Phase.explicit, Phase.reuse, Phase.generate),
)


def _quick(config: pytest.Config) -> bool:
    """Whether only the fast tests run."""
    return bool(config.getoption("markexpr") == "not slow and not browser")


def pytest_configure(config: pytest.Config) -> None:
    """Choose how examples are made, before the tests are read."""
    settings.load_profile(PROFILE if _quick(config) else "slow")


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Spare the fast tests what drives a browser, which takes half a second to load."""
    return True if _quick(config) and collection_path == BROWSER else None


def pytest_collection_finish() -> None:
    """Take what has been loaded out of the garbage collector's rounds, which it lengthens."""
    gc.collect()
    gc.freeze()


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(20240229)
