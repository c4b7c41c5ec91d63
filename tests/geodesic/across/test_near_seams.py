"""Points a hair off seams, corners and poles, whose paths contradict no other path."""

from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from helpers.bodies import BODIES
from helpers.many_patches import SURFACES, sphere, torus
from helpers.speed import quick
from helpers.surfaces.near_boundaries import beside, near_points, random_near_point
from hypothesis import given, settings
from hypothesis import strategies as st

import bodymeasure as bm
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.geodesic.across.routes.topology import topology
from bodymeasure.geodesic.across.search.ends import checked_points
from bodymeasure.geodesic.across.search.leg import first_routes

# The quick tests take some of them, the slow ones the others.
QUICK = (-16.0, -9.0)
EXPONENTS = [
    pytest.param(exponent, marks=() if exponent in QUICK else pytest.mark.slow)
    for exponent in np.arange(-16.0, -5.0).tolist()
]
QUICK_BODY = "female_average"


@cache
def from_the_nape(place: AtlasPoint) -> bm.AtlasPath:
    return bm.geodesic_between(bm.load_sample("female_average"), "back neck point", place)


def assert_triangle(atlas: Atlas, points: tuple[AtlasPoint, AtlasPoint, AtlasPoint]) -> None:
    """No side of a triangle of shortest paths is longer than both others, or as they turned."""
    sides = [bm.geodesic_between(atlas, *ends) for ends in pairwise((*points, points[0]))]
    shorter, middle, longer = sorted(side.length for side in sides)
    assert longer <= shorter + middle + sum(side.error_estimate for side in sides)
    turned = bm.geodesic_between(atlas, points[1], points[0])
    allowed = turned.error_estimate + sides[0].error_estimate
    assert turned.length == pytest.approx(sides[0].length, rel=0.0, abs=allowed)


@pytest.mark.parametrize("exponent", EXPONENTS)
@pytest.mark.parametrize(
    ("patch", "edge", "along"),
    [
        (25, 0.0, 0.25),
        (13, 1.0, 0.4),
        pytest.param(60, 1.0, 0.7, marks=pytest.mark.slow),
        pytest.param(200, 0.0, 0.1, marks=pytest.mark.slow),
    ],
)
def test_a_hair_off_a_seam_is_as_far_as_the_seam(
    patch: int, edge: float, along: float, exponent: float
) -> None:
    body = bm.load_sample("female_average")
    for axis in (0, 1):
        on = AtlasPoint(patch, *np.roll([edge, along], axis).tolist())
        off = AtlasPoint(patch, *np.roll([beside(edge, exponent), along], axis).tolist())
        there = from_the_nape(on)
        path = bm.geodesic_between(body, off, "back neck point")
        apart = np.linalg.norm(body.position(on) - body.position(off))
        allowed = apart + path.error_estimate + there.error_estimate
        assert abs(path.length - there.length) <= allowed
        # Moving an end by so much does not make the estimate any larger than that.
        assert path.error_estimate <= 1.1 * there.error_estimate + 1e-9 * path.length


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=() if name == QUICK_BODY else pytest.mark.slow) for name in BODIES],
)
def test_both_ends_a_hair_off_other_seams(name: str) -> None:
    # The path begins beside one seam, and ends on another seam beside its corner.
    body = bm.load_sample(name)
    along = 0.4697017254297169
    on = (AtlasPoint(215, 1.0, along), AtlasPoint(308, 1.0, 1.0))
    off = (AtlasPoint(215, 1.0 - 1.2e-9, along), AtlasPoint(308, 1.0, 1.0 - 1.4e-7))
    there, path, turned = (bm.geodesic_between(body, *ends) for ends in (on, off, (off[1], off[0])))
    both = path.error_estimate + turned.error_estimate
    assert turned.length == pytest.approx(path.length, rel=0.0, abs=both)
    apart = sum(
        float(np.linalg.norm(body.position(p) - body.position(q)))
        for p, q in zip(on, off, strict=True)
    )
    assert abs(path.length - there.length) <= apart + path.error_estimate + there.error_estimate


@pytest.mark.parametrize("exponent", EXPONENTS)
@pytest.mark.parametrize("corner", quick([(0.0, 0.0), (1.0, 1.0), (1.0, 0.0)], first=2))
def test_meridians_that_begin_a_hair_off_a_corner(
    corner: tuple[float, float], exponent: float
) -> None:
    u, v = (beside(edge, exponent) for edge in corner)
    for start in (AtlasPoint(5, u, v), AtlasPoint(5, corner[0], v), AtlasPoint(5, u, corner[1])):
        assert_triangle(torus(), (start, AtlasPoint(2, 0.3, 0.6), AtlasPoint(9, 0.8, 0.1)))


@pytest.mark.parametrize("exponent", EXPONENTS)
def test_great_circles_that_begin_a_hair_off_a_seam(exponent: float) -> None:
    atlas = sphere()
    ends = [AtlasPoint(0, beside(1.0, exponent), 0.3), AtlasPoint(0, 0.4, beside(0.0, exponent))]
    for start in ends:
        for end in (AtlasPoint(1, 0.6, 0.4), AtlasPoint(5, 0.2, 0.7), AtlasPoint(4, 0.5, 0.3)):
            path = bm.geodesic_between(atlas, start, end)
            a, b = atlas.position(start), atlas.position(end)
            exact = np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)
            assert abs(path.length - exact) <= path.error_estimate


@pytest.mark.parametrize(
    "away", [3e-11, *(pytest.param(away, marks=pytest.mark.slow) for away in (1e-9, 1e-7))]
)
def test_a_mesh_path_that_leaves_out_the_piece_before_a_seam(away: float) -> None:
    ends = AtlasPoint(6, 1.0 - away, 0.118), AtlasPoint(3, 1.0, 0.405)
    for start, end in (ends, ends[::-1]):
        path = bm.geodesic_between(sphere(), start, end)
        a, b = sphere().position(start), sphere().position(end)
        exact = np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)
        assert abs(path.length - exact) <= path.error_estimate


def beside_corner(rng: np.random.Generator, patch: int, corner: tuple[float, float]) -> AtlasPoint:
    """A point each of whose parameters is on the edge at a corner, or a hair off it."""
    parameters = (
        edge if rng.random() < 0.3 else beside(edge, rng.uniform(-16.0, -1.0)) for edge in corner
    )
    return AtlasPoint(patch, *parameters)


@pytest.mark.parametrize("name", ["sphere", "ellipsoid", "torus", "female_average"])
def test_a_way_leads_from_beside_a_corner_to_any_other_corner(
    name: str, rng: np.random.Generator
) -> None:
    atlas = SURFACES[name]()
    neighbors = topology(atlas).neighbors
    for number in range(10):
        corner = AtlasPoint(int(rng.integers(len(atlas))), *map(float, rng.integers(2, size=2)))
        around = neighbors.same(corner)
        if number % 2:
            # The corner opposite to it.
            around.append(AtlasPoint(corner.patch, 1.0 - corner.u, 1.0 - corner.v))
        there = around[-1] if number % 2 else around[int(rng.integers(len(around)))]
        start, end = (beside_corner(rng, place.patch, place[1:]) for place in (corner, there))
        ends = checked_points(atlas, (start, end), ("start", "end")).points
        if neighbors.are_same(*ends):
            continue
        (first, *_) = first_routes(atlas, neighbors, (ends[0], ends[1]))
        assert first.ends is not None
        assert all(map(neighbors.are_same, first.ends, ends))


@pytest.mark.parametrize("away", [0.0, 1e-15, 1e-11, 1e-4])
def test_from_beside_a_corner_to_the_patch_diagonally_opposite(away: float) -> None:
    corner = torus().position(AtlasPoint(5, 1.0, 1.0))
    start = AtlasPoint(5, 1.0 - away, 1.0 - away)
    around = topology(torus()).neighbors.same(AtlasPoint(5, 1.0, 1.0))
    (opposite,) = (place for place in around if place[1:] == (0.0, 0.0))
    for step in (1e-9, 0.2):
        end = AtlasPoint(opposite.patch, step, step)
        path = bm.geodesic_between(torus(), start, end)
        leg = np.linalg.norm(torus().position(start) - corner)
        through = bm.geodesic_between(torus(), AtlasPoint(5, 1.0, 1.0), end)
        # The chord is shorter than the arc by the third order.
        allowed = path.error_estimate + through.error_estimate + leg**3
        assert through.length - leg - allowed <= path.length
        assert path.length <= through.length + leg + allowed


def test_triangles_of_random_points_near_boundaries(rng: np.random.Generator) -> None:
    for _ in range(4):
        first, second, third = (random_near_point(rng, torus()) for _ in range(3))
        assert_triangle(torus(), (first, second, third))


@pytest.mark.slow
@settings(max_examples=10)
@given(st.tuples(*[near_points(torus())] * 3))
def test_triangles_of_any_points_near_boundaries(
    points: tuple[AtlasPoint, AtlasPoint, AtlasPoint],
) -> None:
    assert_triangle(torus(), points)


def test_points_apart_by_less_than_the_digits_of_a_seam_are_measured() -> None:
    start = AtlasPoint(3, 0.4, 0.3)
    end = AtlasPoint(3, 0.4 + 3e-10, 0.3)
    path = bm.geodesic_between(torus(), start, end)
    apart = np.linalg.norm(torus().position(start) - torus().position(end))
    assert path.length == pytest.approx(apart, rel=1e-3)


@pytest.mark.parametrize("exponent", EXPONENTS)
def test_the_way_to_a_corner_that_is_written_on_another_patch(exponent: float) -> None:
    start, end = AtlasPoint(8, 0.0, beside(1.0, exponent)), AtlasPoint(15, 1.0, 0.0)
    apart = np.linalg.norm(torus().position(start) - torus().position(end))
    for ends in ((start, end), (end, start)):
        path = bm.geodesic_between(torus(), *ends)
        assert abs(path.length - apart) <= path.error_estimate + 1e-6 * apart


def test_the_closest_point_to_a_seam_is_exactly_on_it(rng: np.random.Generator) -> None:
    body = bm.load_sample("female_average")
    places = [
        AtlasPoint(int(rng.integers(len(body))), 1.0, float(rng.random())) for _ in range(400)
    ]
    places += [AtlasPoint(place.patch, place.v, 0.0) for place in places]
    found, _ = closest_points(body, [body.position(place) for place in places])
    parameters = np.array([point[1:] for point in found])
    away = np.abs(parameters - np.round(parameters)).min(axis=1)
    assert not away.any()
