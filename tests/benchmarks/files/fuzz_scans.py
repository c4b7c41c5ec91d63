"""Damage valid mesh files in thousands of ways, and see that each is read or refused at once.

Run it by hand: ``python tests/benchmarks/files/fuzz_scans.py [--mutations 10000] [--seed 0]
[--only NAME]``.

For each kind of file it prints how many mutations were refused and how many were read, the most
processor time that one took, and by how much the process grew. It ends with code 1 if one raised an
error other than `InputError`, took more than a second, gave a scan with numbers that are not finite
or with much of the mesh lost in silence, or made the process grow beyond bounds.
"""

import argparse
import os
import resource
import sys
import time
import traceback
from pathlib import Path

os.environ["OMP_NUM_THREADS"] = "1"
import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.files.mutations import mutated
from helpers.scans.damaged import mesh_files, scan_or_refused

SECONDS = 1.0
# The memory, in MiB, by which one kind of file may make the process grow.
GROWTH = 200.0


def run(name: str, extension: str, content: bytes, mutations: int, seed: int) -> bool:
    """Read mutations of a file, print what happened, and return whether all ended well."""
    refused, slowest, failures = 0, 0.0, 0
    before = peak()
    for number in range(mutations):
        damaged = mutated(content, np.random.default_rng([seed, number]))
        begin = time.process_time()
        try:
            refused += scan_or_refused(damaged, extension) is None
        except Exception:
            failures += 1
            print(f"{name}, seed {seed}, mutation {number}:\n{traceback.format_exc(limit=-3)}")
        slowest = max(slowest, time.process_time() - begin)
    growth = peak() - before
    print(
        f"{name:12} {mutations:6} mutations: {refused:6} refused, "
        f"{mutations - refused - failures:5} read, {failures} failed; slowest {slowest:.3f} s, "
        f"{growth:.0f} MiB more",
        flush=True,
    )
    return failures == 0 and slowest < SECONDS and growth < GROWTH


def peak() -> float:
    """The most memory that the process had, in MiB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0


def main() -> int:
    parser = argparse.ArgumentParser(description="Damage mesh files of all kinds, and read them.")
    parser.add_argument("--mutations", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", choices=list(mesh_files()))
    arguments = parser.parse_args()
    well = [
        run(name, extension, content, arguments.mutations, arguments.seed)
        for name, (extension, content) in mesh_files().items()
        if arguments.only in (None, name)
    ]
    return 0 if all(well) else 1


if __name__ == "__main__":
    sys.exit(main())
