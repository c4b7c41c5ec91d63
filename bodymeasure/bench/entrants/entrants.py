"""The entrants of the benchmark: bodymeasure's methods, a general solver, and mesh libraries."""

from collections.abc import Callable
from functools import partial
from importlib.util import find_spec

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bench.entrants.boundary_value import BoundaryValueProblem
from bodymeasure.bench.entrants.entrant import Entrant, Pace, Solve, in_numpy, lengths
from bodymeasure.bench.entrants.mesh_paths import (
    edge_flips,
    fast_marching,
    igl_exact,
    igl_heat,
    pygeodesic_exact,
)
from bodymeasure.bench.entrants.meshed_patch import MeshedPatch
from bodymeasure.bench.entrants.shooting import straightest, with_normals
from bodymeasure.bench.entrants.unfolding import unfolded
from bodymeasure.bench.problems.patches import Problems
from bodymeasure.geodesic import (
    WU_C2,
    Method,
    PolynomialCollocation,
    RBFCollocation,
    RBFRitz,
    Relaxation,
    Ritz,
    Shooting,
    solve_geodesic,
)

Prepare = Callable[[Problems], Solve]
PatchEntrant = Entrant[Problems]

DEFAULT = "RBF, fast form"
# The same without compiled kernels.
NUMPY = "RBF, fast form in NumPy"
BVP = "solve_bvp"
IGL_EXACT = "libigl exact"
TOLERANCES = (1e-3, 1e-6, 1e-8)
POINTS_A_SIDE = (17, 33, 65)
# The numbers in brackets are those of the paper's references.
MESH_METHODS = {
    IGL_EXACT: igl_exact,
    "pygeodesic exact": pygeodesic_exact,
    "potpourri3d edge flips": edge_flips,
    "straightest [4], potpourri3d": straightest,
    "unfolding [5]": unfolded,
    "straightest, normals [6]": with_normals,
    "fast marching [7], potpourri3d": fast_marching,
    "libigl heat": igl_heat,
}


def tolerance_setting(tolerance: float) -> str:
    """Return the name of a tolerance of solve_bvp."""
    return f"tol {tolerance:.0e}".replace("e-0", "e-")


def points_setting(points: int) -> str:
    """Return the name of a mesh."""
    return f"{points} points a side"


def entrants() -> tuple[PatchEntrant, ...]:
    """Return all entrants, bodymeasure's default first; pygeodesic only if it is installed."""
    ours: tuple[tuple[str, Method, Pace], ...] = (
        (DEFAULT, RBFCollocation(), "batch"),
        ("RBF, full form", RBFCollocation(form="full"), "batch"),
        ("RBF, weak form", RBFRitz(), "batch"),
        ("RBF, 8 of Wu's C2", RBFCollocation(WU_C2, 8), "batch"),
        ("polynomial collocation", PolynomialCollocation(), "batch"),
        ("Ritz", Ritz(), "batch"),
        ("relaxation", Relaxation(), "fast"),
        ("shooting", Shooting(), "very slow"),
    )
    result = [
        Entrant(name, "", "bodymeasure", pace, _solver(method)) for name, method, pace in ours
    ]
    pace: Pace
    result.insert(
        1, Entrant(NUMPY, "", "bodymeasure", "batch", in_numpy(_solver(RBFCollocation())))
    )
    for tolerance in TOLERANCES:
        one = partial(BoundaryValueProblem, tolerance=tolerance)
        prepare = _one_by_one(one)
        result.append(Entrant(BVP, tolerance_setting(tolerance), "scipy", "slow", prepare))
    for name, length in MESH_METHODS.items():
        if length is pygeodesic_exact and find_spec("pygeodesic") is None:
            continue
        for points in POINTS_A_SIDE:
            pace = "slow" if points < max(POINTS_A_SIDE) else "very slow"
            prepare = _one_by_one(_on_mesh(length, points))
            result.append(Entrant(name, points_setting(points), "mesh", pace, prepare))
    return tuple(result)


def _solver(method: Method) -> Prepare:
    """Return what prepares one of bodymeasure's own methods, on all problems in one batch."""

    def prepare(problems: Problems) -> Solve:
        def solve() -> Array:
            solution = solve_geodesic(
                problems.nets,
                problems.start,
                problems.end,
                method=method,
                search="straight",
                on_failure="status",
            )
            return np.asarray(solution.length)

        return solve

    return prepare


def _one_by_one(make: Callable[[Array, Array, Array], Callable[[], float]]) -> Prepare:
    """Return what prepares a method that takes one problem at a time."""

    def prepare(problems: Problems) -> Solve:
        calls = [make(*one) for one in zip(*problems, strict=True)]
        return lambda: lengths(calls)

    return prepare


def _on_mesh(
    length: Callable[[MeshedPatch], float], points: int
) -> Callable[[Array, Array, Array], Callable[[], float]]:
    def make(net: Array, start: Array, end: Array) -> Callable[[], float]:
        return partial(length, MeshedPatch.of(net, start, end, points))

    return make
