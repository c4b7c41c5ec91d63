"""The form with one unknown function, compared with calculus and with the other form."""

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from itertools import pairwise
from typing import Any

import array_api_compat.numpy
import numpy as np
import pytest
from benchmarks.independent import reference
from helpers.surfaces.surfaces import ENNEPER, PH_CYLINDER, SURFACES

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.bezier import derivatives, evaluate
from bodymeasure.geodesic.graph.equation import linearize, offset_geometry
from bodymeasure.geodesic.graph.maps import FIELDS, offset_map
from bodymeasure.geodesic.graph.solve import solve_offsets
from bodymeasure.geodesic.lengths.path_geometry import path_geometry
from bodymeasure.geodesic.solving.protocol import MethodResult
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.native import without_kernels

METHOD = bm.RBFCollocation()
SPACES = [lambda count=count: METHOD._space(count) for count in (8, 12, 16, 20)]
TIMES = np.array([0.0, 0.2, 0.5, 0.9])


def coefficients(nets: Array, degrees: tuple[int, int]) -> Array:
    columns = nets.reshape(len(nets), -1, 3).transpose(1, 2, 0).reshape(-1, 3 * len(nets))
    product = offset_map(degrees, tuple(TIMES)) @ columns
    return np.asarray(product).reshape(-1, len(FIELDS), len(TIMES), 3, len(nets))


@pytest.mark.parametrize("degrees", [(1, 1), (3, 3), (2, 4)])
def test_fields_are_polynomials_in_the_offset(
    degrees: tuple[int, int], rng: np.random.Generator
) -> None:
    nets = rng.normal(size=(3, degrees[0] + 1, degrees[1] + 1, 3))
    offset = rng.uniform(-0.4, 0.4, (len(TIMES), 3))
    powers = offset ** np.arange(sum(degrees))[:, None, None]
    fields = np.einsum("aftcp,atp->ftpc", coefficients(nets, degrees), powers)
    there = np.stack([TIMES[:, None] + offset, TIMES[:, None] - offset], axis=-1)
    d = np.moveaxis(derivatives(nets, there.swapaxes(0, 1), order=2), 1, 0)
    np.testing.assert_allclose(fields[0], d[:, :, 1, 0] - d[:, :, 0, 1], atol=1e-12)
    np.testing.assert_allclose(fields[1], d[:, :, 1, 0] + d[:, :, 0, 1], atol=1e-12)
    twice = d[:, :, 2, 0] + 2.0 * d[:, :, 1, 1] + d[:, :, 0, 2]
    np.testing.assert_allclose(fields[2], twice, atol=1e-11)


def test_the_derivatives_of_the_equation(rng: np.random.Generator) -> None:
    parts = coefficients(rng.normal(size=(5, 4, 4, 3)), (3, 3))
    path = [rng.uniform(-0.3, 0.3, (len(TIMES), 5)) for _ in range(3)]

    def equation(offset: Array, slope: Array, bend: Array) -> tuple[Array, Array, Array, Array]:
        return linearize(parts, offset, slope, bend, array_api_compat.numpy)

    _, *slopes = equation(*path)
    step = 1e-5
    for number, slope in enumerate(slopes):
        ahead, behind = ([x.copy() for x in path] for _ in range(2))
        ahead[number] += step
        behind[number] -= step
        difference = (equation(*ahead)[0] - equation(*behind)[0]) / (2.0 * step)
        np.testing.assert_allclose(slope, difference, rtol=1e-6, atol=1e-6 * np.abs(slope).max())


def test_the_geometry_is_that_of_the_path_in_u_and_v(rng: np.random.Generator) -> None:
    nets = rng.normal(size=(5, 4, 4, 3))
    offset, slope, bend = (rng.uniform(-0.3, 0.3, (len(TIMES), 5)) for _ in range(3))
    here = offset_geometry(coefficients(nets, (3, 3)), offset, slope, bend, array_api_compat.numpy)
    sides = [
        np.stack([along + across, along - across], axis=1).transpose(2, 1, 0)
        for along, across in ((TIMES[:, None], offset), (1.0, slope), (0.0, bend))
    ]
    there = path_geometry(BezierSurfaces(nets), *sides)
    np.testing.assert_allclose(here.speed, there.speed, rtol=1e-12)
    np.testing.assert_allclose(here.gaussian_curvature, there.gaussian_curvature, rtol=1e-9)
    # The sign depends only on the choice of the sides.
    np.testing.assert_allclose(
        np.abs(here.geodesic_curvature), np.abs(there.geodesic_curvature), rtol=1e-9
    )


def solved(nets: Any, start: Array, end: Array) -> MethodResult:
    return solve_offsets(SPACES, BezierSurfaces(nets), (start, end), 1e-10)


def lengths(result: MethodResult, count: int) -> Array:
    length = np.full(count, np.nan)
    for batch in result.batches:
        length[batch.problems] = batch.length.corrected
        # Only lengths that can be trusted are returned, or paths that are far outside the patch.
        inside = ~batch.space.leaves_patch(batch.values, 0.02)
        assert batch.converged[inside].all()
    return length


def test_mild_patches_are_its_business(rng: np.random.Generator) -> None:
    nets = reference.mild_patches(rng, 300, 0.3)
    problems = reference.first_diagonals(nets)
    known = reference.geodesics(problems).length
    length = lengths(solved(nets, problems.start, problems.end), len(nets))
    assert np.isfinite(length).mean() > 0.99
    error = np.abs(length / known - 1.0)
    assert np.nanmax(error) < 1e-10
    assert np.nanmedian(error) < 1e-14


def test_any_points_and_all_corners(rng: np.random.Generator) -> None:
    nets = reference.mild_patches(rng, 300, 0.3)
    start, end = rng.random((2, 300, 2))
    start[:40] = rng.integers(0, 2, (40, 2))
    end[:40] = 1.0 - start[:40]
    known = reference.geodesics(reference.Problems(nets, start, end)).length
    length = lengths(solved(nets, start, end), 300)
    corners = lengths(solved(nets[:40], start[:40], end[:40]), 40)
    np.testing.assert_allclose(corners, length[:40], rtol=1e-10)
    assert np.isfinite(length).mean() > 0.9
    assert np.nanmax(np.abs(length / known - 1.0)) < 1e-9


def test_what_is_not_across_is_left() -> None:
    start = np.array([[0.2, 0.1], [0.3, 0.3], [0.0, 0.0]])
    end = np.array([[0.2, 0.9], [0.9, 0.3], [1.0, 1.0]])
    result = solved(np.stack([ENNEPER] * 3), start, end)
    assert np.concatenate([batch.problems for batch in result.batches]).tolist() == [2]


def test_degenerate_patches_are_left(rng: np.random.Generator) -> None:
    nets = reference.mild_patches(rng, 3, 0.3)
    nets[0] = nets[0, :1, :1] + np.zeros((4, 4, 3))
    nets[1, ..., 1] = nets[1, ..., 0]
    nets[1, ..., 2] = 0.0
    corners = np.zeros((3, 2)), np.ones((3, 2))
    result = solved(nets, *corners)
    assert np.concatenate([batch.problems for batch in result.batches]).tolist() == [2]


@pytest.mark.parametrize("form", [nullcontext, without_kernels], ids=["compiled", "NumPy"])
@pytest.mark.parametrize("width", [1e-6, 1e-8, 1e-10])
def test_needles_keep_their_width(
    width: float, form: Callable[[], AbstractContextManager[None]], rng: np.random.Generator
) -> None:
    nets = np.zeros((100, 4, 4, 3))
    nets[..., 0], nets[..., 1] = np.arange(4)[:, None] / 3, np.arange(4) / 3
    nets[..., :2] += rng.uniform(-0.1, 0.1, (100, 4, 4, 2))
    nets[..., 0] *= width
    ends = np.array([[0.2, 0.3], [0.8, 0.6]])
    straight = [np.linalg.norm(np.subtract(*evaluate(net, ends))) for net in nets]
    with form():
        found = bm.solve_geodesic(nets, *ends, search="straight", on_failure="status")
    np.testing.assert_allclose(found.length, straight, rtol=5e-15)


@pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
def test_both_forms_agree(surface: Any) -> None:
    problem = surface.control_points, surface.start, surface.end
    fast = bm.solve_geodesic(*problem)
    full = bm.solve_geodesic(*problem, method=bm.PolynomialCollocation(28, form="full"))
    assert abs(fast.length - full.length) <= 1e-14 * surface.length
    parts = np.linspace(0.0, 1.0, 33)
    # The error of a path is about the square root of that of its raw length.
    assert np.abs(fast.path(parts) - full.path(parts)).max() < 1e-4


def test_paths_run_at_constant_speed() -> None:
    solution = bm.solve_geodesic(PH_CYLINDER, (0.0, 0.0), (1.0, 1.0))
    assert solution.batches[0].speed is not None
    # On the cylinder, at constant speed, 3 u + u^3 = 4 t and v = t.
    t = np.linspace(0.0, 1.0, 41)
    path = solution.path(t)
    np.testing.assert_allclose(3.0 * path[:, 0] + path[:, 0] ** 3, 4.0 * t, atol=1e-5)
    np.testing.assert_allclose(path[:, 1], t, atol=1e-5)
    np.testing.assert_array_equal(path[[0, -1]], [[0.0, 0.0], [1.0, 1.0]])


@pytest.mark.parametrize("kernel", [bm.WU_C2, bm.WU_C10], ids=["C2", "C10"])
def test_the_path_that_is_told_is_the_one_that_was_measured(
    kernel: bm.Kernel, rng: np.random.Generator
) -> None:
    method = bm.RBFCollocation(kernel, 6, tolerance=1.0)
    nets = reference.mild_patches(rng, 20, 0.3)
    solution = bm.solve_geodesic(nets, (0.05, 0.1), (0.9, 1.0), method=method)
    assert all(batch.speed is not None for batch in solution.batches)
    # The correction is large enough that another path would have another length.
    assert np.median(solution.raw_length / solution.length - 1.0) > 1e-10
    places = evaluate(nets, solution.path(np.linspace(0.0, 1.0, 1025)))
    polygons = [
        np.linalg.norm(np.diff(places[:, ::step], axis=1), axis=2).sum(axis=1) for step in (4, 2, 1)
    ]
    # Errors of the polygons run in even powers of their edges (Romberg).
    once = [fine + (fine - coarse) / 3.0 for coarse, fine in pairwise(polygons)]
    twice = once[1] + (once[1] - once[0]) / 15.0
    np.testing.assert_allclose(twice, solution.raw_length, rtol=1e-13)


def test_a_space_without_inner_nodes_has_the_straight_line_alone() -> None:
    single = bm.solve_geodesic(
        ENNEPER,
        (0.0, 0.0),
        (1.0, 1.0),
        method=bm.RBFCollocation(functions=1, tolerance=1.0),
        on_failure="status",
    )
    assert single.functions == 1


def test_arrays_of_another_library(rng: np.random.Generator) -> None:
    torch = pytest.importorskip("torch")
    nets = reference.mild_patches(rng, 20, 0.3)
    ends = np.zeros((20, 2)), np.ones((20, 2))
    mine, theirs = solved(nets, *ends), solved(torch.from_numpy(nets), *ends)
    np.testing.assert_allclose(lengths(theirs, 20), lengths(mine, 20), rtol=1e-14)
