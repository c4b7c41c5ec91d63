"""Random patches of kinds that one polynomial a leg does not serve: how many have no length.

The kinds: flat squares that are unevenly parametrized and cylinders over random cubics, whose
lengths are known in closed form; ridges, symmetric bumps, cusps beside the path, thin strips,
rational patches and heights that are cubes of random numbers. On these, the length is compared with
inscribed polygons of the path itself, extrapolated, which must lie in the patch, and with a spline
that descends from it (`spline_paths.py`): a spline that is shorter is a miss.

Run it by hand: ``python tests/benchmarks/patches/hard.py [--patches N] [--seed K]``; 40 patches of
each kind take about a minute. The columns: patches; without a length, in %; lengths outside their
error estimates; misses, longer than the spline by 1e-6; processor time in ms, median and most.

``python tests/benchmarks/patches/hard.py FILE`` takes patches with known lengths from a file of the
form of ``tests/data/hard_patches.json`` instead. There a length is a miss if it is longer than the
known one by more than its estimate and the doubt of the other, and wrong if it is so much shorter
and not that of its path, by the same polygons. The numbers of those that have no length, differ
from the known one, or take more than a second come last.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import json
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

import bodymeasure as bm
from bodymeasure.bezier import evaluate

sys.path.insert(0, str(Path(__file__).parents[2]))
from benchmarks.independent.spline_paths import descend, greville, lengths, refined

from bodymeasure._typing import Array

MISS, ROUNDING = 1e-6, 1e-12
# The processor time, in ms, past which a patch of a file is named.
SLOW = 1000.0
POLYGON, SPANS = 1 << 15, (16, 64)
# Polygons have vertices ever closer to the ends, too: beside a side that is almost one point, a
# path may turn within a billionth of its length.
GRADED = np.geomspace(1e-16, 1e-2, (1 << 13) + 1)
EVEN = np.linspace(0.0, 1.0, 4)


def flat() -> Array:
    u, v = np.meshgrid(EVEN, EVEN, indexing="ij")
    return np.stack([u, v, 0.0 * u], axis=-1)


def uneven(rng: np.random.Generator) -> Array:
    """A flat unit square whose inner control points are close to its sides."""
    net = flat()
    for axis in (0, 1):
        inner = np.sort(10.0 ** rng.uniform(-4.0, -0.2, 2))
        line = np.array([0.0, *inner, 1.0])
        net[..., axis] = line[:, None] if axis == 0 else line
    return net


def cylinder(rng: np.random.Generator) -> Array:
    net = np.zeros((4, 4, 3))
    net[..., :2] = rng.normal(size=(4, 1, 2))
    net[..., 2] = 10.0 ** rng.uniform(-1.0, 1.0) * EVEN
    return net


def ridge(rng: np.random.Generator) -> Array:
    net = flat()
    net[1:3, :, 2] = rng.uniform(2.0, 8.0) + rng.normal(size=(2, 4))
    return net


def bump(rng: np.random.Generator) -> Array:
    net = flat()
    z = rng.uniform(0.0, 4.0, (4, 4))
    net[..., 2] = z + z.T
    return net


def cusp(rng: np.random.Generator) -> Array:
    """A patch whose control points of one row change places, but for a little."""
    net = flat() + 0.1 * rng.normal(size=(4, 4, 3))
    net[1, :, 0], net[2, :, 0] = 0.99 + 0.02 * rng.normal(size=4), 0.01 + 0.02 * rng.normal(size=4)
    return net


def thin(rng: np.random.Generator) -> Array:
    size = np.array([10.0 ** rng.uniform(1.0, 3.0), 1.0, 1.0])
    return np.asarray((flat() + 0.1 * rng.normal(size=(4, 4, 3))) * size)


def rational(rng: np.random.Generator) -> Array:
    weights = 10.0 ** rng.uniform(-1.0, 1.0, (4, 4, 1))
    return np.concatenate([(flat() + 0.15 * rng.normal(size=(4, 4, 3))) * weights, weights], -1)


def powers(rng: np.random.Generator) -> Array:
    net = flat()
    net[..., 2] = rng.normal(size=(4, 4)) ** 3
    return net


KINDS = (uneven, cylinder, ridge, bump, cusp, thin, rational, powers)


def known(kind: object, net: Array, ends: Array) -> float:
    """The length in closed form, or NaN."""
    places = evaluate(net, ends)
    if kind is uneven:
        return float(np.linalg.norm(places[1] - places[0]))
    if kind is not cylinder:
        return np.nan
    steps = np.diff(net[:, 0, :2], axis=0)

    def speed(t: float) -> float:
        basis = np.array([(1.0 - t) ** 2, 2.0 * t * (1.0 - t), t**2])
        return float(np.linalg.norm(3.0 * basis @ steps))

    low, high = np.sort(ends[:, 0])
    slowest = minimize_scalar(speed, bounds=(low, high)).x
    along = quad(speed, low, high, points=[slowest], epsabs=1e-13, epsrel=1e-13, limit=400)[0]
    return float(np.hypot(along, places[1, 2] - places[0, 2]))


def is_wrong(net: Array, solution: bm.GeodesicSolution, exact: float) -> bool:
    """Whether a length is not that of its path, which lies in the patch, or not the exact one."""
    length, error = float(solution.length), float(solution.error_estimate)
    if np.isfinite(exact):
        return abs(length - exact) > error + ROUNDING * length
    even = np.linspace(0.0, 1.0, POLYGON + 1)
    fine_times, coarse_times = (
        np.unique(np.concatenate([even[::k], GRADED[::k], 1.0 - GRADED[::k]])) for k in (1, 2)
    )
    path = solution.path(fine_times)
    places = evaluate(net, np.clip(path, 0.0, 1.0))
    coarse, fine = (
        np.linalg.norm(np.diff(places[np.isin(fine_times, times)], axis=0), axis=1).sum()
        for times in (coarse_times, fine_times)
    )
    # Each edge of the polygon is rounded by as much, however short it is.
    rounding = len(fine_times) * np.finfo(float).eps * np.abs(places).max()
    doubt = abs(fine - coarse) + ROUNDING * length + rounding
    own = fine + (fine - coarse) / 3.0
    outside = np.abs(path - 0.5).max() > 0.5 + 1e-8
    return bool(abs(own - solution.raw_length) > doubt or outside)


def is_missed(net: Array, solution: bm.GeodesicSolution, ends: Array) -> bool:
    """Whether a spline that starts from the path is shorter."""
    if net.shape[-1] == 4:
        return False
    path = np.clip(solution.path(greville(SPANS[0])), 0.0, 1.0)[None]
    path[:, 0], path[:, -1] = ends
    try:
        for spans in SPANS:
            path = descend(net[None], refined(path, spans), 1e-13)
    except np.linalg.LinAlgError:
        return False
    return bool(lengths(net[None], path)[0] < solution.length * (1.0 - MISS))


@dataclass
class Row:
    """What became of the patches of one kind."""

    kind: str
    without: int = 0
    wrong: int = 0
    missed: int = 0
    times: list[float] = field(default_factory=list)

    def solve(self, net: Array, ends: Array) -> bm.GeodesicSolution:
        begin = time.process_time()
        solution = bm.solve_geodesic(net, *ends, on_failure="status")
        self.times.append(1e3 * (time.process_time() - begin))
        self.without += not solution.converged
        return solution

    def print(self) -> None:
        count = len(self.times)
        print(
            f"{self.kind:10s} {count:7d} {100 * self.without / count:10.1f} "
            f"{self.wrong:6d} {self.missed:7d} "
            f"{np.median(self.times):11.0f} {max(self.times):7.0f}",
            flush=True,
        )


def random_patches(
    kind: Callable[[np.random.Generator], Array], seed: list[int], count: int
) -> Row:
    rng, row = np.random.default_rng(seed), Row(kind.__name__)
    for _ in range(count):
        net, ends = kind(rng), rng.random((2, 2))
        if rng.random() < 0.5:
            ends[rng.integers(2), rng.integers(2)] = rng.integers(2)
        solution = row.solve(net, ends)
        if solution.converged:
            row.wrong += is_wrong(net, solution, known(kind, net, ends))
            row.missed += is_missed(net, solution, ends)
    return row


def patches_of(file: Path) -> tuple[list[Row], list[str]]:
    """The patches of a file by kind and all together, and what is to be said of single ones."""
    rows: dict[str, Row] = {}
    total, remarks = Row("all"), []
    for number, case in enumerate(json.loads(file.read_text())):
        row = rows.setdefault(case["kind"], Row(case["kind"]))
        net = np.array(case["points"])
        solution = row.solve(net, np.array([case["start"], case["end"]]))
        total.times.append(row.times[-1])
        total.without += not solution.converged
        words = [] if solution.converged else [bm.Status(solution.status).name]
        words += [f"{row.times[-1]:.0f} ms"] if row.times[-1] > SLOW else []
        if solution.converged:
            longer = float(solution.length - case["length"])
            allowed = float(solution.error_estimate) + case["doubt"] + ROUNDING * case["length"]
            wrong, missed = longer < -allowed and is_wrong(net, solution, np.nan), longer > allowed
            row.wrong, row.missed = row.wrong + wrong, row.missed + missed
            total.wrong, total.missed = total.wrong + wrong, total.missed + missed
            part = abs(longer) / case["length"]
            words += [f"{part:.1e} longer than known"] if missed else []
            words += [f"{part:.1e} shorter than known"] if longer < -allowed else []
        remarks += [f"{number:4d} {case['kind']}: {', '.join(words)}"] if words else []
    return [*rows.values(), total], remarks


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", nargs="?", type=Path, help="patches with known lengths")
    parser.add_argument("--patches", type=int, default=40, help="of each kind")
    parser.add_argument("--seed", type=int, default=3)
    options = parser.parse_args()
    print("kind       patches  without %  wrong  missed  ms: median    most")
    if options.file is None:
        for number, kind in enumerate(KINDS):
            random_patches(kind, [options.seed, number], options.patches).print()
        return
    rows, remarks = patches_of(options.file)
    for row in rows:
        row.print()
    print("\n".join(remarks))


if __name__ == "__main__":
    main()
