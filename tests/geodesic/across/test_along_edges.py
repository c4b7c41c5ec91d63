"""Paths that an edge of the atlas, or a seam, holds for a part, or that lead round a corner."""

import numpy as np
import pytest
from helpers.surfaces.cut_atlases import (
    cut,
    on_cut,
    random_point,
)
from helpers.surfaces.grids import grid_atlas

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint, Unit


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


def bulging(depth: float) -> Array:
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
