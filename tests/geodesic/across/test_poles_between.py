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
