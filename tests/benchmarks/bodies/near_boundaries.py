"""Whether lengths between points on seams and corners, and a hair off them, contradict each other.

Each triple of points is put to the free oracles of `helpers.oracles.free`: on three bodies, a
torus, a sphere, an ellipsoid and random surfaces of several patches. Every fourth one goes beyond
the triangle inequality: ends are swapped, paths split, and the surface moved.

Run it by hand: ``python tests/benchmarks/bodies/near_boundaries.py [SURFACE ...] [--triples N]
[--seed K]``; 1,000 triples take some ten minutes.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import sys
import time
from collections import Counter
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.many_patches import SURFACES
from helpers.oracles.free import contradictions, moved
from helpers.surfaces.near_boundaries import random_near_triple

# One of so many triples is put to all oracles.
WHOLE = 4
# So many contradictions of each surface are printed.
LISTED = 6


def try_surface(name: str, triples: int, seed: int) -> Counter[str]:
    atlas = SURFACES[name]()
    turned, rng = moved(atlas, seed), np.random.default_rng([seed, *name.encode()])
    counts, begin, listed = Counter[str](), time.process_time(), 0
    for number in range(triples):
        points = random_near_triple(rng, atlas)
        found = list(contradictions(atlas, points, turned, whole=number % WHOLE == 0))
        counts.update({fault.oracle for fault in found})
        for fault in found[: LISTED - listed]:
            places = ", ".join(str(tuple(point)) for point in fault.points)
            print(f"  {fault.oracle}, {fault.beyond:.1e}: {places}", flush=True)
            listed += 1
    seconds = time.process_time() - begin
    print(f"{name}: {triples} triples in {seconds:.0f} s: {dict(counts) or 'none'}", flush=True)
    return counts


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("surfaces", nargs="*", help=f"some of {', '.join(SURFACES)}; else all")
    parser.add_argument("--triples", type=int, default=1000, help="of all surfaces together")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    names = options.surfaces or list(SURFACES)
    if unknown := set(names) - SURFACES.keys():
        parser.error(f"there is no surface {', '.join(sorted(unknown))}")
    counts = Counter[str]()
    for name in names:
        counts += try_surface(name, -(-options.triples // len(names)), options.seed)
    print(f"broken or refused in all: {dict(counts) or 'none'}")


if __name__ == "__main__":
    main()
