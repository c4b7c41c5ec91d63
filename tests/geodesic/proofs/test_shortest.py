"""Geodesics that are proven to be the only shortest paths on their patches, and others."""

import pickle
from typing import Any

import numpy as np
import pytest
from helpers.speed import quick

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.bench.problems.patches import mild_patches, wild_patches
from bodymeasure.bezier import elevate
from bodymeasure.geodesic.proofs.curvature import CurvatureBounds
from bodymeasure.geodesic.proofs.shortest import are_shortest, bounds_for_paths, proves

BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")
FEWEST = {"female_full_bust": 726, "male_average": 752}


@pytest.mark.parametrize("name", quick(BODIES))
def test_nearly_all_diagonals_of_bodies_are_proven(name: str) -> None:
    solutions = bm.diagonals(bm.load_sample(name))
    assert solutions.proven_shortest.shape == solutions.shape
    assert solutions.proven_shortest.sum() >= FEWEST.get(name, 738)


def test_mild_patches_are_proven(rng: np.random.Generator) -> None:
    solutions = bm.solve_geodesic(mild_patches(rng, 200, 0.3), (0.0, 0.0), (1.0, 1.0))
    assert solutions.proven_shortest.all()


def test_the_verdict_has_no_unit_and_no_direction(rng: np.random.Generator) -> None:
    nets = wild_patches(rng, 60, 1.0)
    settings: Any = {"search": "straight", "on_failure": "status"}
    proven = bm.solve_geodesic(nets, (0, 0), (1, 1), **settings).proven_shortest
    assert 0 < proven.sum() < 60
    for scale in (1000.0, 2.0**-300):
        scaled = bm.solve_geodesic(nets * scale, (0, 0), (1, 1), **settings)
        np.testing.assert_array_equal(scaled.proven_shortest, proven)
    turned = bm.solve_geodesic(nets, (1, 1), (0, 0), **settings)
    np.testing.assert_array_equal(turned.proven_shortest, proven)


def test_parts_and_single_problems_keep_their_verdicts(rng: np.random.Generator) -> None:
    nets = np.concatenate([mild_patches(rng, 3, 0.3), wild_patches(rng, 9, 0.6)])
    solutions = bm.solve_geodesic(nets, (0, 0), (1, 1), on_failure="status")
    proven = solutions.proven_shortest
    assert type(solutions[0].proven_shortest).__name__ == "bool"
    chosen = [11, 0, 0, 7]
    np.testing.assert_array_equal(solutions[chosen].proven_shortest, proven[chosen])
    # Only the patches that are needed go with a part.
    assert len(pickle.dumps(solutions[2])) < len(pickle.dumps(solutions)) / 2
    assert pickle.loads(pickle.dumps(solutions[2])).proven_shortest


def test_nothing_is_proven_of_failures_and_of_other_surfaces() -> None:
    class Plane:
        def derivatives(self, parameters: Array) -> Array:
            result = np.zeros((*parameters.shape[:-1], 10, 3))
            result[..., 0, :2] = parameters
            result[..., 1, 0] = result[..., 2, 1] = 1.0
            return result

    assert not bm.solve_geodesic(Plane(), (0, 0), (1, 1)).proven_shortest
    net = bm.load_sample("paraboloid").control_points[0]
    assert not bm.solve_geodesic(net, (0, 0), (1, 1)).proven_shortest
    assert bm.solve_geodesic(net, (0, 0), (0.3, 0.3)).proven_shortest
    rational = bm.homogeneous(net, np.ones((4, 4)))
    assert not bm.solve_geodesic(rational, (0, 0), (0.3, 0.3)).proven_shortest
    lengths = np.array([np.nan, 0.0])
    bounds = bounds_for_paths(net[None], np.zeros(2, int), lengths)
    np.testing.assert_array_equal(are_shortest(bounds, lengths), [False, True])


def symmetric_patches(rng: np.random.Generator, count: int, height: float) -> Array:
    """Patches that are their own mirror images, with a bump between (0, 0) and (1, 1)."""
    nets = mild_patches(rng, count, 0.2)
    nets[:, 1:3, 1:3, 2] += height
    nets[..., 2] = (nets[..., 2] + nets[..., 2].swapaxes(1, 2)) / 2.0
    return nets


def test_paths_that_have_a_twin_are_never_proven(rng: np.random.Generator) -> None:
    """A shortest path off the plane of symmetry has a mirror image of the same length."""
    nets = symmetric_patches(rng, 60, 1.5)
    solutions = bm.solve_geodesic(nets, (0, 0), (1, 1), search="thorough", on_failure="status")
    middle = solutions.path(0.5)
    twins = solutions.converged & (np.abs(middle[:, 0] - middle[:, 1]) > 1e-3)
    assert twins.sum() >= 30
    assert not solutions.proven_shortest[twins].any()
    # Neither are the geodesics over the bump, which are longer.
    over = bm.solve_geodesic(nets, (0, 0), (1, 1), search="straight", on_failure="status")
    assert not over.proven_shortest[twins & (over.length > solutions.length * (1 + 1e-9))].any()


def test_of_whole_curvature_there_may_not_be_too_much() -> None:
    """On a sphere without a cap, geodesics round the rim are shorter than pi, and have twins."""
    # The stereographic map of a square, as a rational patch, of a degree with positive weights.
    x, square = np.array([-2.0, 0.0, 2.0]), np.array([4.0, -4.0, 4.0])
    x, y = np.meshgrid(x, x, indexing="ij")
    squares = np.add.outer(square, square)
    parts = [2.0 * x, 2.0 * y, squares - 1.0, squares + 1.0]
    net = elevate(np.stack(parts, axis=-1), 12, 12)
    solution = bm.solve_geodesic(net, (0, 0), (1, 1), search="thorough")
    assert solution.status is bm.Status.ON_BOUNDARY
    assert 2.5 < solution.length < np.pi
    u, v = solution.path(0.5)
    assert abs(u - v) > 0.5
    # The bound of the curvature alone would prove it, and that of its integral does not.
    area = 4.0 * np.pi * 5.0 / 6.0
    largest = np.array([(np.pi / solution.length) ** 2])
    one, whole = np.ones(1), np.array([area])
    assert not proves(CurvatureBounds(one, whole, whole), largest).any()
    assert proves(CurvatureBounds(one, whole / 2.0, whole), largest).all()


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["wild 1", "wild 0.6", "symmetric", "high"])
def test_a_thorough_search_finds_nothing_shorter_than_what_is_proven(kind: str) -> None:
    rng = np.random.default_rng(["wild 1", "wild 0.6", "symmetric", "high"].index(kind))
    nets = {
        "wild 1": lambda: wild_patches(rng, 1000, 1.0),
        "wild 0.6": lambda: wild_patches(rng, 1000, 0.6),
        "symmetric": lambda: symmetric_patches(rng, 1000, 0.3),
        "high": lambda: mild_patches(rng, 1000, 1.5),
    }[kind]()
    straight = bm.solve_geodesic(nets, (0, 0), (1, 1), search="straight", on_failure="status")
    proven = np.flatnonzero(straight.proven_shortest)
    assert len(proven) > 30
    searched = bm.solve_geodesic(nets[proven], (0, 0), (1, 1), search="thorough")
    assert (searched.length > straight.length[proven] * (1.0 - 1e-9)).all()
