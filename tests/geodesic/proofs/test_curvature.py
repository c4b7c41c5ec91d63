"""Bounds of the Gaussian curvature that hold everywhere on a patch."""

from fractions import Fraction
from math import comb
from typing import Any

import numpy as np
import pytest

from bodymeasure import load_sample
from bodymeasure._typing import Array
from bodymeasure.bench.problems.patches import mild_patches, wild_patches
from bodymeasure.bezier import elevate, split
from bodymeasure.geodesic.lengths.path_geometry import path_geometry
from bodymeasure.geodesic.proofs.bernstein import elevated, scaled, unscaled
from bodymeasure.geodesic.proofs.curvature import curvature_bounds, forms
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces


def bounds(nets: Array, wanted: float = np.inf, **settings: Any) -> Array:
    limits = np.full(len(nets), wanted)
    return curvature_bounds(nets, limits, np.full(len(nets), np.inf), **settings).curvature


def sampled(nets: Array, points: int = 17) -> Array:
    """The Gaussian curvature of patches on a grid, shape (patches, points^2)."""
    grid = np.linspace(0.0, 1.0, points)
    places = np.stack(np.meshgrid(grid, grid), axis=-1).reshape(-1, 2).T
    values = np.broadcast_to(places, (len(nets), *places.shape))
    slopes, none = np.ones_like(values), np.zeros_like(values)
    return np.asarray(
        path_geometry(BezierSurfaces(nets), values, slopes, none).gaussian_curvature
    ).T


@pytest.mark.slow
def test_a_bound_is_not_below_the_curvature_anywhere(rng: np.random.Generator) -> None:
    nets = np.concatenate([mild_patches(rng, 40, 0.5), wild_patches(rng, 10, 1.0)])
    highest = np.maximum(sampled(nets).max(axis=1), 0.0)
    assert (bounds(nets) >= highest * (1.0 - 1e-9)).all()
    assert (bounds(nets, 0.0) >= highest * (1.0 - 1e-9)).all()


def test_a_refined_bound_is_close_to_the_curvature() -> None:
    # On z = x^2 + y^2 the curvature is 4 at the origin, and less elsewhere.
    net = load_sample("paraboloid").control_points
    assert 4.0 * (1.0 - 1e-9) < bounds(net, 0.0)[0] < 4.1


def test_parts_have_no_larger_bounds_than_the_whole(rng: np.random.Generator) -> None:
    nets = mild_patches(rng, 20, 0.5)
    parts = split(nets).reshape(20, 4, 4, 4, 3)
    for number in range(4):
        assert (bounds(parts[:, number]) <= bounds(nets) * (1.0 + 1e-6)).all()


@pytest.mark.parametrize(("p", "q"), [(1, 1), (1, 3), (3, 1), (2, 4)])
def test_patches_of_any_degree_have_the_bounds_of_the_same_ones_written_higher(
    p: int, q: int, rng: np.random.Generator
) -> None:
    u, v = np.meshgrid(np.arange(p + 1) / p, np.arange(q + 1) / q, indexing="ij")
    nets = np.stack([u, v, 0.0 * u], axis=-1)[None].repeat(5, axis=0)
    nets[..., 2] = 0.4 * rng.random(nets.shape[:-1])
    low, high = bounds(nets, 0.0), bounds(elevate(nets, 4, 5), 0.0)
    np.testing.assert_allclose(low, high, rtol=0.05, atol=1e-4)
    if p == q == 1:
        # Bilinear patches are saddles.
        np.testing.assert_array_equal(bounds(nets), 0.0)


def test_integrals_and_areas_are_bounded(rng: np.random.Generator) -> None:
    nets = mild_patches(rng, 10, 0.4)
    none, endless = np.zeros(10), np.full(10, np.inf)
    found = curvature_bounds(nets, none, endless)
    points, weights = np.polynomial.legendre.leggauss(24)
    grid = (points + 1.0) / 2.0
    places = np.stack(np.meshgrid(grid, grid, indexing="ij"), axis=-1).reshape(-1, 2)
    jet = BezierSurfaces(nets).jet(np.broadcast_to(places, (10, *places.shape)), 2)
    density = np.linalg.norm(np.cross(jet[1], jet[2], axis=0), axis=0)
    weight = np.multiply.outer(weights, weights).ravel() / 4.0
    area = density @ weight
    values = np.broadcast_to(places.T, (10, 2, len(places)))
    zeros = np.zeros_like(values)
    curvature = path_geometry(BezierSurfaces(nets), values, zeros + 1.0, zeros).gaussian_curvature
    positive = (np.maximum(curvature.T, 0.0) * density) @ weight
    assert (found.area >= area * (1.0 - 1e-12)).all()
    assert (found.area <= area * 1.01).all()
    assert (found.positive >= positive * (1.0 - 1e-6)).all()
    assert (found.positive <= positive * 1.2 + 0.1).all()


def test_a_collapsed_edge_leaves_no_bound() -> None:
    net = load_sample("paraboloid").control_points.copy()
    net[:, 0] = net[:, 0, :1]
    assert np.isinf(bounds(net)).all()


def product(a: Any, b: Any) -> Any:
    """The product of exact polynomials in powers of u and v, object arrays (m + 1, n + 1)."""
    result = np.full((a.shape[0] + b.shape[0] - 1, a.shape[1] + b.shape[1] - 1), Fraction(0))
    for i, j in np.ndindex(a.shape):
        result[i : i + b.shape[0], j : j + b.shape[1]] += a[i, j] * b
    return result


def in_powers(points: Any) -> Any:
    """Exact coefficients of powers of a Bernstein polynomial's, shape (m + 1, n + 1)."""

    def along(values: Any) -> Any:
        n = len(values) - 1
        return np.array(
            [
                sum(comb(n, k) * comb(k, i) * (-1) ** (k - i) * values[i] for i in range(k + 1))
                for k in range(n + 1)
            ]
        )

    return along(along(points).T).T


def in_bernstein(powers: Any, m: int, n: int) -> Any:
    """The exact Bernstein coefficients, of degrees m and n, of a polynomial in powers."""

    def along(values: Any, degree: int) -> Any:
        return np.array(
            [
                sum(
                    Fraction(comb(i, k), comb(degree, k)) * values[k]
                    for k in range(min(i + 1, len(values)))
                )
                for i in range(degree + 1)
            ]
        )

    return along(along(powers, m).T, n).T


def exact_forms(net: Array) -> tuple[Any, Any]:
    """The exact coefficients of d and of |m|^2, from the powers of u and v."""
    points = [in_powers(np.vectorize(Fraction)(net[..., c])) for c in range(3)]

    def derivative(values: Any, axis: int) -> Any:
        count = np.array([Fraction(k) for k in range(1, values.shape[axis])])
        return values[1:] * count[:, None] if axis == 0 else values[:, 1:] * count

    def dot(a: Any, b: Any) -> Any:
        return sum(product(x, y) for x, y in zip(a, b, strict=True))

    s_u, s_v = ([derivative(c, axis) for c in points] for axis in (0, 1))
    normal = [
        product(s_u[i], s_v[j]) - product(s_u[j], s_v[i]) for i, j in ((1, 2), (2, 0), (0, 1))
    ]
    bend_u = dot([derivative(c, 0) for c in s_u], normal)
    bend_v = dot([derivative(c, 1) for c in s_v], normal)
    twist = dot([derivative(c, 1) for c in s_u], normal)
    d = product(bend_u, bend_v) - product(twist, twist)
    return in_bernstein(d, 14, 14), in_bernstein(dot(normal, normal), 10, 10)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["mild", "wild", "body"])
def test_the_margins_cover_the_rounding_errors(kind: str, rng: np.random.Generator) -> None:
    """In exact rational arithmetic, every coefficient lies on the safe side, but near."""
    nets = {
        "mild": lambda: mild_patches(rng, 2, 0.3),
        "wild": lambda: wild_patches(rng, 2, 1.0),
        "body": lambda: load_sample("female_average").control_points[[5, 200]] * 8.0,
    }[kind]()
    for net in nets:
        numerator, square = exact_forms(net)
        found = forms(net[None])
        above = found.numerator[..., 0] - numerator.astype(float)
        size = np.abs(numerator.astype(float)).max()
        exact = np.vectorize(Fraction)(found.numerator[..., 0]) >= numerator
        assert exact.all()
        assert above.max() < 1e-8 * size
        assert (np.vectorize(Fraction)(found.square[..., 0]) <= square).all()
        assert (np.vectorize(Fraction)(found.above[..., 0]) >= square).all()
        # Rounding takes less than a tenth of the margin.
        middle = (found.square + found.above)[..., 0] / 2.0
        margin = (found.above - found.square)[..., 0] / 2.0
        assert (np.abs(middle - square.astype(float)) < margin / 10.0).all()


@pytest.mark.parametrize("degree", [6, 12])
def test_margins_grow_with_the_degree_and_cover_its_rounding(
    degree: int, rng: np.random.Generator
) -> None:
    nets = mild_patches(rng, 5, 0.4)
    low, high = forms(nets), forms(elevate(nets, degree, degree))
    size = 4 * degree - 2
    known = unscaled(elevated(scaled((low.square + low.above) / 2.0), size, size))
    middle, margin = (high.square + high.above) / 2.0, (high.above - high.square) / 2.0
    assert (np.abs(middle - known) < margin / 10.0).all()
    assert (margin[0, 0] > 0.7 * (low.above - low.square)[0, 0]).all()
