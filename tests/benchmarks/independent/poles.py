"""Random pairs and triples of points on surfaces with poles, against lengths that are known.

On spheres, lengths are those of great circles; on ellipsoids, of geodesics that are shot through
space (`helpers.oracles.ellipsoids`). Points are anywhere, or with a given share at a distance of
1e-16 to 1e-1 from a pole.

    python tests/benchmarks/independent/poles.py sphere --count 300
    python tests/benchmarks/independent/poles.py 1,0.7,0.4 --count 60 --near 0.5
    python tests/benchmarks/independent/poles.py sphere.step --count 300
    python tests/benchmarks/independent/poles.py 1,0.7,0.4 --count 100 --near 0.7 --triples
"""

import argparse
import sys
import time
from itertools import pairwise
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2]))

from helpers.oracles.ellipsoids import ellipsoid_distance
from helpers.surfaces.quadrics import joined, sphere_nets, stretched

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.seams import EDGES, edge_table

# Points closer together than this are not given to the oracle, whose error is some 1e-12.
CLOSE, ORACLE = 1e-3, 5e-12


def main() -> int:
    """Run the benchmark as its options say, and print what it finds."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("surface", help='"sphere", half-axes "a,b,c", or a file of a sphere')
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--near", type=float, default=0.0, help="share of points near a pole")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--triples", action="store_true", help="triangle inequalities only")
    options = parser.parse_args()
    atlas, axes = _surface(options.surface)
    rng = np.random.default_rng(options.seed)
    count = {"pairs": 0, "refused": 0, "beyond": 0}
    worst = slowest = total = 0.0
    for _ in range(options.count):
        points = [_point(rng, atlas, options.near) for _ in range(3 if options.triples else 2)]
        ends = list(pairwise((*points, points[0]) if options.triples else points))
        paths = []
        for start, end in ends:
            begun = time.process_time()
            path = bm.geodesic_between(atlas, start, end, on_failure="status")
            spent = time.process_time() - begun
            slowest, total = max(slowest, spent), total + spent
            count["pairs"] += 1
            if not path.converged:
                count["refused"] += 1
                print("refused", path.status.name, tuple(start), tuple(end), path.raw_length)
            paths.append(path)
        if not all(path.converged for path in paths):
            continue
        off, allowed = _off(atlas, axes, paths)
        worst = max(worst, off)
        if off > allowed:
            count["beyond"] += 1
            print("beyond", [tuple(point) for point in points], off, allowed)
    print(options.surface, *(f"{key}: {value}" for key, value in count.items()), sep=", ")
    print(
        f"largest error {worst:.1e}; {total / count['pairs']:.2f} s a pair, at most {slowest:.2f}"
    )
    return min(1, count["refused"] + count["beyond"])


def _surface(name: str) -> tuple[Atlas, tuple[float, float, float]]:
    if name == "sphere":
        return joined(sphere_nets()), (1.0, 1.0, 1.0)
    if "," in name:
        a, b, c = map(float, name.split(","))
        return joined(stretched(sphere_nets(), (a, b, c))), (a, b, c)
    atlas = bm.read_atlas(name, unit="mm") if name.endswith("obj") else bm.read_atlas(name)
    radius = float(np.linalg.norm(atlas.position(AtlasPoint(0, 0.5, 0.5))))
    return atlas, (radius, radius, radius)


def _point(rng: np.random.Generator, atlas: Atlas, near: float) -> AtlasPoint:
    patch = int(rng.integers(len(atlas)))
    place = rng.random(2)
    sides = np.flatnonzero(edge_table(atlas.index).collapsed[patch])
    if len(sides) and rng.random() < near:
        edge = EDGES[int(rng.choice(sides))]
        place[edge.fixed_axis] = abs(edge.fixed_value - 10.0 ** rng.uniform(-16.0, -1.0))
    return AtlasPoint(patch, *place.tolist())


def _off(
    atlas: Atlas, axes: tuple[float, float, float], paths: list[bm.AtlasPath]
) -> tuple[float, float]:
    """How far the length of a path is off, or the sides of a triangle, and how far they may be."""
    allowed = sum(path.error_estimate for path in paths)
    if len(paths) == 3:
        shorter, middle, longer = sorted(path.length for path in paths)
        return max(longer - shorter - middle, 0.0), allowed
    start, end = (atlas.position(point) for point in paths[0].points)
    if len(set(axes)) == 1:
        return abs(paths[0].length - axes[0] * _angle(start, end)), allowed + 4e-16 * axes[0]
    if np.linalg.norm(start - end) < CLOSE:
        return 0.0, allowed
    return abs(paths[0].length - ellipsoid_distance(axes, start, end)), allowed + ORACLE


def _angle(start: Array, end: Array) -> float:
    return float(np.arctan2(np.linalg.norm(np.cross(start, end)), start @ end))


if __name__ == "__main__":
    sys.exit(main())
