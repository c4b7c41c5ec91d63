"""Bounds of lengths on both sides, which hold whatever the computed path is like."""

import numpy as np
import pytest
from helpers.speed import quick
from helpers.surfaces.surfaces import SURFACES, Surface

import bodymeasure as bm
from bodymeasure.bench.problems.patches import mild_patches, wild_patches
from bodymeasure.geodesic import closer_bounds
from bodymeasure.geodesic.lengths.path_geometry import path_geometry
from bodymeasure.geodesic.proofs import patches
from bodymeasure.geodesic.proofs.bounds import RESOLVED, bounds_of, sample_paths, shortfall
from bodymeasure.geodesic.spaces.kernels import WU_C2

BODIES = ("male_average", "female_average", "female_full_bust", "female_heavy", "female_old")


def test_the_shortfall_is_that_of_circles_in_planes_and_on_spheres() -> None:
    turn = np.array([1e-9, 1e-5, 0.01, 1.0, 2.0])
    # In the plane, an arc of curvature c and length 1 has the chord 2 sin(c / 2) / c.
    chord = 2.0 * np.sin(turn / 2.0) / turn
    found = shortfall(np.ones(5), turn, np.zeros(5))
    np.testing.assert_allclose(found[2:], 1.0 - chord[2:], rtol=1e-5)
    np.testing.assert_allclose(found[:3], turn[:3] ** 2 / 24.0, rtol=1e-5)
    # On the unit sphere, a circle at a distance r from its pole has the curvature 1 / tan r.
    radius, angle = 1.1, np.array([0.1, 1.0, 2.5])
    length = angle * np.sin(radius)
    apart = 2.0 * np.arcsin(np.sin(radius) * np.sin(angle / 2.0))
    found = shortfall(length, np.full(3, 1.0 / np.tan(radius)), np.ones(3))
    np.testing.assert_allclose(found, length - apart, rtol=1e-12, atol=1e-16)
    # Past half of the circle the theorem says nothing.
    assert np.isnan(shortfall(np.array([3.2]), np.zeros(1), np.ones(1))).all()
    assert np.isnan(shortfall(np.ones(1), np.array([np.nan]), np.ones(1))).all()


@pytest.mark.parametrize("functions", quick((8, 4, 6, 12, 20)))
@pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
def test_bounds_contain_lengths_in_closed_form(surface: Surface, functions: int) -> None:
    method = bm.RBFCollocation(functions=functions, tolerance=1.0)
    solution = bm.solve_geodesic(
        surface.control_points, surface.start, surface.end, method=method, on_failure="status"
    )
    if not solution.converged:
        assert np.isnan(solution.bounds).all()
        return
    lower, upper = solution.bounds
    # The closed form itself is rounded.
    assert lower <= surface.length * (1.0 + 1e-15)
    assert upper >= surface.length * (1.0 - 1e-15)
    assert 0.0 <= upper - lower < upper


def contain(solution: bm.GeodesicSolution, exact: bm.GeodesicSolution) -> bool:
    """Whether the bounds agree with lengths, as far as these are known."""
    lower, upper = solution.bounds
    length, error = exact.length, exact.error_estimate
    known = solution.converged & exact.converged
    return bool(((lower - error <= length) & (length <= upper + error))[known].all())


def test_poor_paths_have_bounds_that_hold_and_that_finer_paths_bring_closer(
    rng: np.random.Generator,
) -> None:
    nets = mild_patches(rng, 50, 0.3)
    exact = bm.solve_geodesic(nets, (0, 0), (1, 1), method=bm.RBFCollocation(functions=20))
    for kernel, functions in ((WU_C2, 3), (bm.WU_C10, 4), (bm.WU_C10, 6)):
        method = bm.RBFCollocation(kernel, functions=functions, tolerance=1.0)
        poor = bm.solve_geodesic(nets, (0, 0), (1, 1), method=method, on_failure="status")
        assert poor.converged.any()
        assert contain(poor, exact)
        assert poor.patches is not None
        # Those of the paths themselves do not rest on an error estimate: they are as wide as the
        # paths are poor, and hold.
        curvature = poor.patches.curvature(exact.length * 1.1)
        own = poor.patches.bounds(poor.batches, curvature)
        assert ((own.lower <= exact.length) & (exact.length <= own.upper)).all()
        assert np.nanmedian(own.upper / own.lower) > 1.0 + 1e-6
        closer = poor.bounds.upper / poor.bounds.lower - 1.0
        assert np.nanmedian(closer) < 1e-9


@pytest.mark.parametrize("name", quick(BODIES))
def test_bounds_contain_the_diagonals_of_bodies_and_are_close(name: str) -> None:
    body = bm.load_sample(name)
    method = bm.RBFCollocation(functions=20)
    fine = bm.diagonals(body, method=method, on_failure="status")
    usual = bm.diagonals(body)
    assert contain(usual, usual)
    assert contain(usual, fine)
    known = fine.converged
    (lower, upper), length = fine.bounds, fine.length
    assert ((lower <= length) & (length <= upper))[known].all()
    width = ((upper - lower) / upper)[known]
    assert np.median(width) <= 1.2e-15
    assert np.quantile(width, 0.95) <= 1e-9


def test_wild_patches_have_bounds_that_hold(rng: np.random.Generator) -> None:
    nets = wild_patches(rng, 100, 1.0)
    solution = bm.solve_geodesic(nets, (0, 0), (1, 1), on_failure="status")
    assert contain(solution, solution)
    # Along an edge, the distance in space is left.
    chord = np.linalg.norm(nets[:, 3, 3] - nets[:, 0, 0], axis=-1)
    edge = np.asarray(solution.status) == bm.Status.ON_BOUNDARY
    assert edge.any()
    np.testing.assert_allclose(solution.bounds.lower[edge], chord[edge], rtol=1e-14)


def test_bounds_have_the_unit_and_the_shape_of_the_lengths(rng: np.random.Generator) -> None:
    nets = mild_patches(rng, 6, 0.3).reshape(2, 3, 4, 4, 3)
    one = bm.solve_geodesic(nets, (0, 0), (1, 1))
    large = bm.solve_geodesic(nets * 1000.0, (0, 0), (1, 1))
    assert one.bounds.lower.shape == (2, 3)
    np.testing.assert_allclose(large.bounds, 1000.0 * np.array(one.bounds), rtol=1e-9)
    single = one[1, 2]
    assert np.ndim(single.bounds.lower) == 0
    np.testing.assert_allclose(single.bounds, [each[1, 2] for each in one.bounds], rtol=1e-14)


def test_patches_far_from_the_origin_have_bounds_that_hold() -> None:
    # These coordinates have few digits, so that moving the patch rounds nothing.
    u, v = np.meshgrid([0.0, 1.0, 2.0, 4.0], [0.0, 1.0, 3.0, 4.0], indexing="ij")
    net = np.stack([u, v, np.zeros_like(u)], axis=-1)
    start, end = (0.1, 0.8), (1.0, 0.2)
    near = bm.solve_geodesic(net, start, end)
    far = bm.solve_geodesic(net + 1e9, start, end)
    assert near.bounds.lower <= near.length <= near.bounds.upper
    assert far.bounds.lower <= near.bounds.upper
    np.testing.assert_allclose(far.bounds.lower, near.length, rtol=1e-13)


def test_ends_that_are_nearly_or_quite_in_one_place_have_bounds_that_hold(
    rng: np.random.Generator,
) -> None:
    net = mild_patches(rng, 1, 0.3)[0]
    start = np.array([0.3, 0.3])
    steps = np.array([[2.0**-54, 0.0], [2.0**-50, 0.0], [0.0, 2.0**-40], [0.0, 0.0]])
    solution = bm.solve_geodesic(net, start, start + steps)
    (lower, upper), length = solution.bounds, solution.length
    assert (length[:3] > 0.0).all()
    assert ((lower <= length) & (length <= upper)).all()
    np.testing.assert_array_equal([lower[3], upper[3]], 0.0)
    assert [*bm.solve_geodesic(net, start, start).bounds] == [0.0, 0.0]
    # Along an edge that is collapsed to a point, the length is zero up to its error.
    net[0] = net[0, :1]
    edge = bm.solve_geodesic(net, (0.0, 0.3), (0.0, 0.8))
    assert [*edge.bounds] == [0.0, edge.error_estimate]


def test_the_largest_curvature_is_known_where_samples_resolve_a_path(
    rng: np.random.Generator,
) -> None:
    nets = wild_patches(rng, 60, 0.8)
    times, seen = np.linspace(0.0, 1.0, 2001), 0
    for functions in (3, 5, 8):
        method = bm.RBFCollocation(functions=functions, tolerance=1.0)
        poor = bm.solve_geodesic(nets, (0, 0), (1, 1), method=method, on_failure="status")
        assert poor.patches is not None
        for batch in poor.batches:
            surface = poor.patches.surfaces.take(poor.patches.surface_of[batch.problems])
            found = sample_paths(surface, batch.space, batch.values)
            geometry = path_geometry(
                surface, *(batch.values @ rows.T for rows in batch.space.matrices(times))
            )
            most = np.abs(geometry.geodesic_curvature).max(axis=0)
            known = np.abs(batch.length.raw - found.length) <= RESOLVED * found.length
            assert (most <= found.curvature)[known & np.isfinite(found.curvature)].all()
            # No bound but the distance follows from paths that are not resolved.
            none, flat = np.zeros(len(known)), np.zeros(len(known))
            lower = bounds_of(batch.length.raw, found, flat, none).lower
            assert (lower[~known] == 0.0).all()
            seen += int(known.sum())
    assert seen > 20


def test_many_paths_have_the_bounds_of_few(
    rng: np.random.Generator, monkeypatch: pytest.MonkeyPatch
) -> None:
    nets = np.concatenate([mild_patches(rng, 12, 0.5), wild_patches(rng, 12, 0.8)])
    once = bm.solve_geodesic(nets, (0, 0), (1, 1), on_failure="status").bounds
    for module in (patches, closer_bounds):
        monkeypatch.setattr(module, "TOGETHER", 5)
    parts = bm.solve_geodesic(nets, (0, 0), (1, 1), on_failure="status").bounds
    np.testing.assert_allclose(parts, once, rtol=1e-13)
