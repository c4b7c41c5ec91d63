"""Bodies fitted to scans of which the true body is known: surface, landmarks, girths and cost.

python tests/benchmarks/fit/truth.py SCAN [...] [--file-unit m] [--up +z] [--truth FILE]
                                     [--details] [--first SCAN UNIT]

The truth of NAME.ply is NAME_truth.npz beside it, or FILE: its array `vertices` (13380, 3) is the
control mesh of the body without noise, in meters and in the scan's frame, whose Catmull-Clark limit
surface was scanned. The last row has the scans together. Try tests/data/scans/coarse.ply.

Carried landmarks are compared with the places that the true body carries, those that rules find
with what the same rules find on the true body. With ``--first``, the scans show the body of another
scan; how far their fits are from its fit is printed, too.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import resource
import time
from collections.abc import Collection, Sequence
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
# Girths are compared at the height of the true landmark, where the body is cut horizontally; the
# waist's at the landmark of each body, too.
GIRTHS = {
    "bust": "bust point left",
    "waist": "front waist point",
    "hip": "front hip point",
    "knee": "patella point left",
}


class Row(NamedTuple):
    """Figures of one scan, in millimeters, and seconds of processor time."""

    surface: Array
    carried: dict[str, float]
    by_rule: dict[str, float]
    girths: Array
    waist: Array
    seconds: float


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scans", nargs="+", type=Path)
    parser.add_argument("--file-unit", default="m")
    parser.add_argument("--up", help="which way is up, found if not given")
    parser.add_argument("--truth", type=Path)
    parser.add_argument("--details", action="store_true", help="landmarks one by one, and scores")
    parser.add_argument("--first", nargs=2, metavar=("SCAN", "UNIT"))
    options = parser.parse_args()
    first = options.first and bm.fit_body(options.first[0], file_unit=options.first[1])
    rows = []
    print("scan                 surface: RMS   95 %  worst   carried: RMS  worst", end="   ")
    print("by rule: RMS  worst   girths: " + ", ".join(GIRTHS), end="   ")
    print("waist at its landmark   seconds")
    for scan in options.scans:
        truth = options.truth or scan.with_name(f"{scan.stem}_truth.npz")
        body, row = measured(scan, options.file_unit, options.up, truth)
        rows.append(row)
        print_row(scan.stem, row)
        for warning in body.warnings:
            print("    ", warning)
        if first:
            gaps = 1e3 * surface_distances(body.atlas, first.vertices, seen(body))
            print(f"     from the fit of {options.first[0]}: {rms(gaps):.2f} mm RMS,", end=" ")
            print(f"worst {gaps.max():.2f}")
        if options.details:
            each = {**row.carried, **{f"{name} (rule)": gap for name, gap in row.by_rule.items()}}
            print("    ", body.scores)
            print("    ", ", ".join(f"{name} {gap:.1f}" for name, gap in each.items()))
    if len(rows) > 1:
        print_row("together", together(rows))
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    print(f"peak memory {memory:.2f} GiB, with that of the comparison")


def measured(scan: Path, unit: str, up: str | None, truth: Path) -> tuple[bm.FittedBody, Row]:
    """Fit a scan and compare it with the truth, without the patches that the scan does not show."""
    start = time.process_time()
    body = bm.fit_body(scan, file_unit=unit, up=up)
    seconds = time.process_time() - start
    with np.load(truth) as data:
        vertices = data["vertices"] / bm.Unit.parse(unit).meters
    vertices = vertices @ body.transform[:3, :3].T + body.transform[:3, 3]
    surface = 1e3 * surface_distances(body.atlas, vertices, seen(body))
    carried = atlas_of_vertices(body.vertices), atlas_of_vertices(vertices)
    found = tuple(bm.found_landmarks(atlas) for atlas in carried)
    both = set(found[0].by_rule) & set(found[1].by_rule)
    shown = {name for name, at in carried[0].landmarks.items() if seen(body)[at.patch]}
    true = found[1].atlas
    waist = [bm.body_girth(atlas, atlas.position(GIRTHS["waist"])).taut for atlas in carried]
    return body, Row(
        surface,
        apart(*carried, shown),
        apart(found[0].atlas, true, shown & both),
        girth_errors(body.atlas, true),
        np.array([1e3 * (waist[0] - waist[1])]),
        seconds,
    )


def seen(body: bm.FittedBody) -> Bools:
    """Which patches the scan shows, shape (376,)."""
    result = np.ones(len(body.atlas), dtype=bool)
    result[body.uncovered] = False
    return result


def apart(one: bm.Atlas, other: bm.Atlas, names: Collection[str]) -> dict[str, float]:
    """Distances of landmarks of two atlases, in millimeters."""
    return {
        name: 1e3 * float(np.linalg.norm(one.position(name) - other.position(name)))
        for name in sorted(names)
    }


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


def together(rows: Sequence[Row]) -> Row:
    """The figures of all scans as those of one."""
    return Row(
        np.concatenate([row.surface for row in rows]),
        numbered([row.carried for row in rows]),
        numbered([row.by_rule for row in rows]),
        np.concatenate([row.girths for row in rows]),
        np.concatenate([row.waist for row in rows]),
        sum(row.seconds for row in rows),
    )


def numbered(several: Sequence[dict[str, float]]) -> dict[str, float]:
    return {f"{k} {name}": gap for k, each in enumerate(several) for name, gap in each.items()}


def print_row(name: str, row: Row) -> None:
    girths = " ".join(f"{error:6.1f}" for error in row.girths[: len(GIRTHS)])
    if len(row.girths) > len(GIRTHS):
        girths = f"worst {np.abs(row.girths).max():.1f}, RMS {rms(row.girths):.1f}    "
    carried, by_rule = np.array([*row.carried.values()]), np.array([*row.by_rule.values()])
    waist = row.waist[np.argmax(np.abs(row.waist))]
    print(
        f"{name:24} {rms(row.surface):9.2f} {np.percentile(row.surface, 95):6.2f} "
        f"{row.surface.max():6.1f} {rms(carried):14.1f} {carried.max():6.1f} "
        f"{rms(by_rule):14.1f} {by_rule.max():6.1f}    {girths} {waist:9.1f} {row.seconds:9.1f}",
        flush=True,
    )


def rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))


if __name__ == "__main__":
    main()
