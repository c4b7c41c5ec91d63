"""The search for shorter paths than a method finds from the straight line, and when it is made.

Newton's method from the straight line in (u, v) finds *a* geodesic. It may leave the patch, pass a
conjugate point, or be longer than one elsewhere. `shortest_paths` looks for the shortest inside the
patch; the settings say for which problems:

- ``straight``: for none.
- ``quick``, the default: where the method did not converge, the path leaves the patch or is not
  proven to be a local minimum, and for paths longer than `ROUNDABOUT` chords. No path is shorter
  than its chord, so that the others can be too long by 15 % at most. Compared with 30 starts of
  another method, on 500 patches each of the paper's kind, of sides 1 and 0.6, and symmetric about
  the path, it missed no shorter path
  (``tests/benchmarks/patches/multistart.py``). Asking the graph about every path would take fifty
  times as long as finding it.
- ``thorough``: for all.

No search proves that there is no shorter path still.
"""

from dataclasses import replace
from typing import Literal, get_args

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.errors import InputError
from bodymeasure.geodesic.shortest.candidates import EDGES, KnownPaths, shortest_paths
from bodymeasure.geodesic.shortest.exact_paths import OUTSIDE
from bodymeasure.geodesic.shortest.rough_paths import evenly
from bodymeasure.geodesic.solving.protocol import MethodResult, PathBatch
from bodymeasure.geodesic.surfaces.protocol import Surface

Search = Literal["quick", "thorough", "straight"]
SEARCHES: tuple[Search, ...] = get_args(Search)


# Paths longer than so many chords are searched further: four of a body's 752 diagonals at most. On
# random patches with heights of twice their side, two proven local minima in 6000 were longer
# than others, by 0.3 and 6 %; they were 1.24 and 1.20 chords long.
ROUNDABOUT = 1.15
# The numbers of problems that are searched, and whose chords are calculated, at once: they bound
# the memory.
CHUNK = 128
CHORDS = 16384


def check_search(search: str) -> None:
    """Raise an InputError unless a setting is one of `SEARCHES`."""
    # Compared as text, since an array is not compared as a whole.
    if str(search) not in SEARCHES:
        raise InputError(f"search is {search!r}; expected one of {', '.join(SEARCHES)}")


def search_further(
    surface: Surface,
    ends: tuple[Array, Array],
    result: MethodResult,
    search: Search,
    tolerance: float,
) -> MethodResult:
    """Return the paths that a method found, with shorter ones, and ones inside the patch, put in.

    Parameters
    ----------
    surface : Surface
    ends : tuple of ndarray
        The starts and the ends, both of shape (problems, 2).
    result : MethodResult
    search : {"quick", "thorough", "straight"}
    tolerance : float
        The relative error asked for.
    """
    if search == "straight":
        return result
    count = len(ends[0])
    good, again = np.zeros(count, bool), np.ones(count, bool)
    for batch in result.batches:
        fine = batch.converged & batch.length.minimal & ~is_outside(batch)
        good[batch.problems] = fine
        if search == "quick":
            again[batch.problems] = ~(fine & _is_straight(surface, ends, batch))
    if not again.any():
        return result
    place = np.empty((2, count), np.int64)
    for number, batch in enumerate(result.batches):
        place[0, batch.problems] = number
        place[1, batch.problems] = np.arange(len(batch.problems))
    numbers = np.flatnonzero(again)
    doubtful, replaced = np.zeros(count, bool), np.zeros(count, bool)
    shorter: list[PathBatch] = []
    for first in range(0, len(numbers), CHUNK):
        chunk = numbers[first : first + CHUNK]
        own = _taken(result, place[:, chunk])
        part = surface.take(chunk)
        known = _known(part, own, good[chunk])
        found = shortest_paths(part, np.stack(ends)[:, chunk], known, tolerance)
        shorter += [batch.renumbered(chunk[batch.problems]) for batch in found.batches]
        doubtful[chunk] = found.doubtful
    for batch in shorter:
        replaced[batch.problems] = True
    # A million paths are not copied to leave a few out.
    kept = [
        batch.take(np.flatnonzero(~gone)) if gone.any() else batch
        for batch, gone in ((batch, replaced[batch.problems]) for batch in result.batches)
    ]
    batches = [batch for batch in [*kept, *shorter] if len(batch.problems)]
    if doubtful.any():
        batches = [
            replace(batch, converged=batch.converged & ~doubtful[batch.problems])
            for batch in batches
        ]
    return MethodResult(tuple(batches), result.iterations)


def _is_straight(surface: Surface, ends: tuple[Array, Array], batch: PathBatch) -> Bools:
    """Which paths are hardly longer than their chords, so that none can be much shorter."""
    chord = _chords(surface, ends, batch.problems) if batch.chord is None else batch.chord
    result: Bools = batch.length.corrected <= ROUNDABOUT * chord
    return result


def _chords(surface: Surface, ends: tuple[Array, Array], problems: Ints) -> Array:
    chord = np.empty(len(problems))
    for first in range(0, len(chord), CHORDS):
        rows = problems[first : first + CHORDS]
        places = surface.take(rows).positions(np.stack([end[rows] for end in ends], axis=1))
        chord[first : first + CHORDS] = np.linalg.norm(places[:, 1] - places[:, 0], axis=1)
    return chord


def is_outside(batch: PathBatch) -> Bools:
    """Return which paths leave their patch; the legs of those along edges are checked already."""
    if batch.contacts:
        return np.zeros(len(batch.problems), bool)
    return batch.leaves_patch(OUTSIDE)


def _taken(result: MethodResult, place: Ints) -> list[PathBatch]:
    """The paths of some problems, given by their batches and rows, with new numbers."""
    numbers, rows = place
    return [
        result.batches[number]
        .take(rows[numbers == number])
        .renumbered(np.flatnonzero(numbers == number))
        for number in np.unique(numbers)
    ]


def _known(surface: Surface, batches: list[PathBatch], good: Bools) -> KnownPaths:
    """The paths in the form that the search takes, with the lengths of those that are good."""
    times = np.linspace(0.0, 1.0, EDGES + 1)
    points, length = np.empty((len(good), EDGES + 1, 2)), np.empty(len(good))
    for batch in batches:
        points[batch.problems] = (batch.values @ batch.space.matrices(times)[0].T).swapaxes(1, 2)
        length[batch.problems] = batch.length.corrected
    # Exact times of equal distances would take ten times as long.
    return KnownPaths(evenly(surface, points, EDGES), np.where(good, length, np.inf))
