"""Lengths in closed form, the content of a solution, and the paper's equations at its points."""

from typing import Any

import numpy as np
import pytest
from helpers.surfaces.surfaces import (
    ENNEPER,
    HYPERBOLIC_PARABOLOID,
    PLANE,
    SURFACES,
    Surface,
    plane_length,
)

from bodymeasure.bezier import derivatives, evaluate
from bodymeasure.geodesic import (
    WU_C2,
    WU_C4,
    WU_C6,
    WU_C10,
    GeodesicSolution,
    Kernel,
    RBFCollocation,
    Status,
    solve_geodesic,
)
from bodymeasure.geodesic.spaces.rbf import rbf_coefficients

KERNELS = [WU_C2, WU_C4, WU_C6, WU_C10]

all_surfaces = pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
all_kernels = pytest.mark.parametrize("kernel", KERNELS, ids=lambda kernel: kernel.name)


def on(surface: Surface, method: RBFCollocation | None = None) -> GeodesicSolution:
    return solve_geodesic(surface.control_points, surface.start, surface.end, method=method)


@all_surfaces
@all_kernels
def test_lengths_in_closed_form(surface: Surface, kernel: Kernel) -> None:
    solution = on(surface, RBFCollocation(kernel))
    error = abs(solution.length - surface.length)
    assert error <= 1e-13 * surface.length
    assert error <= solution.error_estimate <= 1e-10 * surface.length
    assert solution.status is Status.CONVERGED
    assert solution.local_minimum
    assert abs(solution.raw_length / surface.length - 1.0) < 1e-7


@all_surfaces
def test_ends_of_paths(surface: Surface) -> None:
    path = on(surface).path([0.0, 1.0])
    np.testing.assert_allclose(path, [surface.start, surface.end], rtol=0.0, atol=1e-16)


@all_surfaces
@pytest.mark.parametrize("kernel", [WU_C2, WU_C10], ids=lambda kernel: kernel.name)
def test_the_papers_equations_hold(surface: Surface, kernel: Kernel) -> None:
    # Equations (7) to (10) are the ends; (11) and (12) the geodesic equations (1) and (2), with
    # Christoffel symbols, at the collocation points; u and v written with the coefficients of (5)
    # and (6).
    method = RBFCollocation(kernel, functions=6, tolerance=1e-2, form="full")
    (batch,) = on(surface, method).batches
    nodes = batch.space.nodes
    assert len(nodes) == 7
    nodal = batch.values[0].T
    np.testing.assert_array_equal(nodal[[0, -1]], [surface.start, surface.end])
    (space,) = method.spaces
    np.testing.assert_array_equal(space.nodes, nodes)
    place, velocity, bend = space.matrices(nodes[1:-1]) @ nodal
    d = derivatives(surface.control_points, place, order=2)
    tangents = np.stack([d[:, 1, 0], d[:, 0, 1]], axis=1)
    second = np.stack([[d[:, 2, 0], d[:, 1, 1]], [d[:, 1, 1], d[:, 0, 2]]])
    lowered = np.einsum("pkc,ijpc->pkij", tangents, second)
    metric = tangents @ tangents.transpose(0, 2, 1)
    christoffel = np.linalg.solve(metric, lowered.reshape(-1, 2, 4)).reshape(-1, 2, 2, 2)
    equations = bend + np.einsum("pkij,pi,pj->pk", christoffel, velocity, velocity)
    assert np.abs(equations).max() < 1e-6 * max(1.0, np.abs(bend).max())


def test_coefficients_of_a_solution_give_its_path() -> None:
    method = RBFCollocation(WU_C2, functions=5, tolerance=1e-2, form="full")
    solution = solve_geodesic(PLANE, (0.1, 0.8), (1.0, 0.2), method=method)
    (batch,) = solution.batches
    centers = (-0.675, -0.225, 1.15, 1.45, 1.75)
    a = rbf_coefficients(WU_C2, centers, 2.0, batch.space.nodes, batch.values[0].T)
    t = np.linspace(0.0, 1.0, 21)
    kernels = WU_C2(np.abs(t[:, None] - np.array(centers)) / 2.0)
    np.testing.assert_allclose(a[0] + kernels @ a[1:], solution.path(t), atol=1e-9)


def test_one_problem_gives_plain_values() -> None:
    solution = solve_geodesic(ENNEPER, (0.0, 0.0), (1.0, 1.0))
    assert solution.shape == ()
    for name in ("length", "raw_length", "error_estimate", "residual", "condition"):
        assert type(getattr(solution, name)) is float
    for name in ("local_minimum", "converged"):
        assert type(getattr(solution, name)) is bool
    for name in ("functions", "iterations"):
        assert type(getattr(solution, name)) is int
    assert type(solution.status) is Status
    assert solution.start.shape == solution.end.shape == (2,)
    assert solution.functions == 8
    assert 1 <= solution.iterations < 10
    assert solution.condition > 1.0


def test_shapes_of_paths() -> None:
    one = solve_geodesic(ENNEPER, (0.0, 0.0), (1.0, 1.0))
    assert one.path(0.5).shape == (2,)
    assert one.path([0.5]).shape == (1, 2)
    assert one.path(np.zeros((0,))).shape == (0, 2)
    assert one.path(np.linspace(0, 1, 6).reshape(2, 3)).shape == (2, 3, 2)
    many = solve_geodesic(ENNEPER, np.zeros((3, 1, 2)), [[1.0, 1.0], [1.0, 0.5]])
    assert many.shape == (3, 2)
    assert many.path(0.5).shape == (3, 2, 2)
    assert many.path([0.0, 0.5, 1.0, 1.0]).shape == (3, 2, 4, 2)
    np.testing.assert_array_equal(many.path([0.25, 0.5])[:, :, 1], many.path(0.5))
    # By symmetry u = v, and at half the length sqrt(2) (u + 2u^3/3) = 5 sqrt(2) / 6.
    u = one.path(0.5)
    np.testing.assert_allclose(u[0] + 2 * u[0] ** 3 / 3, 5 / 6, rtol=1e-4)
    np.testing.assert_allclose(u[0], u[1], rtol=1e-14)


@pytest.mark.parametrize("t", [-1e-9, 1.0 + 1e-9, np.nan, [0.5, 2.0]])
def test_paths_are_defined_from_0_to_1(t: object) -> None:
    solution = solve_geodesic(ENNEPER, (0.0, 0.0), (1.0, 1.0))
    with pytest.raises(ValueError, match=r"\[0, 1\]"):
        solution.path(t)  # type: ignore[arg-type]


def test_a_path_has_the_length_that_is_given(rng: np.random.Generator) -> None:
    start, end = rng.random((5, 2)), rng.random((5, 2))
    solution = solve_geodesic(HYPERBOLIC_PARABOLOID, start, end)
    points = evaluate(HYPERBOLIC_PARABOLOID, solution.path(np.linspace(0.0, 1.0, 2001)))
    steps = np.linalg.norm(np.diff(points, axis=1), axis=-1)
    np.testing.assert_allclose(steps.sum(axis=1), solution.length, rtol=1e-6)
    # Its speed is constant.
    assert (steps.max(axis=1) / steps.min(axis=1) < 1.0 + 1e-4).all()


def test_the_same_point_twice() -> None:
    solution = solve_geodesic(ENNEPER, (0.3, 0.7), (0.3, 0.7))
    assert solution.length == solution.error_estimate == solution.raw_length == 0.0
    assert solution.status is Status.CONVERGED
    np.testing.assert_array_equal(solution.path([0.0, 0.4]), [[0.3, 0.7], [0.3, 0.7]])
    mixed = solve_geodesic(ENNEPER, [(0.0, 0.0), (0.5, 0.5)], [(1.0, 1.0), (0.5, 0.5)])
    np.testing.assert_allclose(mixed.length, [5 * np.sqrt(2) / 3, 0.0], rtol=1e-13)
    np.testing.assert_allclose(mixed.path(1.0), [[1.0, 1.0], [0.5, 0.5]], atol=1e-16)


def test_an_empty_batch() -> None:
    solution = solve_geodesic(np.empty((0, 2, 4, 4, 3)), (0.0, 0.0), (1.0, 1.0))
    assert solution.shape == (0, 2)
    assert solution.length.shape == (0, 2)
    assert solution.path([0.5]).shape == (0, 2, 1, 2)


@pytest.mark.parametrize("distance", [1e-3, 1e-6, 1e-9, 1e-11])
@pytest.mark.parametrize("towards", [(1.0, 0.5), (1.0, 0.0), (0.0, -1.0)])
def test_ends_close_together(distance: float, towards: tuple[float, float]) -> None:
    # These are exact binary fractions, so that the plane's chord is known to all digits.
    start = np.array([0.375, 0.4375])
    end = start + 2.0 ** np.round(np.log2(distance)) * np.array(towards)
    solution = solve_geodesic(PLANE, start, end)
    step = end - start
    # This is the chord by the derivative at the middle; the rest is of third order in the distance.
    if distance > 1e-4:
        expected = plane_length(tuple(start), tuple(end))
    else:
        d = derivatives(PLANE, (start + end) / 2, order=1)
        expected = float(np.linalg.norm(d[1, 0] * step[0] + d[0, 1] * step[1]))
    error = abs(solution.length - expected)
    assert error <= (1e-12 if distance > 1e-10 else 1e-10) * expected
    assert error <= solution.error_estimate + 1e-12 * expected
    np.testing.assert_allclose(solution.path([0.0, 1.0]), [start, end], rtol=0, atol=1e-16)


def test_ends_on_one_edge_and_lines_of_constant_parameter() -> None:
    # Enneper's u-lines through 0 are planar symmetry curves: geodesics, of length u + u^3 / 3.
    start, end = [(0.0, 0.0), (0.2, 0.0), (0.0, 0.0)], [(1.0, 0.0), (0.9, 0.0), (0.0, 1.0)]
    solution = solve_geodesic(ENNEPER, start, end)
    s = np.array([1.0 + 1.0 / 3.0, 0.9 + 0.9**3 / 3 - 0.2 - 0.2**3 / 3, 1.0 + 1.0 / 3.0])
    np.testing.assert_allclose(solution.length, s, rtol=1e-13)
    assert np.abs(solution[:2].path(np.linspace(0, 1, 9))[..., 1]).max() < 1e-15
    # Rulings of the hyperbolic paraboloid are straight, such as the one from (0.3, 0) to (0.3, 1).
    ruling = solve_geodesic(HYPERBOLIC_PARABOLOID, (0.3, 0.0), (0.3, 1.0))
    assert ruling.length == pytest.approx(np.hypot(1.0, 0.3), rel=1e-14)


INDICES = {
    "number": np.s_[2],
    "pair": np.s_[2, 1],
    "negative": np.s_[-1, 0],
    "slice": np.s_[1:3],
    "column": np.s_[:, 1],
    "ellipsis": np.s_[..., 0],
    "all": np.s_[...],
    "reversed": np.s_[::-1],
    "new axis": np.s_[None, 0],
    "numbers": np.s_[[0, 2, 0]],
    "pairs": np.s_[[0, 2], [1, 0]],
    "mask": np.s_[np.array([[True, False], [False, False], [True, True], [False, True]])],
    "row mask": np.s_[np.array([True, False, False, True])],
    "nothing": np.s_[:0],
}


@pytest.fixture(scope="module")
def batch() -> GeodesicSolution:
    # There are two numbers of functions, and one problem has coincident ends.
    nets = np.stack([ENNEPER, HYPERBOLIC_PARABOLOID, PLANE, PLANE])[:, None]
    nets = nets * np.array([1.0, 1.0, 1.0, 0.5])[:, None, None, None, None]
    starts = np.array([[0.1, 0.2], [0.9, 0.1]])
    ends = np.broadcast_to([[0.8, 1.0], [0.2, 0.8]], (4, 2, 2)).copy()
    ends[1, 0] = starts[0]
    method = RBFCollocation(functions=(5, 12), tolerance=1e-11)
    return solve_geodesic(nets, starts, ends, method=method)


@pytest.mark.parametrize("index", INDICES.values(), ids=INDICES.keys())
def test_indexing_a_solution_indexes_all_it_holds(batch: GeodesicSolution, index: Any) -> None:
    assert len(set(batch.functions.ravel())) == 3
    part = batch[index]
    lengths = batch.length[index]
    assert part.shape == lengths.shape
    t = np.array([0.0, 0.3, 1.0])
    for name in (
        "length",
        "raw_length",
        "error_estimate",
        "residual",
        "local_minimum",
        "functions",
        "iterations",
        "converged",
        "condition",
    ):
        np.testing.assert_array_equal(getattr(part, name), getattr(batch, name)[index])
    assert (np.asarray(part.status) == np.asarray(np.asarray(batch.status)[index])).all()
    # The last axis holds u and v, which an index must not reach.
    numbers = np.arange(8).reshape(4, 2)[index]
    for name in ("start", "end"):
        np.testing.assert_array_equal(
            getattr(part, name), getattr(batch, name).reshape(8, 2)[numbers]
        )
    np.testing.assert_allclose(
        part.path(t), batch.path(t).reshape(8, 3, 2)[numbers], rtol=0.0, atol=1e-15
    )


def test_a_problem_taken_from_a_batch_has_plain_values(batch: GeodesicSolution) -> None:
    one = batch[3, 1]
    names = ("length", "functions", "local_minimum", "status")
    assert [type(getattr(one, name)) for name in names] == [float, int, bool, Status]
    assert repr(one.converged) == "True"
    assert batch[3][1].length == one.length


def test_indices_out_of_range_are_refused(batch: GeodesicSolution) -> None:
    with pytest.raises(IndexError):
        batch[4]
    with pytest.raises(IndexError):
        batch[0, 0][0]
