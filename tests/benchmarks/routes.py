"""How often, how well and how fast the geodesic between two points of a body is found.

Random pairs, uniform over the patches. Each is measured both ways round. The best known is the
shortest of both and of a start from a mesh of twice as many steps, at degree 16 or higher; of the
first pairs, libigl's exact distance on local submeshes too, extrapolated. Run it by hand:
``python tests/benchmarks/routes.py [BODY ...] [--pairs N] [--exact M]``.
"""

from __future__ import annotations

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import sys
import time
from collections import Counter
from pathlib import Path

import numpy as np

import bodymeasure as bm
from bodymeasure.atlas.neighbors import Neighbors, Place
from bodymeasure.geodesic.route_error import route_length
from bodymeasure.geodesic.route_reading import first_route
from bodymeasure.geodesic.route_refine import refine
from bodymeasure.geodesic.route_search import shortest_along

sys.path.insert(0, str(Path(__file__).parents[1]))
from body_oracle import mesh_distance, quarter_point

BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")
# The finest degree, and the finer mesh of the second start.
DEGREE, SEGMENTS = 16, 8
# Libigl's uncertainty counts this often, and this is what it can tell at all, relative.
DOUBT, RESOLUTION = 3.0, 1e-6


def best_known(
    atlas: bm.Atlas, neighbors: Neighbors, path: bm.AtlasPath, ends: tuple[Place, Place]
) -> tuple[float, float]:
    """The shortest of two starts at a high degree, and the time of one refinement."""
    lengths, times = [], []
    for segments in (4, SEGMENTS):
        route = first_route(atlas, neighbors, ends, segments)
        assert route is not None
        begin = time.thread_time()
        refine(atlas, route, 8, path.raw_length)
        times.append(time.thread_time() - begin)
        found = shortest_along(atlas, neighbors, route, path.raw_length)
        fine = refine(atlas, found.refined.route, DEGREE, path.raw_length)
        lengths += [found.length.corrected, route_length(fine).corrected]
    return min(lengths), times[0]


def survey(name: str, pairs: int, exact: int) -> None:
    """Print what is found on one body."""
    atlas, rng = bm.load_sample(name), np.random.default_rng(5)
    neighbors = Neighbors(atlas)
    statuses: Counter[str] = Counter()
    seconds, refining, excess, swap, covered = [], [], [], [], 0
    longer = shorter = measured = 0
    for number in range(pairs):
        start, end = quarter_point(rng, atlas), quarter_point(rng, atlas)
        if number >= exact:
            start, end = (
                bm.AtlasPoint(point.patch, *rng.random(2).tolist()) for point in (start, end)
            )
        begin = time.thread_time()
        path = bm.geodesic_between(atlas, start, end, on_failure="status")
        seconds.append(time.thread_time() - begin)
        statuses[path.status.name] += 1
        if not path.converged or path.raw_length == 0.0:
            continue
        back = bm.geodesic_between(atlas, end, start, on_failure="status")
        swap.append(abs(back.length / path.length - 1.0))
        ends = Place(start.patch, start.u, start.v), Place(end.patch, end.u, end.v)
        best, refinement = best_known(atlas, neighbors, path, ends)
        refining.append(refinement)
        excess.append(path.length / min(best, back.length) - 1.0)
        covered += int(abs(path.length - best) <= path.error_estimate)
        if number < exact:
            distance, doubt = mesh_distance(atlas, start, end, path.length)
            allowed = max(DOUBT * doubt, RESOLUTION * distance)
            measured += 1
            longer += int(path.length > distance + allowed)
            shorter += int(path.length < distance - allowed)
    good = np.array(excess)
    print(f"{name}: {dict(statuses)}")
    print(
        f"  over the best known: median {np.median(good):.1e}, worst {good.max():.1e}, "
        f"within 1e-5: {100.0 * (good < 1e-5).mean():.1f} %; "
        f"estimate covers {100.0 * covered / len(good):.1f} %; ends swapped {max(swap):.1e}"
    )
    print(
        f"  median {1e3 * np.median(seconds):.0f} ms, 95 % {1e3 * np.quantile(seconds, 0.95):.0f} "
        f"ms; refinement alone {1e3 * np.median(refining):.1f} ms; "
        f"of {measured} by libigl {longer} longer, {shorter} shorter",
        flush=True,
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("bodies", nargs="*", default=BODIES)
    parser.add_argument("--pairs", type=int, default=60, help="on each body")
    parser.add_argument("--exact", type=int, default=10, help="of them by libigl, too")
    arguments = parser.parse_args()
    for name in arguments.bodies:
        survey(name, arguments.pairs, arguments.exact)


if __name__ == "__main__":
    main()
