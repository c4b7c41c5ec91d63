"""Any two points of any patch: close ones, corners, coincident ones, on patches of all sizes."""

import itertools
import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from helpers.oracles.reference import reference_lengths
from helpers.oracles.straight_line import from_straight_line
from helpers.surfaces.custom_surfaces import Patch, Torus
from helpers.surfaces.surfaces import ENNEPER, PH_CYLINDER, PLANE, SURFACES
from scipy.integrate import solve_bvp

from bodymeasure import InputError
from bodymeasure._typing import Array
from bodymeasure.bezier import derivatives
from bodymeasure.geodesic import PolynomialCollocation, Ritz, Status, solve_geodesic

# Distances in u and v, down to those between which there are only a few floating-point numbers.
DISTANCES = 10.0 ** -np.arange(0.0, 17.0)
PLACES = np.array([(0.0, 0.0), (0.3, 0.7), (1.0, 1.0), (0.0, 0.6), (1.0, 0.2), (1e-9, 0.5)])


def pairs(distance: float, rng: np.random.Generator) -> tuple[Array, Array]:
    """Random points of the patch, and others at a distance in random directions."""
    start = np.repeat(PLACES, 4, axis=0)
    way = rng.normal(size=start.shape)
    end = np.clip(start + distance * way / np.abs(way).max(axis=1, keepdims=True), 0.0, 1.0)
    apart = (start != end).any(axis=1)
    return start[apart], end[apart]


def unrolled(start: Array, end: Array) -> Array:
    """Lengths on `PH_CYLINDER` from differences of parameters, without cancellation."""
    (u, _), (w, _) = start.T, end.T
    du, dv = (end - start).T
    return np.asarray(np.hypot(du * (3.0 + u * u + u * w + w * w), 3.0 * dv))


@pytest.mark.parametrize("distance", DISTANCES)
def test_near_points_of_a_cylinder(distance: float, rng: np.random.Generator) -> None:
    start, end = pairs(distance, rng)
    solution = solve_geodesic(PH_CYLINDER, start, end)
    exact = unrolled(start, end)
    np.testing.assert_allclose(solution.length, exact, rtol=1e-14)
    assert (np.abs(solution.length - exact) <= solution.error_estimate).all()
    assert (solution.error_estimate <= 1e-12 * exact).all()
    np.testing.assert_array_equal(solution.path([0.0, 1.0]), np.stack([start, end], axis=1))
    assert (solution.index == 0).all()


@pytest.mark.parametrize("distance", [1e-50, 1e-160, 1e-300, 1e-320, 5e-324])
def test_points_next_to_a_corner_that_hardly_differ(distance: float) -> None:
    start, end = np.zeros(2), np.array([distance, distance / 2])
    solution = solve_geodesic(PH_CYLINDER, start, end)
    # This is the smallest distance between two floating-point numbers.
    assert solution.length == pytest.approx(3.0 * np.hypot(*end), rel=1e-14, abs=5e-324)
    assert solution.error_estimate <= 1e-12 * solution.length + 5e-323


@pytest.mark.parametrize("distance", DISTANCES)
def test_near_points_of_a_sphere(distance: float, rng: np.random.Generator) -> None:
    sphere = Torus(0.0, 2.5, span_u=1.0, span_v=1.0, begin_v=-0.5)
    start, end = pairs(distance, rng)
    # This is the haversine formula in longitude and latitude.
    middle = 0.5 * (start + end)[:, 1] - 0.5
    longitude, latitude = np.abs(end - start).T
    low, high = middle - latitude / 2.0, middle + latitude / 2.0
    half = np.hypot(
        np.sin(latitude / 2.0), np.sqrt(np.cos(low) * np.cos(high)) * np.sin(longitude / 2.0)
    )
    solution = from_straight_line(sphere, start, end, on_failure="status")
    # The great circle between two points of one edge may leave the patch.
    inside = np.asarray(solution.status) != Status.LEAVES_PATCH
    assert solution.converged[inside].all()
    assert inside.mean() > 0.8
    exact = 5.0 * np.arcsin(half)
    np.testing.assert_allclose(solution.length[inside], exact[inside], rtol=1e-13)


@pytest.mark.parametrize("method", [Ritz(), PolynomialCollocation()], ids=["ritz", "polynomials"])
def test_near_points_by_other_methods(method: Any, rng: np.random.Generator) -> None:
    for distance in (1e-6, 1e-12):
        start, end = pairs(distance, rng)
        solution = solve_geodesic(PH_CYLINDER, start, end, method=method)
        np.testing.assert_allclose(solution.length, unrolled(start, end), rtol=1e-13)


def crowded(gap: float) -> Array:
    """A plane whose control points crowd at the edge u = 0."""
    x, y = np.meshgrid([0.0, gap, 3.0 * gap, 1.0], np.linspace(0.0, 1.0, 4), indexing="ij")
    return np.stack([x, y, 0.0 * x], axis=-1)


def chord(net: Array, start: Array, end: Array) -> float:
    """The straight distance between two points of a patch, in exact arithmetic."""

    def position(point: Array, axis: int) -> Fraction:
        u, v = (Fraction(float(x)) for x in point)
        return sum(
            (
                math.comb(3, i)
                * math.comb(3, j)
                * u**i
                * (1 - u) ** (3 - i)
                * v**j
                * (1 - v) ** (3 - j)
                * Fraction(float(net[i, j, axis]))
                for i, j in np.ndindex(4, 4)
            ),
            start=Fraction(0),
        )

    differences = [position(end, axis) - position(start, axis) for axis in range(3)]
    return math.hypot(*map(float, differences))


@pytest.mark.parametrize("gap", [1e-2, 1e-5, 1e-9, 1e-13])
@pytest.mark.parametrize("place", [0.0, 5e3])
def test_where_control_points_crowd(gap: float, place: float) -> None:
    net = crowded(gap)
    # Control points are rounded, so that moving them by `place` rounds nothing more.
    net = np.round(net * 2.0**60) / 2.0**60 if place == 0.0 else net
    net[..., 1] += place
    # Farther from the edge, u grows as the cube root of the distance, and is no polynomial.
    start, near = np.array([0.0, 0.5]), math.sqrt(gap)
    ways = [(1e-9, 0.0), (1e-3, 0.0), (0.1, 0.0), (1e-3, 1e-3), (0.1, 0.01), (1e-6, 0.1)]
    for end in start + near * np.array(ways):
        solution = solve_geodesic(net, start, end)
        exact = chord(net, start, end)
        assert abs(solution.length - exact) <= solution.error_estimate
        assert solution.error_estimate <= 1e-10 * exact
    # These points are away from the edge.
    start, end = np.array([0.3, 0.1]), np.array([0.9, 0.8])
    solution = solve_geodesic(net, start, end)
    assert solution.length == pytest.approx(chord(net, start, end), rel=1e-12)


NETS = np.stack([surface.control_points for surface in SURFACES])
STARTS = np.array([surface.start for surface in SURFACES])
ENDS = np.array([surface.end for surface in SURFACES])
LENGTHS = np.array([surface.length for surface in SURFACES])


@pytest.mark.parametrize("size", [1e-6, 1e-3, 1.0, 1e6, 1e250, 1e-250])
@pytest.mark.parametrize("distance", [1.0, 1e-4, 1e-11])
def test_patches_of_all_sizes(size: float, distance: float) -> None:
    ends = STARTS + distance * (ENDS - STARTS)
    given = solve_geodesic(NETS, STARTS, ends)
    solution = solve_geodesic(size * NETS, STARTS, ends)
    np.testing.assert_allclose(solution.length / size, given.length, rtol=1e-14)
    np.testing.assert_array_equal(solution.functions, given.functions)
    for net, start, end, length in zip(NETS, STARTS, ends, given.length, strict=True):
        own = solve_geodesic(Patch(size * net), start, end, on_failure="status")
        assert own.length / size == pytest.approx(length, rel=1e-12)


@pytest.mark.parametrize("place", [1e3, 1e6, 1e9])
def test_far_from_the_origin(place: float) -> None:
    # These control points can be moved so far without being rounded.
    nets = np.round(NETS * 2.0**20) / 2.0**20
    solution = solve_geodesic(nets, STARTS, ENDS)
    away = solve_geodesic(nets + place, STARTS, ENDS)
    np.testing.assert_allclose(away.length, solution.length, rtol=1e-15)
    np.testing.assert_allclose(away.error_estimate, solution.error_estimate, rtol=0.5)


def test_coordinates_too_large_to_calculate_with_are_refused() -> None:
    with pytest.raises(InputError, match=r"patch 1 .*e\+305; .*larger unit"):
        solve_geodesic(np.stack([ENNEPER, 1e305 * PLANE]), (0.0, 0.0), (1.0, 1.0))


@pytest.mark.parametrize("aspect", [1e2, 1e4, 1e6])
def test_long_patches(aspect: float) -> None:
    start, end = np.array([0.2, 0.9]), np.array([0.9, 0.3])
    for factor in (aspect, 1.0 / aspect):
        net = PH_CYLINDER * [1.0, 1.0, factor]
        exact = math.hypot(3 * 0.7 + 0.9**3 - 0.2**3, 3 * 0.6 * factor)
        solution = solve_geodesic(net, start, end)
        assert solution.length == pytest.approx(exact, rel=1e-14)
        back = solve_geodesic(net.swapaxes(0, 1), end[::-1], start[::-1])
        assert back.length == pytest.approx(exact, rel=1e-14)


def length_as_graph(net: Array, start: Array, end: Array) -> float:
    """The length of the geodesic v(u) that `solve_bvp` finds with Christoffel symbols."""

    def jets(u: Array, v: Array) -> Array:
        return np.moveaxis(derivatives(net, np.stack([u, v], axis=-1), order=2), 0, -1)

    def slope(u: Array, y: Array) -> Array:
        jet = jets(u, y[0])
        tangents = np.stack([jet[1, 0], jet[0, 1]])
        metric = np.einsum("axk,bxk->kab", tangents, tangents)
        second = np.stack([jet[2, 0], jet[1, 1], jet[0, 2]])
        right = np.einsum("axk,sxk->kas", tangents, second)
        (a11, a12, a22), (b11, b12, b22) = np.moveaxis(np.linalg.solve(metric, right), 0, -1)
        p = y[1]
        return np.stack([p, a22 * p**3 + (2 * a12 - b22) * p**2 + (a11 - 2 * b12) * p - b11])

    def ends(first: Array, last: Array) -> Array:
        return np.array([first[0] - start[1], last[0] - end[1]])

    u = np.linspace(start[0], end[0], 41)
    line = np.stack([np.linspace(start[1], end[1], 41), np.ones_like(u)])
    result = solve_bvp(slope, ends, u, line, tol=1e-8, max_nodes=100_000)
    assert result.success
    nodes, weights = np.polynomial.legendre.leggauss(60)
    u = start[0] + (end[0] - start[0]) * (nodes + 1.0) / 2.0
    v, p = result.sol(u)
    jet = jets(u, v)
    speed = np.linalg.norm(jet[1, 0] + jet[0, 1] * p, axis=0)
    return float((end[0] - start[0]) / 2.0 * weights @ speed)


@pytest.mark.parametrize("aspect", [1.0, 1e2, 1e4])
def test_long_patches_that_are_curved(aspect: float) -> None:
    start, end = np.array([0.1, 0.2]), np.array([0.9, 0.8])
    for factors in ([aspect, 1.0, 1.0], [1.0, 1.0 / aspect, 1.0]):
        net = ENNEPER * factors
        solution = solve_geodesic(net, start, end)
        assert solution.length == pytest.approx(length_as_graph(net, start, end), rel=1e-10)


def test_all_pairs_of_corners_edges_and_inner_points() -> None:
    places = np.array(list(itertools.product((0.0, 0.4, 1.0), repeat=2)))
    start, end = (np.repeat(places, 9, axis=0), np.tile(places, (9, 1)))
    net = ENNEPER[None]
    solution = solve_geodesic(ENNEPER, start, end)
    there = solution.length.reshape(9, 9)
    np.testing.assert_array_equal(np.diag(there), 0.0)
    np.testing.assert_allclose(there, there.T, rtol=1e-12)
    # The triangle inequality holds.
    assert (there[:, :, None] <= (there[:, None] + there.T[None]) * (1 + 1e-12)).all()
    apart = np.flatnonzero((start != end).any(axis=1) & (solution.status == Status.CONVERGED))
    assert len(apart) > 50
    known = reference_lengths(net.repeat(len(apart), axis=0), start[apart], end[apart])
    np.testing.assert_allclose(solution.length[apart], known, rtol=1e-10)


@pytest.mark.parametrize("point", [(0.0, 0.0), (1.0, 0.3), (0.2, 0.6)])
def test_a_point_twice(point: tuple[float, float]) -> None:
    solution = solve_geodesic(ENNEPER, point, point)
    assert solution.length == solution.error_estimate == solution.raw_length == 0.0
    assert solution.status is Status.CONVERGED
    assert solution.index == 0
    np.testing.assert_array_equal(solution.path([0.0, 0.4, 1.0]), [point] * 3)


def triangle(edge: int) -> Array:
    """A patch with one edge (u = 0, u = 1, v = 0 or v = 1) that is collapsed to a point."""
    net = ENNEPER + 3.0
    axis, last = divmod(edge, 2)
    net = np.moveaxis(net, axis, 0).copy()
    net[-last] = net[-last, 1]
    return np.moveaxis(net, 0, axis)


@pytest.mark.parametrize("edge", range(4))
def test_two_points_of_one_collapsed_edge_are_one_place(edge: int) -> None:
    axis, last = divmod(edge, 2)
    start, end = (np.insert([along], axis, float(last)) for along in (0.2, 0.9))
    solution = solve_geodesic(triangle(edge), start, end)
    assert solution.length == 0.0
    assert solution.error_estimate < 1e-14
    assert solution.index == 0
    np.testing.assert_array_equal(solution.path([0.0, 1.0]), [start, end])
    # Elsewhere on the patch a path of the same kind has a length.
    start[axis] = end[axis] = 0.5
    assert solve_geodesic(triangle(edge), start, end).length > 0.1


def test_two_points_of_a_pole() -> None:
    sphere = Torus(0.0, 1.0, span_u=1.0, span_v=math.pi / 2, begin_v=0.0)
    solution = solve_geodesic(sphere, (0.1, 1.0), (0.8, 1.0))
    assert solution.length == 0.0
    assert 0.0 < solution.error_estimate < 1e-14
