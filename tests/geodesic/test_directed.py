"""Geodesics from a point in a direction, on surfaces where they are known, and back again."""

import numpy as np
import pytest
from helpers.surfaces.cut_atlases import random_point, slant_cut, wavy_plane
from helpers.surfaces.quadrics import joined, octant, sphere_nets, stretched
from helpers.surfaces.surfaces import PARABOLOID

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.bezier import derivatives

SPHERE = joined(sphere_nets())
POLE = AtlasPoint(1, 0.4, 1.0)


def misses_its_great_circle(start: AtlasPoint, direction: Array, length: float) -> float:
    """How far a path on the sphere is from its great circle; its estimate must say so."""
    x = SPHERE.position(start)
    tangent = direction - (direction @ x) * x
    tangent /= np.linalg.norm(tangent)
    path = bm.geodesic_from(SPHERE, start, direction, length)
    assert path.status is bm.Status.CONVERGED
    assert path.length == length
    t = np.linspace(0.0, 1.0, 41)
    angle = length * t[:, None]
    off = np.abs(path.position(t) - (np.cos(angle) * x + np.sin(angle) * tangent)).max(axis=1)
    assert off[-1] <= path.error_estimate <= 1e-8
    away = -np.sin(length) * x + np.cos(length) * tangent
    assert path.end_direction == pytest.approx(away, abs=1e-9)
    return float(off.max())


@pytest.mark.parametrize(
    "length", [0.3, *(pytest.param(x, marks=pytest.mark.slow) for x in (2, 9))]
)
def test_great_circles(length: float, rng: np.random.Generator) -> None:
    start = random_point(rng, SPHERE)
    assert misses_its_great_circle(start, rng.standard_normal(3), length) < 1e-11


@pytest.mark.slow
@pytest.mark.parametrize("off", [1e-13, 1e-6, 2e-5])
def test_great_circles_through_a_pole_and_close_by(off: float, rng: np.random.Generator) -> None:
    start = AtlasPoint(0, 0.3, 0.6)
    to_pole = np.array([0.0, 0.0, 1.0]) + off * rng.standard_normal(3)
    # Inside of the passage the path itself is as good as that is wide.
    assert misses_its_great_circle(start, to_pole, 2.3) < 2e-5


@pytest.mark.slow
@pytest.mark.parametrize("off", [1e-11, 1e-8, 3e-6, 2e-5])
def test_great_circles_from_beside_a_pole(off: float, rng: np.random.Generator) -> None:
    start = AtlasPoint(1, 0.3, 1.0 - off)
    for direction in ((1.0, 0.5, 0.0), rng.standard_normal(3)):
        assert misses_its_great_circle(start, np.array(direction), 0.7) < 2e-5


@pytest.mark.slow
def test_great_circles_through_both_poles_and_from_one() -> None:
    start = AtlasPoint(0, 0.3, 0.6)
    assert misses_its_great_circle(start, np.array([0.0, 0.0, -1.0]), 6.0) < 1e-11
    assert misses_its_great_circle(POLE, np.array([0.3, -1.0, 0.2]), 1.2) < 1e-11


@pytest.mark.slow
def test_great_circles_along_seams() -> None:
    for place, axis in ((AtlasPoint(0, 0.0, 0.3), 1), (AtlasPoint(0, 0.3, 0.0), 0)):
        jet = derivatives(SPHERE.control_points[0], (place.u, place.v), 1)
        direction = jet[1, 0] if axis == 0 else jet[0, 1]
        assert misses_its_great_circle(place, direction, 1.9) < 1e-11


@pytest.mark.slow
def test_a_pole_is_a_point_like_others(rng: np.random.Generator) -> None:
    factors = (1.0, 0.7, 0.4)
    upright = joined(stretched(sphere_nets(), factors))
    lying = joined(stretched(sphere_nets()[..., [2, 0, 1, 3]], factors))
    from_pole = bm.geodesic_from(lying, (0.0, 0.0, 0.4), rng.standard_normal(3), 0.6)
    there, direction = lying.position(from_pole.end), -from_pole.end_direction
    through, past = (bm.geodesic_from(each, there, direction, 1.1) for each in (upright, lying))
    gap = np.linalg.norm(upright.position(through.end) - lying.position(past.end))
    assert gap <= through.error_estimate + past.error_estimate < 1e-9


def test_lines_on_a_plane_with_curved_kinked_seams(rng: np.random.Generator) -> None:
    atlas = wavy_plane(rng)
    for _ in range(4):
        start, end = random_point(rng, atlas), random_point(rng, atlas)
        way = atlas.position(end) - atlas.position(start)
        length = float(np.linalg.norm(way))
        path = bm.geodesic_from(atlas, start, way, length)
        assert np.linalg.norm(path.position(1.0) - atlas.position(end)) <= path.error_estimate
        t = np.linspace(0.0, 1.0, 9)[:, None]
        line = atlas.position(start) + t * way
        assert path.position(t[:, 0]) == pytest.approx(line, abs=1e-10)


def test_a_path_stops_at_a_boundary(rng: np.random.Generator) -> None:
    atlas, _ = slant_cut(PARABOLOID, rng)
    path = bm.geodesic_from(atlas, (0.5, 0.5, 0.5), (1.0, 0.0, 0.0), 30.0)
    assert path.status is bm.Status.ENDS_AT_BOUNDARY
    assert path.converged
    assert atlas.position(path.end)[0] == pytest.approx(1.0, abs=1e-12)
    # The same length is found between its ends.
    between = bm.geodesic_between(atlas, (0.5, 0.5, 0.5), path.end)
    assert path.length == pytest.approx(between.length, rel=1e-9)


@pytest.mark.parametrize("length", [0.11, pytest.param(0.9, marks=pytest.mark.slow)])
def test_back_again_on_a_body(length: float, rng: np.random.Generator) -> None:
    body = bm.load_sample("female_average")
    start = random_point(rng, body)
    path = bm.geodesic_from(body, start, rng.standard_normal(3), length)
    back = bm.geodesic_from(body, path.end, -path.end_direction, length)
    gap = np.linalg.norm(body.position(back.end) - body.position(start))
    assert gap <= 10.0 * (path.error_estimate + back.error_estimate) < 1e-9
    assert path.residual < 1e-5
    for crossing in path.crossings:
        here = [body.position(point) for point in (crossing.before, crossing.after)]
        assert here[0] == pytest.approx(here[1], abs=1e-11)
        assert path.position(crossing.t) == pytest.approx(here[0], abs=1e-11)


@pytest.mark.slow
def test_the_shortest_path_is_found_again_from_its_direction() -> None:
    body = bm.load_sample("female_average")
    shortest = bm.geodesic_between(body, "shoulder point left", "elbow point left")
    first = shortest.pieces[0]
    slope = first.space.matrices(0.0)[1] @ first.values.T
    jet = derivatives(body.control_points[first.patch], first.values[:, 0], 1)
    direction = slope[0, 0] * jet[1, 0] + slope[0, 1] * jet[0, 1]
    path = bm.geodesic_from(body, "shoulder point left", direction, shortest.length)
    t = np.linspace(0.0, 1.0, 21)
    # The direction is good to the path's error, which is the root of that of its length.
    assert path.position(t) == pytest.approx(shortest.position(t), abs=1e-5)


def octant_atlas() -> Atlas:
    """An eighth of a sphere."""
    return joined(octant()[None])


def test_a_boundary_beyond_a_pole_is_one() -> None:
    path = bm.geodesic_from(
        octant_atlas(), AtlasPoint(0, 0.5, 0.5), (0.0, 0.0, 1.0), 3.0, on_failure="status"
    )
    assert path.status is not bm.Status.CONVERGED


@pytest.mark.parametrize(
    ("direction", "length", "words"),
    [
        ((0.0, 0.0, 0.0), 1.0, "not zero"),
        ("up", 1.0, "expected a vector"),
        ((0.0, 0.0, 1.0), 0.1, "is normal to the surface"),
        ((1.0, 0.0, 0.0), -1.0, "expected a positive number"),
        ((1.0, 0.0, 0.0), np.nan, "expected a positive number"),
    ],
)
def test_bad_input_is_refused(direction: object, length: float, words: str) -> None:
    atlas = bm.load_sample("paraboloid")
    with pytest.raises(bm.InputError, match=words):
        bm.geodesic_from(atlas, AtlasPoint(0, 0.0, 0.0), direction, length)  # type: ignore[arg-type]


def test_the_closest_point_is_a_place_and_a_distance() -> None:
    point, distance = bm.closest_point(SPHERE, (0.0, 0.0, 3.0))
    assert SPHERE.position(point) == pytest.approx((0.0, 0.0, 1.0), abs=1e-9)
    assert distance == pytest.approx(2.0, abs=1e-12)
    with pytest.raises(bm.InputError, match="three finite numbers"):
        bm.closest_point(SPHERE, "nape")
