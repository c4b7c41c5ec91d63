"""How often the searches miss the shortest path, compared with many starts of another method.

The patches are random and as rough as the paper's; some are symmetric about the diagonal, so that
the straight start is a geodesic and often not the shortest. From 30 starts on each patch (straight,
bowed to either side, S-shaped, along the edges, and random ones) splines slide down to paths of
least energy (`spline_paths.py`); the best are refined. Each of them lies in its patch, so the
shortest path is no longer than it: a length that is longer by 1e-6 is a miss for certain.

Run it by hand: ``python tests/benchmarks/patches/multistart.py [--patches N]``; 500 patches of each
kind take some fifteen minutes. The columns: processor time of the search, in ms a patch; lengths
given, those among them along an edge, in %; misses, longer than the multistart's path by 1e-6, and
the worst excess; lengths shorter than it by more than 1e-6 and what the last refinement took off,
and those among them that a spline path confirms which starts from the search's own path, so that
the multistart missed it (the others are wrong); lengths of paths along an edge that are more than
1e-7 off, and no more than that is the refinement's. Problems without a length have a status that
says so; they are listed, and are not counted as misses.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import sys
import time
from collections.abc import Iterable
from pathlib import Path

import numpy as np

import bodymeasure as bm

sys.path.insert(0, str(Path(__file__).parents[2]))
from benchmarks.independent.reference import symmetric, wild_patches
from benchmarks.independent.spline_paths import descend, greville, lengths, places, refined

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic import SEARCHES

# Relative excess of a length that counts as a miss, and relative error of a path along an edge.
MISS, OFF = 1e-6, 1e-7
STARTS = 30
# Spans of the splines that compete, and of those that are refined in turn. With 16 a length is
# 1e-6 too long in the median and 1e-5 at most where the path is smooth, ten times that at edges;
# each doubling takes it down to a tenth or less. Refinement ends when it takes off less than that.
COARSE, FINE, ENOUGH = 16, (32, 64, 128, 256), 1e-8
# A path is at rest when a step would lower its energy by less than this part.
COARSE_REST, FINE_REST = 1e-9, 1e-14
# The most paths of each patch that are refined, how much longer than the best they may be
# (relative), and how far in (u, v) they must be from those already taken.
FINALISTS, WORTH, APART = 4, 3e-3, 0.02
# The number of patches that are solved at once.
CHUNK = 25
# How many of the problems that went wrong are listed.
LISTED = 8
TIMES = np.linspace(0.0, 1.0, 33)


def starts(rng: np.random.Generator) -> Array:
    """Coefficients of varied paths from (0, 0) to (1, 1), shape (STARTS, n, 2)."""
    t = greville(COARSE)
    side = [0.0 * t]
    side += [size * np.sin(np.pi * t) for k in (0.15, 0.3, 0.5, 0.8) for size in (k, -k)]
    side += [size * np.sin(2 * np.pi * t) for k in (0.2, 0.45) for size in (k, -k)]
    paths = [np.stack([t + way, t - way], axis=1) for way in side]
    first, second = np.minimum(2.0 * t, 1.0), np.maximum(2.0 * t - 1.0, 0.0)
    paths += [np.stack([first, second], axis=1), np.stack([second, first], axis=1)]
    waves = np.sin(np.pi * np.arange(1, 5) * t[:, None])
    while len(paths) < STARTS:
        sizes = rng.normal(size=(4, 2)) * 0.6 / np.arange(1, 5)[:, None]
        paths.append(t[:, None] + waves @ sizes)
    result = np.clip(paths, 0.0, 1.0)
    result[:, 0], result[:, -1] = 0.0, 1.0
    return result


def shortest(nets: Array, rng: np.random.Generator) -> tuple[Array, Array]:
    """Lengths of the shortest spline paths, and what the last refinement changed, relative."""
    best, change = np.empty(len(nets)), np.empty(len(nets))
    for first in range(0, len(nets), CHUNK):
        part = nets[first : first + CHUNK]
        owners = np.arange(len(part)).repeat(STARTS)
        paths = np.concatenate([starts(rng) for _ in part])
        paths = descend(part[owners], paths, COARSE_REST)
        chosen = _finalists(owners, paths, lengths(part[owners], paths))
        length, changed = refine(part[owners[chosen]], paths[chosen])
        for patch in range(len(part)):
            mine = np.flatnonzero(owners[chosen] == patch)
            winner = mine[length[mine].argmin()]
            best[first + patch], change[first + patch] = length[winner], changed[winner]
    return best, change


def _finalists(owners: Ints, paths: Array, length: Array) -> list[int]:
    """The indices of the paths that are worth being refined."""
    points = places(paths, TIMES)
    result = []
    for patch in np.unique(owners):
        mine = np.flatnonzero(owners == patch)
        mine = mine[np.argsort(length[mine])]
        taken: list[int] = []
        for i in mine[length[mine] <= (1.0 + WORTH) * length[mine[0]]]:
            if len(taken) < FINALISTS and all(
                np.abs(points[i] - points[j]).max() > APART for j in taken
            ):
                taken.append(int(i))
        result += taken
    return result


def refine(nets: Array, paths: Array) -> tuple[Array, Array]:
    """Lengths with more spans, and what the last change of their number took off, relative."""
    latest = lengths(nets, paths)
    change, rest = np.full(len(nets), np.inf), np.arange(len(nets))
    for spans in FINE:
        paths = descend(nets[rest], refined(paths, spans), FINE_REST)
        length = lengths(nets[rest], paths)
        change[rest] = latest[rest] / length - 1.0
        latest[rest] = length
        keep = change[rest] > ENOUGH
        rest, paths = rest[keep], paths[keep]
        if len(rest) == 0:
            break
    return latest, change


def compare(kind: str, nets: Array) -> None:
    """Print what each search makes of one kind of patches."""
    count = len(nets)
    begin = time.process_time()
    best, change = shortest(nets, np.random.default_rng(1))
    seconds = time.process_time() - begin
    print(
        f"{kind}: {STARTS} starts, {1e3 * seconds / count:.0f} ms each; the last refinement took "
        f"off {np.median(change):.0e} in the median, {change.max():.0e} at most",
        flush=True,
    )
    for search in SEARCHES:
        begin = time.process_time()
        solution = bm.solve_geodesic(nets, (0, 0), (1, 1), search=search, on_failure="status")
        seconds = time.process_time() - begin
        excess = solution.length / best - 1.0
        along = np.asarray(solution.status) == bm.Status.ON_BOUNDARY
        off = np.flatnonzero(along & (np.abs(excess) > OFF + np.abs(change)))
        below = np.flatnonzero(excess < -MISS - np.abs(change))
        confirmed = 0
        if len(below):
            own = np.clip(solution.path(greville(COARSE))[below], 0.0, 1.0)
            length = refine(nets[below], descend(nets[below], own, COARSE_REST))[0]
            confirmed = (np.abs(length / solution.length[below] - 1.0) < MISS).sum()
        print(
            f"{kind:14s} {search:9s} {1e3 * seconds / count:8.1f} "
            f"{100 * solution.converged.mean():8.1f} {100 * along.mean():8.1f} "
            f"{(excess > MISS).sum():7d} {np.nan_to_num(excess, nan=-1.0).max():9.1e} "
            f"{len(below):8d} {confirmed:10d} {len(off):8d}"
        )
        _tell("missed", np.flatnonzero(excess > MISS), excess)
        _tell("shorter", below, excess)
        _tell("on edge, off", off, excess)
        failed = np.flatnonzero(~solution.converged)
        if len(failed):
            names = [np.asarray(solution.status)[i].name for i in failed]
            listed = ", ".join(f"{names.count(name)} {name}" for name in sorted(set(names)))
            print(f"    no length: {listed}: {_some(failed)}", flush=True)


def _tell(what: str, numbers: Ints, excess: Array) -> None:
    if len(numbers):
        print(f"    {what}: {_some(f'{i} ({excess[i]:.1e})' for i in numbers)}", flush=True)


def _some(items: Iterable[object]) -> str:
    """The first of some items, as a list in words."""
    words = [str(item) for item in items]
    return ", ".join(words[:LISTED]) + (", ..." if len(words) > LISTED else "")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--patches", type=int, default=500, help="of each kind")
    parser.add_argument("--seed", type=int, default=7)
    options = parser.parse_args()
    count = options.patches
    rng = np.random.default_rng(options.seed)
    print(
        f"{'':14s} {'search':9s}  ms each  length% on edge%  missed     worst "
        " shorter  confirmed edge off"
    )
    for side in (1.0, 0.6):
        compare(f"wild {side:g}", wild_patches(rng, count, side))
    for side in (1.0, 0.3):
        compare(f"symmetric {side:g}", symmetric(wild_patches(rng, count, side)))
    # Heights of eleven times the side, as on the roughest patches that were reported.
    compare("rough", wild_patches(rng, count, 1.0 / 11.0))


if __name__ == "__main__":
    main()
