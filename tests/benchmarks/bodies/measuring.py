"""What one measurement of a body costs: girths, loops, tapes, paths and whole charts.

Run it by hand: ``python tests/benchmarks/bodies/measuring.py [--before PYTHON] [--repeats N]``; it
takes a minute for each repeat. PYTHON is the interpreter of an environment in which another state
of the package is installed: both take turns, and the ratios are printed, too. All times are
processor times on one thread. The bodies are fresh ones for each chart; what is kept with a body is
made before the others are timed.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

import bodymeasure as bm

SEED, PAIRS = 7, 100
LEVELS = ("bust point left", "front waist point", "side hip point left")
LIMBS = (
    ("shoulder point left", "elbow point left", 0.7),
    ("side hip point left", "patella point left", 0.6),
)
TAPES = (("bust point left", "bust point right"), ("back neck point", "back hip point"))
LOOPS = ("side waist point left", "front waist point")
EXTREMES = (("front waist point", "side hip point left"),)


def random_points(body: bm.Atlas, count: int) -> list[bm.AtlasPoint]:
    rng = np.random.default_rng(SEED)
    return [
        bm.AtlasPoint(int(rng.integers(len(body))), *map(float, rng.random(2)))
        for _ in range(count)
    ]


def calls(body: bm.Atlas) -> Iterator[tuple[str, Callable[[], Any]]]:
    """Yield kinds of measurements, and calls that take one each."""
    for at in LEVELS:
        yield "girth", partial(bm.body_girth, body, at)
    for first, last, part in LIMBS:
        yield "limb girth", partial(bm.limb_girth, body, first, last, at=part)
    for at in LOOPS:
        yield "closed loop", partial(bm.closed_geodesic, body, at)
    for first, last in TAPES:
        contact = bm.geodesic_between(body, first, last)
        yield "taut tape", partial(bm.taut_tape, body, first, last, contact=contact)
    for first, last in EXTREMES:
        yield "extreme girth", partial(bm.extreme_girth, body, first, last, "smallest")
    points = random_points(body, 2 * PAIRS)
    starts, ends = points[::2], points[1::2]
    for start, end in zip(starts, ends, strict=True):
        yield "path", partial(bm.geodesic_between, body, start, end, on_failure="status")
    at_once = partial(bm.geodesics_between, body, starts, ends, on_failure="status")
    yield f"{PAIRS} paths at once", at_once


def seconds(call: Callable[[], Any]) -> float:
    begin = time.process_time()
    call()
    return time.process_time() - begin


def measured() -> dict[str, list[float]]:
    """The times of each kind, in milliseconds."""
    body = bm.load_sample("female_average")
    bm.measure_chart(body)
    found: dict[str, list[float]] = {}
    for kind, call in calls(body):
        found.setdefault(kind, []).append(1e3 * seconds(call))
    fresh = replace(body, points=body.points.copy())
    found["chart's numbers"] = [1e3 * seconds(partial(bm.measure_chart, fresh))]
    return found


def run(python: str) -> dict[str, list[float]]:
    command = [python, __file__, "--measure"]
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
    found: dict[str, list[float]] = json.loads(done.stdout)
    return found


def figures(runs: list[dict[str, list[float]]]) -> dict[str, float]:
    """The least times of all runs, and the median and nearly the longest of paths."""
    result: dict[str, float] = {}
    for kind in runs[0]:
        least = np.min([each[kind] for each in runs], axis=0)
        if len(least) < PAIRS:
            result[kind] = float(least.mean())
            continue
        for name, part in (("median", 0.5), ("95 %", 0.95), ("longest", 1.0)):
            result[f"{kind}, {name}"] = float(np.quantile(least, part))
    return result


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--measure", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--before", metavar="PYTHON", help="the interpreter to compare with")
    parser.add_argument("--repeats", type=int, default=3)
    options = parser.parse_args()
    if options.measure:
        json.dump(measured(), sys.stdout)
        return
    sides = [options.before, sys.executable] if options.before else [sys.executable]
    runs: list[list[dict[str, list[float]]]] = [[] for _ in sides]
    for _ in range(options.repeats):
        for python, own in zip(sides, runs, strict=True):
            own.append(run(python))
    before, after = figures(runs[0]), figures(runs[-1])
    print(f"{'':22s} {'before':>10s} {'now':>10s} {'ratio':>6s}")
    for kind, now in after.items():
        ratio = f"{now / before[kind]:6.2f}" if options.before else ""
        print(f"{kind:22s} {before[kind]:8.1f}ms {now:8.1f}ms {ratio}")


if __name__ == "__main__":
    main()
