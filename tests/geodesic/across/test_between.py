import sys

import numpy as np
import pytest
from helpers.surfaces.cut_atlases import (
    corner_of,
    cut,
    on_cut,
    on_part,
    random_point,
    slant_cut,
    wavy_cylinder,
    wavy_plane,
)
from helpers.surfaces.grids import grid_atlas
from helpers.surfaces.surfaces import (
    ENNEPER,
    HYPERBOLIC_PARABOLOID,
    PARABOLOID,
    PH_CYLINDER,
    SURFACES,
    Surface,
)
from numpy.typing import NDArray
from scipy.optimize import brentq

import bodymeasure as bm
from bodymeasure.atlas import Atlas, AtlasPoint, Unit
from bodymeasure.bezier import evaluate

# There are no wheels of it for the latest versions of Python.
pytest.importorskip("pygeodesic")

CUTS: dict[str, tuple[tuple[float, ...], tuple[float, ...]]] = {
    "whole": ((), ()),
    "in two": ((0.4,), ()),
    "in four": ((0.5,), (0.5,)),
    "in nine": ((0.3, 0.65), (0.2, 0.7)),
    "in sixty-four": (tuple(np.arange(1, 8) / 8), tuple(np.arange(1, 8) / 8)),
}


@pytest.mark.parametrize("cuts", CUTS.values(), ids=CUTS)
@pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
def test_cutting_a_surface_changes_no_length(
    surface: Surface, cuts: tuple[tuple[float, ...], tuple[float, ...]]
) -> None:
    atlas = cut(surface.control_points, *cuts, turn=False)
    start, end = on_cut(cuts, surface.start), on_cut(cuts, surface.end)
    path = bm.geodesic_between(atlas, start, end)
    assert path.status is bm.Status.CONVERGED
    assert path.length == pytest.approx(surface.length, rel=1e-9)
    assert abs(path.length - surface.length) <= path.error_estimate <= 1e-9 * path.length
    assert len(path.crossings) == len(path.pieces) - 1


@pytest.mark.parametrize("surface", SURFACES[:3], ids=lambda surface: surface.name)
def test_turned_patches_change_nothing(surface: Surface) -> None:
    atlas = cut(surface.control_points, (0.3, 0.65), (0.2, 0.7))
    start, end = (
        corner_of(atlas, evaluate(surface.control_points, uv).tolist())
        for uv in (surface.start, surface.end)
    )
    path = bm.geodesic_between(atlas, start, end)
    assert path.length == pytest.approx(surface.length, rel=1e-9)


def test_lines_on_a_plane_with_curved_kinked_seams(rng: np.random.Generator) -> None:
    atlas = wavy_plane(rng)
    crossed = 0
    for _ in range(25):
        start, end = random_point(rng, atlas), random_point(rng, atlas)
        chord = np.linalg.norm(atlas.position(end) - atlas.position(start))
        path = bm.geodesic_between(atlas, start, end)
        assert path.length == pytest.approx(chord, rel=1e-9)
        assert abs(path.length - chord) <= path.error_estimate
        crossed += len(path.crossings)
        # The path itself is straight, and at constant speed.
        t = np.linspace(0.0, 1.0, 21)[:, None]
        line = (1.0 - t) * atlas.position(start) + t * atlas.position(end)
        np.testing.assert_allclose(path.position(t[:, 0]), line, atol=2e-4)
    assert crossed > 25


def test_helices_on_a_cylinder_with_curved_seams(rng: np.random.Generator) -> None:
    atlas, _ = wavy_cylinder(rng)
    for _ in range(15):
        start, end = random_point(rng, atlas), random_point(rng, atlas)
        arcs, heights = [], []
        for point in (start, end):
            x, _, z = atlas.position(point)
            u = brentq(lambda u, x=x: 3 * u - u**3 - x, 0.0, 1.0, xtol=1e-15)
            arcs.append(3 * u + u**3)
            heights.append(z)
        expected = np.hypot(arcs[1] - arcs[0], heights[1] - heights[0])
        path = bm.geodesic_between(atlas, start, end)
        assert path.length == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize(
    "net", [ENNEPER, PARABOLOID, HYPERBOLIC_PARABOLOID, PH_CYLINDER], ids=["e", "p", "h", "c"]
)
def test_cutting_along_curves_that_meet_at_kinks_changes_no_length(
    net: NDArray[np.float64], rng: np.random.Generator
) -> None:
    compared = 0
    for _ in range(8):
        atlas, corners = slant_cut(net, rng)
        start, end = random_point(rng, atlas), random_point(rng, atlas)
        ends = [on_part(corners[point.patch], point.u, point.v).tolist() for point in (start, end)]
        whole = bm.solve_geodesic(net, *ends)
        path = bm.geodesic_between(atlas, start, end)
        assert path.status is whole.status
        compared += int(whole.status is bm.Status.CONVERGED)
        assert path.length == pytest.approx(whole.length, rel=1e-9)
    assert compared >= 4


def rotation(rng: np.random.Generator) -> np.ndarray:
    q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    return np.asarray(q * np.linalg.det(q))


def test_swapped_ends_motions_and_scales_change_nothing(rng: np.random.Generator) -> None:
    atlas = cut(PARABOLOID, (0.3, 0.65), (0.2, 0.7))
    moved = Atlas(atlas.points @ rotation(rng).T + [3.0, -2.0, 5.0], atlas.index, Unit.CM)
    larger = Atlas(atlas.points * 1e3, atlas.index, Unit.CM)
    for _ in range(5):
        start, end = random_point(rng, atlas), random_point(rng, atlas)
        length = bm.geodesic_between(atlas, start, end).length
        assert bm.geodesic_between(atlas, end, start).length == pytest.approx(length, rel=1e-11)
        assert bm.geodesic_between(moved, start, end).length == pytest.approx(length, rel=1e-11)
        scaled = bm.geodesic_between(larger, start, end).length
        assert scaled == pytest.approx(1e3 * length, rel=1e-11)


def test_an_end_on_a_seam_or_corner_may_be_given_on_any_of_its_patches() -> None:
    cuts = ((0.3, 0.65), (0.2, 0.7))
    atlas = cut(PARABOLOID, *cuts, turn=False)
    end = on_cut(cuts, (0.9, 0.85))
    for same in (
        [AtlasPoint(0, 1.0, 0.3), AtlasPoint(3, 0.0, 0.3)],
        [AtlasPoint(0, 1.0, 1.0), AtlasPoint(1, 1.0, 0.0), AtlasPoint(4, 0.0, 0.0)],
    ):
        paths = [bm.geodesic_between(atlas, point, end) for point in same]
        for path in paths:
            assert path.length == pytest.approx(paths[0].length, rel=1e-12)
            assert min(piece.length for piece in path.pieces) > 0.0
            # Trimmed to the patch that the path really starts on.
            assert path.patches == paths[0].patches


def test_a_path_along_a_seam() -> None:
    # The parabola z = x^2, moved along y, with a paraboloid's fall to both sides of the seam.
    net = PARABOLOID.copy()
    net[..., 1] -= 0.5
    net[..., 2] = net[..., 2] - PARABOLOID[..., 1]
    atlas = cut(net, (0.4,), (0.5,), turn=False)
    start, end = AtlasPoint(0, 0.0, 1.0), AtlasPoint(3, 1.0, 0.0)
    path = bm.geodesic_between(atlas, start, end)
    a = atlas.position(start)[0], atlas.position(end)[0]
    # z = x^2 along it: its arc length.
    arc = [x * np.sqrt(1 + 4 * x * x) / 2 + np.arcsinh(2 * x) / 4 for x in a]
    assert path.length == pytest.approx(arc[1] - arc[0], rel=1e-9)


def test_the_path_leads_from_start_to_end_over_its_crossings() -> None:
    atlas = cut(PARABOLOID, (0.3, 0.65), (0.2, 0.7))
    start, end = corner_of(atlas, (0, 0, 0)), corner_of(atlas, (1, 1, 2))
    start, end = start._replace(u=abs(start.u - 0.1)), end._replace(v=abs(end.v - 0.3))
    path = bm.geodesic_between(atlas, start, end)
    patch, parameters = path.path([0.0, 1.0])
    assert [(int(p), *uv) for p, uv in zip(patch, parameters.tolist(), strict=True)] == [
        (start.patch, start.u, start.v),
        (end.patch, end.u, end.v),
    ]
    assert path.path(0.3)[1].shape == (2,)
    assert path.patches == (
        *(crossing.before.patch for crossing in path.crossings),
        path.crossings[-1].after.patch,
    )
    for crossing in path.crossings:
        before, after = atlas.position(crossing.before), atlas.position(crossing.after)
        np.testing.assert_allclose(before, after, atol=1e-14)
        np.testing.assert_allclose(path.position(crossing.t), after, atol=1e-12)
    polygon = np.diff(path.position(np.linspace(0.0, 1.0, 4001)), axis=0)
    assert np.linalg.norm(polygon, axis=1).sum() == pytest.approx(path.length, rel=1e-7)


def test_via_points_are_led_through_in_order(rng: np.random.Generator) -> None:
    atlas = wavy_plane(rng)
    points = [random_point(rng, atlas) for _ in range(4)]
    positions = np.array([atlas.position(point) for point in points])
    path = bm.geodesic_between(atlas, points[0], points[-1], via=points[1:-1])
    legs = np.linalg.norm(np.diff(positions, axis=0), axis=1)
    assert path.length == pytest.approx(legs.sum(), rel=1e-9)
    at = np.concatenate([[0.0], np.cumsum(legs) / legs.sum()])
    np.testing.assert_allclose(path.position(at), positions, atol=1e-6)
    assert path.points == tuple(points)


def test_many_pairs_are_measured_as_each_alone(rng: np.random.Generator) -> None:
    atlas = wavy_plane(rng)
    starts, ends = ([random_point(rng, atlas) for _ in range(4)] for _ in range(2))
    paths = bm.geodesics_between(atlas, starts, ends)
    assert [path.length for path in paths] == [
        bm.geodesic_between(atlas, start, end).length
        for start, end in zip(starts, ends, strict=True)
    ]
    assert bm.geodesics_between(atlas, [], []) == ()
    with pytest.raises(bm.InputError, match="4 starts and 3 ends"):
        bm.geodesics_between(atlas, starts, ends[1:])
    with pytest.raises(bm.InputError, match="the end of pair 1 is on patch 9"):
        bm.geodesics_between(atlas, starts[:2], [ends[0], AtlasPoint(9, 0.5, 0.5)])


def test_a_point_is_at_no_distance_from_itself() -> None:
    atlas = grid_atlas(2, 1)
    for start, end in (
        (AtlasPoint(0, 0.3, 0.4), AtlasPoint(0, 0.3, 0.4)),
        (AtlasPoint(0, 1.0, 0.4), AtlasPoint(1, 0.0, 0.4)),
    ):
        path = bm.geodesic_between(atlas, start, end)
        assert (path.length, path.error_estimate, path.status) == (0.0, 0.0, bm.Status.CONVERGED)
        np.testing.assert_allclose(path.position([0.0, 0.5, 1.0]), [atlas.position(start)] * 3)


def test_points_that_nearly_meet(rng: np.random.Generator) -> None:
    atlas = wavy_plane(rng)
    start = AtlasPoint(4, 1.0, 0.3)
    for step in (1e-2, 1e-5, 1e-8):
        for end in (AtlasPoint(4, 1.0 - step, 0.3), AtlasPoint(7, step, 0.3 + step)):
            chord = np.linalg.norm(atlas.position(end) - atlas.position(start))
            path = bm.geodesic_between(atlas, start, end)
            assert abs(path.length - chord) <= path.error_estimate + 1e-15
            assert path.length == pytest.approx(chord, rel=1e-6)


def test_round_a_corner_of_the_boundary() -> None:
    # Three unit squares about the corner (1, 1), where the fourth is missing.
    square = grid_atlas(2, 2)
    atlas = Atlas(square.points, square.index[[0, 1, 2]], Unit.CM)
    path = bm.geodesic_between(atlas, AtlasPoint(1, 0.8, 0.9), AtlasPoint(2, 0.7, 0.6))
    expected = np.hypot(0.2, 0.9) + np.hypot(0.7, 0.4)
    assert path.length == pytest.approx(expected, rel=1e-9)
    assert path.status is bm.Status.CONVERGED
    assert path.patches == (1, 0, 2)


@pytest.mark.parametrize("cuts", [((), ()), ((0.5,), ()), ((0.4,), (0.5,))], ids=str)
def test_along_a_boundary_that_bulges_into_the_way(
    cuts: tuple[tuple[float, ...], tuple[float, ...]],
) -> None:
    net = bulging(3.0)
    # The same contact by collocation on one patch, its arcs along the edge by quadrature.
    expected = bm.solve_geodesic(net, (0.0, 0.1), (1.0, 0.1)).length
    atlas = cut(net, *cuts, turn=False)
    path = bm.geodesic_between(atlas, on_cut(cuts, (0.0, 0.1)), on_cut(cuts, (1.0, 0.1)))
    assert path.status is bm.Status.ON_BOUNDARY
    assert path.length == pytest.approx(expected, rel=1e-12)
    assert path.error_estimate <= 1e-9 * expected
    assert_hangs_together(path)


def assert_hangs_together(path: bm.AtlasPath) -> None:
    """The positions along a path make up its length, over its crossings too."""
    t = np.linspace(0.0, 1.0, 2001)
    np.testing.assert_allclose(
        path.position([0.0, 1.0]), [path.atlas.position(end) for end in path.points], atol=1e-12
    )
    steps = np.linalg.norm(np.diff(path.position(t), axis=0), axis=1)
    assert steps.sum() == pytest.approx(path.length, rel=1e-5)
    assert steps.max() < 2.0 * path.length / len(t)
    for crossing in path.crossings:
        before, after = path.atlas.position(crossing.before), path.atlas.position(crossing.after)
        np.testing.assert_allclose(before, after, atol=1e-12)
        np.testing.assert_allclose(path.position(crossing.t), after, atol=1e-9)


def bulging(depth: float) -> NDArray[np.float64]:
    """A plane patch 3 wide and 1 high whose lower edge bulges up into it."""
    x, y = np.meshgrid(np.arange(4) / 3, np.arange(4) / 3, indexing="ij")
    return np.stack([3 * x, y + depth * (1 - y) * x * (1 - x), 0 * x], axis=-1)


@pytest.mark.parametrize("cuts", [((), ()), ((0.5,), ())], ids=str)
def test_along_a_seam_that_holds_it_from_both_sides(
    cuts: tuple[tuple[float, ...], tuple[float, ...]],
) -> None:
    # A sheet and its mirror image, sewn together along the edge that bulges: the path from one to
    # the other is as long as on one of them, along that edge for a part.
    net = bulging(3.0)
    net[..., 2] = 0.4 * np.arange(4) / 3
    expected = bm.solve_geodesic(net, (0.0, 0.1), (1.0, 0.1)).length
    upper = cut(net, *cuts, turn=False)
    number = np.arange(len(upper.points)) + len(upper.points)
    edge = np.unique(upper.index[:: len(cuts[1]) + 1, :, 0])
    number[edge] = edge
    atlas = Atlas(
        np.concatenate([upper.points, upper.points * [1.0, 1.0, -1.0]]),
        np.concatenate([upper.index, number[upper.index][:, ::-1]]),
        Unit.CM,
    )
    start, end = on_cut(cuts, (0.0, 0.1)), on_cut(cuts, (1.0, 0.1))
    end = AtlasPoint(end.patch + len(upper), 1.0 - end.u, end.v)
    for ends in ((start, end), (end, start)):
        path = bm.geodesic_between(atlas, *ends)
        assert path.status is bm.Status.CONVERGED
        assert path.length == pytest.approx(expected, rel=1e-12)
        assert path.error_estimate <= 1e-9 * expected
        assert_hangs_together(path)


def test_from_an_end_on_the_boundary_that_holds_the_path() -> None:
    net = bulging(3.0)
    atlas = cut(net, (0.5,), (), turn=False)
    expected = bm.solve_geodesic(net, (0.4, 0.0), (1.0, 0.1)).length
    path = bm.geodesic_between(atlas, AtlasPoint(0, 0.8, 0.0), AtlasPoint(1, 1.0, 0.1))
    assert path.status is bm.Status.ON_BOUNDARY
    assert path.length == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("columns", [1, 2, 3])
def test_patches_that_close_up_are_gone_round_the_short_way(
    columns: int, rng: np.random.Generator
) -> None:
    # A closed profile of cubics by height; of one patch, it is its own neighbor.
    count = 3 * columns
    angle = 2.0 * np.pi * np.arange(count) / count
    lattice = np.empty((count, 4, 3))
    lattice[..., :2] = np.stack([np.cos(angle), np.sin(angle)], axis=-1)[:, None]
    lattice[..., 2] = np.arange(4)
    ring = (3 * np.arange(columns)[:, None] + np.arange(4)) % count
    index = ring[:, :, None] * 4 + np.arange(4)
    atlas = Atlas(lattice.reshape(-1, 3), index, Unit.CM)

    nodes, weights = np.polynomial.legendre.leggauss(60)

    def arc(point: AtlasPoint) -> float:
        """From the profile's start, at the patch's u."""
        total = 0.0
        for patch in range(point.patch + 1):
            end = point.u if patch == point.patch else 1.0
            u = end * (nodes + 1.0) / 2.0
            net = atlas.control_points[patch, :, 0, :2]
            hodograph = 3.0 * np.diff(net, axis=0)
            basis = np.stack([(1 - u) ** 2, 2 * u * (1 - u), u**2], axis=-1)
            total += np.linalg.norm(basis @ hodograph, axis=1) @ weights * end / 2.0
        return float(total)

    around = arc(AtlasPoint(columns - 1, 1.0, 0.0))
    for _ in range(5):
        start, end = random_point(rng, atlas), random_point(rng, atlas)
        way = abs(arc(end) - arc(start))
        expected = np.hypot(min(way, around - way), 3.0 * (end.v - start.v))
        path = bm.geodesic_between(atlas, start, end)
        assert path.length == pytest.approx(expected, rel=1e-8)


def two_parts() -> Atlas:
    atlas = grid_atlas(1, 2)
    points = np.vstack([atlas.points, atlas.points + np.array([5.0, 0.0, 0.0])])
    index = np.concatenate([atlas.index, atlas.index + len(atlas.points)])
    return Atlas(points, index, Unit.CM, patch_names=("left", "right", "far left", "far right"))


def test_separate_parts_are_refused() -> None:
    with pytest.raises(bm.InputError, match=r"the start is on 'right' and the end on 'far left'"):
        bm.geodesic_between(two_parts(), AtlasPoint(1, 0.5, 0.5), AtlasPoint(2, 0.5, 0.5))
    with pytest.raises(bm.InputError, match=r"via point 0 on 'far right'.* 2 separate parts"):
        bm.geodesic_between(
            two_parts(),
            AtlasPoint(0, 0.5, 0.5),
            AtlasPoint(1, 0.5, 0.5),
            via=[AtlasPoint(3, 0.1, 0.1)],
        )


def test_parts_that_meet_in_a_corner_only_are_separate() -> None:
    square = grid_atlas(2, 2)
    atlas = Atlas(square.points, square.index[[0, 3]], Unit.CM)
    with pytest.raises(bm.InputError, match="no seams join"):
        bm.geodesic_between(atlas, AtlasPoint(0, 0.5, 0.5), AtlasPoint(1, 0.5, 0.5))


@pytest.mark.parametrize(
    ("point", "message"),
    [
        (AtlasPoint(9, 0.5, 0.5), r"the end is on patch 9, .* numbered 0 to 3"),
        (AtlasPoint(-1, 0.5, 0.5), r"the end is on patch -1"),
        (AtlasPoint(0, 1.5, 0.5), r"the end has \(u, v\) = \(1.5, 0.5\)"),
        (AtlasPoint(0, 0.5, float("nan")), r"expected both in \[0, 1\]"),
        ((0, 0.5), r"expected three finite numbers, a landmark's name or an AtlasPoint"),
        ((0, 0.5, 0.5), r"the end at \(0, 0.5, 0.5\) cm is 0.5 cm from the surface, more than"),
    ],
)
def test_points_that_are_not_on_the_atlas(point: AtlasPoint, message: str) -> None:
    with pytest.raises(bm.InputError, match=message):
        bm.geodesic_between(two_parts(), AtlasPoint(0, 0.5, 0.5), point)


def test_a_missing_package_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pygeodesic.geodesic", None)
    with pytest.raises(bm.MissingExtraError, match=r"bodymeasure\[routes\]"):
        bm.geodesic_between(two_parts(), AtlasPoint(0, 0.5, 0.5), AtlasPoint(1, 0.5, 0.5))


def test_other_mistakes() -> None:
    atlas = two_parts()
    ends = AtlasPoint(0, 0.5, 0.5), AtlasPoint(1, 0.5, 0.5)
    with pytest.raises(bm.InputError, match="on_failure is 'ignore'"):
        bm.geodesic_between(atlas, *ends, on_failure="ignore")  # type: ignore[arg-type]
    path = bm.geodesic_between(atlas, *ends)
    for wrong in (1.5, [0.0, float("nan")], "half"):
        with pytest.raises(bm.InputError, match="path parameters"):
            path.path(wrong)
