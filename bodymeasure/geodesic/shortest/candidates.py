"""The shortest paths inside patches, for many problems at once.

Candidates slide down to polygons at rest, and the shortest of these are made exact.
"""

from dataclasses import dataclass, field
from functools import partial
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.shortest.descent import descend
from bodymeasure.geodesic.shortest.exact_paths import exact_paths
from bodymeasure.geodesic.shortest.polygon_energy import polygon_energy, polygon_lengths
from bodymeasure.geodesic.shortest.rough_paths import rough_paths
from bodymeasure.geodesic.shortest.saddles import descent_directions
from bodymeasure.geodesic.solving.protocol import PathBatch
from bodymeasure.geodesic.surfaces.protocol import Surface

# The number of edges of the polygons that compete.
EDGES = 32
# The number of edges of polygons that are examined once more for being saddles.
FINE_EDGES = 128
# How far, in u or v, a path steps off a saddle.
STEP_OFF = 0.05
# Polygons nearer to one another than this everywhere, in (u, v), lead to the same path.
SAME = 0.02
# Seeds nearer than this to a known local minimum lead to it.
NEAR = 0.05
# The number of parts of a path that others are compared with.
CURVE_PARTS = 256
# A path must be shorter than one that is known by this part to be taken instead.
SHORTER = 1e-8
# After so many polygons that are shorter than the best path but could not be made exact, the
# problem stays doubtful: another one can hardly ever be made exact then, and each takes as long as
# a hundred that can.
MOST_FAILURES = 2


class KnownPaths(NamedTuple):
    """A path that is known already for each problem.

    Parameters
    ----------
    points : ndarray, shape (problems, EDGES + 1, 2)
        (u, v) at equal distances; they may leave the patch, or not be finite.
    length : ndarray, shape (problems,)
        Infinite where the path is not a proven local minimum inside the patch.
    """

    points: Array
    length: Array


class SearchResult(NamedTuple):
    """The paths that a search found.

    Parameters
    ----------
    batches : tuple of PathBatch
        Paths that are shorter than those known.
    doubtful : ndarray of bool, shape (problems,)
        Where an even shorter path seems to exist, which could not be made exact.
    """

    batches: tuple[PathBatch, ...]
    doubtful: Bools


class _Contenders(NamedTuple):
    """Polygons at rest, shape (contenders, EDGES + 1, 2), with their problems and lengths."""

    problems: Ints
    points: Array
    length: Array


@dataclass(eq=False)
class _Standing:
    """How the competition stands; it changes while contenders are made exact.

    Parameters
    ----------
    best : ndarray, shape (problems,)
        The length that a path must be below.
    unsolved : ndarray, shape (problems,)
        The least length of a polygon that could not be made exact.
    winner : ndarray of int, shape (problems,)
        The number of the batch that holds the shortest path; -1 if that is the one known before.
    batches : list of PathBatch
    """

    best: Array
    unsolved: Array
    winner: Ints
    batches: list[PathBatch] = field(default_factory=list)

    def enter(self, batch: PathBatch) -> None:
        """Let paths win where they are shorter than the best."""
        owners, length = batch.problems, batch.length.corrected
        shorter = length < self.best[owners]
        self.winner[owners[shorter]] = len(self.batches)
        # A path that is no minimum gives way to one of the same length.
        bar = np.where(batch.length.minimal, length, length * (1.0 + SHORTER))
        self.best[owners[shorter]] = bar[shorter]
        self.batches.append(batch)

    def curve(self, problem: int) -> Array:
        """Return (u, v) at equal distances along the shortest path, shape (CURVE_PARTS + 1, 2).

        NaN if that is no minimum, or was known before.
        """
        number = int(self.winner[problem])
        if number >= 0:
            batch = self.batches[number]
            path = batch.take(np.flatnonzero(batch.problems == problem))
            if path.length.minimal.all():
                return np.asarray(path.points(np.linspace(0.0, 1.0, CURVE_PARTS + 1))[0])
        return np.full((CURVE_PARTS + 1, 2), np.nan)

    def winners(self) -> tuple[PathBatch, ...]:
        """Return the shortest paths, by batch."""
        chosen = (
            batch.take(np.flatnonzero(self.winner[batch.problems] == number))
            for number, batch in enumerate(self.batches)
        )
        return tuple(batch for batch in chosen if len(batch.problems))


# Overflow and the like on wild surfaces end as candidates that are not finite.
@np.errstate(over="ignore", divide="ignore", invalid="ignore")
def shortest_paths(
    surface: Surface, ends: Array, known: KnownPaths, tolerance: float
) -> SearchResult:
    """Find the shortest paths between pairs of points, each in a patch.

    Candidates are the straight line, the path that is known already, and those of a graph. Each
    slides down to a path at rest in the box, off saddles too. Then the shortest is made exact, and
    so are the others as long as they may be shorter, since a polygon at rest is shorter than the
    path it stands for. That there is none shorter still is not proven.

    Parameters
    ----------
    surface : Surface
    ends : ndarray, shape (2, problems, 2)
        Starts and ends.
    known : KnownPaths
    tolerance : float
        The relative error asked for.
    """
    count = len(known.length)
    standing = _Standing(
        best=known.length * (1.0 - SHORTER),
        unsolved=np.full(count, np.inf),
        winner=np.full(count, -1),
    )
    latest = np.where(np.isfinite(known.length)[:, None, None], known.points, np.nan)
    contenders = _at_rest(surface, *_seeds(surface, ends, known))
    _compete(surface, contenders, latest, standing, tolerance)
    # A path at rest on a polygon of few edges may be on a saddle that only finer ones reveal.
    saddles = [batch for batch in standing.winners() if not batch.length.minimal.all()]
    if saddles:
        problems = np.concatenate([batch.problems for batch in saddles])
        times = np.linspace(0.0, 1.0, FINE_EDGES + 1)
        paths = np.concatenate([batch.points(times) for batch in saddles])
        beyond = _at_rest(surface, problems, np.clip(paths, 0.0, 1.0))
        # What lies beyond a saddle may be near it, and must not be taken for the same path.
        _compete(surface, beyond, np.full((count, *paths.shape[1:]), np.nan), standing, tolerance)
    return SearchResult(standing.winners(), standing.unsolved < standing.best)


def _seeds(surface: Surface, ends: Array, known: KnownPaths) -> tuple[Ints, Array]:
    """The polygons to slide down from, preceded by their problems."""
    times = np.linspace(0.0, 1.0, EDGES + 1)[:, None]
    straight = ends[0, :, None] * (1.0 - times) + ends[1, :, None] * times
    # Where the path that is known is a good one, the straight line led there.
    unsure = np.flatnonzero(~np.isfinite(known.length))
    rough = rough_paths(surface, ends, EDGES)
    problems = np.concatenate([unsure, unsure, rough.problems])
    points = np.concatenate([straight[unsure], known.points[unsure], rough.points])
    points = np.clip(points, 0.0, 1.0)
    points[:, 0], points[:, -1] = ends[:, problems]
    energy = polygon_energy(surface.take(problems), points).energy
    # Nothing can be found where the surface is not finite, or all one point.
    usable = np.isfinite(energy) & (energy > 0.0)
    sure = np.isfinite(known.length)[problems]
    usable &= ~(sure & (_gap(points, known.points[problems]) <= NEAR))
    return problems[usable], points[usable]


def _at_rest(surface: Surface, problems: Ints, seeds: Array) -> _Contenders:
    """The polygons that seeds slide down to, also beyond saddles, in order of length."""
    points = descend(surface.take(problems), seeds)
    saddles, direction = descent_directions(surface.take(problems), points)
    beyond = np.concatenate([points[saddles] + sign * STEP_OFF * direction for sign in (-1.0, 1.0)])
    owners = np.concatenate([problems[saddles]] * 2)
    beyond = descend(surface.take(owners), beyond)
    problems, points = np.concatenate([problems, owners]), np.concatenate([points, beyond])
    length = polygon_lengths(surface.take(problems), points)
    order = np.argsort(length, kind="stable")
    return _Contenders(problems[order], points[order], length[order])


def _compete(
    surface: Surface,
    contenders: _Contenders,
    latest: Array,
    standing: _Standing,
    tolerance: float,
) -> None:
    """Make contenders exact, the shortest of each problem first, while they may still win."""
    failures = np.zeros(len(standing.best), np.int64)
    while True:
        given_up = np.where(failures < MOST_FAILURES, np.inf, -np.inf)
        bar = np.minimum(np.minimum(standing.best, standing.unsolved), given_up)
        contenders = _others(contenders, latest, bar)
        if len(contenders.problems) == 0:
            break
        problems, first = np.unique(contenders.problems, return_index=True)
        latest[problems] = contenders.points[first]
        exact = exact_paths(
            surface.take(problems),
            latest[problems],
            standing.best[problems],
            [partial(standing.curve, problem) for problem in problems.tolist()],
            tolerance,
        )
        standing.unsolved[problems] = np.minimum(standing.unsolved[problems], exact.unsolved)
        failures[problems] += exact.unsolved < standing.best[problems]
        for batch in exact.batches:
            standing.enter(batch.renumbered(problems[batch.problems]))


def _others(contenders: _Contenders, latest: Array, best: Array) -> _Contenders:
    """The contenders that may be shorter than the best known and differ from the latest."""
    problems, points, length = contenders
    keep = (length < best[problems]) & ~(_gap(points, latest[problems]) <= SAME)
    return _Contenders(problems[keep], points[keep], length[keep])


def _gap(points: Array, others: Array) -> Array:
    result: Array = np.abs(points - others).max(axis=(1, 2))
    return result
