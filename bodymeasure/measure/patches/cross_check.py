"""Lengths compared with libigl's distances on meshes of the patches."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas import Atlas
from bodymeasure.geodesic import GeodesicSolution, Status
from bodymeasure.oracle import LEVELS, mesh_distances

# The mesh distance's own uncertainty covers its error for 99.4 to 99.9 % of pairs of points
# (tests/benchmarks/patches/oracle_levels.py), so that some of a body's 752 diagonals would be
# called wrong by chance. A difference counts from three times that, and never below a millionth,
# which is as far as meshes of this size can show.
SAFETY = 3.0
RESOLUTION = 1e-6


class Verdict(Enum):
    """How a length compares with the mesh's; each value is a sentence for the user."""

    AGREES = "The length and the mesh distance agree, as far as the meshes can show."
    LONGER = (
        "The mesh has a path that is shorter by more than the meshes' uncertainty: the geodesic is "
        "probably not the shortest on its patch."
    )
    SHORTER = (
        "The length is below the mesh distance by more than the uncertainty, which cannot be: "
        "one of the two is wrong, and the length should not be used."
    )
    NOT_COMPARED = (
        "There is no length to compare with the mesh distance, which is given for itself, or the "
        "patch could not be meshed."
    )

    @property
    def sentence(self) -> str:
        """The verdict in words for the user."""
        return self.value


@dataclass(frozen=True, eq=False)
class CrossCheck:
    """Mesh distances beside lengths; every array has the shape of the solution.

    Parameters
    ----------
    exact : ndarray
        Shortest path inside the patch, extrapolated from exact polyhedral distances.
    exact_uncertainty : ndarray
        The uncertainty of `exact`.
    heat : ndarray
        Distance by the heat method: a plausibility check, right to some percent.
    difference : ndarray
        Length less `exact`; NaN where there is no length.
    relative_difference : ndarray
        `difference` over `exact`.
    verdict : ndarray of Verdict
    levels : tuple of int
        Segments a side of the meshes.
    failures : mapping of int to str
        Patches that could not be meshed, by number, and why; there `exact` is NaN.
    """

    exact: Array
    exact_uncertainty: Array
    heat: Array
    difference: Array
    relative_difference: Array
    verdict: NDArray[Any]
    levels: tuple[int, ...]
    failures: Mapping[int, str]


def cross_check(
    atlas: Atlas,
    solution: GeodesicSolution,
    *,
    levels: tuple[int, ...] = LEVELS,
    processes: int = 1,
    progress: Callable[[int], None] | None = None,
) -> CrossCheck:
    """Compare geodesics with distances on tessellations, which share no code with them.

    Parameters
    ----------
    atlas : Atlas
    solution : GeodesicSolution, shape (patches, pairs)
        As `diagonals` returns it.
    levels : tuple of int
        Segments a side of the meshes that are extrapolated from.
    processes : int
        Worker processes.
    progress : callable, optional
        Called with the number of geodesics compared so far.

    Raises
    ------
    MissingExtraError
        If libigl is not installed.
    """
    mesh = mesh_distances(
        atlas.control_points,
        solution.start,
        solution.end,
        levels=levels,
        processes=processes,
        progress=progress,
    )
    difference = solution.length - mesh.exact
    uncertainty = np.maximum(SAFETY * mesh.exact_uncertainty, RESOLUTION * mesh.exact)
    # Along an edge of the patch the meshes converge more slowly than the extrapolation assumes: all
    # that it adds to the finest mesh's distance is uncertain there.
    added = np.abs(mesh.exact - mesh.by_level[..., -1])
    along = _along_an_edge(solution)
    uncertainty = np.where(along, np.maximum(uncertainty, added), uncertainty)
    allowed = uncertainty + solution.error_estimate
    verdict = np.full(solution.shape, Verdict.AGREES, dtype=object)
    verdict[difference > allowed] = Verdict.LONGER
    verdict[difference < -allowed] = Verdict.SHORTER
    verdict[~np.isfinite(difference)] = Verdict.NOT_COMPARED
    # Two points at the same place have the distance 0: their difference is given as it is.
    with np.errstate(divide="ignore", invalid="ignore"):
        relative = np.where(mesh.exact > 0.0, difference / mesh.exact, difference)
    return CrossCheck(
        exact=mesh.exact,
        exact_uncertainty=mesh.exact_uncertainty,
        heat=mesh.heat,
        difference=difference,
        relative_difference=relative,
        verdict=verdict,
        levels=levels,
        failures=mesh.failures,
    )


def _along_an_edge(solution: GeodesicSolution) -> Bools:
    """Return whether paths run along an edge of their patch, or may, since both ends lie on it."""
    start, end = solution.start, solution.end
    common = (start == end) & ((start == 0.0) | (start == 1.0))
    return np.asarray(common.any(axis=-1) | (solution.status == Status.ON_BOUNDARY))
