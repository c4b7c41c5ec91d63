"""The converged shortest paths with which both of the paper's methods are compared."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic import solve_geodesic

START, END = (0.0, 0.0), (1.0, 1.0)
# The number of points at which paths are examined, and the decrease of u that is rounding.
LOOKS = 129
ROUNDING = 1e-9


@dataclass(frozen=True, eq=False)
class Truth:
    """The shortest diagonals inside their patches; arrays of shape (patches,).

    Parameters
    ----------
    length, error : ndarray
        Length and its estimated error; NaN and infinite where no length can be trusted.
    turns_back : ndarray of bool
        Whether u decreases somewhere on the path, so that v is no function of u.
    along_edge : ndarray of bool
        Whether the path runs along an edge, where the geodesic of the differential equations
        leaves the patch.
    """

    length: Array
    error: Array
    turns_back: Bools
    along_edge: Bools


def true_diagonals(control_points: Array) -> Truth:
    """Return the shortest paths from (0, 0) to (1, 1), which are searched for thoroughly.

    Parameters
    ----------
    control_points : ndarray, shape (patches, 4, 4, 3)
    """
    solution = solve_geodesic(control_points, START, END, search="thorough", on_failure="status")
    u = solution.path(np.linspace(0.0, 1.0, LOOKS))[..., 0]
    known = np.isfinite(solution.length)
    along_edge = np.array([bool(contacts) for contacts in solution.contacts])
    return Truth(
        length=solution.length,
        error=np.where(known, solution.error_estimate, np.inf),
        turns_back=known & (np.diff(u, axis=-1) < -ROUNDING).any(axis=-1),
        along_edge=known & along_edge,
    )
