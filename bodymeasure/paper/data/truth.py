"""The converged shortest paths that both of the paper's methods are measured against."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic import solve_geodesic

START, END = (0.0, 0.0), (1.0, 1.0)
# Where paths are looked at, and by how much u may fall from rounding.
LOOKS = 129
ROUNDING = 1e-9


@dataclass(frozen=True, eq=False)
class Truth:
    """The shortest diagonals inside their patches; arrays of shape (patches,).

    Parameters
    ----------
    length, error : ndarray
        With its estimated error; NaN and infinite where no length can be trusted.
    turns_back : ndarray of bool
        Whether u falls somewhere on the way, so that v is no function of u.
    along_edge : ndarray of bool
        Whether the path runs along an edge: the geodesic that the differential equations know
        leaves the patch there.
    """

    length: Array
    error: Array
    turns_back: Bools
    along_edge: Bools

    @property
    def is_known(self) -> Bools:
        """Where there is a length."""
        return np.isfinite(self.length)


def true_diagonals(control_points: Array) -> Truth:
    """The shortest paths from (0, 0) to (1, 1), searched thoroughly.

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
