"""Enclosures of lengths in ball arithmetic: how close they are, and how long they take.

Run it by hand: ``python tests/benchmarks/patches/enclosures.py``; it takes half a minute.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import time

import bodymeasure as bm

# From (0, 0) to (1, 1); the tangent developable from (0, 1) to (1, 0.3).
KNOWN = {
    "enneper": 2.3570226039551585,
    "paraboloid": 2.562007137069414,
    "hyperbolic_paraboloid": 1.7978527887818834,
    "ph_cylinder": 5.0,
    "tangent_developable": 10.795929801053113,
}
BODY, PATCHES = "female_average", (0, 76, 114, 152, 190, 228, 266, 342)


def row(name: str, solution: bm.GeodesicSolution, known: float | None) -> None:
    """Print the enclosure of a length beside its closed form, or beside the computed one."""
    begin = time.process_time()
    lower, upper = bm.enclose(solution)
    seconds = time.process_time() - begin
    # Computed lengths are rounded.
    length, error = (solution.length, solution.error_estimate) if known is None else (known, 0.0)
    inside = lower - error <= length <= upper + error
    print(
        f"{name:22s} {lower!r:22} {upper!r:22} {(upper - lower) / upper:.1e} "
        f"{'contains' if inside else 'MISSES'} the {'length' if known is None else 'closed form'}, "
        f"{seconds:.1f} s"
    )


def main() -> None:
    """Print the table."""
    for name, length in KNOWN.items():
        net = bm.load_sample(name).control_points[0]
        ends = ((0.0, 1.0), (1.0, 0.3)) if name == "tangent_developable" else ((0, 0), (1, 1))
        row(name, bm.solve_geodesic(net, *ends), length)
    body = bm.load_sample(BODY)
    for patch in PATCHES:
        solution = bm.solve_geodesic(body.control_points[patch], (0, 0), (1, 1))
        row(f"{BODY} {patch}", solution, None)


if __name__ == "__main__":
    main()
