import numpy as np
import pytest
from helpers.charts.hand_charts import (
    chart_of,
    chord_between,
    girth_at,
    height_of,
    limb_girth_between,
    missing,
    path_between,
)

import bodymeasure as bm
from bodymeasure.atlas import Atlas
from bodymeasure.chart import Chart
from bodymeasure.samples import load_sample
from bodymeasure.scene import TapeScene, tapes_scene


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


@pytest.fixture(scope="session")
def chart(body: Atlas) -> Chart:
    """A few measurements of each kind of tape, and one without a value."""
    return chart_of(
        body,
        [
            missing("cervicale_height"),
            girth_at(body, "bust point left"),
            girth_at(body, "front waist point"),
            limb_girth_between(body, "side hip point left", "patella point left", 0.5),
            limb_girth_between(body, "side hip point right", "patella point right", 0.5),
            path_between(body, "back neck point", "back waist point"),
            chord_between(body, "bust point left", "bust point right"),
            height_of(body, "shoulder point left"),
        ],
    )


@pytest.fixture(scope="session")
def scene(chart: Chart) -> TapeScene:
    return tapes_scene(chart)
