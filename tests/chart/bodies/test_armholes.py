"""The girths beside the arms: high bust and armscye."""

from collections.abc import Collection
from dataclasses import replace as replace_fields

import numpy as np
import pytest
from helpers.body_space import random_body
from msgspec.structs import replace

from bodymeasure import load_sample
from bodymeasure.atlas import Atlas, closest_point
from bodymeasure.chart import Chart, load_definitions, measure_chart


def chart_of(atlas: Atlas, keys: Collection[str], rules: Collection[str]) -> Chart:
    every = load_definitions()
    return measure_chart(
        atlas,
        replace(
            every,
            measurement=tuple(one for one in every.measurement if one.key in keys),
            landmark=tuple(rule for rule in every.landmark if rule.name in rules),
        ),
    )


@pytest.mark.slow
def test_the_tape_of_an_armhole_has_no_corner() -> None:
    body = load_sample("male_average")
    chart = chart_of(body, ["armscye_girth_{side}"], ["armpit point {side}"])
    left, right = chart.measured
    assert right.value == pytest.approx(left.value, rel=1e-9)
    points = left.tapes[0].points
    for name in ("shoulder point left", "armpit point left"):
        place = body.position(chart.landmarks[name])
        assert np.linalg.norm(points - place, axis=1).min() < 0.005
    steps = np.diff(points, axis=0)
    steps = steps[np.linalg.norm(steps, axis=1) > 1e-4]
    steps /= np.linalg.norm(steps, axis=1)[:, None]
    turns = np.degrees(np.arccos(np.clip((steps * np.roll(steps, -1, axis=0)).sum(axis=1), -1, 1)))
    # Once round, evenly: before, it turned by 63 degrees at one point.
    assert turns.sum() == pytest.approx(360.0, abs=10.0)
    assert turns.max() < 15.0


def test_an_armhole_that_runs_on_along_the_trunk_has_no_girth() -> None:
    # With the armpit point on the side of the chest, the plane cuts the trunk from the armpit to
    # the hip: on the body of a scan, that made an armhole of 1.46 m.
    body = load_sample("female_average")
    place = np.array([0.13389332, -0.00919276, 1.16183624])
    low = replace_fields(
        body, landmarks={**body.landmarks, "armpit point left": closest_point(body, place)[0]}
    )
    (left,) = measure_chart(low, only=["armscye_girth_left"]).measured
    assert np.isnan(left.value)
    assert "runs on far beyond them: the plane cuts into the trunk" in left.reason


@pytest.mark.slow
@pytest.mark.parametrize("body", ["female_average", "female_full_bust", "male_average", 2, 15])
def test_the_high_bust_is_taken_below_both_armpits(body: str | int) -> None:
    # On the random bodies, a level just below one armpit merges the trunk with the other arm.
    atlas = load_sample(body) if isinstance(body, str) else random_body(body)
    keys = ("high_bust_girth", "high_bust_front_arc", "bust_girth")
    rules = ("armpit point {side}", "high bust point {side}", "high bust level point")
    chart = chart_of(atlas, keys, rules)
    height = {
        name: float(atlas.position(point) @ atlas.axes.up_vector)
        for name, point in chart.landmarks.items()
    }
    level = height["high bust level point"]
    armpits, busts = (
        [height[f"{name} point {side}"] for side in ("left", "right")]
        for name in ("armpit", "bust")
    )
    assert max(busts) < level < min(armpits)
    # The middle of a tape some two centimeters wide.
    assert 0.005 < min(armpits) - level < 0.025
    high, bust, arc = (chart[key].value for key in ("high_bust_girth", "bust_girth", keys[1]))
    # Men are the widest at the armpits.
    most = 1.06 if body in ("male_average", 15) else 1.03
    assert 0.85 * bust < high < most * bust
    assert 0.4 * high < arc < 0.65 * high
