"""Lengths of paths across patches that are known, or that a change must not change."""

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
from scipy.optimize import brentq

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint, Unit
from bodymeasure.bezier import evaluate

CUTS: dict[str, tuple[tuple[float, ...], tuple[float, ...]]] = {
    "whole": ((), ()),
    "in two": ((0.4,), ()),
    "in four": ((0.5,), (0.5,)),
    "in nine": ((0.3, 0.65), (0.2, 0.7)),
    "in sixty-four": (tuple(np.arange(1, 8) / 8), tuple(np.arange(1, 8) / 8)),
}
MANY_CUTS = ("in two", "in sixty-four")


@pytest.mark.parametrize(
    "cuts",
    [
        pytest.param(cuts, id=name, marks=pytest.mark.slow if name in MANY_CUTS else ())
        for name, cuts in CUTS.items()
    ],
)
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
    for _ in range(12):
        start, end = random_point(rng, atlas), random_point(rng, atlas)
        chord = np.linalg.norm(atlas.position(end) - atlas.position(start))
        path = bm.geodesic_between(atlas, start, end)
        assert path.length == pytest.approx(chord, rel=1e-9)
        assert abs(path.length - chord) <= path.error_estimate
        crossed += len(path.crossings)
        # The path itself is straight, and its speed is constant.
        t = np.linspace(0.0, 1.0, 21)[:, None]
        line = (1.0 - t) * atlas.position(start) + t * atlas.position(end)
        np.testing.assert_allclose(path.position(t[:, 0]), line, atol=2e-4)
    assert crossed > 12


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
    net: Array, rng: np.random.Generator
) -> None:
    compared = 0
    for _ in range(4):
        atlas, corners = slant_cut(net, rng)
        start, end = random_point(rng, atlas), random_point(rng, atlas)
        ends = [on_part(corners[point.patch], point.u, point.v).tolist() for point in (start, end)]
        whole = bm.solve_geodesic(net, *ends)
        path = bm.geodesic_between(atlas, start, end)
        assert path.status is whole.status
        compared += int(whole.status is bm.Status.CONVERGED)
        assert path.length == pytest.approx(whole.length, rel=1e-9)
    assert compared >= 2


def rotation(rng: np.random.Generator) -> np.ndarray:
    q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    return np.asarray(q * np.linalg.det(q))


def test_swapped_ends_motions_and_scales_change_nothing(rng: np.random.Generator) -> None:
    atlas = cut(PARABOLOID, (0.3, 0.65), (0.2, 0.7))
    moved = Atlas(atlas.points @ rotation(rng).T + [3.0, -2.0, 5.0], atlas.index, Unit.CM)
    larger = Atlas(atlas.points * 1e3, atlas.index, Unit.CM)
    for _ in range(3):
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
            # The path is trimmed to the patch on which it really starts.
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
