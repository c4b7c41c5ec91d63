"""Weak form and collocation side by side on patches, and what quadrature does to the weak form."""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic import WU_C2, Kernel, Method, RBFCollocation, RBFRitz, solve_geodesic
from bodymeasure.geodesic.lengths.functionals import energy
from bodymeasure.geodesic.methods.rbf_collocation import chebyshev_points, default_centers
from bodymeasure.geodesic.solving.levenberg_marquardt import minimize
from bodymeasure.geodesic.solving.on_spaces import straight
from bodymeasure.geodesic.spaces.kernels import WU_C10
from bodymeasure.geodesic.spaces.quadrature import Quadrature
from bodymeasure.geodesic.spaces.rbf import rbf_space
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.paper.data.truth import END, START
from bodymeasure.paper.tables.beyond import ANY, Known
from bodymeasure.paper.tables.table import Column, Table

OUTSIDE, INSIDE = "C10, centers outside", "C2, centers inside"
COUNTS = (4, 6, 8, 12, 16)
# Where rounding begins, below which no slope is fitted.
FLOOR = 1e-13
FEW, POINTS = 8, (8, 10, 12, 16, 24)
MOST_ITERATIONS = 60
# Only this much below the truth is no rounding error.
BELOW = 1e-13


class PathErrors(NamedTuple):
    """Errors of paths, shape (problems,), and which of them were found."""

    h1: Array
    raw: Array
    corrected: Array
    solved: Bools


class _Form(NamedTuple):
    functions: str
    number: int
    weak: float | None
    collocation: float | None
    weak_solved: int
    collocation_solved: int
    below: int


class _Rule(NamedTuple):
    points: int
    excess: float
    below_by_own: int
    below_by_fine: int


def path_errors(known: Known, method: Method) -> PathErrors:
    """Return the errors of a method's paths: of the path, of its length, of the corrected length.

    The error of the path is the norm in L2 of the difference of its slopes in (u, v) from those of
    a path by 28 polynomials.
    """
    solve = partial(solve_geodesic, known.control_points, START, END, on_failure="status")
    found, best = solve(method=method), solve(method=RBFCollocation(functions=20, tolerance=ANY))
    times, weights = np.polynomial.legendre.leggauss(40)
    places = [solution.path((times + 1.0) / 2.0) for solution in (found, best)]
    # Slopes by an interpolant through the Gauss points, which is exact enough for these norms.
    slope = _slopes(times)
    gap = np.einsum("ij,pjc->pic", slope, places[0] - places[1])
    h1 = np.sqrt(np.einsum("i,pic->p", weights / 2.0, gap**2))
    solved = np.zeros(len(known.length), bool)
    for batch in found.batches:
        solved[batch.problems] = batch.converged
    raw, corrected = found.raw_length / known.length - 1.0, found.length / known.length - 1.0
    return PathErrors(h1, np.asarray(raw), np.asarray(corrected), solved)


def _slopes(times: Array) -> Array:
    """The matrix from values at points of [-1, 1] to slopes by t in [0, 1] there."""
    degree = len(times) - 1
    place = np.polynomial.legendre.legvander(times, degree)
    coefficients = np.eye(degree + 1)
    lower = np.polynomial.legendre.legder(coefficients)
    slope = np.polynomial.legendre.legvander(times, degree - 1) @ lower
    return np.asarray(2.0 * slope @ np.linalg.inv(place))


def _methods(functions: str, count: int) -> tuple[Method, Method]:
    kernel, centers = _placed(functions, count)
    strong = RBFCollocation(kernel, centers=centers, tolerance=ANY, form="full")
    return RBFRitz(kernel, centers=centers, tolerance=ANY), strong


def _placed(functions: str, count: int) -> tuple[Kernel, list[float]]:
    if functions == OUTSIDE:
        return WU_C10, default_centers(WU_C10, count).tolist()
    return WU_C2, np.linspace(0.0, 1.0, count).tolist()


def forms_table(known: Known, counts: Sequence[int] = COUNTS) -> Table:
    """Return the errors of uncorrected lengths by both forms, with centers outside and inside."""
    rows = []
    for functions in (OUTSIDE, INSIDE):
        for count in counts:
            results = []
            for method in _methods(functions, count):
                try:
                    results.append(path_errors(known, method))
                except ValueError:
                    # Collocation refuses what it cannot resolve.
                    none = np.full(len(known.length), np.nan)
                    results.append(PathErrors(none, none, none, np.zeros(len(none), bool)))
            weak, strong = results
            rows.append(
                _Form(
                    functions,
                    count,
                    _median(weak.raw[weak.solved]),
                    _median(strong.raw[strong.solved]),
                    int(weak.solved.sum()),
                    int(strong.solved.sum()),
                    int((weak.raw[weak.solved] < -BELOW).sum()),
                )
            )
    columns = (
        Column("functions", "Functions", "text"),
        Column("number", "Number", "count"),
        Column("weak", "Weak form: median error", "small"),
        Column("collocation", "Collocation: median error", "small"),
        Column("weak_solved", "Weak form: solved", "count"),
        Column("collocation_solved", "Collocation: solved", "count"),
        Column("below", "Weak lengths below the truth", "count"),
    )
    return Table.of(
        "future_forms",
        f"Weak form and collocation, {len(known.length)} patches",
        columns,
        rows,
        "The relative error of the length of the computed path, before its correction. The weak "
        "form is the path of least energy; its length is never below that of the geodesic.",
    )


def _median(errors: Array) -> float | None:
    return float(np.median(np.abs(errors))) if len(errors) else None


def quadrature_table(known: Known) -> Table:
    """Return what the number of Gauss points does to paths of least energy, with 8 functions."""
    surface = BezierSurfaces(known.control_points)
    centers = tuple(default_centers(WU_C10, FEW).tolist())
    space = rbf_space(WU_C10, centers, tuple(chebyshev_points(FEW - 1)), 2.0)
    count = len(known.length)
    start, end = (np.tile(np.asarray(each, float), (count, 1)) for each in (START, END))
    guess = straight(start, end, space.nodes)
    fine = Quadrature(space.functions.edges, 64)
    rows = []
    for points in POINTS:
        coarse = replace(space)
        coarse.__dict__["quadrature"] = Quadrature(space.functions.edges, points)
        found = minimize(energy, surface, coarse, guess, max_iterations=MOST_ITERATIONS)
        own, exact = (
            _lengths(surface, space, found.values, rule) / known.length - 1.0
            for rule in (coarse.quadrature, fine)
        )
        rows.append(
            _Rule(
                points,
                float(np.median(exact)),
                int((own < -BELOW).sum()),
                int((exact < -BELOW).sum()),
            )
        )
    columns = (
        Column("points", "Gauss points", "count"),
        Column("excess", "Length of the path less the truth: median", "small"),
        Column("below_by_own", "Below the truth, by the same points", "count"),
        Column("below_by_fine", "by 64 points", "count"),
    )
    return Table.of(
        "future_quadrature",
        f"Quadrature in the weak form, {FEW} functions, {count} patches",
        columns,
        rows,
        f"Twice the number of functions plus 8, which is used, is {2 * FEW + 8}. With fewer points "
        "the minimum is that of another energy, and lengths by the same points are no upper "
        "bounds.",
    )


def _lengths(surface: BezierSurfaces, space: object, values: Array, rule: Quadrature) -> Array:
    place, slope, _ = space.matrices(rule.points)  # type: ignore[attr-defined]
    jet = surface.jet((values @ place.T).transpose(0, 2, 1), 1)
    du, dv = (values @ slope.T).transpose(1, 0, 2)
    speed = np.sqrt(((jet[1] * du + jet[2] * dv) ** 2).sum(axis=0))
    return np.asarray(speed @ rule.weights)
