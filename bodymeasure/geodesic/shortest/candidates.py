"""The shortest paths inside patches: candidates, descent, polishing, for many problems at once."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.shortest.descent import descend
from bodymeasure.geodesic.shortest.exact_paths import polish
from bodymeasure.geodesic.shortest.polygon_energy import polygon_energy, polygon_lengths
from bodymeasure.geodesic.shortest.rough_paths import rough_paths
from bodymeasure.geodesic.shortest.saddles import ways_off
from bodymeasure.geodesic.solving.protocol import Piece
from bodymeasure.geodesic.surfaces.protocol import Surface

# Edges of the polygons that compete.
EDGES = 32
# And of those that are looked at once more for being saddles.
FINE_EDGES = 128
# How far, in u or v, a path steps off a saddle.
STEP_OFF = 0.05
# Polygons nearer to one another than this everywhere, in (u, v), lead to the same path.
SAME = 0.02
# Seeds nearer than this to a known local minimum lead to it.
NEAR = 0.05
# A path must be shorter than one that is known by this part to be taken instead.
SHORTER = 1e-8
# After so many polygons shorter than the best path that could not be made exact, a problem stays in
# doubt: then hardly ever another one can, and each takes as long as a hundred that can.
MOST_FAILURES = 2


class Known(NamedTuple):
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


class Found(NamedTuple):
    """What a search found.

    Parameters
    ----------
    pieces : tuple of Piece
        Paths that are shorter than those known.
    doubtful : ndarray of bool, shape (problems,)
        Where a path shorter still seems to exist, which could not be made exact.
    """

    pieces: tuple[Piece, ...]
    doubtful: NDArray[np.bool_]


class _Contenders(NamedTuple):
    """Polygons at rest, shape (contenders, EDGES + 1, 2), whose they are, and their lengths."""

    problems: Ints
    points: Array
    length: Array


# Overflow and the like on wild surfaces end as candidates that are not finite.
@np.errstate(over="ignore", divide="ignore", invalid="ignore")
def shortest_paths(surface: Surface, ends: Array, known: Known, tolerance: float) -> Found:
    """The shortest paths found between pairs of points, each in a patch.

    Candidates are the straight line, the path that is known already, and the graph's; each slides
    down to a path at rest, off saddles too, in the box; then the shortest is made exact, and others
    as long as they may be shorter: a polygon at rest is shorter than the path it stands for. That
    there is none shorter still is not proven.

    Parameters
    ----------
    surface : Surface
    ends : ndarray, shape (2, problems, 2)
        Starts and ends.
    known : Known
    tolerance : float
        Relative error asked for.
    """
    count = len(known.length)
    standing = _Standing(
        best=known.length * (1.0 - SHORTER),
        doubt=np.full(count, np.inf),
        winner=np.full(count, -1),
        pieces=[],
    )
    latest = np.where(np.isfinite(known.length)[:, None, None], known.points, np.nan)
    contenders = _at_rest(surface, *_seeds(surface, ends, known))
    _compete(surface, contenders, latest, standing, tolerance)
    # A path at rest on a polygon of few edges may be on a saddle that only finer ones can tell.
    saddles = [piece for piece in standing.winners() if not piece.measured.minimal.all()]
    if saddles:
        problems = np.concatenate([piece.problems for piece in saddles])
        times = np.linspace(0.0, 1.0, FINE_EDGES + 1)
        paths = np.concatenate([piece.points(times) for piece in saddles])
        beyond = _at_rest(surface, problems, np.clip(paths, 0.0, 1.0))
        # What lies beyond may be near, so that none is taken for the same.
        _compete(surface, beyond, np.full((count, *paths.shape[1:]), np.nan), standing, tolerance)
    return Found(standing.winners(), standing.doubt < standing.best)


class _Standing(NamedTuple):
    """How the competition stands; the arrays, one entry a problem, and the list change.

    Parameters
    ----------
    best : ndarray
        What a path must be shorter than.
    doubt : ndarray
        The least length of a path that could not be made exact.
    winner : ndarray of int
        The number of the piece that holds the shortest path; -1 if that is the one known before.
    pieces : list of Piece
    """

    best: Array
    doubt: Array
    winner: Ints
    pieces: list[Piece]

    def winners(self) -> tuple[Piece, ...]:
        """The shortest paths, by piece."""
        chosen = (
            piece.take(np.flatnonzero(self.winner[piece.problems] == number))
            for number, piece in enumerate(self.pieces)
        )
        return tuple(piece for piece in chosen if len(piece.problems))


def _compete(
    surface: Surface,
    contenders: _Contenders,
    latest: Array,
    standing: _Standing,
    tolerance: float,
) -> None:
    """Make contenders exact, the shortest of each problem first, while they may still win."""
    best, doubt, winner, pieces = standing
    failures = np.zeros(len(best), np.int64)
    while True:
        given_up = np.where(failures < MOST_FAILURES, np.inf, -np.inf)
        contenders = _others(contenders, latest, np.minimum(np.minimum(best, doubt), given_up))
        if len(contenders.problems) == 0:
            break
        problems, first = np.unique(contenders.problems, return_index=True)
        latest[problems] = contenders.points[first]
        polished, in_doubt = polish(surface.take(problems), latest[problems], tolerance)
        doubt[problems] = np.minimum(doubt[problems], in_doubt)
        failures[problems] += in_doubt < best[problems]
        for piece in polished:
            owners, length = problems[piece.problems], piece.measured.corrected
            shorter = length < best[owners]
            winner[owners[shorter]] = len(pieces)
            # One that is no minimum gives way to its equals.
            bar = np.where(piece.measured.minimal, length, length * (1.0 + SHORTER))
            best[owners[shorter]] = bar[shorter]
            pieces.append(piece.renumbered(owners))


def _seeds(surface: Surface, ends: Array, known: Known) -> tuple[Ints, Array]:
    """Polygons to slide down from, and whose they are."""
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
    """Where seeds slide down to, also those beyond saddles; in order of length."""
    points = descend(surface.take(problems), seeds)
    saddles, direction = ways_off(surface.take(problems), points)
    beyond = np.concatenate([points[saddles] + sign * STEP_OFF * direction for sign in (-1.0, 1.0)])
    owners = np.concatenate([problems[saddles]] * 2)
    beyond = descend(surface.take(owners), beyond)
    problems, points = np.concatenate([problems, owners]), np.concatenate([points, beyond])
    length = polygon_lengths(surface.take(problems), points)
    order = np.argsort(length, kind="stable")
    return _Contenders(problems[order], points[order], length[order])


def _others(contenders: _Contenders, latest: Array, best: Array) -> _Contenders:
    """Those that may be shorter than the best known, and are not the same as the latest."""
    problems, points, length = contenders
    keep = (length < best[problems]) & ~(_gap(points, latest[problems]) <= SAME)
    return _Contenders(problems[keep], points[keep], length[keep])


def _gap(points: Array, others: Array) -> Array:
    result: Array = np.abs(points - others).max(axis=(1, 2))
    return result
