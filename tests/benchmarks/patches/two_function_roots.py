"""How many roots of the paper's two-function system are found, and how fast.

On random patches of four kinds, 200 in all, Newton's method runs from 2581 starts each; every root
that it finds and that is one in exact arithmetic is looked for among those of `system_roots`. Run
it by hand: ``python tests/benchmarks/patches/two_function_roots.py``; it takes a minute.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import sys
import time
from pathlib import Path

import numpy as np

from bodymeasure.paper.method.system_roots import system_roots
from bodymeasure.paper.method.two_functions import paper_space

sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.oracles.root_multistart import missed, multistart_roots, sharpened, starts
from helpers.surfaces.random_patches import wild_patches

PATCHES = 50
# Side of the grid, how far points are moved off it, and whether the patch is symmetric.
KINDS = ((0.6, 0.0, False), (1.0, 0.0, False), (0.6, 0.045, False), (0.6, 0.0, True))


def main() -> None:
    space = paper_space()
    motion = space.differentiation[:, 0, 1:]
    rng = np.random.default_rng(2007)
    guesses = starts(rng)
    print(f"{len(guesses)} starts a patch, {PATCHES} patches a kind")
    print("side jitter symmetric | roots: system_roots  multistart  false  missed | ms a patch")
    for side, jitter, symmetric in KINDS:
        nets = wild_patches(rng, PATCHES, side, jitter=jitter, symmetric=symmetric)
        begin = time.thread_time()
        real = system_roots(nets, space).real
        each = 1e3 * (time.thread_time() - begin) / PATCHES
        total = false = lost = 0
        for net, roots in zip(nets, real, strict=True):
            found = multistart_roots(net, motion, guesses)
            others = np.array(missed(roots, found)).reshape(-1, 2)
            exact = sharpened(net, motion, others)
            exact = exact[np.isfinite(exact).all(axis=1)]
            total += len(found)
            false += len(others) - len(exact)
            lost += len(missed(roots, exact))
        print(
            f"{side:4.1f} {jitter:6.3f} {symmetric!s:>9s} | {sum(map(len, real)):19d} {total:11d} "
            f"{false:6d} {lost:7d} | {each:10.1f}",
            flush=True,
        )


if __name__ == "__main__":
    main()
