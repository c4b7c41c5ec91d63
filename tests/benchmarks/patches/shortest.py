"""How often the searches find the shortest path, compared with libigl's exact distance.

The patches are random and as rough as the paper's; some are symmetric about the diagonal, so that
the straight start is a geodesic and often not the shortest. A length that is longer than the mesh's
distance by more than three times its uncertainty is a miss; one that is shorter by as much would be
wrong. Then lengths known in closed form. Run it by hand: ``python
tests/benchmarks/patches/shortest.py [--patches N]``; 100 patches of each kind take some five
minutes.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import sys
import time
from pathlib import Path

import numpy as np

import bodymeasure as bm
from bodymeasure.oracle import mesh_distances

sys.path.insert(0, str(Path(__file__).parents[2]))
from benchmarks.independent.reference import symmetric, wild_patches
from helpers.surfaces.surfaces import SURFACES

from bodymeasure._typing import Array
from bodymeasure.geodesic import SEARCHES

# As in the cross-check: the multiple of the meshes' uncertainty that is allowed, and the relative
# difference that they can resolve at all.
DOUBT, RESOLUTION = 3.0, 1e-6


def compare(kind: str, nets: Array) -> None:
    """Print what each search makes of one kind of patches."""
    count = len(nets)
    starts, ends = np.zeros((count, 1, 2)), np.ones((count, 1, 2))
    mesh = mesh_distances(nets, starts, ends)
    exact, doubt = mesh.exact[:, 0], DOUBT * mesh.exact_uncertainty[:, 0]
    allowed = np.maximum(doubt, RESOLUTION * exact)
    for search in SEARCHES:
        begin = time.process_time()
        solution = bm.solve_geodesic(
            nets, (0.0, 0.0), (1.0, 1.0), search=search, on_failure="status"
        )
        seconds = time.process_time() - begin
        difference = solution.length - exact
        edges = (np.asarray(solution.status) == bm.Status.ON_BOUNDARY).sum()
        print(
            f"{kind:16s} {search:9s} {100 * solution.converged.mean():7.1f} "
            f"{100 * edges / count:8.1f} {(difference > allowed).sum():7d} "
            f"{(difference < -allowed).sum():9d} {1e3 * seconds / count:9.1f}"
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--patches", type=int, default=100, help="of each kind")
    count = parser.parse_args().patches
    rng = np.random.default_rng(7)
    print(f"{'':16s} {'search':9s} length% on edge%  longer   shorter   ms each")
    for side in (1.0, 0.6):
        compare(f"wild {side:g}", wild_patches(rng, count, side))
    for side in (1.0, 0.3):
        compare(f"symmetric {side:g}", symmetric(wild_patches(rng, count, side)))
    errors = [
        abs(bm.solve_geodesic(s.control_points, s.start, s.end).length / s.length - 1.0)
        for s in SURFACES
    ]
    print(f"closed forms: {len(errors)} lengths, worst relative error {max(errors):.1e}")


if __name__ == "__main__":
    main()
