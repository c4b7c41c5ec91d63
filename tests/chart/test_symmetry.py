"""Mirrors fitted to bodies and deviations from them; names of landmarks; missing landmarks."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.surfaces.tubes import tube
from scipy.spatial.transform import Rotation

from bodymeasure import load_sample
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.chart import load_definitions
from bodymeasure.chart.kinds import (
    ChordMeasure,
    FormulaMeasure,
    GirthMeasure,
    LimbGirthMeasure,
    PathMeasure,
)
from bodymeasure.chart.landmarks.names import (
    KNOWN_NAMES,
    SYNONYMS,
    other_side,
    side_of,
    suggested_name,
)
from bodymeasure.chart.landmarks.symmetry import check_symmetry
from bodymeasure.chart.needed import lacking, names_in


@pytest.fixture(scope="module")
def body() -> Atlas:
    return load_sample("female_average")


def test_a_symmetric_body_is_its_own_mirror_image(body: Atlas) -> None:
    for kind in ("fitted", "axes"):
        found = check_symmetry(body, kind)
        np.testing.assert_allclose(found.plane.normal, [1.0, 0.0, 0.0], rtol=0.0, atol=1e-14)
        assert found.plane.point[0] == pytest.approx(0.0, abs=1e-15)
        assert found.deviation < 1e-15
        assert len(found.pairs) == 7
        assert max(pair.apart for pair in found.pairs) < 1e-14
        assert max(abs(away) for _, away in found.median) < 1e-15
        assert found.unpaired == ()


def test_the_mirror_is_found_on_a_body_that_stands_askew(body: Atlas) -> None:
    turn = Rotation.from_euler("zyx", [8.0, -3.0, 2.0], degrees=True).as_matrix()
    askew = replace(body, points=body.points @ turn.T + [0.1, -0.2, 0.05])
    found = check_symmetry(askew)
    np.testing.assert_allclose(found.plane.normal, turn[:, 0], rtol=0.0, atol=1e-12)
    assert found.plane.distances(np.array([0.1, -0.2, 0.05])) == pytest.approx(0.0, abs=1e-12)
    assert max(pair.apart for pair in found.pairs) < 1e-12
    across = check_symmetry(askew, "axes")
    np.testing.assert_array_equal(across.plane.normal, [1.0, 0.0, 0.0])
    assert across.deviation > 1e-3
    assert max(pair.apart for pair in across.pairs) > 0.02


def test_misplaced_landmarks_are_told_by_how_far(body: Atlas) -> None:
    places = [body.position(body.landmarks[n]) for n in ("bust point left", "front waist point")]
    points, _ = closest_points(body, places + np.array([[0.0, 0.0, 0.03], [-0.02, 0.0, 0.0]]))
    moved = {
        **body.landmarks,
        "bust point left": points[0],
        "front waist point": points[1],
        "mole left": points[0],
    }
    del moved["elbow point right"]
    found = check_symmetry(replace(body, landmarks=moved))
    mirrored = body.position(points[0]) * [-1.0, 1.0, 1.0]
    apart = np.linalg.norm(mirrored - body.position(body.landmarks["bust point right"]))
    assert found.pairs[0].left == "bust point left"
    assert found.pairs[0].apart == pytest.approx(float(apart), abs=1e-14)
    assert found.pairs[1].apart < 1e-14
    name, away = found.median[0]
    assert name == "front waist point"
    assert away == pytest.approx(float(body.position(points[1])[0]), abs=1e-14)
    assert away < -0.015
    assert set(found.unpaired) == {"elbow point left", "mole left"}


def test_an_atlas_without_landmarks_has_a_mirror_too() -> None:
    found = check_symmetry(tube((2.0, 1.0, 1.2, 2.0), center=(0.7, 0.0)), "axes")
    assert found.plane.point[0] == pytest.approx(0.7)
    assert (found.pairs, found.unpaired, found.median) == ((), (), ())


@pytest.mark.parametrize(
    ("name", "suggested"),
    [
        ("bust pont left", "bust point left"),
        ("Left_Bust-Point", "bust point left"),
        ("BustPoint_R", "bust point right"),
        ("C7", "back neck point"),
        ("acromion l", "shoulder point left"),
        ("left nipple", "bust point left"),
        ("bust point", "bust point left"),
        ("back neck point", None),
        ("mole", None),
        ("tattoo left", None),
    ],
)
def test_names_are_suggested(name: str, suggested: str | None) -> None:
    assert suggested_name(name) == suggested


def test_names_of_definitions_are_known() -> None:
    assert suggested_name("dart pont", {"dart point"}) == "dart point"
    assert suggested_name("dart point", {"dart point"}) is None


def test_the_lists_of_names_agree_with_each_other() -> None:
    assert len(set(KNOWN_NAMES)) == len(KNOWN_NAMES)
    places = {name.removesuffix(side_of(name)).strip() for name in KNOWN_NAMES}
    assert set(SYNONYMS.values()) <= places
    assert set(SYNONYMS).isdisjoint(places)
    assert all(other_side(other_side(name)) == name for name in KNOWN_NAMES)
    assert all(other_side(name) in KNOWN_NAMES for name in KNOWN_NAMES)
    assert side_of("left") == side_of("leftover left hand") == ""


@pytest.mark.parametrize("name", ["female_average", "male_average"])
def test_the_samples_are_named_well(name: str) -> None:
    assert set(load_sample(name).landmarks) <= set(KNOWN_NAMES)


def test_measurements_tell_what_they_lack() -> None:
    limb = {"name": "limb", "start": "a {side}", "end": "b {side}"}
    measurements = (
        PathMeasure(key="path", name="path", through=("a left", "b left", "a left")),
        GirthMeasure(key="girth", name="girth", at="c", cut=("a left", "a right")),
        LimbGirthMeasure(key="limb_{side}", at="d {side}", **limb),  # type: ignore[arg-type]
        LimbGirthMeasure(key="half_{side}", at=0.5, **limb),  # type: ignore[arg-type]
        ChordMeasure(key="chord", name="chord", start="a left", end="c"),
        FormulaMeasure(key="all", name="all", formula="2 * (path + limb_left) - max(chord, girth)"),
        FormulaMeasure(key="none", name="none", formula="chord / 2"),
    )
    assert measurements[0].landmarks == ("a left", "b left")
    lacks = lacking(measurements, {"a left", "a right", "b left", "c"})
    assert {lack.measurement.key: lack.landmarks for lack in lacks} == {
        "limb_left": ("d left",),
        "limb_right": ("b right", "d right"),
        "half_right": ("b right",),
        "all": ("d left",),
    }


def test_all_names_of_the_default_set_are_known_to_it() -> None:
    names = names_in(load_definitions())
    assert {"bust point left", "armpit point right", "crotch point"} <= names
    assert not any("{" in name for name in names)
    # No name in it is spelled in two ways.
    close = [name for name in names if suggested_name(name, names) is not None]
    assert close == []


def test_a_landmark_on_a_point_of_two_patches_has_one_place() -> None:
    atlas = replace(
        tube([1.0] * 4),
        landmarks={"p left": AtlasPoint(0, 1.0, 0.5), "p right": AtlasPoint(1, 0.0, 0.5)},
    )
    (pair,) = check_symmetry(atlas, "axes").pairs
    np.testing.assert_allclose(
        atlas.position(atlas.landmarks[pair.left]),
        atlas.position(atlas.landmarks[pair.right]),
        rtol=0.0,
        atol=1e-15,
    )
    assert pair.apart == pytest.approx(0.0, abs=1e-15)
