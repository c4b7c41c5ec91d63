"""Paths that pass close by a pole, through it, or begin right beside it."""

from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from helpers.many_patches import sphere
from helpers.oracles.ellipsoids import ellipsoid_distance
from helpers.surfaces.near_boundaries import beside, near_points
from helpers.surfaces.quadrics import joined, sphere_nets, stretched
from helpers.surfaces.tubes import cone
from hypothesis import given, settings

import bodymeasure as bm
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.geodesic.across.poles.fan import fan_at
from bodymeasure.geodesic.across.poles.junction import PoleLeg, passage

TRIAXIAL = (1.0, 0.7, 0.4)
# Two points of the sphere of eight octants. The first is half a great circle from the second when
# seen from a pole, or nearly so, or one of them is beside a pole.
PAIRS = [
    (
        AtlasPoint(1, 1.0, 0.41773184078136605),
        AtlasPoint(2, 0.0512109138501563, 0.9786696585103881),
    ),
    (AtlasPoint(0, 0.3, 0.5), AtlasPoint(2, 0.3, 0.6)),
    (AtlasPoint(0, 0.3, 0.5), AtlasPoint(2, 0.31, 0.6)),
    (AtlasPoint(0, 0.3, 0.5), AtlasPoint(2, 0.3001, 0.6)),
    (AtlasPoint(0, 0.3, 1.0 - 1e-8), AtlasPoint(1, 0.9, 0.2)),
    (AtlasPoint(0, 0.3, 1.0 - 1e-10), AtlasPoint(2, 0.9, 0.2)),
    (AtlasPoint(0, 0.3, 1.0 - 1e-4), AtlasPoint(2, 0.6, 0.2)),
    (AtlasPoint(0, 0.3, 1.0 - 1e-8), AtlasPoint(2, 0.9, 1.0 - 2e-8)),
    (AtlasPoint(3, 0.46, 1.0 - 8e-9), AtlasPoint(0, 0.85, 1.0 - 4e-7)),
    (AtlasPoint(6, 0.83, 0.0), AtlasPoint(6, 0.3, 4e-11)),
    # Cuts about the pole hold these, until they are farther away from it.
    (AtlasPoint(1, 0.0792931602, 0.4187681245), AtlasPoint(3, 0.0663445959, 0.1042526927)),
    (AtlasPoint(3, 0.1749041940, 0.8515784172), AtlasPoint(1, 0.1738268557, 0.3178371659)),
    # The way from the first to the seam beside it is shorter than 1e-9, but counts.
    (AtlasPoint(6, 0.5511719558, 1.0 - 1e-9), AtlasPoint(1, 0.3736243928, 0.7913229003)),
]
# Points beside both poles of a triaxial ellipsoid, or at one. Two geodesics join the poles.
BESIDE_BOTH = [
    (AtlasPoint(3, 0.36, 1.0 - 2e-11), AtlasPoint(7, 0.26, 3.9e-06)),
    (AtlasPoint(3, 0.543, 1.0 - 7.7e-09), AtlasPoint(5, 0.966, 2.2e-11)),
    (AtlasPoint(4, 0.9999996618288315, 1.7e-07), AtlasPoint(0, 0.0, 1.0)),
    (AtlasPoint(0, 0.0, 1.0), AtlasPoint(4, 0.9999996618288315, 1.7e-07)),
]
# The quick tests take some of them, the slow ones the others.
QUICK = (1, 2, 4, 9)


@cache
def ellipsoid(axes: tuple[float, float, float]) -> Atlas:
    return joined(stretched(sphere_nets(), axes))


def great_circle(start: np.ndarray, end: np.ndarray) -> float:
    return float(np.arctan2(np.linalg.norm(np.cross(start, end)), start @ end))


def assert_great_circle(start: AtlasPoint, end: AtlasPoint) -> None:
    path = bm.geodesic_between(sphere(), start, end)
    exact = great_circle(sphere().position(start), sphere().position(end))
    assert abs(path.length - exact) <= path.error_estimate
    # Coordinates are rounded, however short the path.
    assert path.error_estimate <= 1e-9 * exact + 3e-14
    assert path.position([0.0, 1.0]) == pytest.approx(
        np.array([sphere().position(start), sphere().position(end)]), abs=1e-11
    )


@pytest.mark.parametrize(
    ("start", "end"),
    [
        pytest.param(*pair, marks=() if number in QUICK else pytest.mark.slow)
        for number, pair in enumerate(PAIRS)
    ],
)
def test_great_circles_past_a_pole_and_from_beside_it(start: AtlasPoint, end: AtlasPoint) -> None:
    assert_great_circle(start, end)


def random_point(rng: np.random.Generator) -> AtlasPoint:
    """A point of eight octants anywhere, or near one of the poles."""
    patch = int(rng.integers(8))
    away = 10.0 ** rng.uniform(-16.0, -1.0) if rng.random() < 0.4 else rng.random()
    return AtlasPoint(patch, float(rng.random()), float(1.0 - away if patch < 4 else away))


def are_apart(start: AtlasPoint, end: AtlasPoint) -> bool:
    """Whether two points of a sphere have one shortest path, rather than many."""
    return great_circle(sphere().position(start), sphere().position(end)) < np.pi - 1e-3


@pytest.mark.slow
def test_random_great_circles(rng: np.random.Generator) -> None:
    for _ in range(60):
        start, end = random_point(rng), random_point(rng)
        if are_apart(start, end):
            assert_great_circle(start, end)


@pytest.mark.slow
@pytest.mark.parametrize("axes", [TRIAXIAL, (1.0, 1.0, 2.0)])
def test_random_paths_on_ellipsoids(
    axes: tuple[float, float, float], rng: np.random.Generator
) -> None:
    atlas = ellipsoid(axes)
    for _ in range(8):
        start, end = random_point(rng), random_point(rng)
        places = atlas.position(start), atlas.position(end)
        if not are_apart(start, end) or np.linalg.norm(places[0] - places[1]) < 1e-3:
            continue
        path = bm.geodesic_between(atlas, start, end)
        # The oracle's own error is some 1e-12.
        allowed = path.error_estimate + 3e-12
        assert path.length == pytest.approx(ellipsoid_distance(axes, *places), abs=allowed)


@pytest.mark.slow
@pytest.mark.parametrize(("start", "end"), BESIDE_BOTH)
def test_the_nearer_of_two_ways_between_poles(start: AtlasPoint, end: AtlasPoint) -> None:
    atlas = ellipsoid(TRIAXIAL)
    path = bm.geodesic_between(atlas, start, end)
    exact = ellipsoid_distance(TRIAXIAL, atlas.position(start), atlas.position(end))
    assert path.length == pytest.approx(exact, abs=path.error_estimate + 3e-12)
    assert path.error_estimate <= 1e-9


def assert_triangle(atlas: Atlas, points: tuple[AtlasPoint, AtlasPoint, AtlasPoint]) -> None:
    sides = [bm.geodesic_between(atlas, *ends) for ends in pairwise((*points, points[0]))]
    shorter, middle, longer = sorted(side.length for side in sides)
    assert longer <= shorter + middle + sum(side.error_estimate for side in sides)


@pytest.mark.slow
@pytest.mark.parametrize("height", [0.0, 1.0])
def test_triangles_near_the_tip_of_a_cone(height: float, rng: np.random.Generator) -> None:
    atlas = cone(height)
    for _ in range(2):
        away, along = 10.0 ** rng.uniform(-16.0, 0.0, 3), rng.random(3)
        first, second, third = (
            AtlasPoint(int(rng.integers(4)), float(u), float(v))
            for u, v in zip(away, along, strict=True)
        )
        assert_triangle(atlas, (first, second, third))


@pytest.mark.slow
@settings(max_examples=10)
@given(near_points(sphere()), near_points(sphere()), near_points(sphere()))
def test_triangles_of_any_points_of_a_sphere(
    first: AtlasPoint, second: AtlasPoint, third: AtlasPoint
) -> None:
    if all(are_apart(*ends) for ends in pairwise((first, second, third, first))):
        assert_triangle(sphere(), (first, second, third))


@pytest.mark.parametrize("turn", [0.3, 2.0, 3.0])
@pytest.mark.parametrize("away", [1e-12, 1e-6])
def test_a_short_leg_moves_the_end_of_a_long_one(turn: float, away: float) -> None:
    # On the unit sphere, by the cosine rule for the sides of a triangle at the pole.
    length = 1.1
    legs = (
        PoleLeg(0.0, 0.0, away, 1.0 / np.tan(away)),
        PoleLeg(turn, 0.0, length, 1.0 / np.tan(length)),
    )
    first = np.array([np.sin(away), 0.0, np.cos(away)])
    second = np.array(
        [np.sin(length) * np.cos(turn), np.sin(length) * np.sin(turn), np.cos(length)]
    )
    found = passage(turn, legs, 1.0)
    exact = away + length - great_circle(first, second)
    assert found.gain == pytest.approx(exact, abs=found.error + 4e-16)
    assert found.error <= 1e-6 * away


@pytest.mark.parametrize("bend", [1e-6, 1e-4, 1e-3])
def test_two_long_legs_that_nearly_go_straight_on(bend: float) -> None:
    lengths = 0.7, 1.2
    legs = [PoleLeg(0.0, 0.0, length, 1.0 / np.tan(length)) for length in lengths]
    found = passage(np.pi - bend, (legs[0], legs[1]), 1.0)
    first, second = (np.array([np.sin(length), np.cos(length)]) for length in lengths)
    versed = 2.0 * np.sin(0.5 * bend) ** 2
    cosine = np.cos(sum(lengths)) + first[0] * second[0] * versed
    # The difference of two arc cosines, without cancellation.
    exact = np.arcsin(
        first[0] * second[0] * versed / np.sin(sum(lengths))
        - 0.5 * np.cos(sum(lengths)) * (first[0] * second[0] * versed) ** 2
    )
    assert np.arccos(cosine) <= sum(lengths)
    assert found.gain == pytest.approx(exact, abs=found.error)
    assert found.error <= 0.1 * found.gain + 1e-15


def test_a_path_over_a_saddle_shaped_tip_leads_through_it() -> None:
    legs = PoleLeg(0.0, 0.0, 1.0, 1.0), PoleLeg(3.2, 0.0, 2.0, 0.5)
    assert passage(3.2, legs, 1.0).gain == 0.0


@pytest.mark.parametrize("height", [0.0, 0.5, -2.0])
def test_the_angles_about_the_tip_of_a_cone(height: float) -> None:
    fan = fan_at(cone(height), AtlasPoint(1, 0.0, 0.4))
    assert fan is not None
    assert fan.closed
    assert [sector.patch for sector in fan.sectors] == [1, 2, 3, 0]
    # A cone's rulings are at equal angles from its axis, so that the angle is known for a round
    # one, which this is nearly.
    round_angle = 2.0 * np.pi / np.hypot(1.0, height)
    assert fan.angle == pytest.approx(round_angle, rel=1e-2)
    assert fan.curvature == pytest.approx(1.0 / np.hypot(1.0, height), rel=2e-2)


def test_the_angles_about_the_pole_of_a_smooth_surface_add_up_to_a_full_turn() -> None:
    fan = fan_at(ellipsoid(TRIAXIAL), AtlasPoint(5, 0.2, 0.0))
    assert fan is not None
    assert fan.angle == pytest.approx(2.0 * np.pi, rel=1e-14)
    start, end = (fan.direction(AtlasPoint(5, u, 0.0)) for u in (0.0, 1.0))
    assert start is not None
    assert end is not None
    assert abs(end - start) == pytest.approx(0.5 * np.pi, rel=1e-14)
    near = fan.chord_direction(AtlasPoint(5, 0.3, beside(0.0, -5.0)))
    assert near == pytest.approx(fan.direction(AtlasPoint(5, 0.3, 0.0)), abs=1e-5)


def test_an_open_fan_has_one_way_between_two_directions() -> None:
    whole = cone(1.0)
    half = Atlas(whole.points, whole.index[:2], whole.unit)
    fan = fan_at(half, AtlasPoint(1, 0.0, 0.5))
    assert fan is not None
    assert not fan.closed
    first, second = (fan.direction(AtlasPoint(patch, 0.0, 0.5)) for patch in (0, 1))
    assert first is not None
    assert second is not None
    assert fan.ways(first, second)[0] == pytest.approx(0.5 * fan.angle, rel=1e-12)
    assert fan.ways(first, second)[1] == np.inf
    # The path between them cannot lead round the other side.
    path = bm.geodesic_between(half, AtlasPoint(0, 1e-7, 0.1), AtlasPoint(1, 0.8, 0.9))
    through = bm.geodesic_between(half, AtlasPoint(0, 0.0, 0.1), AtlasPoint(1, 0.8, 0.9))
    assert path.length == pytest.approx(through.length, abs=3e-7)


@pytest.mark.parametrize("patch", [0, 1])
def test_a_point_a_hair_off_a_pole_is_reached_along_its_meridian(patch: int) -> None:
    # The point is so near to the pole and to a seam that it has the digits of a point of both.
    ends = AtlasPoint(0, 0.0, 0.0), AtlasPoint(patch, 1e-6, 0.999999999)
    path = bm.geodesic_between(sphere(), *ends)
    exact = great_circle(*(sphere().position(place) for place in ends))
    assert path.length == pytest.approx(exact, abs=path.error_estimate + 1e-15)


def test_the_course_past_a_pole_begins_at_the_distance_at_which_the_path_passes() -> None:
    # In the plane, the line would pass the pole at a sixth of that distance, and from there
    # Newton's method crept away for a quarter of a minute.
    start = AtlasPoint(0, 0.2028260339594391, 0.4797911014611099)
    end = AtlasPoint(6, 0.20246893446815994, 0.78055079415706)
    path = bm.geodesic_between(sphere(), start, end)
    exact = great_circle(sphere().position(start), sphere().position(end))
    assert abs(path.length - exact) <= path.error_estimate <= 1e-9
