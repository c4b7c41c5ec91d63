"""The independent method that gives the true lengths."""

import numpy as np
import pytest
from helpers.surfaces.surfaces import ENNEPER, SURFACES, Surface

from bodymeasure import load_sample
from bodymeasure.bench.problems.patches import Problems, both_diagonals, mild_patches, wild_patches
from bodymeasure.bench.problems.reference import GUESS_TIMES, geodesics
from bodymeasure.bench.problems.sets import body_set, mild_set, wild_set


def one(surface: Surface) -> Problems:
    ends = (np.array([point]) for point in (surface.start, surface.end))
    return Problems(surface.control_points[None], *ends)


@pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
def test_lengths_in_closed_form(surface: Surface) -> None:
    known = geodesics(one(surface))
    np.testing.assert_allclose(known.length, surface.length, rtol=5e-15)
    assert not known.leaves.any()


def test_a_bent_start_ends_in_the_same_path() -> None:
    bow = 0.2 * np.sin(np.pi * GUESS_TIMES)[:, None] * [1.0, -1.0]
    guess = (GUESS_TIMES[:, None] + bow)[None]
    before = guess.copy()
    known = geodesics(one(SURFACES[0]), guess=guess)
    np.testing.assert_allclose(known.length, SURFACES[0].length, rtol=5e-15)
    np.testing.assert_array_equal(guess, before)


def test_a_geodesic_that_leaves_its_patch_has_no_length() -> None:
    # On the surface's continuation the path between points of an edge runs outside.
    problems = Problems(ENNEPER[None], np.array([[0.0, 0.0]]), np.array([[1.0, 0.0]]))
    bulging = problems.nets.copy()
    bulging[:, 1:3, 0, 1] += 0.4
    known = geodesics(problems._replace(nets=bulging))
    assert known.leaves.all()
    assert np.isnan(known.length).all()


def test_random_patches_are_as_described(rng: np.random.Generator) -> None:
    mild, wild = mild_patches(rng, 50, 0.3), wild_patches(rng, 50, 0.6)
    assert (mild[..., :2].max(), wild[..., :2].max()) == (1.0, 0.6)
    assert 0.0 <= mild[..., 2].min() < mild[..., 2].max() < 0.3
    assert set(np.unique(np.round(5.0 * wild[..., 2], 12))) == {0, 1, 2, 3, 4, 5}
    assert (wild[:, 0, 0, 2] == 0.0).all()
    assert (wild[:, 3, 3, 2] == 1.0).all()


@pytest.mark.parametrize("make", [mild_set, wild_set, body_set])
def test_no_problem_of_a_set_is_lost_unsaid(make: type) -> None:
    found = make(12)
    assert found.drawn == 12
    assert len(found) + found.leaving + found.unresolved == 12
    assert np.isfinite(found.truth).all()
    chord = np.linalg.norm(found.problems.nets[:, 0, 0] - found.problems.nets[:, -1, -1], axis=-1)
    if found.name != "body":
        assert (found.truth >= chord).all()


def test_diagonals_of_a_body_stand_patch_by_patch() -> None:
    atlas = load_sample("enneper")
    problems = both_diagonals(atlas)
    np.testing.assert_array_equal(problems.start, [[0, 0], [1, 0]])
    np.testing.assert_array_equal(problems.end, [[1, 1], [0, 1]])
    np.testing.assert_array_equal(problems.nets[0], problems.nets[1])
