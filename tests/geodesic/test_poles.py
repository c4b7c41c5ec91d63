"""Paths from and to an edge that is collapsed to a point, as on triangular patches."""

import numpy as np
import pytest
from helpers.speed import quick

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.oracle import mesh_distances

PARAMETERS = [((0.0, 0.9), (1.0, 0.3)), ((0.0, 0.0), (1.0, 0.5)), ((0.0, 0.5), (0.7, 0.2))]
# The corners of a triangle in the plane, the first of which is the pole.
TRIANGLE = np.array([(0.2, -0.1), (1.1, 0.1), (0.4, 0.9)])


def biquadratic(points: Array) -> Array:
    """Control points through values at u, v = 0, 1/2 and 1, shape (3, 3, k)."""
    to_control = np.array([[1.0, 0.0, 0.0], [-0.5, 2.0, -0.5], [0.0, 0.0, 1.0]])
    return np.asarray(np.einsum("ai,bj,ijk->abk", to_control, to_control, points))


def over_triangle(bend: float) -> Array:
    """Control points of z = bend (x^2 + y^2) over the triangle, with the edge u = 0 collapsed."""
    u, v = np.meshgrid(*2 * [np.array([0.0, 0.5, 1.0])], indexing="ij")
    pole, left, right = TRIANGLE
    xy = pole + u[..., None] * (
        (left - pole) * (1.0 - v)[..., None] + (right - pole) * v[..., None]
    )
    z = bend * (xy * xy).sum(axis=-1, keepdims=True)
    return biquadratic(np.concatenate([xy, z], axis=-1))


def over_square(bend: float) -> Array:
    """The same surface over the square from -1 to 2, with x and y as its parameters."""
    x, y = np.meshgrid(*2 * [np.array([-1.0, 0.5, 2.0])], indexing="ij")
    return biquadratic(np.stack([x, y, bend * (x * x + y * y)], axis=-1))


def turned(net: Array, quarter: int) -> tuple[Array, bool]:
    """The net with the pole on another edge, and whether u and v have changed places."""
    if quarter in (1, 3):
        net = net[::-1]
    if quarter in (2, 3):
        net = net.swapaxes(0, 1)
    return net, quarter in (2, 3)


@pytest.mark.parametrize(("start", "end"), PARAMETERS)
def test_on_a_flat_triangle_the_way_is_straight(
    start: tuple[float, float], end: tuple[float, float]
) -> None:
    net = over_triangle(0.0)
    first, last = evaluate(net, np.array([start, end]))
    there = bm.solve_geodesic(net, start, end)
    back = bm.solve_geodesic(net, end, start)
    for solution in (there, back):
        assert solution.status is bm.Status.CONVERGED
        assert solution.length == pytest.approx(np.linalg.norm(last - first), rel=1e-14)
    # The path leaves the pole along the ray to its end.
    assert there.path(0.0) == pytest.approx([0.0, end[1]], abs=1e-9)


@pytest.mark.parametrize("bend", [0.3, 1.0])
@pytest.mark.parametrize("quarter", range(4))
def test_another_parametrization_without_a_pole_agrees(bend: float, quarter: int) -> None:
    net, exchanged = turned(over_triangle(bend), quarter)
    u, v = (0.0 if quarter in (0, 2) else 1.0), 0.4
    start = np.array([u, v])
    end = np.array([1.0 - u + 0.2 * (2.0 * u - 1.0), 0.7])
    if exchanged:
        start, end = start[::-1], end[::-1]
    triangular = bm.solve_geodesic(net, start, end)
    places = (evaluate(net, np.array([start, end]))[:, :2] + 1.0) / 3.0
    square = bm.solve_geodesic(over_square(bend), *places)
    assert abs(triangular.length - square.length) <= (
        triangular.error_estimate + square.error_estimate
    )
    assert triangular.error_estimate <= 1e-10 * triangular.length


def test_it_does_not_matter_by_which_parameter_the_pole_is_told() -> None:
    net = over_triangle(1.0)
    start = np.stack([np.zeros(9), np.linspace(0.0, 1.0, 9)], axis=-1)
    solutions = bm.solve_geodesic(net, start, (0.9, 0.35))
    np.testing.assert_allclose(solutions.length, solutions.length[0], rtol=1e-12)


def test_from_pole_to_pole() -> None:
    # The patch is a lens: the edges u = 0 and u = 1 are points, and v = 0 and v = 1 are bent.
    u, v = np.meshgrid(*2 * [np.linspace(0.0, 1.0, 4)], indexing="ij")
    net = np.stack([u, 4.0 * u * (1.0 - u) * (v - 0.5), 0.0 * u], axis=-1)
    net[0], net[-1] = net[0, :1], net[-1, :1]
    solution = bm.solve_geodesic(net, (0.0, 0.1), (1.0, 0.8))
    assert solution.length == pytest.approx(1.0, rel=1e-13)
    middle = evaluate(net, solution.path([0.5]))[0]
    assert middle == pytest.approx([0.5, 0.0, 0.0], abs=1e-9)


def bent_triangles(rng: np.random.Generator, count: int) -> Array:
    """Random control points over triangles whose edge u = 0 is collapsed."""
    u, v = np.meshgrid(*2 * [np.linspace(0.0, 1.0, 4)], indexing="ij")
    nets = np.stack([u, u * (v - 0.5), 0.0 * u], axis=-1)[None].repeat(count, axis=0)
    nets[:, 1:] += rng.uniform(-0.05, 0.05, (count, 3, 4, 3))
    nets[:, 1:, :, 2] += 0.5 * rng.random((count, 3, 4))
    return nets


def test_bent_patches_against_meshes(rng: np.random.Generator) -> None:
    count = 6
    nets = bent_triangles(rng, count)
    # The ends are inner points, the far corner, and points on an edge, along which some of the
    # paths run.
    starts = np.stack([np.zeros((3, count)), rng.random((3, count))], axis=-1)
    ends = np.stack([rng.uniform(0.3, 1.0, (count, 2)), np.ones((count, 2)), np.zeros((count, 2))])
    ends[2, :, 0] = 0.8
    solutions = bm.solve_geodesic(nets, starts, ends)
    assert (np.asarray(solutions.status) == bm.Status.ON_BOUNDARY).any()
    mesh = mesh_distances(nets, starts.swapaxes(0, 1), ends.swapaxes(0, 1))
    difference = np.abs(solutions.length - mesh.exact.T)
    assert (difference <= 3.0 * mesh.exact_uncertainty.T + 1e-6 * solutions.length).all()


@pytest.mark.parametrize("width", [1e-13, 5e-12])
def test_an_edge_that_is_shorter_than_errors_is_a_pole(
    rng: np.random.Generator, width: float
) -> None:
    exact = bent_triangles(rng, 3)
    nets = exact.copy()
    nets[:, 0, :, 1] += width * np.linspace(-0.5, 0.5, 4)
    starts, ends = np.array([0.0, 0.3]), np.array([[1.0, 1.0], [0.8, 0.4], [0.8, 0.0]])
    collapsed = bm.solve_geodesic(exact, starts, ends)
    nearly = bm.solve_geodesic(nets, starts, ends)
    assert (np.abs(nearly.length - collapsed.length) <= nearly.error_estimate).all()
    # The error covers the choice of the point of the narrow edge from which a path starts.
    assert (nearly.error_estimate >= width).all()


@pytest.mark.parametrize("width", quick([1e-9, 1e-6]))
def test_a_narrow_edge_is_a_pole_to_who_asks_for_less(
    rng: np.random.Generator, width: float
) -> None:
    nets = bent_triangles(rng, 3)
    start, ends = (0.0, 0.3), np.array([[1.0, 1.0], [0.8, 0.4], [0.8, 0.0]])
    collapsed = bm.solve_geodesic(nets, start, ends)
    nets[:, 0, :, 1] += width * np.linspace(-0.5, 0.5, 4)
    # The path bends close to the edge, where hardly any single polynomial follows it.
    narrow = bm.solve_geodesic(nets, start, ends)
    assert (np.abs(narrow.length - collapsed.length) <= width).all()
    loose = bm.RBFCollocation(tolerance=50.0 * width)
    found = bm.solve_geodesic(nets, start, ends, method=loose, search="quick")
    assert (np.abs(found.length - collapsed.length) <= found.error_estimate).all()
    assert (found.error_estimate <= 50.0 * width * found.length).all()
