"""Girths, their search, and straight measures."""

import math
from dataclasses import replace

import numpy as np
import pytest
from helpers.bodies import BODIES, ONE_QUICKLY
from helpers.surfaces.tubes import joined, ring_length, tube
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation

from bodymeasure.atlas import Atlas, AtlasPoint, Unit
from bodymeasure.errors import InputError
from bodymeasure.measure import (
    Extremum,
    Girth,
    body_girth,
    chord,
    closed_geodesic,
    extreme_girth,
    height,
    limb_girth,
    plane_girth,
    vertical_drop,
)
from bodymeasure.samples import load_sample
from bodymeasure.section import Plane, convex_hull, plane_section


def at(x: float, y: float, z: float) -> np.ndarray:
    return np.array([x, y, z])


def turned(atlas: Atlas, turn: np.ndarray) -> Atlas:
    return replace(atlas, points=atlas.points @ turn.T)


def dense_hull(girth: Girth) -> float:
    """The perimeter of the hull of many points, extrapolated from two numbers of points."""
    loop = girth.loop
    perimeters = []
    for steps in (2048, 4096):
        # The ends of pieces are among the points, since seams may have kinks.
        place = np.arange(steps * len(loop.pieces), dtype=np.float64) / steps
        flat = loop.positions_at(place) @ loop.surface.plane.frame().T
        # In the plane, the `area` of a hull is its perimeter.
        perimeters.append(float(ConvexHull(flat).area))
    return (4.0 * perimeters[1] - perimeters[0]) / 3.0


@pytest.mark.parametrize("radius", [0.5, 1.0, 20.0])
def test_girth_of_a_tube(radius: float) -> None:
    girth = body_girth(tube([radius] * 4), at(radius, 0.0, 1.3))
    known = radius * ring_length()
    assert girth.contact == pytest.approx(known, rel=1e-13)
    assert girth.taut == pytest.approx(known, rel=1e-12)
    assert girth.gap == girth.contact - girth.taut >= 0.0
    assert girth.unit == Unit.CM


@pytest.mark.parametrize(
    ("radii", "kind", "fraction", "radius"),
    [
        # 1 + 3 v (1 - v)
        ((1.0, 2.0, 2.0, 1.0), "largest", 0.5, 1.75),
        # 2 - 3 v (1 - v)
        ((2.0, 1.0, 1.0, 2.0), "smallest", 0.5, 1.25),
        # 1 + 3 v (1 - v)^2
        ((1.0, 2.0, 1.0, 1.0), "largest", 1.0 / 3.0, 1.0 + 4.0 / 9.0),
    ],
)
@pytest.mark.parametrize("tape", ["contact", "taut"])
def test_extreme_girths(
    radii: tuple[float, ...], kind: str, fraction: float, radius: float, tape: str
) -> None:
    atlas = tube(radii)
    found = extreme_girth(atlas, at(0, 0, 0.3), at(0, 0, 2.7), kind, tape=tape)  # type: ignore[arg-type]
    assert found.status == Extremum.INSIDE
    assert found.height == pytest.approx(3.0 * fraction, abs=1e-5)
    assert found.fraction == pytest.approx((3.0 * fraction - 0.3) / 2.4, abs=1e-5)
    assert found.girth.contact == pytest.approx(radius * ring_length(), rel=1e-10)


@pytest.mark.parametrize(
    ("kind", "status", "z"),
    [("largest", Extremum.AT_END, 2.0), ("smallest", Extremum.AT_START, 0.5)],
)
def test_an_extreme_at_an_end_says_so(kind: str, status: Extremum, z: float) -> None:
    found = extreme_girth(tube([1.0, 2.0, 3.0, 4.0]), at(1, 0, 0.5), at(1, 0, 2.0), kind)  # type: ignore[arg-type]
    assert found.status == status
    assert "a more extreme girth may lie beyond" in found.status
    assert found.height == pytest.approx(z, abs=1e-12)
    assert found.girth.contact == pytest.approx((1.0 + z) * ring_length(), rel=1e-12)


def test_limb_girth_follows_the_axis(rng: np.random.Generator) -> None:
    turn = Rotation.random(random_state=int(rng.integers(1000))).as_matrix()
    atlas = turned(tube([1.0, 2.0, 2.0, 1.0]), turn)
    girth = limb_girth(atlas, turn @ at(0, 0, 0), turn @ at(0, 0, 3), at=0.5)
    assert girth.contact == pytest.approx(1.75 * ring_length(), rel=1e-12)
    through = limb_girth(
        atlas, turn @ at(0, 0, 0), turn @ at(0, 0, 3), at=AtlasPoint(1, 0.3, 1.0 / 3.0)
    )
    assert through.contact == pytest.approx((1.0 + 2.0 / 3.0) * ring_length(), rel=1e-12)
    found = extreme_girth(atlas, turn @ at(0, 0, 0.5), turn @ at(0, 0, 2), "largest", limb=True)
    assert found.fraction == pytest.approx(2.0 / 3.0, abs=1e-5)


def test_units_carry_through() -> None:
    atlas = load_sample("female_old")
    in_m, in_cm = (body_girth(a, "side hip point left") for a in (atlas, atlas.converted("cm")))
    assert in_cm.unit == Unit.CM
    assert in_cm.contact == pytest.approx(100.0 * in_m.contact, rel=1e-12)
    assert in_cm.taut == pytest.approx(100.0 * in_m.taut, rel=1e-12)


@pytest.mark.parametrize(
    ("landmark", "contact", "taut"),
    [
        # Values in centimeters from another program, which placed its planes by itself: a
        # quarter of a millimeter of height is 0.04 cm of girth at the waist and the bust.
        ("bust point left", 84.30, 83.47),
        pytest.param("front waist point", 71.07, 71.06, marks=pytest.mark.slow),
        pytest.param("side hip point left", 92.65, 92.52, marks=pytest.mark.slow),
    ],
)
def test_girths_of_the_average_female(landmark: str, contact: float, taut: float) -> None:
    girth = body_girth(load_sample("female_average"), landmark)
    assert 100.0 * girth.contact == pytest.approx(contact, abs=0.045)
    assert 100.0 * girth.taut == pytest.approx(taut, abs=0.045)
    assert girth.taut == pytest.approx(dense_hull(girth), rel=1e-9)
    assert girth.error_estimate < 1e-12
    for bridge in girth.bridges:
        assert np.linalg.norm(bridge[1] - bridge[0]) > 0.0


def test_taut_does_not_depend_on_where_it_is_sampled(monkeypatch: pytest.MonkeyPatch) -> None:
    # This loop has hollows far smaller than the steps between samples.
    loop = body_girth(load_sample("female_average"), "bust point left").loop
    known = convex_hull(loop)
    assert len(known.bridges) > 4
    for samples in (5, 31, 100):
        monkeypatch.setattr("bodymeasure.section.hull.SAMPLES", samples)
        assert convex_hull(loop).length == pytest.approx(known.length, rel=1e-13)


@pytest.mark.parametrize("name", ONE_QUICKLY)
def test_left_and_right_limbs_agree(name: str) -> None:
    atlas = load_sample(name)
    for start, end in (("shoulder point", "elbow point"), ("side hip point", "patella point")):
        left, right = (
            limb_girth(atlas, f"{start} {side}", f"{end} {side}", at=0.7)
            for side in ("left", "right")
        )
        assert left.contact == pytest.approx(right.contact, rel=1e-9)
        assert left.taut == pytest.approx(right.taut, rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("name", BODIES[1::2])
def test_taut_is_the_hull(name: str, rng: np.random.Generator) -> None:
    atlas = load_sample(name)
    compared = 0
    for _ in range(20):
        point = atlas.points[rng.integers(len(atlas.points))]
        normal = atlas.axes.up_vector + 0.3 * rng.normal(size=3)
        try:
            girth = plane_girth(atlas, Plane(point, normal), point)
        except InputError as error:
            assert "open" in str(error) or "merges" in str(error)  # noqa: PT017
            continue
        assert girth.taut <= girth.contact
        assert girth.taut == pytest.approx(dense_hull(girth), rel=1e-9)
        compared += 1
    assert compared >= 10


def test_arms_beside_the_waist_are_left_out() -> None:
    atlas = load_sample("female_average")
    girth = body_girth(atlas, at(0.0, -0.1, 1.05))
    assert not any("arm" in region for region in girth.loop.length_by_region)
    arm = body_girth(atlas, at(0.4, 0.0, 1.05))
    assert set(arm.loop.length_by_region) == {"forearm left"}


def test_a_trunk_that_touches_patches_of_the_arm_is_no_merger() -> None:
    girth = body_girth(load_sample("male_average"), at(0.0, -0.2, 1.311))
    assert 0.0 < girth.loop.length_by_region["upper arm left"] < 0.1
    assert girth.contact < 1.0


@pytest.mark.parametrize("name", ONE_QUICKLY)
def test_a_loop_that_merges_trunk_and_arms_is_refused(name: str) -> None:
    atlas = load_sample(name)
    z = height(atlas, "shoulder point left") - 0.06
    with pytest.raises(
        InputError, match=r"merges the trunk and the left arm \(.*choose a landmark below it"
    ):
        body_girth(atlas, at(0.0, -0.2, z))
    with pytest.raises(InputError, match=r"at \d+\.\d % of the stretch.*shorten the stretch"):
        extreme_girth(atlas, "front waist point", "shoulder point left", "largest")


def test_a_merging_loop_is_refused_though_the_plane_cuts_the_arm_again() -> None:
    # From the nape to the front of the waist the plane cuts the shoulders and the bent forearms.
    atlas = load_sample("female_average")
    front, back = (
        atlas.position(atlas.landmarks[name]) for name in ("front waist point", "back neck point")
    )
    tilted = Plane(front, np.cross(atlas.axes.left_vector, front - back))
    arms = [loop for loop in plane_section(atlas, tilted).loops if loop.length < 0.5]
    assert any(set(loop.length_by_region) <= {"forearm left", "upper arm left"} for loop in arms)
    with pytest.raises(InputError, match="merges the trunk and the left arm"):
        plane_girth(atlas, tilted, "front waist point")


def test_a_limb_girth_round_the_trunk_is_refused() -> None:
    atlas = load_sample("male_average")
    with pytest.raises(InputError, match=r"parts of both sides.*farther down the limb"):
        limb_girth(atlas, "side hip point left", at(0.2, 0.0, 0.0), at=0.0)
    with pytest.raises(InputError, match="merges the trunk and the left arm"):
        limb_girth(load_sample("female_average"), "shoulder point left", "elbow point left", at=0.2)


def test_two_legs_are_told_apart() -> None:
    legs = joined(
        [tube([1.0] * 4, (2.0, 0.0)), tube([1.5] * 4, (-2.0, 0.0))], ["leg left", "leg right"]
    )
    left, right = (body_girth(legs, at(x, 0.0, 1.5)) for x in (1.0, -1.0))
    assert left.contact == pytest.approx(ring_length(), rel=1e-12)
    assert right.contact == pytest.approx(1.5 * ring_length(), rel=1e-12)


def test_results_are_shown_in_a_line_or_two() -> None:
    body = load_sample("female_average")
    waist = body_girth(body, "front waist point")
    assert repr(waist).startswith(
        f"<Girth of contact {waist.contact:.6g} m, taut {waist.taut:.6g} m"
    )
    shown = (
        body,
        waist,
        waist.loop,
        vertical_drop(body, "back neck point", "back waist point"),
        closed_geodesic(body, "front waist point"),
    )
    assert max(len(repr(each)) for each in shown) < 200


def test_mistakes_are_named() -> None:
    atlas = load_sample("female_average")
    with pytest.raises(InputError, match="no landmark 'bust point'; did you mean 'bust point"):
        body_girth(atlas, "bust point")
    with pytest.raises(InputError, match="no landmark 'navel', nor any other; add it"):
        height(tube([1.0] * 4), "navel")
    with pytest.raises(InputError, match=r"no landmark 'xyz'; it has back hip point, "):
        chord(atlas, "xyz", "crotch point")
    with pytest.raises(InputError, match="expected three finite numbers"):
        height(atlas, at(0.0, math.nan, 0.0))
    with pytest.raises(InputError, match="misses the body; move it"):
        body_girth(atlas, at(0.0, 0.0, 5.0))
    with pytest.raises(InputError, match="the section is open"):
        plane_girth(atlas, Plane(np.zeros(3), at(1.0, 0.0, 0.0)), "crotch point")
    with pytest.raises(InputError, match="axis starts and ends at one place"):
        limb_girth(atlas, "elbow point left", "elbow point left")
    # Beyond the elbow, the nearest loop would be the trunk's or a leg's.
    for fraction in (-0.1, 2.0, math.nan):
        with pytest.raises(InputError, match=rf"at is {fraction}; expected 0 to 1, or a place"):
            limb_girth(atlas, "shoulder point left", "elbow point left", at=fraction)
    with pytest.raises(InputError, match="starts and ends at one height"):
        extreme_girth(atlas, at(0, 0, 1), at(0.1, 0, 1), "largest")
    with pytest.raises(InputError, match="kind is 'biggest'; expected 'largest' or 'smallest'"):
        extreme_girth(atlas, at(0, 0, 1), at(0, 0, 1.1), "biggest")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="tape is 'loose'; expected 'contact' or 'taut'"):
        extreme_girth(atlas, at(0, 0, 1), at(0, 0, 1.1), "largest", tape="loose")  # type: ignore[arg-type]
