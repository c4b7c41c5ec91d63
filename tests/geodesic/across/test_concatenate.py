"""Concatenated paths are the path through all their points."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from helpers.surfaces.cut_atlases import random_point, wavy_plane

from bodymeasure.geodesic import AtlasPath, Status, geodesic_between


def test_joined_paths_are_the_path_through_all_points(rng: np.random.Generator) -> None:
    atlas = wavy_plane(rng)
    start, *via, end = (random_point(rng, atlas) for _ in range(4))
    whole = geodesic_between(atlas, start, end, via)
    points = [start, *via, end]
    legs = [geodesic_between(atlas, *ends) for ends in pairwise(points)]
    path = AtlasPath.concatenate(legs)
    assert path.points == whole.points
    assert path.patches == whole.patches
    assert path.length == pytest.approx(whole.length, rel=1e-14)
    assert path.error_estimate == pytest.approx(whole.error_estimate)
    t = np.linspace(0.0, 1.0, 50)
    np.testing.assert_allclose(path.position(t), whole.position(t), atol=1e-12)
    assert len(path.crossings) == len(whole.crossings)
    for crossing, known in zip(path.crossings, whole.crossings, strict=True):
        assert crossing.before == known.before
        assert crossing.t == pytest.approx(known.t, abs=1e-13)
    assert AtlasPath.concatenate(legs[:1]) is legs[0]


def test_the_status_is_that_of_the_worst_leg(rng: np.random.Generator) -> None:
    atlas = wavy_plane(rng)
    first, second, third = (random_point(rng, atlas) for _ in range(3))
    good, other = geodesic_between(atlas, first, second), geodesic_between(atlas, second, third)
    touching = replace(other, status=Status.ON_BOUNDARY)
    failed = replace(other, status=Status.NOT_CONVERGED, length=np.nan)
    assert AtlasPath.concatenate([good, touching]).status is Status.ON_BOUNDARY
    path = AtlasPath.concatenate([touching, failed, good])
    assert path.status is Status.NOT_CONVERGED
    assert np.isnan(path.length)
    lost = replace(other, status=Status.NO_ROUTE, length=np.nan, pieces=(), crossings=())
    nowhere = AtlasPath.concatenate([good, lost])
    assert nowhere.status is Status.NO_ROUTE
    assert nowhere.pieces == ()
    assert nowhere.crossings == ()
