"""The default set: its names, and its measurements of the sample bodies."""

import re
from collections import Counter
from dataclasses import replace
from functools import cache

import msgspec
import numpy as np
import pytest
from helpers.bodies import BODIES
from helpers.files.pattern_names import FREESEWING, SEAMLY

from bodymeasure.atlas import Atlas, Axes
from bodymeasure.chart import (
    Chart,
    Outcome,
    TapeKind,
    both_sides,
    load_definitions,
    measure_chart,
)
from bodymeasure.chart.kinds import FormulaMeasure
from bodymeasure.report.body import GARMENTCODE_KEYS
from bodymeasure.samples import load_sample

DEFAULT = load_definitions()
bodies = pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=pytest.mark.slow) for name in BODIES],
)


@cache
def chart_of(name: str) -> Chart:
    return measure_chart(load_sample(name))


def test_it_has_what_pattern_blocks_need() -> None:
    keys = {one.key for one in DEFAULT.measurement}
    assert len(keys) >= 45
    assert keys >= {
        *("neck_girth", "neck_base_girth", "bust_girth", "underbust_girth", "waist_girth"),
        *("top_hip_girth", "hip_girth", "thigh_girth_{side}", "mid_thigh_girth_{side}"),
        *("knee_girth_{side}", "calf_girth_{side}", "ankle_girth_{side}"),
        *("upper_arm_girth_{side}", "elbow_girth_{side}", "wrist_girth_{side}"),
        *("shoulder_length_{side}", "shoulder_width", "across_back_width", "across_front_width"),
        *("back_neck_to_waist", "front_neck_to_waist", "front_neck_to_waist_between"),
        *("side_neck_to_bust_{side}", "bust_to_waist_{side}", "bust_span", "scye_depth"),
        *("arm_length_{side}", "outer_leg_length_{side}", "inner_leg_length"),
        *("waist_to_hip_{side}", "crotch_length", "trunk_length"),
        *("back_neck_height", "waist_height_{side}", "hip_height_{side}", "knee_height_{side}"),
    }


def test_names_of_pattern_programs_are_theirs_and_used_once() -> None:
    seamly = [name for one in DEFAULT.measurement for name in one.seamly]
    freesewing = [one.freesewing for one in DEFAULT.measurement if one.freesewing is not None]
    assert set(seamly) <= SEAMLY
    assert set(freesewing) <= FREESEWING
    assert [name for name, count in Counter(seamly).items() if count > 1] == []
    assert [name for name, count in Counter(freesewing).items() if count > 1] == []
    # The height where leg and foot meet; the bodies end above the ankle bones.
    assert "leg_ankle_circ" not in seamly
    assert set(freesewing) == FREESEWING
    garmentcode = [one.garmentcode for one in DEFAULT.measurement if one.garmentcode is not None]
    assert sorted(garmentcode) == sorted(GARMENTCODE_KEYS)


def test_each_measurement_is_described() -> None:
    names = Counter(one.name for one in both_sides(DEFAULT.measurement))
    assert max(names.values()) == 1
    clauses = [one.iso.clause for one in DEFAULT.measurement if one.iso and one.iso.clause]
    assert max(Counter(clauses).values()) == 1
    assert len(clauses) >= 15
    for one in DEFAULT.measurement:
        assert re.fullmatch(r"[A-Z].+\.", one.words), one.key
        assert one.group, one.key
    for rule in DEFAULT.landmark:
        assert re.fullmatch(r"[A-Z].+\.", rule.words), rule.name


def test_each_rule_is_needed() -> None:
    text = repr(msgspec.to_builtins(DEFAULT))
    for rule in DEFAULT.landmark:
        one_side = rule.name.replace("{side}", "left")
        assert text.count(f"'{rule.name}'") + text.count(f"'{one_side}'") > 1, rule.name


@bodies
def test_all_of_it_is_measured(name: str) -> None:
    chart = chart_of(name)
    failed = {
        one.definition.key: one.reason
        for one in chart.measured
        if one.outcome is not Outcome.MEASURED
    }
    assert failed == {}
    assert chart.missing_landmarks == {}
    for one in chart.measured:
        key = one.definition.key
        if key in chart.atlas.given:
            assert one.reason == chart.atlas.given[key].origin
            assert 0.0 <= one.error_estimate <= 1e-3 * one.value, key
            continue
        assert one.reason == "", key
        # What is computed from the stature is as exact as the mesh on which that was measured.
        assert 0.0 <= one.error_estimate <= 1e-5 * one.value, key
        assert one.tapes or isinstance(one.definition, FormulaMeasure)
        assert one.landmarks


@bodies
def test_tapes_lie_as_tapes_do(name: str) -> None:
    for one in chart_of(name).measured:
        error = one.error_estimate
        if np.isfinite(one.taut) and np.isfinite(one.contact):
            assert one.gap >= -error, one.definition.key
        kinds = {tape.kind: tape for tape in one.tapes}
        lengths = {TapeKind.CONTACT: one.contact, TapeKind.TAUT: one.taut}
        for kind, tape in kinds.items():
            drawn = np.linalg.norm(np.diff(tape.points, axis=0), axis=1).sum()
            # The tapes of a formula are those of the measurements that it is made of.
            if not isinstance(one.definition, FormulaMeasure):
                assert drawn == pytest.approx(lengths.get(kind, one.value), rel=5e-3)
            sizes = np.linalg.norm(tape.normals, axis=1)
            assert (np.isclose(sizes, 1.0) | (sizes == 0.0)).all()
        if one.length_by_region and TapeKind.CONTACT in kinds:
            assert sum(one.length_by_region.values()) == pytest.approx(one.contact, rel=1e-6)


@bodies
def test_both_sides_agree(name: str) -> None:
    chart = chart_of(name)
    pairs = 0
    for one in chart.measured:
        if one.definition.key.endswith("_left"):
            other = chart[one.definition.key.removesuffix("left") + "right"]
            pairs += 1
            for length, mirrored in ((one.contact, other.contact), (one.taut, other.taut)):
                assert mirrored == pytest.approx(length, rel=1e-6, nan_ok=True)
            # The meshes of head, hands and feet are mirror images to a micrometer.
            given = one.definition.key in chart.atlas.given
            assert other.value == pytest.approx(one.value, rel=5e-5 if given else 1e-6)
    assert pairs > 30


@bodies
def test_parts_add_up(name: str) -> None:
    chart = chart_of(name)
    value = {one.definition.key: one.value for one in chart.measured}
    for part in ("bust", "waist", "hip"):
        both = value[f"{part}_front_arc"] + value[f"{part}_back_arc"]
        assert both == pytest.approx(value[f"{part}_girth"], rel=1e-12)
    legs = value["upper_arm_length_left"] + value["forearm_length_left"]
    assert value["arm_length_left"] == pytest.approx(legs, rel=1e-12)
    halves = value["crotch_length_front"] + value["crotch_length_back"]
    assert value["crotch_length"] == pytest.approx(halves, rel=1e-12)
    # The one tape lies over another that spans the hollow in which the other lies.
    assert value["front_neck_to_waist"] > chart["front_neck_to_waist_between"].taut
    assert value["natural_waist_girth"] < value["waist_girth"] < value["hip_girth"]
    down = [f"{part}_height_left" for part in ("side_neck", "shoulder", "armpit", "bust", "waist")]
    down += [f"{part}_height_left" for part in ("top_hip", "hip", "upper_thigh", "knee")]
    heights = [value[key] for key in down]
    assert heights == sorted(heights, reverse=True)


@bodies
def test_armholes_are_halved(name: str) -> None:
    chart = chart_of(name)
    value = {one.definition.key: one.value for one in chart.measured}
    shoulder, armpit = value["shoulder_height_left"], value["armpit_height_left"]
    for side in ("front", "back"):
        point = chart.landmarks[f"{side} mid-armhole point left"]
        height = float(chart.atlas.position(point)[2])
        down = (shoulder - height) / (shoulder - armpit)
        assert 0.35 < down < 0.85, side
    # The chest between the creases is narrower than the back.
    assert value["across_front_width"] < 0.9 * value["across_back_width"]


@pytest.mark.slow
def test_known_girths_of_the_average_body() -> None:
    # Found by another program on this body, at these heights to a millimeter.
    chart = chart_of("female_average")
    for key, contact, taut in (
        ("bust_girth", 0.8430, 0.8347),
        ("waist_girth", 0.7107, 0.7106),
        ("hip_girth", 0.9265, 0.9252),
    ):
        assert chart[key].contact == pytest.approx(contact, abs=5e-4)
        assert chart[key].taut == pytest.approx(taut, abs=5e-4)
    assert 0.38 < chart["back_neck_to_waist"].value < 0.42


@pytest.mark.slow
def test_a_girth_of_both_thighs_is_none_of_a_thigh() -> None:
    body = load_sample("female_average")
    # The body is like one whose thighs touch.
    high = replace(
        body, landmarks={**body.landmarks, "upper thigh point left": body.landmarks["crotch point"]}
    )
    thighs = tuple(one for one in DEFAULT.measurement if one.key == "thigh_girth_{side}")
    left, right = measure_chart(high, msgspec.structs.replace(DEFAULT, measurement=thighs)).measured
    assert left.outcome is Outcome.REFUSED
    assert re.match(r"the loop is to go round one limb, but has parts of both sides", left.reason)
    assert right.outcome is Outcome.MEASURED


def turned(atlas: Atlas) -> Atlas:
    """The body on its side and moved, in coordinates with other axes."""
    rotation = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    # The move is along the floor only, since heights are above it.
    moved = atlas.points @ rotation.T + np.array([0.0, 0.3, -0.7])
    return replace(atlas, points=moved, axes=Axes("+x", "-z"))


@pytest.mark.slow
def test_motion_and_units_change_nothing() -> None:
    chart = chart_of("female_average")
    other = measure_chart(turned(chart.atlas).converted("mm"))
    for one, same in zip(chart.measured, other.measured, strict=True):
        scale = 1.0 if one.definition.in_degrees else 1000.0
        rounding = 1e-9 * one.value + 2.0 * one.error_estimate
        assert abs(same.value - scale * one.value) <= scale * rounding, one.definition.key
