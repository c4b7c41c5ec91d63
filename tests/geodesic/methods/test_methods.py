"""The common contract of all methods, their rates of convergence and their agreement."""

import importlib
import inspect
import math
import pkgutil
from collections.abc import Callable

import numpy as np
import pytest
from helpers.surfaces.surfaces import (
    PLANE,
    SURFACES,
    Surface,
    bicubic,
)

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.geodesic import Method, Relaxation, Shooting, methods
from bodymeasure.geodesic.solving.protocol import PathBatch
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.geodesic.surfaces.protocol import JET

METHODS: dict[str, Method] = {
    "RBF": bm.RBFCollocation(),
    "RBF, full": bm.RBFCollocation(form="full"),
    "RBF, weak": bm.RBFRitz(),
    "polynomials": bm.PolynomialCollocation(),
    "polynomials, full": bm.PolynomialCollocation(form="full"),
    "Ritz": bm.Ritz(),
    "Ritz, u = t": bm.Ritz(parametrization="u"),
    "shooting": Shooting(),
    "relaxation": Relaxation(),
}
every_method = pytest.mark.parametrize("method", METHODS.values(), ids=METHODS)
# On the tangent developable, the geodesic is no polynomial and its parameters are far from linear.
CURVED = next(surface for surface in SURFACES if surface.name == "tangent_developable")
# No length meets this tolerance, so that the method does all it can.
NEVER = 1e-300
ANY = 1.0


def mild_patches(rng: np.random.Generator, count: int) -> Array:
    """A regular grid in the unit square, with random heights."""
    nets = np.empty((count, 4, 4, 3))
    nets[..., 0], nets[..., 1] = np.meshgrid(np.arange(4) / 3, np.arange(4) / 3, indexing="ij")
    nets[..., 2] = 0.3 * rng.random((count, 4, 4))
    return nets


def solved(method: Method, surface: Surface) -> PathBatch:
    """The solution of the method itself, without a search for a shorter path."""
    ends = (np.array([end], dtype=np.float64) for end in (surface.start, surface.end))
    (batch,) = method.solve(BezierSurfaces(surface.control_points[None]), *ends).batches
    return batch


def raw_error(method: Method, surface: Surface) -> float:
    return abs(float(solved(method, surface).length.raw[0]) / surface.length - 1.0)


def test_every_method_is_exported_and_tried_here() -> None:
    package = "bodymeasure.geodesic.methods"
    modules = [f"{package}.{module.name}" for module in pkgutil.iter_modules(methods.__path__)]
    found = {
        each
        for module in modules
        for each in vars(importlib.import_module(module)).values()
        if inspect.isclass(each) and each.__module__ == module and hasattr(each, "solve")
    }
    assert found == {type(method) for method in METHODS.values()}
    assert {each.__name__ for each in found} <= set(bm.geodesic.__all__)


@every_method
@pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
def test_every_method_keeps_the_contract(method: Method, surface: Surface) -> None:
    solution = bm.solve_geodesic(surface.control_points, surface.start, surface.end, method=method)
    error = abs(solution.length - surface.length)
    assert solution.status is bm.Status.CONVERGED
    assert solution.local_minimum
    assert error <= 1e-14 * surface.length
    assert error <= solution.error_estimate <= 1e-11 * surface.length
    assert surface.length * (1.0 - 3e-15) <= solution.raw_length
    assert solution.functions >= 8
    assert solution.iterations >= 1
    path = solution.path(np.linspace(0.0, 1.0, 101))
    assert ((path >= -1e-12) & (path <= 1.0 + 1e-12)).all()
    np.testing.assert_allclose(solution.path([0.0, 1.0]), [surface.start, surface.end], atol=1e-15)


@every_method
def test_a_path_runs_where_the_geodesic_does(method: Method) -> None:
    # The patch is a plane whose lines v = const are shifted; the geodesic is a straight line.
    net = bicubic({(1, 0): 1, (0, 1): 1, (0, 2): -1}, {(0, 1): 1}, {})
    solution = bm.solve_geodesic(net, (0.0, 0.1), (0.9, 0.8), method=method)
    u, v = solution.path(np.linspace(0.0, 1.0, 21)).T
    x = u + v - v**2
    fraction = (v - 0.1) / 0.7
    np.testing.assert_allclose(x, 0.09 + fraction * (0.9 + 0.8 - 0.64 - 0.09), atol=2e-4)


@every_method
def test_methods_agree_within_their_estimates(method: Method, rng: np.random.Generator) -> None:
    nets = mild_patches(rng, 4)
    mine = bm.solve_geodesic(nets, (0.0, 0.0), (1.0, 1.0), method=method)
    others = bm.solve_geodesic(nets, (0.0, 0.0), (1.0, 1.0), method=bm.PolynomialCollocation(24))
    assert (
        np.abs(mine.length - others.length) <= mine.error_estimate + others.error_estimate
    ).all()
    assert (mine.error_estimate <= 1e-10 * mine.length).all()


@every_method
def test_lengths_do_not_depend_on_direction_place_and_unit(
    method: Method, rng: np.random.Generator
) -> None:
    net = mild_patches(rng, 1)[0]
    rotation = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    moved = 1e4 * (net @ rotation.T + rng.normal(size=3))
    one = bm.solve_geodesic(net, (0.0, 0.9), (1.0, 0.2), method=method)
    back = bm.solve_geodesic(net, (1.0, 0.2), (0.0, 0.9), method=method)
    other = bm.solve_geodesic(moved, (0.0, 0.9), (1.0, 0.2), method=method)
    assert abs(back.length - one.length) <= one.error_estimate + back.error_estimate
    assert abs(other.length / 1e4 - one.length) <= one.error_estimate + other.error_estimate / 1e4
    np.testing.assert_allclose(other.length, 1e4 * one.length, rtol=1e-11)


class _Sphere:
    """The unit sphere; u is the longitude and v - 1/2 the latitude, in radians."""

    def derivatives(self, parameters: Array) -> Array:
        u, v = parameters[..., 0], parameters[..., 1] - 0.5
        zero = np.zeros_like(u)
        quarter = np.pi / 2.0
        return np.stack(
            [
                np.stack(
                    [
                        np.cos(u + i * quarter) * np.cos(v + j * quarter),
                        np.sin(u + i * quarter) * np.cos(v + j * quarter),
                        zero if i else np.sin(v + j * quarter),
                    ],
                    axis=-1,
                )
                for i, j in JET
            ],
            axis=-2,
        )


@every_method
def test_any_surface_with_derivatives_will_do(method: Method) -> None:
    solution = bm.solve_geodesic(_Sphere(), (0.1, 0.9), (0.9, 0.8), method=method)
    cosine = np.sin(0.4) * np.sin(0.3) + np.cos(0.4) * np.cos(0.3) * np.cos(0.8)
    assert abs(solution.length - np.arccos(cosine)) <= solution.error_estimate + 1e-15
    assert solution.error_estimate < 1e-12


@every_method
def test_a_patch_without_area_has_no_length(method: Method) -> None:
    u, v = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij")
    line = np.stack([u + v, 0.0 * u, 0.0 * u], axis=-1)
    solution = bm.solve_geodesic(line, (0.0, 1.0), (1.0, 0.0), method=method, on_failure="status")
    assert np.isnan(solution.length)
    assert not solution.converged


@pytest.mark.parametrize(
    "method",
    [
        bm.PolynomialCollocation(8, tolerance=ANY),
        bm.Ritz(8, tolerance=ANY),
        bm.Ritz(8, parametrization="u", tolerance=ANY),
        Relaxation(33),
    ],
    ids=["polynomials", "Ritz", "Ritz, u = t", "relaxation"],
)
def test_the_correction_serves_all_methods(method: Method, rng: np.random.Generator) -> None:
    nets = mild_patches(rng, 30)
    exact = bm.solve_geodesic(nets, (0.0, 0.0), (1.0, 1.0), method=bm.PolynomialCollocation(28))
    solution = bm.solve_geodesic(nets, (0.0, 0.0), (1.0, 1.0), method=method)
    raw, corrected = (
        np.median(np.abs(length / exact.length - 1.0))
        for length in (solution.raw_length, solution.length)
    )
    assert 1e-10 < raw < 1e-6
    assert corrected < 1e-4 * raw


@pytest.mark.parametrize(
    "make",
    [
        lambda n: bm.PolynomialCollocation(n, tolerance=ANY),
        lambda n: bm.Ritz(n, tolerance=ANY),
        lambda n: bm.Ritz(n, parametrization="u", tolerance=ANY),
    ],
    ids=["polynomials", "Ritz", "Ritz, u = t"],
)
def test_polynomials_converge_exponentially(make: Callable[[int], Method]) -> None:
    degrees = np.array([4, 6, 8, 10, 12, 14])
    errors = np.array([max(raw_error(make(int(n)), CURVED), 1e-15) for n in degrees])
    rate = np.polyfit(degrees, np.log10(errors), 1)[0]
    assert -1.2 < rate < -0.6
    # Each two degrees more give the same factor down to rounding, unlike a power of the degree.
    assert errors[-1] < 1e-12
    assert raw_error(make(24), CURVED) < 3e-15


def test_more_terms_of_v_of_u_give_no_longer_path() -> None:
    # Each space contains the one before, and Ritz's method seeks the least length over it.
    orders = range(2, 13)
    lengths = [
        solved(bm.Ritz(n, parametrization="u", tolerance=ANY), CURVED).length.raw[0] for n in orders
    ]
    assert (np.diff(lengths) <= 1e-14 * CURVED.length).all()
    assert min(lengths) >= CURVED.length * (1.0 - 1e-14)


def test_relaxed_paths_are_of_second_order_and_their_lengths_of_fourth() -> None:
    # These are mesh points of all the meshes.
    t = np.arange(9) / 8.0
    exact = solved(bm.PolynomialCollocation(28, form="full"), CURVED)
    there = exact.values @ exact.space.matrices(t)[0].T
    path, length = [], []
    widths = 1.0 / np.array([16, 24, 32])
    for points in (17, 25, 33):
        batch = solved(Relaxation(points, tolerance=NEVER), CURVED)
        path.append(np.abs(batch.values @ batch.space.matrices(t)[0].T - there).max())
        length.append(batch.length.raw[0] / CURVED.length - 1.0)
    assert abs(np.polyfit(np.log(widths), np.log(path), 1)[0] - 2.0) < 0.1
    assert abs(np.polyfit(np.log(widths), np.log(length), 1)[0] - 4.0) < 0.2


def test_shooting_follows_its_tolerance() -> None:
    exact = solved(bm.PolynomialCollocation(28, form="full"), CURVED)
    t = np.linspace(0.1, 0.9, 9)
    there = exact.values @ exact.space.matrices(t)[0].T
    # The polynomials of degree 12 that represent the path leave 1.4e-6.
    for rtol in (1e-2, 1e-3, 1e-4):
        batch = solved(Shooting(rtol=rtol, tolerance=NEVER), CURVED)
        error = np.abs(batch.values @ batch.space.matrices(t)[0].T - there).max()
        assert error < 3.0 * rtol


def test_a_path_that_turns_back_in_u_is_no_function_of_u() -> None:
    # On this plane u runs forwards and backwards along the straight line.
    net = bicubic({(1, 0): 1, (0, 1): 2, (0, 2): -2}, {(0, 1): 1}, {})
    surface = Surface("sheared", net, (0.8, 0.0), (0.9, 1.0), math.hypot(0.1, 1.0))
    assert not solved(bm.Ritz(parametrization="u"), surface).converged[0]
    found = solved(bm.Ritz(), surface)
    assert found.converged[0]
    length = found.length.raw[0] - found.length.correction[0]
    assert abs(length / surface.length - 1.0) < 1e-13


def test_v_of_u_needs_ends_with_different_u() -> None:
    with pytest.raises(bm.InputError, match=r"same u.*Ritz\(parametrization='arbitrary'\)"):
        bm.solve_geodesic(PLANE, (0.2, 0.0), (0.2, 1.0), method=bm.Ritz(parametrization="u"))


def test_a_batch_is_solved_as_its_problems_are(rng: np.random.Generator) -> None:
    nets = mild_patches(rng, 3)
    for method in (bm.Ritz(), bm.PolynomialCollocation(), Relaxation()):
        batch = bm.solve_geodesic(nets, (0.0, 0.0), (1.0, 1.0), method=method)
        for net, length, error in zip(nets, batch.length, batch.error_estimate, strict=True):
            one = bm.solve_geodesic(net, (0.0, 0.0), (1.0, 1.0), method=method)
            assert abs(one.length - length) <= error


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: bm.PolynomialCollocation(degrees=()), r"degrees is \(\); expected a whole number"),
        (lambda: bm.PolynomialCollocation(degrees=1), "degrees is 1; .* at least 2"),
        (lambda: bm.PolynomialCollocation(degrees=(8, 9.5)), "degrees is .*9.5"),  # type: ignore[arg-type]
        (lambda: bm.PolynomialCollocation(form="slow"), "form is 'slow'; .* full"),  # type: ignore[arg-type]
        (lambda: bm.PolynomialCollocation(tolerance=0.0), "tolerance is 0.0; expected a positive"),
        (lambda: bm.Ritz(order=True), "order is True"),
        (lambda: bm.Ritz(order="eight"), "order is 'eight'"),  # type: ignore[arg-type]
        (lambda: bm.Ritz(tolerance=math.nan), "tolerance is nan"),
        (lambda: bm.Ritz(parametrization="v"), "expected 'arbitrary' or 'u'"),  # type: ignore[arg-type]
        (lambda: Shooting(rtol=1e-15), "rtol is 1e-15; expected a number from 1e-13 to 1"),
        (lambda: Shooting(rtol=None), "rtol is None"),  # type: ignore[arg-type]
        (lambda: Shooting(tolerance=-1.0), "tolerance is -1.0"),
        (lambda: Relaxation(points=6), "points is 6; .* at least 7"),
        (lambda: Relaxation(points=(9, 17)), "points is .* expected one whole"),  # type: ignore[arg-type]
        (lambda: Relaxation(tolerance=math.inf), "tolerance is inf"),
    ],
)
def test_settings_that_make_no_sense_are_refused(make: Callable[[], Method], message: str) -> None:
    with pytest.raises(bm.InputError, match=message):
        make()


@every_method
def test_nothing_to_solve_is_no_mistake(method: Method) -> None:
    assert bm.solve_geodesic(PLANE, np.empty((0, 2)), (1.0, 1.0), method=method).shape == (0,)
    assert bm.solve_geodesic(PLANE, (0.3, 0.7), (0.3, 0.7), method=method).length == 0.0
