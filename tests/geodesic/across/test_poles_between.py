"""Paths over atlases some of whose sides are collapsed to points."""

import numpy as np
import pytest
from helpers.speed import quick
from helpers.surfaces.cut_atlases import random_point
from helpers.surfaces.tubes import cone

import bodymeasure as bm
from bodymeasure.atlas import AtlasPoint
from bodymeasure.atlas.topology.neighbors import Neighbors


def test_chords_of_a_flat_disc_of_four_patches_about_a_pole(rng: np.random.Generator) -> None:
    disc = cone(0.0)
    good = 0
    for _ in range(8):
        start, end = random_point(rng, disc), random_point(rng, disc)
        chord = np.linalg.norm(disc.position(end) - disc.position(start))
        path = bm.geodesic_between(disc, start, end, on_failure="status")
        # Paths that pass close to the pole may be too much for polynomials, and say so.
        assert path.status in (bm.Status.CONVERGED, bm.Status.NOT_CONVERGED)
        if path.converged:
            good += 1
            assert path.length == pytest.approx(chord, rel=1e-9)
            assert abs(path.length - chord) <= path.error_estimate
    assert good >= 7


@pytest.mark.parametrize("height", quick([0.5, 0.0, -2.0]))
def test_rulings_of_a_cone_from_its_tip(height: float, rng: np.random.Generator) -> None:
    atlas = cone(height)
    for _ in range(6):
        # The tip is a point of all patches, at any v.
        tip = AtlasPoint(int(rng.integers(4)), 0.0, float(rng.random()))
        other = random_point(rng, atlas)
        chord = np.linalg.norm(atlas.position(other) - atlas.position(tip))
        for ends in ((tip, other), (other, tip)):
            path = bm.geodesic_between(atlas, *ends)
            assert path.status is bm.Status.CONVERGED
            assert path.length == pytest.approx(chord, rel=1e-9)


def test_the_straight_line_through_the_pole_is_right_or_has_a_status() -> None:
    disc = cone(0.0)
    for v in (0.2, 0.5):
        start, end = AtlasPoint(0, 0.5, v), AtlasPoint(2, 0.8, v)
        path = bm.geodesic_between(disc, start, end, on_failure="status")
        if path.converged:
            chord = np.linalg.norm(disc.position(end) - disc.position(start))
            assert path.length == pytest.approx(chord, rel=1e-9)
        else:
            assert path.status is bm.Status.NOT_CONVERGED
            assert np.isnan(path.length)


def test_all_places_of_a_tip_are_one_point() -> None:
    atlas = cone(1.0)
    neighbors = Neighbors(atlas)
    tip = AtlasPoint(1, 0.0, 0.3)
    assert {place.patch for place in neighbors.same(tip)} == {0, 1, 2, 3}
    assert neighbors.are_same(tip, AtlasPoint(3, 0.0, 0.8))
    assert not neighbors.are_same(tip, AtlasPoint(1, 0.1, 0.3))
    assert {len(way) for way in neighbors.ways(tip, AtlasPoint(3, 0.0, 0.8))} == {2}
    path = bm.geodesic_between(atlas, tip, AtlasPoint(3, 0.0, 0.8))
    assert (path.length, path.status) == (0.0, bm.Status.CONVERGED)


@pytest.mark.parametrize("ends", [((1e-8, 1e-10), (0.624, 0.57)), ((0.0, 0.0), (0.9, 0.1))])
def test_paths_that_end_where_two_collapsed_sides_of_a_patch_meet(
    ends: tuple[tuple[float, float], tuple[float, float]],
) -> None:
    # (u^2 v, u v^2): between two parabolas, which is convex, so that chords are shortest.
    once, squared = np.array([0.0, 1.0, 2.0, 3.0]) / 3.0, np.array([0.0, 0.0, 1.0, 3.0]) / 3.0
    net = np.stack([np.outer(squared, once), np.outer(once, squared), np.zeros((4, 4))], axis=-1)
    index = np.zeros((1, 4, 4), np.int64)
    index[0, 1:, 1:] = np.arange(1, 10).reshape(3, 3)
    points = np.concatenate([np.zeros((1, 3)), net[1:, 1:].reshape(-1, 3)])
    atlas = bm.Atlas(points, index, bm.Unit.M)
    one, other = (AtlasPoint(0, *each) for each in ends)
    chord = np.linalg.norm(atlas.position(one) - atlas.position(other))
    for path in (bm.geodesic_between(atlas, one, other), bm.geodesic_between(atlas, other, one)):
        assert path.length == pytest.approx(chord, abs=1e-9)
        assert abs(path.length - chord) <= path.error_estimate
