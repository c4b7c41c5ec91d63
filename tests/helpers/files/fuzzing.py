"""Read damaged copies of a file many times, for benchmarks, within bounds on time and memory."""

import resource
import time
import traceback
from collections.abc import Callable

import numpy as np
from helpers.files.mutations import mutated

SECONDS = 1.0
# The memory, in MiB, by which one kind of file may make the process grow.
GROWTH = 200.0


def survives(
    name: str, content: bytes, read: Callable[[bytes], object], mutations: int, seed: int
) -> bool:
    """Read mutations of a file, print what happened, and return whether all ended well.

    `read` returns None for what it refuses.
    """
    refused, slowest, failures = 0, 0.0, 0
    before = peak()
    for number in range(mutations):
        damaged = mutated(content, np.random.default_rng([seed, number]))
        begin = time.process_time()
        try:
            refused += read(damaged) is None
        except Exception:
            failures += 1
            print(f"{name}, seed {seed}, mutation {number}:\n{traceback.format_exc(limit=-3)}")
        slowest = max(slowest, time.process_time() - begin)
    growth = peak() - before
    print(
        f"{name:16} {mutations:6} mutations: {refused:6} refused, "
        f"{mutations - refused - failures:5} read, {failures} failed; slowest {slowest:.3f} s, "
        f"{growth:.0f} MiB more",
        flush=True,
    )
    return failures == 0 and slowest < SECONDS and growth < GROWTH


def peak() -> float:
    """The most memory that the process had, in MiB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
