"""Landmarks by rule and lengths of head, hands and feet on bodies of the model."""

import numpy as np
import pytest

from bodymeasure.atlas import Atlas
from bodymeasure.chart import Outcome, measure_chart
from bodymeasure.fit.completed import completed
from bodymeasure.fit.model import atlas_of_vertices, shaped


def body(distance: float | None = None) -> Atlas:
    vertices = shaped(np.random.default_rng(1).standard_normal(30))
    away = None if distance is None else np.full(len(vertices), distance)
    return completed(atlas_of_vertices(vertices), vertices, distance=away)


@pytest.mark.slow
def test_a_chart_has_stature_head_and_feet() -> None:
    keys = ["stature", "head_girth", "head_above_neck", "heel_girth", "hand_length"]
    chart = measure_chart(body(0.001), only=keys)
    assert {one.outcome for one in chart.measured} == {Outcome.MEASURED}
    value = {one.definition.key: one.value for one in chart.measured}
    assert 0.2 < value["head_above_neck"] < 0.32
    assert chart["stature"].input_uncertainty == 0.001
    assert chart["head_girth"].input_uncertainty == 0.001 * np.pi
    plain = measure_chart(body(), only=["stature"])
    assert plain["stature"].value == value["stature"]
    assert plain["stature"].input_uncertainty is None


def test_landmarks_by_rule_are_in_the_provenance() -> None:
    assert "side hip point left" in body().provenance["landmarks by rule"]
