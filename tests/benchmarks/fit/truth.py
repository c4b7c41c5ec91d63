"""Bodies fitted to scans of which the true body is known: surface, landmarks, girths and cost.

python tests/benchmarks/fit/truth.py SCAN [...] [--file-unit m] [--truth FILE] [--details]

The truth of NAME.ply is NAME_truth.npz beside it, or FILE: its array `vertices` (13380, 3) is the
control mesh of the body without noise, in meters and in the scan's frame, whose Catmull-Clark limit
surface was scanned. The last row has the scans together. Try tests/data/scans/coarse.ply.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import resource
import time
from pathlib import Path
from typing import NamedTuple

import igl
import numpy as np

import bodymeasure as bm
from bodymeasure._typing import Array, Bools
from bodymeasure.bezier import evaluate
from bodymeasure.fit.model import atlas_of_vertices, body_model
from bodymeasure.subdivision import QuadMesh, limit_positions, subdivide, triangles

# Samples along a side of each patch; the truth is cut into quads of 3 mm.
SIDE, SUBDIVISIONS = 5, 2
# Girths are compared at the height of the true landmark, where the body is cut horizontally.
GIRTHS = {
    "bust": "bust point left",
    "waist": "front waist point",
    "hip": "front hip point",
    "knee": "patella point left",
}


class Row(NamedTuple):
    """Figures of one scan, in millimeters, and seconds of processor time."""

    surface: Array
    landmarks: Array
    girths: Array
    seconds: float


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scans", nargs="+", type=Path)
    parser.add_argument("--file-unit", default="m")
    parser.add_argument("--truth", type=Path)
    parser.add_argument("--details", action="store_true", help="landmarks one by one, and scores")
    options = parser.parse_args()
    rows = []
    print("scan                 surface: RMS   95 %  worst   landmarks: RMS  worst", end="   ")
    print("girths: " + ", ".join(GIRTHS) + "   seconds")
    for scan in options.scans:
        truth = options.truth or scan.with_name(f"{scan.stem}_truth.npz")
        body, row = measured(scan, options.file_unit, truth)
        rows.append(row)
        print_row(scan.stem, row)
        if options.details:
            names = zip(body.atlas.landmarks, row.landmarks, strict=True)
            print("   ", body.scores, *body.warnings, sep="\n    ")
            print("   ", ", ".join(f"{name} {gap:.1f}" for name, gap in names))
    if len(rows) > 1:
        surface = np.concatenate([row.surface for row in rows])
        landmarks = np.concatenate([row.landmarks for row in rows])
        girths = np.concatenate([row.girths for row in rows])
        seconds = sum(row.seconds for row in rows)
        print_row("together", Row(surface, landmarks, girths, seconds))
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    print(f"peak memory {memory:.2f} GiB, with that of the comparison")


def measured(scan: Path, unit: str, truth: Path) -> tuple[bm.FittedBody, Row]:
    """Fit a scan and compare it with the truth, without the patches that the scan does not show."""
    start = time.process_time()
    body = bm.fit_body(scan, file_unit=unit)
    seconds = time.process_time() - start
    with np.load(truth) as data:
        vertices = data["vertices"] / bm.Unit.parse(unit).meters
    vertices = vertices @ body.transform[:3, :3].T + body.transform[:3, 3]
    shown = np.ones(len(body.atlas), dtype=bool)
    shown[body.uncovered] = False
    # What a rule finds is compared with what it finds on the true body.
    true = bm.found_landmarks(atlas_of_vertices(vertices)).atlas
    gaps = [
        np.linalg.norm(body.atlas.position(name) - true.position(name)) for name in true.landmarks
    ]
    surface = surface_distances(body.atlas, vertices, shown)
    return body, Row(1e3 * surface, 1e3 * np.array(gaps), girth_errors(body.atlas, true), seconds)


def surface_distances(atlas: bm.Atlas, truth: Array, shown: Bools) -> Array:
    """Distances of points of an atlas's patches from a body's limit surface, by libigl."""
    mesh = QuadMesh(np.asarray(truth, dtype=float), body_model().quads)
    for _ in range(SUBDIVISIONS):
        mesh = subdivide(mesh)
    side = (np.arange(SIDE) + 0.5) / SIDE
    places = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1).reshape(-1, 2)
    nets = atlas.control_points[shown]
    points = evaluate(nets, np.tile(places, (len(nets), 1, 1))).reshape(-1, 3)
    squares = igl.point_mesh_squared_distance(points, limit_positions(mesh), triangles(mesh.quads))[
        0
    ]
    return np.asarray(np.sqrt(squares))


def girth_errors(atlas: bm.Atlas, true: bm.Atlas) -> Array:
    """Taut girths less the true ones, at the heights of the true landmarks, in millimeters."""
    result = []
    for name in GIRTHS.values():
        place = true.position(name)
        result.append(1e3 * (bm.body_girth(atlas, place).taut - bm.body_girth(true, place).taut))
    return np.array(result)


def print_row(name: str, row: Row) -> None:
    def rms(values: Array) -> float:
        return float(np.sqrt(np.mean(values**2)))

    girths = " ".join(f"{error:6.1f}" for error in row.girths[: len(GIRTHS)])
    if len(row.girths) > len(GIRTHS):
        girths = f"worst {np.abs(row.girths).max():.1f}, RMS {rms(row.girths):.1f}    "
    print(
        f"{name:24} {rms(row.surface):9.2f} {np.percentile(row.surface, 95):6.2f} "
        f"{row.surface.max():6.1f} {rms(row.landmarks):16.1f} {row.landmarks.max():6.1f}    "
        f"{girths} {row.seconds:9.1f}",
        flush=True,
    )


if __name__ == "__main__":
    main()
