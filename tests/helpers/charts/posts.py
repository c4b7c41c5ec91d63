"""A round tube that stands like a post, and charts of it."""

from collections.abc import Sequence
from dataclasses import replace

from helpers.surfaces.tubes import joined, tube

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart import (
    Chart,
    Definitions,
    LandmarkRule,
    MeasurementDefinition,
    measure_chart,
)

RADIUS = 1.5
# Directions of the tube's patches where u = 0: to the left, back, right and front.
LEFT, BACK, RIGHT, FRONT = range(4)


def post(radii: Sequence[float] = (RADIUS,) * 4) -> Atlas:
    """A tube with landmarks round its waist and above and below."""
    landmarks = {
        "left": AtlasPoint(LEFT, 0.0, 0.5),
        "right": AtlasPoint(RIGHT, 0.0, 0.5),
        "front": AtlasPoint(FRONT, 0.0, 0.5),
        "back": AtlasPoint(BACK, 0.0, 0.5),
        "low front": AtlasPoint(FRONT, 0.0, 0.25),
        "high front": AtlasPoint(FRONT, 0.0, 0.75),
        "high back": AtlasPoint(BACK, 0.0, 0.75),
        "low left": AtlasPoint(LEFT, 0.0, 0.25),
    }
    tubes = joined([tube(radii)], ["torso"])
    return replace(tubes, landmarks=landmarks)


def chart_of(
    atlas: Atlas, measurements: Sequence[MeasurementDefinition], rules: Sequence[LandmarkRule] = ()
) -> Chart:
    """The chart of some measurements of an atlas."""
    definitions = Definitions(name="Test", landmark=tuple(rules), measurement=tuple(measurements))
    return measure_chart(atlas, definitions)
