"""How taut tapes compare with lengths that are known, and with geodesics on convex bodies.

Run it by hand: ``python tests/benchmarks/bodies/taut_oracles.py [KIND ...] [--pairs N]``.

Over extruded profiles, with kinks and without, a tape is the hull of the profile, unrolled; round a
sphere of eight rational octants it is a great circle, on other convex bodies the geodesic. Pairs
are random, or (``beside``) beside edges, corners and poles by 1e-16 to 0.1. It prints how many have
no length, how many are off by more than the estimate, the estimates, and the time of a tape.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import math
import sys
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np

import bodymeasure as bm

sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.oracles.extruded_hulls import random_profile
from helpers.surfaces.quadrics import joined, sphere_nets, stretched

# The arc length of a hull is known to this part.
KNOWN = 1e-10


class Case(NamedTuple):
    """A pair of points, the side of the tape, and its length; None for that of the geodesic."""

    atlas: bm.Atlas
    start: bm.AtlasPoint
    end: bm.AtlasPoint
    above: bool
    length: float | None


def on_profile(rng: np.random.Generator) -> Case:
    case = random_profile(rng)
    return Case(case.atlas, *case.points, case.above, case.length)


def somewhere(rng: np.random.Generator) -> bm.AtlasPoint:
    u, v = rng.random(2).tolist()
    return bm.AtlasPoint(int(rng.integers(8)), u, v)


def beside(rng: np.random.Generator) -> bm.AtlasPoint:
    off = 10.0 ** rng.uniform(-16.0, -1.0, 2)
    kind = rng.integers(4, size=2)
    choices = np.stack([rng.random(2), off, 1.0 - off, rng.integers(2, size=2)])
    u, v = choices[kind, [0, 1]].tolist()
    return bm.AtlasPoint(int(rng.integers(8)), u, v)


def round_body(
    factors: tuple[float, float, float], place: Callable[[np.random.Generator], bm.AtlasPoint]
) -> Callable[[np.random.Generator], Case]:
    """Pairs on an ellipsoid."""
    atlas = joined(stretched(sphere_nets(), factors))

    def pair(rng: np.random.Generator) -> Case:
        start, end = place(rng), place(rng)
        p, q = atlas.position(start), atlas.position(end)
        circle = math.atan2(float(np.linalg.norm(np.cross(p, q))), float(p @ q))
        return Case(atlas, start, end, True, circle if factors == (1.0, 1.0, 1.0) else None)

    return pair


KINDS = {
    "profiles": on_profile,
    "sphere": round_body((1.0, 1.0, 1.0), somewhere),
    "sphere_beside": round_body((1.0, 1.0, 1.0), beside),
    "triaxial": round_body((1.0, 0.7, 0.4), somewhere),
    "prolate": round_body((1.0, 1.0, 3.0), somewhere),
}


def survey(kind: str, pairs: int, seed: int) -> None:
    """Draw tapes of one kind, and print how they compare."""
    statuses: Counter[str] = Counter()
    ratios, estimates, seconds = [], [], []
    for number in range(pairs):
        case = KINDS[kind](np.random.default_rng([seed, number]))
        contact = bm.geodesic_between(case.atlas, case.start, case.end, on_failure="status")
        begin = time.thread_time()
        tape = bm.taut_tape(
            case.atlas,
            case.start,
            case.end,
            contact=contact,
            outside="along normals" if case.above else "against normals",
            on_failure="status",
        )
        seconds.append(time.thread_time() - begin)
        statuses[tape.status.name] += 1
        length = contact.length if case.length is None else case.length
        if not tape.converged or not np.isfinite(length) or length == 0.0:
            continue
        away = abs(tape.length - length) - KNOWN * length
        if case.length is None:
            away -= contact.error_estimate
        ratios.append(max(away, 0.0) / tape.error_estimate)
        estimates.append(tape.error_estimate / length)
        if ratios[-1] > 1.0:
            print(f"    pair {number}: {tape}, known {length!r}, off by {tape.length - length:.1e}")
    beyond = np.count_nonzero(np.array(ratios) > 1.0)
    print(
        f"{kind}: {dict(statuses)}; beyond the estimate {beyond} of {len(ratios)}, largest part of "
        f"it {max(ratios):.2f}; estimate: median {np.median(estimates):.1e}, worst "
        f"{max(estimates):.1e}; {1e3 * np.median(seconds):.0f} ms (median), "
        f"{1e3 * max(seconds):.0f} ms (most)",
        flush=True,
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("kinds", nargs="*", default=list(KINDS), help=", ".join(KINDS))
    parser.add_argument("--pairs", type=int, default=300, help="of each kind")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    for kind in arguments.kinds:
        survey(kind, arguments.pairs, arguments.seed)


if __name__ == "__main__":
    main()
