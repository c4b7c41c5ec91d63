from collections.abc import Iterator, Mapping
from typing import Any

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
from helpers.charts.straight_survey import straight_survey

import bodymeasure as bm
from bodymeasure.atlas import Atlas
from bodymeasure.chart import Chart
from bodymeasure.samples import load_sample
from bodymeasure.scene import BodyScene, TapeScene, View, body_scene, body_views, tapes_scene
from bodymeasure.scene.drawing import RENDERERS
from bodymeasure.scene.drawing.opengl_check import PYVISTA, SOFTWARE, opengl_trouble
from bodymeasure.scene.drawing.picture import Draw
from bodymeasure.scene.drawing.visibility import Sight, sight
from bodymeasure.scene.tapes.camera import sights
from bodymeasure.scene.tapes.gallery import roomy_views


@pytest.fixture(scope="session")
def body() -> Atlas:
    return load_sample("female_average")


@pytest.fixture(scope="session")
def square() -> Atlas:
    """An upright, flat square of 10 cm that faces the front."""
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


@pytest.fixture(scope="session")
def seen(scene: TapeScene, chart: Chart) -> Mapping[str, Sight]:
    """The parts of the body seen from its four sides, in views with room for labels."""
    views = roomy_views(scene, chart.atlas.axes)
    return {side: sight(scene.surface, view) for side, view in views.items()}


@pytest.fixture(scope="session")
def around(scene: TapeScene, chart: Chart) -> list[Sight]:
    """The parts of the body seen from all around."""
    return sights(scene.surface, chart.atlas.axes, 0.01)


@pytest.fixture(scope="session")
def survey(body: Atlas) -> Any:
    return straight_survey(body)


@pytest.fixture(scope="session")
def survey_scene(survey: Any) -> BodyScene:
    return body_scene(survey)


@pytest.fixture(scope="session")
def views(survey_scene: BodyScene, body: Atlas) -> Mapping[str, View]:
    return body_views(survey_scene, body.axes)


@pytest.fixture(scope="module", params=[SOFTWARE, pytest.param(PYVISTA, marks=pytest.mark.slow)])
def draw(request: pytest.FixtureRequest) -> Iterator[Draw]:
    """A function that draws pictures with the renderer of the test."""
    if request.param == PYVISTA and opengl_trouble():
        pytest.skip(opengl_trouble())
    with RENDERERS[request.param]() as draw:
        yield draw
