"""Landmarks of fitted bodies that are defined by the shape, on bodies of the model."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from bodymeasure.atlas import Atlas, LandmarkFound, LandmarkOrigin, ScanFit, closest_point
from bodymeasure.chart import FoundLandmarks, found_landmarks
from bodymeasure.errors import InputError
from bodymeasure.samples import load_sample

UP = np.array([0.0, 0.0, 1.0])
HIPS = ("side hip point left", "side hip point right", "front hip point", "back hip point")


def scanned() -> Atlas:
    body = load_sample("female_old")
    carried = {name: LandmarkFound(LandmarkOrigin.CARRIED, 0.006) for name in body.landmarks}
    none = np.zeros(len(body))
    return replace(body, scan=ScanFit(none + 1.0, none, carried))


@cache
def found() -> FoundLandmarks:
    return found_landmarks(scanned())


def test_the_hips_are_at_the_level_of_the_fullest_part_of_the_buttocks() -> None:
    atlas = found().atlas
    assert set(found().by_rule) == set(HIPS)
    assert found().carried == {}
    heights = {float(round(atlas.position(name)[2], 9)) for name in HIPS}
    assert len(heights) == 1
    # No control point between crotch and waist shows a surface that is farther back.
    low, high = (float(atlas.position(name)[2]) for name in ("crotch point", "back waist point"))
    trunk = [
        number
        for number, region in enumerate(atlas.regions)
        if region.startswith(("hip", "thigh", "torso"))
    ]
    mesh = atlas.to_trimesh(6)
    inside = np.isin(mesh.vertex_attributes["patch"], trunk)
    points = mesh.vertices[inside & (mesh.vertices[:, 2] > low) & (mesh.vertices[:, 2] < high)]
    fullest = points[np.argmax(points[:, 1])]
    assert fullest[2] == pytest.approx(heights.pop(), abs=0.008)


def test_what_was_found_is_said() -> None:
    atlas = found().atlas
    assert atlas.provenance["landmarks by rule"] == ", ".join(found().by_rule)
    assert "landmarks carried" not in atlas.provenance
    assert atlas.scan is not None
    for name, how in atlas.scan.landmarks.items():
        expected = LandmarkOrigin.RULE if name in HIPS else LandmarkOrigin.CARRIED
        assert how.origin is expected, name
        if name not in HIPS:
            assert atlas.landmarks[name] == scanned().landmarks[name]


def test_picked_landmarks_stay() -> None:
    kept = found_landmarks(scanned(), keep=HIPS[:2])
    assert set(kept.by_rule) == set(HIPS[2:])
    for name in HIPS[:2]:
        assert kept.atlas.landmarks[name] == scanned().landmarks[name]
    with pytest.raises(InputError, match="keep"):
        found_landmarks(scanned(), keep="side hip point left")


def test_a_rule_that_fails_leaves_the_carried_landmark() -> None:
    body = scanned()
    # Nothing lies above the crotch and below the waist.
    upside_down = {**body.landmarks, "crotch point": body.landmarks["back neck point"]}
    kept = found_landmarks(replace(body, landmarks=upside_down))
    assert kept.by_rule == ()
    assert set(kept.carried) == set(HIPS)
    assert "'crotch point' is not below 'back waist point'" in kept.carried["front hip point"]
    assert kept.atlas.landmarks == upside_down
    assert "front hip point: " in kept.atlas.provenance["landmarks carried"]


def test_a_rule_that_finds_another_part_is_not_believed() -> None:
    body = scanned()
    knee = closest_point(body, body.position("patella point left") + 0.05 * UP)[0]
    kept = found_landmarks(replace(body, landmarks={**body.landmarks, "front hip point": knee}))
    assert "front hip point" not in kept.by_rule
    assert "cm from the carried place, more than 8 cm" in kept.carried["front hip point"]
    assert kept.atlas.landmarks["front hip point"] == knee


def test_units_change_nothing() -> None:
    millimeters = found_landmarks(load_sample("female_old").converted("mm"))
    assert millimeters.carried == {}
    for name in HIPS:
        assert np.allclose(
            millimeters.atlas.position(name), 1000.0 * found().atlas.position(name), atol=1e-6
        )
