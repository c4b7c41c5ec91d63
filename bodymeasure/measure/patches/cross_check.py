"""Lengths compared with distances on meshes of the patches.

Edge flips measure on all meshes, in a fifth of libigl's time. Their paths are locally shortest
ones: they bound distances from above, and could hide that a length is no shortest one. So libigl's
exact algorithm confirms a sample of the patches, each disagreement and what comes near one, and all
worst cases; where it finds flips wrong more often than now and then, it measures everything.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from enum import Enum
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas import Atlas
from bodymeasure.errors import InputError
from bodymeasure.geodesic import GeodesicSolution, Status
from bodymeasure.measure.patches.checks import Check
from bodymeasure.oracle import LEVELS, MeshDistances, has_flips, mesh_distances

# The mesh distance's own uncertainty covers its error for 99.4 to 99.9 % of pairs of points
# (tests/benchmarks/patches/oracle_levels.py), so that some of a body's 752 diagonals would be
# called wrong by chance. A difference counts from three times that, and never below a millionth,
# which is as far as meshes of this size can show.
SAFETY = 3.0
RESOLUTION = 1e-6

# One of so many patches is confirmed by libigl, and so are this many of the worst ones, twice as
# many as reports show.
SAMPLE = 20
WORST = 12
# What uses up this part of the difference that is allowed is confirmed, too.
NEARLY = 0.5
# Of 320 distances by flips, 2 were longer than libigl's by more than a ten-millionth. Where more
# than this part is longer by a millionth, flips serve no purpose.
MOST_LONGER = 0.05


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
    confirmed : ndarray of bool, shape (patches,)
        The patches whose distances are libigl's; those of the others are by edge flips.
    flips_longer : float
        By how much distances by flips are longer than libigl's at most, as a part of them, where
        both measured; NaN where only one did.
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
    confirmed: Bools
    flips_longer: float
    failures: Mapping[int, str]


def cross_check(
    atlas: Atlas,
    solution: GeodesicSolution,
    *,
    levels: tuple[int, ...] = LEVELS,
    check: Check = "flips",
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
    check : {"flips", "libigl"}
        Whether edge flips may measure what libigl need not confirm. Without potpourri3d, libigl
        measures everything.
    processes : int
        Worker processes.
    progress : callable, optional
        Called with the number of geodesics compared so far.

    Raises
    ------
    InputError
        If `check` is neither.
    MissingExtraError
        If libigl is not installed.
    """
    if str(check) not in ("flips", "libigl"):
        raise InputError(f"check is {check!r}; expected 'flips' or 'libigl'")
    ends = atlas.control_points, solution.start, solution.end
    measure = partial(mesh_distances, levels=levels, processes=processes)
    by_flips = check == "flips" and has_flips()
    mesh = measure(*ends, engine="flips" if by_flips else "libigl", progress=progress)
    confirmed = np.full(len(atlas), not by_flips)
    judged, longest = _judged(solution, mesh), np.nan
    again = _doubtful(judged, confirmed)
    while len(again):
        exact = measure(*(each[again] for each in ends), engine="libigl")
        longer = (mesh.by_level[again] / exact.by_level - 1.0)[np.isfinite(exact.by_level)]
        longest = float(np.nanmax(np.append(longer, longest), initial=0.0))
        # The sample says how often flips are longer; all others were chosen for their differences.
        sampled = (mesh.exact[again] > exact.exact * (1.0 + RESOLUTION))[again % SAMPLE == 0]
        often = sampled.sum() > MOST_LONGER * sampled.size
        mesh, confirmed[again] = _replaced(mesh, again, exact), True
        judged = _judged(solution, mesh)
        again = np.flatnonzero(~confirmed) if often else _doubtful(judged, confirmed)
    return CrossCheck(
        exact=mesh.exact,
        exact_uncertainty=mesh.exact_uncertainty,
        heat=mesh.heat,
        difference=judged.difference,
        relative_difference=judged.relative,
        verdict=judged.verdict,
        levels=levels,
        confirmed=confirmed,
        flips_longer=longest,
        failures=mesh.failures,
    )


class _Judged(NamedTuple):
    """How lengths compare with distances; the arrays have the shape of the solution."""

    difference: Array
    relative: Array
    allowed: Array
    verdict: NDArray[Any]


def _judged(solution: GeodesicSolution, mesh: MeshDistances) -> _Judged:
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
    return _Judged(difference, relative, allowed, verdict)


def _doubtful(judged: _Judged, confirmed: Bools) -> Ints:
    """The patches that libigl is to measure, and has not yet."""
    wanted = np.arange(len(confirmed)) % SAMPLE == 0
    # What is not finite is not nearly as it should be either.
    wanted |= ~(np.abs(judged.difference) <= NEARLY * judged.allowed).all(axis=1)
    wanted |= (judged.verdict != Verdict.AGREES).any(axis=1)
    size = np.abs(judged.relative).max(axis=1)
    wanted[np.argsort(-np.where(np.isfinite(size), size, np.inf), kind="stable")[:WORST]] = True
    return np.flatnonzero(wanted & ~confirmed)


def _replaced(mesh: MeshDistances, patches: Ints, other: MeshDistances) -> MeshDistances:
    """The distances with those of some patches replaced."""
    arrays = {}
    for name in ("exact", "exact_uncertainty", "heat", "by_level"):
        arrays[name] = getattr(mesh, name).copy()
        arrays[name][patches] = getattr(other, name)
    failures = {patch: why for patch, why in mesh.failures.items() if patch not in patches}
    failures |= {int(patches[place]): why for place, why in other.failures.items()}
    return replace(mesh, **arrays, failures=failures)


def _along_an_edge(solution: GeodesicSolution) -> Bools:
    """Return whether paths run along an edge of their patch, or may, since both ends lie on it."""
    start, end = solution.start, solution.end
    common = (start == end) & ((start == 0.0) | (start == 1.0))
    return np.asarray(common.any(axis=-1) | (solution.status == Status.ON_BOUNDARY))
