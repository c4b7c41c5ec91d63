"""What a diagonal costs: bodymeasure, `scipy.integrate.solve_bvp` and libigl's exact distance.

All in one run on one thread, interleaved, in processor time, the least of several repeats; errors
are relative to independent references (`reference.py`). The others get what helps them: solve_bvp
the surface evaluation that bodymeasure uses itself, on its whole mesh at once (the Jacobian is by
differences; that takes a quarter of its time); libigl a finished mesh, so that only the call is
timed. Diagonals that leave their patch are spared the others; the search for the shortest path
along its edges, which bodymeasure adds by default, is timed for itself. Then: how time and memory
grow with the number of diagonals, on rigidly moved copies of the body's patches.
Run it by hand: ``python tests/benchmarks/speed.py [--quick]``; it takes a minute or two.
"""

from __future__ import annotations

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import sys
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import igl
import numpy as np
from scipy.integrate import solve_bvp

import bodymeasure as bm
from bodymeasure.atlas.tessellation import grid_faces
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.surface import BezierSurfaces

sys.path.insert(0, str(Path(__file__).parents[1]))
from benchmarks import reference
from benchmarks.reference import ENDS, STARTS, Array

SAMPLE = "female_average"
POINTS_A_SIDE = 65


def seconds(call: Callable[[], object]) -> float:
    start = time.process_time()
    call()
    return time.process_time() - start


class BoundaryValueProblem:
    """One geodesic for solve_bvp: y = (u, v, u', v'), the metric's 2 x 2 system solved by hand."""

    def __init__(self, net: Array, start: Array, end: Array) -> None:
        self.surface = BezierSurfaces(net[None])
        self.start, self.end = start, end
        self.length = np.nan

    def slope(self, _: Array, y: Array) -> Array:
        _, s_u, s_v, s_uu, s_uv, s_vv = self.surface.jet(y[None, :2].swapaxes(1, 2), 2)[:, :, 0]
        du, dv = y[2:]
        bend = s_uu * (du * du) + s_uv * (2.0 * du * dv) + s_vv * (dv * dv)
        e, f, g = (s_u * s_u).sum(axis=0), (s_u * s_v).sum(axis=0), (s_v * s_v).sum(axis=0)
        p, q = (s_u * bend).sum(axis=0), (s_v * bend).sum(axis=0)
        determinant = e * g - f * f
        return np.stack([du, dv, (f * q - g * p) / determinant, (f * p - e * q) / determinant])

    def ends(self, first: Array, last: Array) -> Array:
        return np.concatenate([first[:2] - self.start, last[:2] - self.end])

    def solve(self) -> None:
        t = np.linspace(0.0, 1.0, 17)
        way = (self.end - self.start)[:, None]
        guess = np.vstack([self.start[:, None] + way * t, np.broadcast_to(way, (2, len(t)))])
        solution = solve_bvp(self.slope, self.ends, t, guess, tol=1e-8, max_nodes=20000)
        y = solution.sol(reference.GAUSS)
        jet = self.surface.jet(y[None, :2].swapaxes(1, 2), 1)[:, :, 0]
        speed = np.sqrt(((jet[1] * y[2] + jet[2] * y[3]) ** 2).sum(axis=0))
        self.length = float(speed @ reference.WEIGHTS) if solution.success else np.nan


class ExactDistance:
    """One diagonal for libigl, on a mesh of the patch."""

    def __init__(self, net: Array, start: Array, end: Array) -> None:
        side = np.linspace(0.0, 1.0, POINTS_A_SIDE)
        parameters = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1).reshape(-1, 2)
        self.vertices = evaluate(net, parameters)
        self.faces = grid_faces(np.arange(len(parameters)).reshape(POINTS_A_SIDE, -1))
        ends = [np.abs(parameters - point).max(axis=1).argmin() for point in (start, end)]
        self.source, self.target = (np.array([number], dtype=np.int64) for number in ends)
        self.length = np.nan

    def solve(self) -> None:
        # By keyword: positional calls put the targets among the source faces.
        ends = {"VS": self.source, "VT": self.target}
        self.length = float(igl.exact_geodesic(self.vertices, self.faces, **ends)[0])


def row(name: str, time_each: float, ours: float, error: Array) -> None:
    """Print one line of the table."""
    figures = " ".join(f"{value:9.1e}" for value in np.quantile(error, [0.5, 1.0]))
    print(f"{name:42s} {1e6 * time_each:10.1f} {time_each / ours:9.1f} {figures}")


def compare(repeats: int, counts: tuple[int, int]) -> None:
    """Print the times of all three on one body."""
    atlas = bm.load_sample(SAMPLE)
    first = seconds(lambda: bm.diagonals(atlas, search="straight"))
    solution = bm.diagonals(atlas, search="straight")
    length, converged = solution.length.ravel(), solution.converged.ravel()
    problems = reference.body_diagonals(SAMPLE)
    known = reference.geodesics(problems, pairs=reference.FINEST).length
    stays = np.random.default_rng(0).permutation(np.flatnonzero(np.isfinite(known) & converged))
    chosen = [stays[:count] for count in counts]
    others: list[list[BoundaryValueProblem | ExactDistance]] = [
        [BoundaryValueProblem(*one) for one in zip(*problems.take(chosen[0]), strict=True)],
        [ExactDistance(*one) for one in zip(*problems.take(chosen[1]), strict=True)],
    ]
    warm, whole, times = [], np.inf, [np.full(count, np.inf) for count in counts]
    for _ in range(repeats):
        for least, calls in zip(times, others, strict=True):
            for i, call in enumerate(calls):
                least[i] = min(least[i], seconds(call.solve))
            warm += [seconds(lambda: bm.diagonals(atlas, search="straight")) for _ in range(4)]
            whole = min(whole, seconds(lambda: bm.diagonals(atlas)))
    ours = min(warm) / length.size
    print(f"{SAMPLE}: {length.size} diagonals, {len(stays)} with a length and a reference")
    print(f"{'':42s} {'microsec.':>10s} {'times':>9s}   relative error")
    print(f"{'':42s} {'each':>10s} {'ours':>9s}    median     worst")
    error = np.abs(length[stays] / known[stays] - 1.0)
    row("bodymeasure", ours, ours, error)
    row("bodymeasure, first call of a process", first / length.size, ours, error)
    names = ("solve_bvp, tol 1e-8", f"libigl exact, {POINTS_A_SIDE} points a side")
    for name, rows, least, calls in zip(names, chosen, times, others, strict=True):
        lengths = np.array([call.length for call in calls])
        row(
            f"{name} ({len(rows)} diagonals)", least.mean(), ours, np.abs(lengths / known[rows] - 1)
        )
    print(f"bodymeasure, median of {len(warm)} calls: {1e6 * np.median(warm) / length.size:.1f}")
    edges = (~converged).sum()
    print(
        f"with the search along edges: {1e3 * whole:.0f} ms for all, "
        f"{1e3 * (whole - min(warm)) / edges:.0f} ms for each of the {edges} that leave their patch"
    )


def scale(sizes: tuple[int, ...], repeats: int) -> None:
    """Print time and peak memory against the number of diagonals."""
    nets = bm.load_sample(SAMPLE).control_points
    rng = np.random.default_rng(1)
    print("\ndiagonals   microsec. each   peak memory, MiB")
    for copies in sizes:
        turns = np.linalg.qr(rng.standard_normal((copies, 1, 1, 3, 3)))[0]
        turns *= np.linalg.det(turns)[..., None, None]
        moved = (nets @ turns[:, None, 0] + rng.standard_normal((copies, 1, 1, 1, 3))).reshape(
            -1, 1, *nets.shape[1:]
        )

        def solve(moved: Array = moved) -> None:
            bm.solve_geodesic(moved, STARTS, ENDS, search="straight", on_failure="status")

        least = min(seconds(solve) for _ in range(repeats))
        tracemalloc.start()
        solve()
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        print(f"{2 * len(moved):9d} {1e6 * least / (2 * len(moved)):16.1f} {peak / 2**20:18.0f}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="fewer diagonals and repeats")
    quick = parser.parse_args().quick
    compare(2 if quick else 5, (6, 2) if quick else (24, 6))
    scale((1,) if quick else (1, 10, 100), 2 if quick else 3)


if __name__ == "__main__":
    main()
