from dataclasses import replace

import numpy as np
import pytest
from helpers.oracles.body_oracle import mesh_distance, quarter_point
from helpers.surfaces.cut_atlases import random_point
from scipy.spatial.transform import Rotation

import bodymeasure as bm


@pytest.mark.slow
@pytest.mark.parametrize("name", ["female_average", "male_average"])
def test_lengths_across_a_body_agree_with_exact_mesh_distances(
    name: str, rng: np.random.Generator
) -> None:
    body = bm.load_sample(name)
    for _ in range(6):
        start, end = quarter_point(rng, body), quarter_point(rng, body)
        path = bm.geodesic_between(body, start, end)
        exact, doubt = mesh_distance(body, start, end, path.length)
        assert path.length == pytest.approx(exact, abs=3.0 * doubt + 1e-5 * exact)


@pytest.mark.slow
@pytest.mark.parametrize("name", bm.sample_names())
def test_swapped_ends_and_motions_change_no_length_on_a_body(
    name: str, rng: np.random.Generator
) -> None:
    body = bm.load_sample(name)
    turn = Rotation.from_rotvec(rng.normal(size=3)).as_matrix()
    moved = replace(body, points=body.points @ turn.T + rng.normal(size=3))
    for _ in range(6):
        start, end = random_point(rng, body), random_point(rng, body)
        path = bm.geodesic_between(body, start, end)
        assert path.error_estimate <= 1e-6 * path.length
        back, there = (
            bm.geodesic_between(body, end, start),
            bm.geodesic_between(moved, start, end),
        )
        assert back.length == pytest.approx(path.length, rel=1e-9)
        assert there.length == pytest.approx(path.length, rel=1e-9)


def test_landmarks_of_a_symmetric_body_are_at_mirrored_distances() -> None:
    body = bm.load_sample("female_average")
    for first, second in (("shoulder point", "elbow point"), ("bust point", "side waist point")):
        lengths = [
            bm.geodesic_between(
                body, body.landmarks[f"{first} {side}"], body.landmarks[f"{second} {side}"]
            ).length
            for side in ("left", "right")
        ]
        assert lengths[0] == pytest.approx(lengths[1], rel=1e-9)


@pytest.mark.parametrize("name", ["female_average", "male_average"])
def test_down_the_middle_of_the_back_where_the_path_runs_along_seams(name: str) -> None:
    body = bm.load_sample(name)
    nape, waist = body.landmarks["back neck point"], body.landmarks["back waist point"]
    path = bm.geodesic_between(body, nape, waist)
    back = bm.geodesic_between(body, waist, nape)
    assert path.status is bm.Status.CONVERGED
    assert path.error_estimate < 1e-9 * path.length
    assert path.length == pytest.approx(back.length, rel=1e-11)
    # The body is symmetric about x = 0: the path leaves the seams by micrometers.
    np.testing.assert_allclose(path.position(np.linspace(0.0, 1.0, 50))[:, 0], 0.0, atol=1e-4)


def test_a_path_through_the_crotch_has_as_many_functions_as_it_takes() -> None:
    body = bm.load_sample("female_average")
    start, end = bm.AtlasPoint(131, 0.5, 0.5), bm.AtlasPoint(331, 0.5, 0.75)
    ahead, back = bm.geodesic_between(body, start, end), bm.geodesic_between(body, end, start)
    assert ahead.length == pytest.approx(back.length, rel=1e-9)
    assert ahead.error_estimate < 1e-7 * ahead.length
    assert any(body.regions[patch].startswith("crotch") for patch in ahead.patches)
