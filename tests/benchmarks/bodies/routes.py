"""How often, how well and how fast the geodesic between two points of an atlas is found.

On bodies, the pairs are random and uniform over the patches. Each is measured in both directions
and on the body turned and moved. The best known path is the shortest of both and of many more
starts, at degree 16. For pairs whose parameters are quarters, libigl's exact distance on
local submeshes is extrapolated, too, with its own uncertainty. On known surfaces, random pairs are
measured on whole patches and on the same patches cut into 2, 4 and 64 parts, and into nine along
curves that meet at kinks.

Run it by hand: ``python tests/benchmarks/bodies/routes.py [BODY ...] [--pairs N] [--free M] [--cuts
K]``; 300 pairs by libigl and 100 others take some ten minutes a body. A body is a sample, a random
one by its number (``random:3``), or a file.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import sys
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

import bodymeasure as bm
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.geodesic.across.pieces.error import route_length
from bodymeasure.geodesic.across.pieces.refine import refine
from bodymeasure.geodesic.across.routes.graph import patch_graph
from bodymeasure.geodesic.across.routes.reading import route_of
from bodymeasure.geodesic.across.routes.topology import topology
from bodymeasure.geodesic.across.routes.ways import Scope, first_ways
from bodymeasure.geodesic.across.search.search import shortest_along

sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.bodies import BODIES
from helpers.body_space import random_body
from helpers.oracles.body_oracle import LEVELS, mesh_distance, quarter_point
from helpers.surfaces.cut_atlases import cut, on_cut, on_part, random_point, slant_cut
from helpers.surfaces.surfaces import ENNEPER, HYPERBOLIC_PARABOLOID, PARABOLOID, PH_CYLINDER, PLANE

# The finest degree of paths, and how widely ways are sought from which they start.
DEGREE = 16
WIDE = Scope(0.08, 0.02, (0.5, 0.3, 0.7, 0.15, 0.85), 0.035, 80)
# Where libigl does not agree, it is asked again on these finer meshes; and the relative difference
# that it can resolve at all.
FINER = (8, 16, 24)
RESOLUTION = 1e-6
# Paths that are longer than the best known by more than this part of it are counted.
LONGER = 1e-6
SHAPES = {
    "plane": PLANE,
    "cylinder": PH_CYLINDER,
    "Enneper": ENNEPER,
    "paraboloid": PARABOLOID,
    "saddle": HYPERBOLIC_PARABOLOID,
}
EIGHTHS = tuple(np.arange(1, 8) / 8)


@dataclass
class Tally:
    """The results on one body."""

    statuses: Counter[str] = field(default_factory=Counter)
    seconds: list[float] = field(default_factory=list)
    refining: list[float] = field(default_factory=list)
    excess: list[float] = field(default_factory=list)
    swap: list[float] = field(default_factory=list)
    motion: list[float] = field(default_factory=list)
    covered: int = 0
    measured: int = 0
    closer: int = 0
    longer: list[float] = field(default_factory=list)
    shorter: list[float] = field(default_factory=list)

    def print(self, name: str) -> None:
        """Print the results."""
        good, count = np.array(self.excess), len(self.excess)
        swap, motion = np.array(self.swap), np.array(self.motion)
        print(f"{name}: {dict(self.statuses)}")
        print(
            f"  over the best known: median {np.median(good):.1e}, worst {good.max():.1e}, beyond "
            f"{LONGER:.0e}: {(good > LONGER).sum()} of {count}; estimate covers "
            f"{100.0 * self.covered / count:.1f} %"
        )
        print(
            f"  ends swapped {swap.max():.1e}, {(swap > 1e-9).sum()} above 1e-9; turned and moved "
            f"{motion.max():.1e}, {(motion > 1e-9).sum()} above 1e-9"
        )
        print(
            f"  median {1e3 * np.median(self.seconds):.0f} ms, 95 % "
            f"{1e3 * np.quantile(self.seconds, 0.95):.0f} ms, longest {max(self.seconds):.2f} s; "
            f"refinement alone {1e3 * np.median(self.refining):.1f} ms"
        )
        print(
            f"  of {self.measured} by libigl, {self.closer} of them on finer meshes, longer "
            f"{self.longer}, shorter {self.shorter} (in its uncertainties)",
            flush=True,
        )


def best_known(
    atlas: bm.Atlas, path: bm.AtlasPath, ends: tuple[AtlasPoint, AtlasPoint]
) -> tuple[float, float]:
    """The shortest length from many starts at a high degree, and the time of one refinement."""
    lengths, times = [], []
    neighbors, mesh = topology(atlas).neighbors, patch_graph(atlas).mesh
    for way in first_ways(atlas, *ends, WIDE):
        route = route_of(neighbors, mesh, ends, way)
        if route is None:
            continue
        begin = time.thread_time()
        refine(atlas, route, 8, path.raw_length)
        times.append(time.thread_time() - begin)
        found = shortest_along(atlas, neighbors, [route], path.raw_length)
        fine = refine(atlas, found.refined.route, DEGREE, path.raw_length)
        lengths += [float(found.part.length.corrected), float(route_length(fine)[0].corrected)]
    return min(lengths), times[0]


def body(name: str) -> bm.Atlas:
    """The sample of a name, the random body of a number, or the atlas of a file."""
    kind, _, number = name.partition(":")
    if kind == "random" and number.isdecimal():
        return random_body(int(number))
    return bm.load_sample(name) if name in bm.sample_names() else bm.read_atlas(name)


def survey(name: str, pairs: int, free: int) -> None:
    """Measure random pairs on one body, and print the results."""
    atlas, rng, tally = body(name), np.random.default_rng(5), Tally()
    turn = Rotation.from_rotvec(rng.normal(size=3)).as_matrix()
    moved = replace(atlas, points=atlas.points @ turn.T + rng.normal(size=3))
    for number in range(pairs + free):
        pick = quarter_point if number < pairs else random_point
        start, end = pick(rng, atlas), pick(rng, atlas)
        begin = time.thread_time()
        path = bm.geodesic_between(atlas, start, end, on_failure="status")
        tally.seconds.append(time.thread_time() - begin)
        tally.statuses[path.status.name] += 1
        if path.status not in (bm.Status.CONVERGED, bm.Status.ON_BOUNDARY):
            print(f"  {path.status.name}: {start}, {end}", flush=True)
        if not path.converged or path.raw_length == 0.0:
            continue
        compare(tally, atlas, moved, path)
        if number < pairs:
            by_libigl(tally, atlas, path)
    tally.print(name)


def compare(tally: Tally, atlas: bm.Atlas, moved: bm.Atlas, path: bm.AtlasPath) -> None:
    """Compare a path with itself reversed and moved, and with the best known."""
    start, end = path.points
    back = bm.geodesic_between(atlas, end, start, on_failure="status")
    there = bm.geodesic_between(moved, start, end, on_failure="status")
    for changes, other in ((tally.swap, back), (tally.motion, there)):
        changes.append(abs(other.length / path.length - 1.0))
        if not changes[-1] <= 1e-9:
            print(f"  {changes[-1]:.1e} {path.length} {other.status.name}: {start}, {end}")
    ends = start, end
    best, refinement = best_known(atlas, path, ends)
    tally.refining.append(refinement)
    tally.excess.append(path.length / min(best, back.length) - 1.0)
    if tally.excess[-1] > LONGER:
        print(f"  {tally.excess[-1]:.1e} over the best known: {start}, {end}", flush=True)
    tally.covered += int(abs(path.length - best) <= path.error_estimate)


def by_libigl(tally: Tally, atlas: bm.Atlas, path: bm.AtlasPath) -> None:
    """Compare a path with the extrapolated exact distances over meshes."""
    start, end = path.points
    tally.measured += 1
    for levels in (LEVELS, FINER):
        distance, doubt = mesh_distance(atlas, start, end, path.length, levels)
        over = (path.length - distance) / max(doubt, RESOLUTION * distance)
        if abs(over) <= 1.0:
            return
        tally.closer += int(levels == LEVELS)
    (tally.longer if over > 0.0 else tally.shorter).append(round(over, 2))


def cut_surfaces(count: int) -> None:
    """Print by how much lengths change where patches are cut."""
    rng = np.random.default_rng(5)
    grids: dict[str, tuple[Sequence[float], Sequence[float]]] = {
        "2": ((0.4,), ()),
        "4": ((0.5,), (0.5,)),
        "64": (EIGHTHS, EIGHTHS),
    }
    for name, net in SHAPES.items():
        atlases = {pieces: cut(net, *lines, turn=False) for pieces, lines in grids.items()}
        changes: dict[str, list[float]] = {pieces: [] for pieces in (*grids, "9 slanted")}
        for _ in range(count):
            slanted, corners = slant_cut(net, rng)
            points = random_point(rng, slanted), random_point(rng, slanted)
            ends = [on_part(corners[point.patch], point.u, point.v).tolist() for point in points]
            whole = bm.solve_geodesic(net, *ends)
            paths = {"9 slanted": bm.geodesic_between(slanted, *points)}
            for pieces, atlas in atlases.items():
                start, end = (on_cut(grids[pieces], uv) for uv in ends)
                paths[pieces] = bm.geodesic_between(atlas, start, end)
            for pieces, path in paths.items():
                changes[pieces].append(abs(path.length / float(whole.length) - 1.0))
        worst = ", ".join(f"{max(each):.1e} in {pieces}" for pieces, each in changes.items())
        print(f"{name} cut: at most {worst}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("bodies", nargs="*", default=BODIES, help="random:N, or a file, too")
    parser.add_argument("--pairs", type=int, default=60, help="on each body, by libigl too")
    parser.add_argument("--free", type=int, default=20, help="on each body, not by libigl")
    parser.add_argument("--cuts", type=int, default=20, help="pairs on each cut surface")
    arguments = parser.parse_args()
    if arguments.cuts:
        cut_surfaces(arguments.cuts)
    for name in arguments.bodies:
        survey(name, arguments.pairs, arguments.free)


if __name__ == "__main__":
    main()
