"""Charts of random bodies: all is measured, and what has to be larger is.

``python tests/benchmarks/bodies/chart.py --random 100`` charts more of them.
"""

import numpy as np
import pytest
from helpers.body_space import random_body

from bodymeasure.atlas import Severity, check_atlas
from bodymeasure.chart import Chart, Outcome, measure_chart
from bodymeasure.samples import load_sample

# Of the first bodies, those whose charts take longest, since their paths are hardest to find.
NUMBERS = (0, 10, 15, 16, 22, 24, 37, 39)
# Lengths of which the first is the larger one, on whatever body.
LARGER = (
    ("waist_girth", "natural_waist_girth"),
    ("neck_base_girth", "neck_girth"),
    ("bust_girth", "underbust_girth"),
    ("hip_girth", "thigh_girth_left"),
    ("thigh_girth_left", "mid_thigh_girth_left"),
    ("mid_thigh_girth_left", "knee_girth_left"),
    ("calf_girth_left", "ankle_girth_left"),
    ("upper_arm_girth_left", "wrist_girth_left"),
    ("armscye_girth_left", "upper_arm_girth_left"),
    ("across_back_width", "across_front_width"),
    ("shoulder_width", "shoulder_breadth"),
    ("arm_length_left", "upper_arm_length_left"),
    ("front_neck_to_waist", "bust_to_waist_left"),
)
HEIGHTS = (
    "back_neck",
    "shoulder",
    "armpit",
    "bust",
    "waist",
    "top_hip",
    "hip",
    "upper_thigh",
    "knee",
)
# The arms, legs and sides of these bodies differ by a few percent.
ASYMMETRY = 0.08


@pytest.mark.slow
@pytest.mark.parametrize("number", NUMBERS)
def test_all_of_a_random_body_is_measured(number: int) -> None:
    body = random_body(number)
    assert [one.message for one in check_atlas(body) if one.severity == Severity.ERROR] == []
    chart = measure_chart(body)
    lost = {
        one.definition.key: one.reason
        for one in chart.measured
        if one.outcome is not Outcome.MEASURED
    }
    # These atlases end at the neck, the wrists and the ankles.
    whole = set(load_sample("female_average").given)
    assert set(lost) <= whole, lost
    for one in chart.measured:
        if one.definition.key in whole:
            continue
        assert 0.0 <= one.error_estimate <= 1e-5 * one.value, one.definition.key
        if np.isfinite(one.taut) and np.isfinite(one.contact):
            assert one.gap >= -one.error_estimate, one.definition.key
    assert_in_order(chart)


def assert_in_order(chart: Chart) -> None:
    value = {one.definition.key: one.value for one in chart.measured}
    for larger, smaller in LARGER:
        assert not value[larger] < value[smaller], (larger, smaller)
    sided = ("shoulder", "armpit", "bust", "waist", "top_hip", "hip", "upper_thigh", "knee")
    heights = [value[f"{part}_height{'_left' if part in sided else ''}"] for part in HEIGHTS]
    assert heights == sorted(heights, reverse=True)
    # Beside the arms: a level below both armpits, and a tape through the shoulder and the armpit.
    at = {name: chart.atlas.position(point) for name, point in chart.landmarks.items()}
    for side in ("left", "right"):
        assert at["high bust level point"][2] < at[f"armpit point {side}"][2]
        assert at["high bust level point"][2] > at[f"bust point {side}"][2]
        across = np.linalg.norm(at[f"shoulder point {side}"] - at[f"armpit point {side}"])
        assert 2.0 * across < value[f"armscye_girth_{side}"] < 5.0 * across
    assert 0.8 < value["high_bust_girth"] / value["bust_girth"] < 1.08
    for key, left in value.items():
        if np.isfinite(left) and key.endswith("_left") and "slope" not in key:
            right = value[key.removesuffix("left") + "right"]
            assert abs(left - right) <= ASYMMETRY * max(left, right), key
