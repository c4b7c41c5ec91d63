from __future__ import annotations

import numpy as np
import pytest

import bodymeasure as bm
from bodymeasure.atlas import Atlas
from bodymeasure.samples import load_sample


@pytest.fixture(scope="session")
def body() -> Atlas:
    return load_sample("female_average")


@pytest.fixture
def square() -> Atlas:
    """A flat square of 10 cm, upright, facing the front."""
    ticks = np.linspace(0.0, 0.1, 4)
    net = np.zeros((4, 4, 3))
    net[..., 0], net[..., 2] = ticks[:, None], ticks
    return bm.Atlas.from_control_points(net, "m")
