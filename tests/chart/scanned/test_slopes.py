"""The change of a value with its landmarks, against measuring again with landmarks elsewhere."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.charts.scanned import scanned

from bodymeasure import Atlas, Measured, load_sample, measure_chart
from bodymeasure._typing import Array
from bodymeasure.atlas.queries.closest import closest_points

BODY = scanned(load_sample("female_average"))
UP, FRONT, LEFT = (
    BODY.axes.up_vector,
    BODY.axes.front_vector,
    BODY.axes.left_vector,
)
# In meters: so small that the values are linear in it, and so large that rounding does not show.
MOVE = 2e-3
# The slope of an angle, in degrees for a meter, is about the inverse of the line's length.
DEGREES = 400.0


def measured(key: str, body: Atlas = BODY) -> Measured:
    return measure_chart(body, only=[key])[key]


def measured_with(name: str, move: Array, key: str) -> tuple[Measured, Array]:
    """The chart with a landmark moved over the skin, and the movement that it made."""
    before = BODY.position(name)
    points, _ = closest_points(BODY, (before + move)[None])
    moved = replace(BODY, landmarks={**BODY.landmarks, name: points[0]})
    return measured(key, moved), moved.position(name) - before


@pytest.mark.parametrize(
    ("key", "landmark", "direction", "tolerance"),
    [
        ("waist_girth", "front waist point", UP, 0.02),
        pytest.param("bust_girth", "bust point left", UP, 0.02, marks=pytest.mark.slow),
        pytest.param("hip_girth", "side hip point left", UP, 0.02, marks=pytest.mark.slow),
        pytest.param("knee_girth_left", "patella point left", UP, 0.03, marks=pytest.mark.slow),
        ("upper_arm_girth_left", "elbow point left", UP - LEFT, 0.05),
        ("bust_breadth", "bust point left", UP, 0.02),
        pytest.param("waist_depth", "front waist point", UP, 0.02, marks=pytest.mark.slow),
        ("hip_front_arc", "side hip point left", FRONT, 0.05),
        ("back_neck_to_waist", "back waist point", UP, 0.02),
        pytest.param("back_neck_to_waist", "back neck point", UP, 0.05, marks=pytest.mark.slow),
        pytest.param(
            "side_neck_to_waist_back_left",
            "side neck point left",
            LEFT,
            0.1,
            marks=pytest.mark.slow,
        ),
        ("bust_span", "bust point left", LEFT, 0.02),
        pytest.param("crotch_length_front", "front waist point", UP, 0.02, marks=pytest.mark.slow),
        pytest.param("neck_base_girth", "front neck point", UP, 0.05, marks=pytest.mark.slow),
        ("knee_height_left", "patella point left", UP, 1e-9),
        ("body_rise", "side waist point left", UP, 1e-9),
        ("shoulder_chord_left", "shoulder point left", LEFT, 0.02),
        ("shoulder_slope_left", "shoulder point left", LEFT - UP, 0.05),
        pytest.param(
            "waist_to_knee_left", "side waist point left", UP, 0.02, marks=pytest.mark.slow
        ),
    ],
)
def test_slopes_are_those_of_measuring_again(
    key: str, landmark: str, direction: Array, tolerance: float
) -> None:
    slope = measured(key).slopes[landmark]
    higher, there = measured_with(landmark, MOVE * direction, key)
    lower, back = measured_with(landmark, -MOVE * direction, key)
    change = higher.value - lower.value
    size = np.linalg.norm(there - back) * (DEGREES if higher.unit == "deg" else 1.0)
    assert abs(slope @ (there - back) - change) < tolerance * size
    # A slope of nothing would not do.
    assert abs(change) > 2.0 * tolerance * size


def test_a_landmark_to_which_a_value_owes_nothing_has_no_slope() -> None:
    assert measured("calf_girth_left").slopes == {}
    assert list(measured("waist_girth").slopes) == ["front waist point"]
