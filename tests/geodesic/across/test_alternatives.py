from itertools import combinations

import numpy as np
import pytest
from helpers.surfaces.cut_atlases import cut, random_point, wavy_plane
from helpers.surfaces.grids import grid_atlas
from helpers.surfaces.surfaces import PARABOLOID
from helpers.surfaces.tubes import QUARTER, ring_length, tube

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint, Unit
from bodymeasure.bezier import bernstein
from bodymeasure.geodesic.across.routes.graph import patch_graph
from bodymeasure.geodesic.across.routes.via_pairs import via_pairs
from bodymeasure.geodesic.across.routes.ways import along_way, way_through

PARTS = np.linspace(0.0, 1.0, 33)


def arc(u: float) -> float:
    """The arc length of a quarter of the tube's ring, from its start to u."""
    x, weights = np.polynomial.legendre.leggauss(40)
    velocity = bernstein(3, 0.5 * u * (1.0 + x), order=1)[:, 1] @ QUARTER
    return float(0.5 * u * weights @ np.linalg.norm(velocity, axis=1))


def test_helices_about_a_tube_are_told_apart_by_side_and_winding() -> None:
    atlas, ring = tube((1.0, 1.0, 1.0, 1.0)), ring_length()
    start, end = AtlasPoint(0, 0.2, 0.1), AtlasPoint(0, 0.7, 0.6)
    way = arc(0.7) - arc(0.2)
    paths = bm.geodesic_alternatives(atlas, start, end, count=3)
    around = np.array([way, ring - way, ring + way])
    np.testing.assert_allclose([path.length for path in paths], np.hypot(around, 1.5), rtol=1e-9)
    for path in paths:
        assert path.status is bm.Status.CONVERGED
        assert path.points == (start, end)
    # The sign shows the direction in which they start: x grows with u only if they go back.
    x = [path.position(0.01)[0] - atlas.position(start)[0] for path in paths]
    np.testing.assert_array_equal(np.sign(x), [-1, 1, -1])


def test_the_first_is_the_shortest_and_fewer_are_the_first_of_more() -> None:
    atlas = tube((1.0, 0.8, 0.8, 1.0))
    start, end = AtlasPoint(0, 0.2, 0.1), AtlasPoint(0, 0.6, 0.5)
    paths = bm.geodesic_alternatives(atlas, start, end)
    assert len(paths) == 3
    lengths = [path.length for path in paths]
    assert lengths == sorted(lengths)
    assert lengths[0] == bm.geodesic_between(atlas, start, end).length
    (alone,) = bm.geodesic_alternatives(atlas, start, end, count=1)
    assert alone.length == lengths[0]
    for path, other in combinations(paths, 2):
        apart = np.linalg.norm(path.position(PARTS) - other.position(PARTS), axis=1).max()
        assert apart > 0.02 * path.length


@pytest.mark.slow
def test_swapped_ends_have_the_same_alternatives() -> None:
    atlas = tube((1.0, 0.8, 0.8, 1.0))
    start, end = AtlasPoint(0, 0.2, 0.1), AtlasPoint(0, 0.6, 0.5)
    there, back = (
        [path.length for path in bm.geodesic_alternatives(atlas, *ends)]
        for ends in ((start, end), (end, start))
    )
    np.testing.assert_allclose(there, back, rtol=1e-9)


@pytest.mark.slow
def test_where_there_is_one_way_only(rng: np.random.Generator) -> None:
    for atlas in (wavy_plane(rng), cut(PARABOLOID, (0.4,), (0.5,))):
        start, end = random_point(rng, atlas), random_point(rng, atlas)
        (path,) = bm.geodesic_alternatives(atlas, start, end)
        assert path.length == bm.geodesic_between(atlas, start, end).length


def bump(x: Array, y: Array) -> Array:
    """A high bump about (1.5, 1.5)."""
    return np.stack([x, y, 3.0 * np.exp(-4.0 * ((x - 1.5) ** 2 + (y - 1.5) ** 2))], axis=-1)


@pytest.mark.slow
def test_left_and_right_round_a_bump() -> None:
    atlas = grid_atlas(3, 3, bump)
    left, right, *_ = bm.geodesic_alternatives(
        atlas, AtlasPoint(1, 0.0, 0.5), AtlasPoint(7, 1.0, 0.5)
    )
    # The bump is symmetric, so that the paths on either side are equally long.
    assert left.length == pytest.approx(right.length, rel=1e-8)
    middles = sorted(path.position(0.5)[1] for path in (left, right))
    assert middles[0] < 1.2
    assert middles[0] + middles[1] == pytest.approx(3.0, abs=1e-3)


def test_a_point_and_itself() -> None:
    atlas = grid_atlas(2, 1)
    (path,) = bm.geodesic_alternatives(atlas, AtlasPoint(0, 1.0, 0.4), AtlasPoint(1, 0.0, 0.4))
    assert (path.length, path.status) == (0.0, bm.Status.CONVERGED)


@pytest.mark.parametrize("count", [0, -1, 1.5, True, "two"])
def test_a_wrong_count_is_refused(count: object) -> None:
    ends = AtlasPoint(0, 0.5, 0.5), AtlasPoint(1, 0.5, 0.5)
    with pytest.raises(bm.InputError, match=r"count is .* a whole number above 0"):
        bm.geodesic_alternatives(grid_atlas(2, 1), *ends, count)  # type: ignore[arg-type]


def test_points_that_are_not_joined_are_refused() -> None:
    square = grid_atlas(3, 1)
    atlas = Atlas(square.points, square.index[[0, 2]], Unit.CM)
    with pytest.raises(bm.InputError, match="no seams join"):
        bm.geodesic_alternatives(atlas, AtlasPoint(0, 0.5, 0.5), AtlasPoint(1, 0.5, 0.5))


def test_rough_ways_are_a_little_too_long(rng: np.random.Generator) -> None:
    atlas = wavy_plane(rng)
    graph = patch_graph(atlas)
    place = AtlasPoint(4, 0.3, 0.4)
    apart = np.linalg.norm(graph.vertices - atlas.position(place), axis=1)
    far = apart > 0.5
    ratio = graph.distances(atlas, place)[far] / apart[far]
    assert (ratio >= 1.0).all()
    assert ratio.max() < 1.15
    for vertex, there in zip(graph.vertices, graph.places, strict=True):
        np.testing.assert_allclose(atlas.position(there), vertex, atol=1e-14)


def test_ways_on_both_sides_of_a_tube_are_among_the_pairs() -> None:
    atlas = tube((1.0, 1.0, 1.0, 1.0))
    graph = patch_graph(atlas)
    first, last = (graph.distances(atlas, AtlasPoint(patch, 0.5, 0.5)) for patch in (0, 2))
    pairs = via_pairs(graph, first, last, 4.0)
    middles = {np.sign(graph.vertices[pair.first] @ [-1.0, 1.0, 0.0]) for pair in pairs}
    assert {-1.0, 1.0} <= middles
    assert pairs == sorted(pairs)
    assert not via_pairs(graph, first, last, 1.0)


def test_a_way_is_pulled_straight_but_not_over_to_the_other_side() -> None:
    atlas, ring = tube((1.0, 1.0, 1.0, 1.0)), ring_length()
    graph = patch_graph(atlas)
    # The points lead up and down the long way from patch 0 to patch 1.
    places = AtlasPoint(3, 0.5, 0.75), AtlasPoint(2, 0.5, 0.25)
    vertices = tuple(
        int(np.argmin(np.linalg.norm(graph.vertices - atlas.position(place), axis=1)))
        for place in places
    )
    ends = AtlasPoint(0, 0.5, 0.5), AtlasPoint(1, 0.5, 0.5)
    way = way_through(atlas, ends, vertices)
    assert way is not None
    points = way.points(graph.mesh.surface)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    assert steps.sum() == pytest.approx(0.75 * ring, rel=0.02)
    np.testing.assert_allclose(along_way(points, np.array([0.0, 1.0])), points[[0, -1]])
    np.testing.assert_allclose(along_way(points, PARTS)[:, 2], 1.5, atol=0.1)


@pytest.mark.parametrize(
    ("start", "end", "axis"),
    [
        # The paths lead around either side of the neck, and around the front and the back of the
        # waist.
        ("back neck point", "front neck point", 0),
        ("side waist point left", "side waist point right", 1),
    ],
)
def test_both_ways_round_a_body(start: str, end: str, axis: int) -> None:
    body = bm.load_sample("female_average")
    ends = body.landmarks[start], body.landmarks[end]
    paths = bm.geodesic_alternatives(body, *ends, count=2)
    middles = sorted(path.position(0.5)[axis] for path in paths)
    sides = sorted(body.position(end)[axis] for end in ends)
    assert middles[0] < sides[0] - 0.02
    assert middles[1] > sides[1] + 0.02
    if axis == 0:
        assert paths[0].length == pytest.approx(paths[1].length, rel=1e-9)
