"""What the default settings make of patches that are meant to break them.

Each problem is a patch that is folded, collapsed, stretched, thrown about or crumpled, of a random
size from 1e-3 to 1e6, and two of its points: corners, on edges, inside, 1e-12 apart, the same. It
is solved alone and timed. Every length is then compared with an independent one, which starts from
its path: Chebyshev collocation (`reference.py`) or, where that finds nothing, a spline inside the
patch (`spline_paths.py`), both on the part of the patch around the points, cut out in exact
arithmetic (`enlarged.py`). It must also have the properties of any length: it is finite where the
status says that there is one, no less than the chord and no more than the straight line's in
(u, v) on the patch, and its path lies in the patch. Every violation is listed, by kind.

Run it by hand: ``python tests/benchmarks/patches/adversarial.py [--problems N] [--first K]``;
10,000 take half an hour. Problem k is the same however many are run.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import sys
import time
import warnings
from collections import Counter, defaultdict
from pathlib import Path
from typing import NamedTuple

import numpy as np

import bodymeasure as bm
from bodymeasure.bezier import evaluate

sys.path.insert(0, str(Path(__file__).parents[2]))
from benchmarks.independent import reference
from benchmarks.independent.enlarged import Enlarged, enlarged
from benchmarks.independent.reference import Problems
from benchmarks.independent.spline_paths import descend, greville, lengths, refined
from helpers.surfaces.adversarial_patches import SPOILS, adversarial_patch, random_ends

from bodymeasure._typing import Array

SEED = 20240301
SLOW = 1.0
# The error in u and v that the library's tests of paths allow.
OUTSIDE = 1e-9
# A path this close to the reference's is meant to be the same geodesic.
SAME_PATH = 0.05
# The relative rounding error of the lengths that are compared.
ROUNDING, PLACE = 1e-14, 1e-15
# The numbers of spans that are tried in turn, until one changes the length by less than this part.
SPANS, ENOUGH = (16, 32, 64, 128), 1e-9
# A spline is never shorter than the shortest path, but for the error of its quadrature. It may be
# longer by some times the last change, which falls to a tenth each time where nothing is singular,
# and by what its descent leaves on patches much longer than wide.
DOUBT, DOUBT_BELOW, LEFT = 2.0, 10.0, 1e-9
BATCH = 200
# The numbers of edges of the polygons that measure a path.
FINE = 8192
# A summary is printed each time that so many problems are done.
REPORT = 1000
LISTED = 12


class Case(NamedTuple):
    """A problem and what came of it; `part` is the patch around its points and its path."""

    number: int
    solution: bm.GeodesicSolution
    seconds: float
    part: Enlarged

    @property
    def size(self) -> float:
        """Extent of the part of the patch."""
        return float(np.ptp(self.part.net, axis=(0, 1)).max())

    @property
    def rounding(self) -> float:
        """The relative rounding error of the lengths that this one is compared with.

        It includes that of the points on the part, which counts where a length is short beside it.
        """
        return ROUNDING * float(self.solution.raw_length) + PLACE * self.size

    def path(self, times: Array) -> Array:
        """The solution's path on the part of the patch."""
        return np.asarray((self.solution.path(times) - self.part.low) / self.part.size)


def problem(number: int) -> tuple[Array, Array]:
    """Control points and ends."""
    rng = np.random.default_rng([SEED, number])
    spoils = [SPOILS[k] for k in rng.integers(0, len(SPOILS), rng.integers(0, 4))]
    net = adversarial_patch(
        int(rng.integers(2**32)), spoils, float(rng.choice([0.0, 0.05, 0.2, 0.5]))
    )
    return net * 10.0 ** rng.uniform(-3.0, 6.0), random_ends(rng)


def solve(number: int, complaints: dict[str, list[int]]) -> Case | None:
    """Solve a problem; None if there is no length. Faults are added to the complaints."""
    net, ends = problem(number)
    seconds, solution = np.inf, None
    # It is solved again if it takes long, since the first use of a trial space has to make it.
    for _ in range(2):
        begin = time.process_time()
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                solution = bm.solve_geodesic(net, *ends, on_failure="status")
        except bm.InputError:
            if np.ptp(net, axis=(0, 1)).max() > 0.0:
                complaints["refused"].append(number)
            return None
        except Warning:
            complaints["warned"].append(number)
            return None
        except Exception:
            complaints["crashed"].append(number)
            return None
        seconds = min(seconds, time.process_time() - begin)
        if seconds < SLOW / 2.0:
            break
    assert solution is not None
    if seconds > SLOW:
        complaints["slow"].append(number)
    if solution.converged != np.isfinite(solution.length):
        complaints["a length and a status that do not agree"].append(number)
    if solution.converged and not np.isfinite(solution.error_estimate):
        complaints["a length without an error"].append(number)
    path = solution.path(reference.GUESS_TIMES)
    if solution.converged and np.abs(path - 0.5).max() > 0.5 + OUTSIDE:
        complaints["a path outside the patch"].append(number)
    if (ends[0] == ends[1]).all():
        if solution.length != 0.0:
            complaints["not 0 between a point and itself"].append(number)
        return Case(number, solution, seconds, Enlarged(net, ends, np.zeros(2), np.ones(2)))
    return Case(number, solution, seconds, enlarged(net, ends, path))


def check(cases: list[Case], complaints: dict[str, list[int]]) -> Counter[str]:
    """Compare lengths with independent ones; return how many were confirmed, and by what."""
    cases = [case for case in cases if case.solution.converged and case.solution.length > 0.0]
    with np.errstate(all="ignore"):
        known = _by_collocation(cases)
        result = Counter[str]()
        for case, exact in zip(cases, known, strict=True):
            _check_bounds(case, complaints)
            length, change, witness = exact, 0.0, "collocation"
            below = 0.0
            if np.isnan(exact):
                length, change = _by_splines(case)
                witness = "spline, to 1e-6" if change < 1e-7 * length else "spline, roughly"
                below = DOUBT_BELOW * change + LEFT * length
            is_longer = case.solution.length > length
            doubt = DOUBT * change if is_longer else below
            allowed = case.solution.error_estimate + doubt + case.rounding
            if not np.isfinite(length + change):
                witness = "nothing"
            elif np.isnan(exact) and case.solution.length < length - below and _is_true(case):
                # The solution's own path, which lies in the patch, is shorter: the spline has come
                # to rest elsewhere, or not at all.
                witness = "its own path, measured"
            elif not abs(case.solution.length - length) <= allowed:
                kind = "longer" if is_longer else "shorter"
                complaints[f"{kind} than by {witness}"].append(case.number)
                off = abs(case.solution.length - length)
                print(
                    f"    {case.number} {bm.Status(case.solution.status).name}: {kind} by "
                    f"{off / length:.1e} than by {witness}; estimate "
                    f"{case.solution.error_estimate / length:.1e}, doubt {doubt / length:.1e}",
                    flush=True,
                )
            result[witness] += 1
    return result


def _is_true(case: Case) -> bool:
    """Whether inscribed polygons confirm the length of the path."""
    places = evaluate(case.part.net, case.path(np.linspace(0.0, 1.0, FINE + 1)))
    coarse, fine = (
        np.linalg.norm(np.diff(places[::step], axis=0), axis=1).sum() for step in (2, 1)
    )
    # Two terms of their errors, in even powers of the edges, are eliminated.
    own, doubt = fine + (fine - coarse) / 3.0, abs(fine - coarse) / 3.0
    return bool(abs(own - case.solution.raw_length) <= doubt + case.rounding)


def _by_collocation(cases: list[Case]) -> Array:
    """The lengths of the same geodesics by collocation, NaN where none was found."""
    if not cases:
        return np.empty(0)
    # Each part is measured in a unit of its own, so that residuals are relative.
    sizes = np.array([case.size for case in cases])
    nets = np.stack([case.part.net for case in cases]) / sizes[:, None, None, None]
    ends = np.stack([case.part.ends for case in cases])
    paths = np.stack([case.path(reference.GUESS_TIMES) for case in cases])
    found = reference.geodesics(
        Problems(nets, ends[:, 0], ends[:, 1]), guess=paths, pairs=reference.FINEST
    )
    own = np.stack([case.path(reference.GAUSS) for case in cases])
    near = np.abs(found.paths - own).max(axis=(1, 2)) < SAME_PATH
    return np.where(near, found.length * sizes, np.nan)


def _by_splines(case: Case) -> tuple[float, float]:
    """The length of a spline that descends from the solution's path, and its last change."""
    net = case.part.net[None] / case.size
    path = np.clip(case.path(greville(SPANS[0])), 0.0, 1.0)[None]
    path[:, 0], path[:, -1] = case.part.ends
    latest, change = np.nan, np.inf
    try:
        for spans in SPANS:
            path = descend(net, refined(path, spans), ROUNDING)
            length = float(lengths(net, path)[0])
            latest, change = length, abs(latest / length - 1.0)
            if change < ENOUGH:
                break
    except np.linalg.LinAlgError:
        return np.nan, np.inf
    return latest * case.size, change * latest * case.size


def _check_bounds(case: Case, complaints: dict[str, list[int]]) -> None:
    """Whether a length lies between the chord and that of the straight line in (u, v)."""
    net, ends, solution = case.part.net, case.part.ends, case.solution
    line = [ends[0] + (ends[1] - ends[0]) * greville(n)[:, None] for n in SPANS[-2:]]
    coarse, fine = (float(lengths(net[None], each[None])[0]) for each in line)
    chord = np.linalg.norm(np.subtract(*evaluate(net, ends)))
    allowed = solution.error_estimate + case.rounding
    if not solution.length >= chord - allowed:
        complaints["shorter than the chord"].append(case.number)
    if not solution.length <= fine + DOUBT * abs(fine - coarse) + allowed:
        complaints["longer than the straight line"].append(case.number)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--problems", type=int, default=10_000)
    parser.add_argument("--first", type=int, default=0, help="number of the first problem")
    options = parser.parse_args()
    complaints: dict[str, list[int]] = defaultdict(list)
    statuses, witnesses = Counter[str](), Counter[str]()
    seconds: list[float] = []
    last = options.first + options.problems
    for first in range(options.first, last, BATCH):
        solved = [solve(n, complaints) for n in range(first, min(first + BATCH, last))]
        cases = [case for case in solved if case is not None]
        statuses.update(bm.Status(case.solution.status).name for case in cases)
        statuses["refused"] += len(solved) - len(cases)
        witnesses += check(cases, complaints)
        seconds += [case.seconds for case in cases]
        if (first + BATCH) % REPORT == 0 or first + BATCH >= last:
            print(f"after {min(first + BATCH, last) - options.first} problems:")
            _report(statuses, witnesses, seconds, complaints)


def _report(
    statuses: Counter[str],
    witnesses: Counter[str],
    seconds: list[float],
    complaints: dict[str, list[int]],
) -> None:
    print("statuses:", ", ".join(f"{n} {name}" for name, n in statuses.most_common()))
    print("confirmed by:", ", ".join(f"{n} {name}" for name, n in witnesses.most_common()))
    marks = np.quantile(seconds, [0.5, 0.9, 0.99, 0.999, 1.0])
    print("ms a problem:", " ".join(f"{1e3 * mark:.1f}" for mark in marks), "(50 90 99 99.9 100 %)")
    for kind, numbers in complaints.items():
        listed = ", ".join(map(str, numbers[:LISTED])) + (", ..." if len(numbers) > LISTED else "")
        print(f"WRONG: {kind}: {len(numbers)}: {listed}")
    if not complaints:
        print("nothing wrong")
    sys.stdout.flush()


if __name__ == "__main__":
    main()
