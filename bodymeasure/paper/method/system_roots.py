"""All solutions of the paper's system of equations for two functions."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Complex, Ints
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.paper.method.polynomial_pair import PolynomialPair
from bodymeasure.paper.method.roots import SAME, all_roots, are_roots, counted, distinct, real_roots
from bodymeasure.paper.method.two_functions import (
    MIDDLE,
    collocation_equations,
    graph_directions,
    graph_equations,
)

# The number of roots, real and complex, of two general polynomials of degrees (5, 6) and (6, 5):
# 5 * 5 + 6 * 6 (D. N. Bernstein, "The number of roots of a system of equations", 1975).
GENERAL_COUNT = 61
# The same for patches that are graphs, where the other 24 are at infinity, counted on random ones.
GRAPH_COUNT = 37
# Units of length in which roots are sought: that of the patch and, where fewer than the general
# number have been found, larger ones for distant roots.
UNITS = ((1.0,), (6.0, 40.0))
# The residual, relative to the terms, below which a root of one form of the equations is a root of
# the other.
RESIDUAL = 1e-8


class SystemRoots(NamedTuple):
    """The real solutions of a batch of systems.

    Parameters
    ----------
    real : tuple of ndarray, each of shape (roots, 2)
        (u, v) at the collocation point, in order of u.
    complex_count : ndarray of int, shape (patches,)
        Number of roots that were found, including those that are not real.
    """

    real: tuple[Array, ...]
    complex_count: Ints


def system_roots(control_points: Array, space: TrialSpace, *, far: bool = True) -> SystemRoots:
    """Return all roots of equations (11) and (12) for diagonals, with one collocation point.

    Parameters
    ----------
    control_points : ndarray, shape (patches, 4, 4, 3)
    space : TrialSpace
        Trial space of two functions.
    far : bool
        Whether to look again for roots far from the patch where fewer than the general number have
        been found.
    """
    units = UNITS if far else UNITS[:1]
    direction, is_graph = graph_directions(control_points)
    found: list[Complex] = [np.empty((0, 2), np.complex128)] * len(control_points)
    for kind in (True, False):
        rows = np.flatnonzero(is_graph == kind)
        equations = collocation_equations(control_points[rows], space).without_rounding
        if kind:
            reduced = graph_equations(control_points[rows], space, direction[rows])
            roots = _searched(reduced.without_rounding, equations, GRAPH_COUNT, units)
        else:
            roots = _searched(equations, equations, GENERAL_COUNT, units)
        for row, points in zip(rows, roots, strict=True):
            found[row] = points
    counts = np.array([counted(points[None])[0] for points in found], np.int64)
    return SystemRoots(tuple(MIDDLE + real_roots(points) for points in found), counts)


def _searched(
    pair: PolynomialPair,
    equations: PolynomialPair,
    count: int,
    units: tuple[tuple[float, ...], ...],
) -> Complex:
    """Return roots of a pair that solve the equations, too, in larger units where some lack."""
    found = np.full((len(pair.first), 0, 2), np.nan, np.complex128)
    rows = np.arange(len(pair.first))
    for some in units:
        roots = all_roots(pair.take(rows), some)
        roots[~are_roots(equations.take(rows), roots, RESIDUAL)] = np.nan
        wider = np.full((len(found), found.shape[1] + roots.shape[1], 2), np.nan, np.complex128)
        wider[:, : found.shape[1]] = found
        wider[rows, found.shape[1] :] = roots
        found = distinct(wider, np.full(wider.shape[1], SAME))
        rows = np.flatnonzero(counted(found) < count)
        if len(rows) == 0:
            break
    return found
