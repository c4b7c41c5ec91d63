"""What compiled kernels save: the same work with them and in the NumPy form, in turns.

Run it by hand: ``python tests/benchmarks/compiled.py [--repeats N]``; it takes two minutes. For
each kind of work the script prints the least processor time of both forms, their ratio, and the
largest relative difference of the lengths.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import time
from collections.abc import Callable
from contextlib import nullcontext

import numpy as np

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.native import without_kernels

SEED = 5


def paths(count: int = 60) -> list[float]:
    rng, body = np.random.default_rng(SEED), bm.load_sample("female_average")
    result = []
    for _ in range(count):
        start, end = (
            bm.AtlasPoint(int(rng.integers(len(body))), *map(float, rng.random(2)))
            for _ in range(2)
        )
        result.append(bm.geodesic_between(body, start, end, on_failure="status").length)
    return result


def loop() -> list[float]:
    body = bm.load_sample("female_average")
    return [bm.closed_geodesic(body, "side waist point left").length]


def chart() -> list[float]:
    measured = bm.measure_chart(bm.load_sample("female_average")).measured
    return [np.nan if each.value is None else each.value for each in measured]


def wild_patches() -> Array:
    rng, even = np.random.default_rng(SEED), np.linspace(0.0, 1.0, 4)
    nets = np.zeros((60, 4, 4, 3))
    nets[..., 0], nets[..., 1] = even[:, None], even
    nets[..., 2] = 3.0 * rng.random((60, 4, 4))
    return bm.solve_geodesic(nets, (0, 0), (1, 1), on_failure="status").length


def diagonals() -> Array:
    return bm.diagonals(bm.load_sample("female_average")).length


WORK: dict[str, Callable[[], object]] = {
    "60 paths across a body": paths,
    "a loop round the waist": loop,
    "a chart's numbers": chart,
    "60 wild patches": wild_patches,
    "a body's diagonals": diagonals,
}


def timed(work: Callable[[], object], compiled: bool) -> tuple[float, Array]:
    with nullcontext() if compiled else without_kernels():
        begin = time.process_time()
        result = work()
        return time.process_time() - begin, np.asarray(result, np.float64)


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--repeats", type=int, default=3)
    repeats = parser.parse_args().repeats
    print(f"{'':24s} {'NumPy':>9s} {'compiled':>9s} {'ratio':>6s}  largest difference")
    for name, work in WORK.items():
        timed(work, True)  # what is kept with a sample is made once
        runs = [(timed(work, False), timed(work, True)) for _ in range(repeats)]
        plain, compiled = (min(pair[form][0] for pair in runs) for form in (0, 1))
        (_, one), (_, other) = runs[0]
        apart = np.nanmax(np.abs(one - other) / np.abs(one))
        print(f"{name:24s} {plain:8.3f}s {compiled:8.3f}s {plain / compiled:6.2f}  {apart:.0e}")


if __name__ == "__main__":
    main()
