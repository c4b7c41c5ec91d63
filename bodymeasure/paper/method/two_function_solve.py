"""Table 1: the paper's method with two functions."""

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.errors import InputError
from bodymeasure.geodesic.lengths.equations import residual_and_jacobian
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.paper.method.arc_length import arc_lengths, inside_patch
from bodymeasure.paper.method.system_roots import system_roots
from bodymeasure.paper.method.two_functions import paper_space

# The solution that is taken: the shortest of all, or the shortest that stays in the patch.
Rule = Literal["all", "inside"]
RULES: tuple[Rule, ...] = get_args(Rule)
# Collocation points that are tried in turn: the middle, then to either side of it.
COLLOCATION_POINTS = (0.5, 0.45, 0.55, 0.4, 0.6, 0.35, 0.65, 0.3, 0.7)
# The determinant counts as zero if the angle between the gradients of the two equations at the
# solution is below this, in radians. Where solutions meet, rounding leaves an angle of some 1e-8.
PARALLEL = 1e-6


@dataclass(frozen=True, eq=False)
class TwoFunctionSolution:
    """The results of the paper's method for a batch of patches; arrays of shape (patches,).

    Parameters
    ----------
    length : ndarray
        NaN where no solution was accepted at any collocation point.
    place : ndarray, shape (patches, 2)
        (u, v) at the collocation point.
    collocation_point : ndarray
        The one whose solution was accepted, NaN if none was.
    roots, inside : ndarray of int
        Numbers of real solutions at the first collocation point, and of those that stay in the
        patch.
    degenerate : ndarray of int
        Number of collocation points whose solution was refused because the determinant was zero.
    """

    length: Array
    place: Array
    collocation_point: Array
    roots: Ints
    inside: Ints
    degenerate: Ints


def solve_two_functions(
    control_points: Array,
    rule: Rule,
    collocation_points: tuple[float, ...] = COLLOCATION_POINTS,
) -> TwoFunctionSolution:
    """Return diagonals from (0, 0) to (1, 1) by two functions and one collocation point.

    Parameters
    ----------
    control_points : ndarray, shape (patches, 4, 4, 3)
    rule : {"all", "inside"}
        Whether the shortest of all solutions is taken, as Table 1 says, or of those that stay in
        the patch.
    collocation_points : tuple of float
        Points that are tried in turn, as long as the determinant is zero at the solution (section
        5) or there is no solution.

    Raises
    ------
    InputError
        If there is no such rule.
    """
    if rule not in RULES:
        raise InputError(f"rule is {rule!r}; expected one of {', '.join(RULES)}")
    count = len(control_points)
    length, point = np.full(count, np.nan), np.full(count, np.nan)
    place = np.full((count, 2), np.nan)
    roots, inside, degenerate = (np.zeros(count, np.int64) for _ in range(3))
    rows = np.arange(count)
    for number, t in enumerate(collocation_points):
        space = paper_space((t,))
        # A distant solution is no path inside; but all solutions are counted once.
        far = rule == "all" or number == 0
        found = _candidates(control_points[rows], space, far)
        if number == 0:
            roots = np.bincount(found.owner, minlength=count)
            inside = np.bincount(found.owner[found.inside], minlength=count)
        allowed = np.isfinite(found.length) & (found.inside if rule == "inside" else True)
        best = _shortest(found, np.flatnonzero(allowed), len(rows))
        has = best >= 0
        regular = np.zeros(len(rows), bool)
        winners = found.take(best[has])
        regular[has] = _angles(control_points[rows[has]], space, winners.place) > PARALLEL
        degenerate[rows[has & ~regular]] += 1
        good = regular[has]
        length[rows[regular]] = winners.length[good]
        place[rows[regular]] = winners.place[good]
        point[rows[regular]] = t
        rows = rows[~regular]
        if len(rows) == 0:
            break
    return TwoFunctionSolution(length, place, point, roots, inside, degenerate)


@dataclass(frozen=True, eq=False)
class _Candidates:
    """All real solutions of a batch: the patch of each, its place and length, and if inside."""

    owner: Ints
    place: Array
    length: Array
    inside: Bools

    def take(self, rows: Ints) -> "_Candidates":
        return _Candidates(self.owner[rows], self.place[rows], self.length[rows], self.inside[rows])


def nodal_values(places: Array) -> Array:
    """Return values (k, 2, 3) at the nodes 0, t* and 1 of diagonals through (u, v) at t*."""
    values = np.zeros((len(places), 2, 3))
    values[:, :, 1], values[:, :, 2] = places, 1.0
    return values


def _candidates(control_points: Array, space: TrialSpace, far: bool) -> _Candidates:
    real = system_roots(control_points, space, far=far).real
    owner = np.repeat(np.arange(len(real)), [len(roots) for roots in real])
    place = np.concatenate([np.empty((0, 2)), *real])
    values = nodal_values(place)
    length = arc_lengths(BezierSurfaces(control_points[owner]), space, values)
    return _Candidates(owner, place, length, inside_patch(space, values))


def _shortest(found: _Candidates, allowed: Ints, count: int) -> Ints:
    """Return the shortest allowed candidate of each owner, -1 if it has none."""
    best = np.full(count, -1)
    # The last value that is written stays.
    order = allowed[np.argsort(found.length[allowed], kind="stable")[::-1]]
    best[found.owner[order]] = order
    return best


def _angles(control_points: Array, space: TrialSpace, places: Array) -> Array:
    """Return the angles between the gradients of both equations: their scaled determinant."""
    surface = BezierSurfaces(control_points)
    _, jacobian = residual_and_jacobian(surface, space, nodal_values(places))
    matrix = jacobian[:, :, 0, :, 0]
    sizes = np.linalg.norm(matrix, axis=2).prod(axis=1)
    determinant = np.abs(np.linalg.det(matrix))
    return np.asarray(determinant / np.where(sizes > 0.0, sizes, 1.0))
