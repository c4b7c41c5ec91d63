"""Paths over patches that a single polynomial does not follow, so that pieces are cut."""

from itertools import pairwise

import numpy as np
import pytest
import scipy
from helpers.body_space import held_out_body
from helpers.surfaces.extruded_surfaces import row_of

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.atlas import AtlasPoint
from bodymeasure.bezier import bernstein

# Profiles with sharp folds: their speed falls to 0.04 and 0.12 of its mean.
FOLDS = (
    np.array([[0.0, 0.0], [1.1, 0.9], [0.0, 1.0], [1.0, 0.1]]),
    np.array([[1.0, 0.1], [1.8, -0.8], [1.1, -1.0], [2.0, 0.2]]),
)


def extruded(profile: Array) -> Array:
    """A patch over a profile (4, 2), three units long along y."""
    across = np.broadcast_to(profile[:, None, :], (4, 4, 2))
    along = np.broadcast_to(np.arange(4.0)[None, :, None], (4, 4, 1))
    return np.concatenate([across[..., :1], along, across[..., 1:]], axis=-1)


def arc_length(profile: Array, first: float, last: float) -> float:
    def speed(t: float) -> float:
        return float(np.linalg.norm(bernstein(3, np.array([t]), order=1)[0, 1] @ profile))

    found, _ = scipy.integrate.quad(speed, first, last, epsabs=1e-13, epsrel=1e-13, limit=200)
    return float(found)


@pytest.mark.parametrize(
    ("start", "end"),
    [
        ((0.05, 0.1), (0.9, 0.7)),
        ((0.3, 0.9), (0.2, 0.1)),
        pytest.param((0.0, 0.5), (1.0, 0.0), marks=pytest.mark.slow),
    ],
)
def test_paths_over_folds_are_as_long_as_on_the_flat_sheet(
    start: tuple[float, float], end: tuple[float, float]
) -> None:
    atlas = row_of(*map(extruded, FOLDS))
    across = arc_length(FOLDS[0], start[0], 1.0) + arc_length(FOLDS[1], 0.0, end[0])
    expected = float(np.hypot(across, 3.0 * (end[1] - start[1])))
    here, there = AtlasPoint(0, *start), AtlasPoint(1, *end)
    for path in (bm.geodesic_between(atlas, *ends) for ends in ((here, there), (there, here))):
        assert abs(path.length - expected) <= path.error_estimate + 1e-14 * expected
        assert path.error_estimate <= 1e-8 * expected
        # Parts of one patch have no seam between them.
        changes = sum(one != other for one, other in pairwise(path.patches))
        assert len(path.crossings) == changes == 1


def test_uneven_parameters_change_nothing() -> None:
    # The first patch runs along x as 0, 0.001, 0.02, 1, and the second the other way round.
    x = np.array([0.0, 0.001, 0.02, 1.0])
    first, second = (np.stack([values, 0.0 * x], axis=-1) for values in (x, 2.0 - x[::-1]))
    atlas = row_of(extruded(first), extruded(second))
    rng = np.random.default_rng(3)
    for start, end in rng.uniform(size=(6, 2, 2)).tolist():
        here, there = AtlasPoint(0, *start), AtlasPoint(1, *end)
        chord = float(np.linalg.norm(atlas.position(there) - atlas.position(here)))
        path = bm.geodesic_between(atlas, here, there)
        assert abs(path.length - chord) <= path.error_estimate + 1e-14 * chord
        assert path.error_estimate <= 1e-6 * chord


@pytest.mark.slow
@pytest.mark.parametrize("side", ["left", "right"])
def test_paths_over_the_fold_below_a_breast(side: str) -> None:
    body = held_out_body()
    ends = (f"bust point {side}", "front waist point")
    path, back = (bm.geodesic_between(body, *way) for way in (ends, ends[::-1]))
    assert path.error_estimate < 1e-9
    assert abs(path.length - back.length) <= path.error_estimate + back.error_estimate
    # The length of the drawn path, by chords, which fall short of it.
    points = path.position(np.linspace(0.0, 1.0, 20_001))
    chords = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    assert path.length - 2e-7 < chords < path.length + path.error_estimate
