"""The methods on meshes that the paper's introduction names: errors, failures, times and orders.

Run it by hand: ``python tests/benchmarks/patches/paper_methods.py [--diagonals N]``; 12 diagonals
take some two minutes. `bodymeasure bench` has them beside all others.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import time

import numpy as np

import bodymeasure as bm
from bodymeasure.bench.entrants.entrants import MESH_METHODS, POINTS_A_SIDE, points_setting
from bodymeasure.bench.entrants.entrants import entrants as every_entrant
from bodymeasure.bench.problems.patches import Problems, both_diagonals, mild_patches


def row(name: str, problems: Problems, truth: np.ndarray) -> None:
    """Print the errors of a method on three meshes, and its order."""
    errors, failures, seconds = [], [], []
    every = {(each.method, each.setting): each for each in every_entrant()}
    for points in POINTS_A_SIDE:
        solve = every[name, points_setting(points)].prepare(problems)
        begin = time.process_time()
        length = solve()
        seconds.append((time.process_time() - begin) / len(truth))
        error = np.abs(length / truth - 1.0)
        errors.append(float(np.nanmedian(error)))
        failures.append(int(np.isnan(error).sum()))
    gaps = np.log(np.array(POINTS_A_SIDE) - 1.0)
    order = -np.polyfit(gaps, np.log(errors), 1)[0]
    print(
        f"{name:32s} "
        + " ".join(f"{error:.1e}" for error in errors)
        + f"  order {order:5.2f}  failures {failures}  "
        + " ".join(f"{1e3 * each:.1f}" for each in seconds)
        + " ms"
    )


def main() -> None:
    """Print a table for random patches, and one for the diagonals of a body."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--diagonals", type=int, default=12, help="of each kind")
    count = parser.parse_args().diagonals
    nets = mild_patches(np.random.default_rng(1), count, 0.3)
    mild = Problems(nets, np.zeros((count, 2)), np.ones((count, 2)))
    body = both_diagonals(bm.load_sample("female_average"))
    body = body.take(np.linspace(0, len(body.nets) - 1, count).astype(np.int64))
    for title, problems in (("mild patches", mild), ("diagonals of female_average", body)):
        solution = bm.solve_geodesic(*problems, on_failure="status")
        known = solution.converged
        print(f"{title}: {int(known.sum())}")
        for name in MESH_METHODS:
            row(name, problems.take(np.flatnonzero(known)), np.asarray(solution.length)[known])


if __name__ == "__main__":
    main()
