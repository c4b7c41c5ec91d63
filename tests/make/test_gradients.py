"""Derivatives of measurements against differences of bodies that are a little different."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from helpers.speed import quick

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.chart import Definitions, derive_landmarks, load_definitions
from bodymeasure.chart.body import Body
from bodymeasure.chart.kinds import KINDS as MEASUREMENTS
from bodymeasure.chart.kinds import ChordMeasure
from bodymeasure.chart.landmarks.rules import RULES
from bodymeasure.chart.selection import restricted
from bodymeasure.chart.sides import both_sides
from bodymeasure.chart.taken import Taken
from bodymeasure.make.body.atlases import atlas_of, point_components
from bodymeasure.make.body.stature import stature_of
from bodymeasure.make.gradient import gradient_of, has_gradient
from bodymeasure.make.gradient.rules import has_derivative

RNG = np.random.default_rng(0)
BODY = 0.6 * RNG.normal(size=120)
WAY = RNG.normal(size=120)
# One of each kind first, and then others.
EXACT = (
    "waist_girth", "shoulder_length_left", "back_neck_to_waist", "waist_breadth", "hip_depth",
    "back_neck_height", "neck_width", "upper_arm_girth_left", "neck_girth", "shoulder_slope_left",
    "front_neck_to_waist", "natural_waist_girth", "waist_front_arc", "crotch_length", "hip_girth",
    "arm_length_left", "high_bust_girth", "armscye_girth_left", "side_neck_to_waist_back_left",
    "top_hip_height_left", "armpit_height_left", "buttock_span", "outer_leg_length_left",
)  # fmt: skip
# What ends at places that are themselves searched for less exactly, or is a string of points.
CLOSE = {
    "calf_girth_left": 1e-5,
    "bust_girth": 2e-6,
    "underbust_girth": 2e-5,
    "bust_front_arc": 1e-4,
    "hip_front_arc": 1e-4,
    "thigh_girth_left": 2e-3,
    "bust_span": 1e-3,
}
LANDMARKS = {
    "side neck end point left": 1e-6,
    "side mid-neck point left": 1e-6,
    "front mid-neck point": 1e-6,
    "armpit point left": 1e-6,
    "buttock point left": 1e-6,
    "waist level point left": 1e-6,
    "high bust level point": 2e-6,
    "underbust point left": 1e-5,
    "side bust point left": 2e-6,
    "lower knee point left": 1e-6,
    "upper belly point left": 2e-6,
}


@cache
def _body(step: float) -> Atlas:
    return atlas_of(BODY + step * WAY)


def _state(atlas: Atlas, definitions: Definitions, key: str) -> tuple[Taken, Array]:
    """The measurement of a body, and its derivative by the coefficients; as a function of both."""
    _, needed = restricted(definitions, [key])
    derived = derive_landmarks(atlas, needed.landmark, strict=False)
    body = Body(atlas, derived.landmarks, derived.missing)
    taken = Taken(body, {one.key: one for one in both_sides(needed.measurement)})
    pull = gradient_of(key, taken, body, derived)
    return taken, np.tensordot(point_components(), pull.weights, 2)


def _value(step: float, definitions: Definitions, key: str) -> float:
    _, needed = restricted(definitions, [key])
    atlas = _body(step)
    derived = derive_landmarks(atlas, needed.landmark, strict=False)
    body = Body(atlas, derived.landmarks, derived.missing)
    return Taken(body, {one.key: one for one in both_sides(needed.measurement)})[key].value


def _misfit(definitions: Definitions, key: str) -> float:
    """How far a derivative along a way is from that by differences, as a part of the whole."""
    _, slopes = _state(_body(0.0), definitions, key)
    h = 1e-3
    near, far = (
        _value(k * h, definitions, key) - _value(-k * h, definitions, key) for k in (1.0, 2.0)
    )
    differences = (8.0 * near - far) / (12.0 * h)
    return float(abs(slopes @ WAY - differences) / np.linalg.norm(slopes))


@pytest.mark.parametrize("key", quick(EXACT, first=9))
def test_derivatives_are_exact(key: str) -> None:
    assert _misfit(load_definitions(), key) < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("key", CLOSE)
def test_derivatives_are_as_exact_as_the_places_that_they_depend_on(key: str) -> None:
    assert _misfit(load_definitions(), key) < CLOSE[key]


@pytest.mark.parametrize("name", quick(LANDMARKS, first=5))
def test_landmarks_by_rule_move_with_the_body(name: str) -> None:
    chord = ChordMeasure(key="c", name="c", start=name, end="elbow point right")
    definitions = Definitions(
        name="chord", landmark=load_definitions().landmark, measurement=(chord,)
    )
    assert _misfit(definitions, "c") < LANDMARKS[name]


def test_the_stature_moves_with_the_body() -> None:
    h = 1e-3
    (_, slopes), high, low = (stature_of(BODY + k * h * WAY) for k in (0.0, 1.0, -1.0))
    assert abs(slopes @ WAY - (high[0] - low[0]) / (2.0 * h)) < 1e-6 * np.linalg.norm(slopes)


def test_a_movement_of_the_whole_body_changes_no_length() -> None:
    definitions, atlas = load_definitions(), _body(0.0)
    for key in ("waist_girth", "shoulder_length_left", "side_neck_to_waist_back_left"):
        _, needed = restricted(definitions, [key])
        derived = derive_landmarks(atlas, needed.landmark, strict=False)
        body = Body(atlas, derived.landmarks, derived.missing)
        taken = Taken(body, {one.key: one for one in both_sides(needed.measurement)})
        weights = gradient_of(key, taken, body, derived).weights
        assert np.abs(weights.sum(axis=0)).max() < 1e-8
        # A larger body has a longer tape in proportion.
        assert float((weights * atlas.points).sum()) == pytest.approx(taken[key].value, rel=1e-6)


def test_all_kinds_and_rules_but_those_of_other_parts_have_derivatives() -> None:
    without = {tag for tag, kind in MEASUREMENTS.items() if not _has(kind)}
    assert without == {"given"}
    rules = {one.tag() for one in load_definitions().landmark}
    known = {one.tag() for one in load_definitions().landmark if has_derivative(one)}
    assert rules == known
    assert set(RULES) - known == {"girth level"}


def _has(kind: type) -> bool:
    examples = [one for one in load_definitions().measurement if isinstance(one, kind)]
    return all(map(has_gradient, examples))


def test_a_copy_of_the_body_has_the_same_derivative() -> None:
    definitions, atlas = load_definitions(), _body(0.0)
    one = _state(atlas, definitions, "knee_girth_left")[1]
    other = _state(replace(atlas, name="copy"), definitions, "knee_girth_left")[1]
    assert np.array_equal(one, other)
