"""What the compiled kernel of diagonals takes, and whether it finds what the NumPy form finds.

Run it by hand: ``python tests/benchmarks/patches/kernels.py [--problems N] [--largest 6]
[--bodies N] [--only times|agreement]``; with 10,000 problems it takes some ten minutes, nearly all
of them for the NumPy form on adversarial patches. It prints

- the processor time of a mild diagonal with its error estimate, by the whole of `solve_geodesic`
  and on one thread, in the NumPy form and with 2, 4 and 8 problems in a vector (SSE2, AVX2 and
  AVX-512), in batches of 1000 and more, each the least of some turns; and of a single problem;
- the time of `scipy.integrate.solve_bvp` at 1e-8 and of libigl's exact distance on 65 x 65 points,
  as multiples of that;
- the memory that the largest batch takes beside its control points;
- the number of statuses, indices and sizes of spaces that differ between the forms, and the largest
  relative difference of the lengths: on mild, wild and adversarial patches, on the five sample
  bodies, and on random ones of the body space.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import resource
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np

import bodymeasure as bm

sys.path.insert(0, str(Path(__file__).parents[2]))
from benchmarks.independent import reference
from benchmarks.patches.adversarial import problem
from helpers.body_space import random_body

from bodymeasure._typing import Array
from bodymeasure.bench.entrants.boundary_value import BoundaryValueProblem
from bodymeasure.bench.entrants.mesh_paths import igl_exact
from bodymeasure.bench.entrants.meshed_patch import MeshedPatch
from bodymeasure.native import lengths, without_kernels

SEED = 7
# The heights of mild and of wild patches over the unit square.
MILD, WILD = 0.3, 2.0
FORMS = {"NumPy": 0, "SSE2, 2 lanes": 2, "AVX2, 4 lanes": 4, "AVX-512, 8 lanes": 8}
TURNS = 7
# The numbers of problems that solve_bvp and libigl are timed on.
FEW, FEWEST = 20, 3
BODIES = ("average", "full_bust", "heavy", "old")
CORNERS = (0.0, 0.0), (1.0, 1.0)
Work = Callable[[], bm.GeodesicSolution]


@contextmanager
def form(lanes: int) -> Iterator[None]:
    """Solve with at most so many problems in a vector; with none, by NumPy."""
    before = lengths.MOST_LANES
    if lanes == 0:
        with without_kernels():
            yield
    else:
        lengths.MOST_LANES = lanes
        yield
        lengths.MOST_LANES = before


def seconds(work: Callable[[], object], turns: int = 1) -> float:
    best = np.inf
    for _ in range(turns):
        begin = time.process_time()
        work()
        best = min(best, time.process_time() - begin)
    return best


def diagonals_of(nets: Array) -> Work:
    return lambda: bm.solve_geodesic(nets, *CORNERS, on_failure="status")


def straight(
    nets: Array, start: Array | tuple[float, float], end: Array | tuple[float, float]
) -> Work:
    return lambda: bm.solve_geodesic(nets, start, end, search="straight", on_failure="status")


def all_of(atlas: bm.Atlas, search: bm.geodesic.Search = "quick") -> Work:
    return lambda: bm.diagonals(atlas, search=search, on_failure="status")


def times(largest: int) -> None:
    rng = np.random.default_rng(SEED)
    counts = [10**exponent for exponent in range(3, largest + 1)]
    heading = "".join(f"{count:>11,}" for count in counts)
    print(f"microseconds a diagonal, in batches of{heading}\n")
    nets = reference.mild_patches(rng, counts[-1], MILD)
    small = nets[:1000]
    row: dict[str, list[float]] = {}
    for name, lanes in FORMS.items():
        with form(lanes):
            row[name] = []
            for count in counts:
                # NumPy's chunks are of a thousand anyway.
                if lanes == 0 and count > 10_000:
                    continue
                turns = TURNS if count <= 100_000 else 3
                row[name].append(1e6 * seconds(diagonals_of(nets[:count]), turns) / count)
        print(f"{name:38}" + "".join(f"{each:11.2f}" for each in row[name]), flush=True)
    single = seconds(lambda: [diagonals_of(small[0])() for _ in range(100)], 3) / 100
    print(f"\na single problem: {1e3 * single:.3f} ms")
    body = bm.load_sample("female_average")
    searches: tuple[bm.geodesic.Search, ...] = ("straight", "quick")
    for search in searches:
        best = seconds(all_of(body, search), TURNS)
        print(f"the 752 diagonals of a body, {search}: {1e3 * best:.1f} ms")
    start, end = map(np.array, CORNERS)
    bvp = seconds(lambda: [BoundaryValueProblem(net, start, end, 1e-8)() for net in small[:FEW]])
    meshes = [MeshedPatch.of(net, start, end, 65) for net in small[:FEWEST]]
    exact = seconds(lambda: [igl_exact(mesh) for mesh in meshes])
    for name, whole in (("solve_bvp at 1e-8", bvp / FEW), ("libigl exact, 65", exact / FEWEST)):
        ratios = ", ".join(f"{1e6 * whole / row[each][0]:,.0f} x {each}" for each in FORMS)
        print(f"{name}: {1e3 * whole:.1f} ms = {ratios}")
    kept = diagonals_of(nets)()
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    print(f"{len(kept.length):,} diagonals: the process took {peak:.2f} GiB at most, of which the")
    print(f"control points are {nets.nbytes / 2**30:.2f}")


def agreement(problems: int, bodies: int) -> None:
    rng = np.random.default_rng(SEED)
    mild = reference.mild_patches(rng, problems, MILD)
    compare("mild", straight(mild, *CORNERS))
    compare("mild, any points", straight(mild, *rng.random((2, problems, 2))))
    compare("wild", straight(reference.mild_patches(rng, problems, WILD), *CORNERS))
    every = [problem(number) for number in range(problems)]
    kept = [(net, ends) for net, ends in every if np.ptp(net, axis=(0, 1)).max() > 0.0]
    nets, ends = np.stack([net for net, _ in kept]), np.stack([ends for _, ends in kept])
    compare("adversarial", straight(nets, ends[:, 0], ends[:, 1]))
    compare("adversarial, corners", straight(nets, *CORNERS))
    for name in (*(f"female_{kind}" for kind in BODIES), "male_average"):
        compare(name, all_of(bm.load_sample(name)))
    for number in range(bodies):
        compare(f"random body {number}", all_of(random_body(number)))


def compare(name: str, work: Work) -> None:
    with form(0):
        plain = work()
    for lanes in [lanes for lanes in FORMS.values() if lanes]:
        with form(lanes):
            compiled = work()
        apart = np.abs(compiled.length - plain.length) / np.abs(plain.length)
        worst = float(np.nanmax(apart, initial=0.0))
        other = {
            what: int(
                (np.asarray(getattr(compiled, what)) != np.asarray(getattr(plain, what))).sum()
            )
            for what in ("status", "index", "functions")
        }
        words = ", ".join(f"{count} {what}" for what, count in other.items())
        print(
            f"{name:22} {lanes} lanes: of {plain.length.size:6,}, {words} differ; lengths by "
            f"{worst:.1e} at most",
            flush=True,
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--problems", type=int, default=10_000)
    parser.add_argument("--largest", type=int, default=6, help="the largest batch, a power of 10")
    parser.add_argument("--bodies", type=int, default=3, help="random bodies that are compared")
    parser.add_argument("--only", choices=("times", "agreement"))
    options = parser.parse_args()
    if options.only != "agreement":
        times(options.largest)
    if options.only != "times":
        with np.errstate(all="ignore"):
            agreement(options.problems, options.bodies)


if __name__ == "__main__":
    main()
