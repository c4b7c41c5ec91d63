"""Charts of synthetic scans against the charts of the bodies that were scanned.

python tests/benchmarks/bodies/scan_charts.py [--random N] [--first K] [--noise MM] [--keys KEYS]
    [SCAN TRUTH UNIT ...]

Random bodies that are not quite of the space (`tests/helpers/synthetic_scans.py`) stand in random
poses; each is scanned with noise, fitted and charted. A scan of yours is a mesh with the control
vertices of its body (an .npz file with `vertices`) and a unit. Printed are the processor time of
fit and chart, and for each measurement the share of true errors within twice the stated
uncertainty, and their root mean square in units of it; and how far each landmark was off.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"

import argparse
import sys
import time
from collections import defaultdict
from pathlib import Path

import numpy as np

import bodymeasure as bm
from bodymeasure._typing import Array, Ints
from bodymeasure.chart import found_landmarks
from bodymeasure.fit.model import atlas_of_vertices, limit_matrix

sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.synthetic_scans import synthetic_scan


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scans", nargs="*", help="triples of a mesh, its truth and its unit")
    parser.add_argument("--random", type=int, default=0, help="number of random bodies")
    parser.add_argument("--first", type=int, default=0, help="number of the first random body")
    parser.add_argument("--noise", type=float, default=1.3, help="noise of the scan in mm")
    parser.add_argument("--keys", default="", help="measurements, separated by commas")
    options = parser.parse_args()
    keys = [key for key in options.keys.split(",") if key]
    ratios: dict[str, list[float]] = defaultdict(list)
    errors: dict[str, list[float]] = defaultdict(list)
    off: dict[str, list[float]] = defaultdict(list)
    for number in range(options.first, options.first + options.random):
        scan = synthetic_scan(number, noise=1e-3 * options.noise)
        mesh = (scan.vertices, scan.triangles)
        _one(f"random {number}", mesh, "m", scan.truth, keys, (ratios, errors, off))
    for mesh, truth, unit in zip(*[iter(options.scans)] * 3, strict=True):
        with np.load(truth) as data:
            vertices = data["vertices"].astype(float)
        _one(Path(mesh).stem, mesh, unit, vertices, keys, (ratios, errors, off))
    print(f"\n{'measurement':36s} {'n':>3s} {'RMS, mm':>8s} {'within 2':>8s} {'RMS/unc.':>8s}")
    for key in ratios:
        print(_line(key, errors[key], ratios[key]))
    print(
        _line(
            "all",
            [e for each in errors.values() for e in each],
            [r for each in ratios.values() for r in each],
        )
    )
    print("\nlandmark, RMS mm along the skin")
    for name, values in off.items():
        print(
            f"{name:24s} {1e3 * np.sqrt(np.mean(np.square(values))):6.1f} "
            f"worst {1e3 * max(values):6.1f}"
        )


def _line(name: str, errors: list[float], ratios: list[float]) -> str:
    within = np.mean(np.abs(ratios) < 2.0)
    rms = np.sqrt(np.mean(np.square(ratios)))
    size = 1e3 * np.sqrt(np.mean(np.square(errors)))
    return f"{name:36s} {len(ratios):3d} {size:8.2f} {within:8.0%} {rms:8.2f}"


def _one(
    name: str,
    mesh: str | tuple[Array, Ints],
    unit: str,
    vertices: Array,
    keys: list[str],
    found: tuple[dict[str, list[float]], dict[str, list[float]], dict[str, list[float]]],
) -> None:
    """Fit, chart and compare one scan."""
    ratios, errors, off = found
    begin = time.process_time()
    fitted = bm.fit_body(mesh, file_unit=unit, up="+z")
    middle = time.process_time()
    chart = bm.measure_chart(fitted.atlas, only=keys, despite_errors=True)
    end = time.process_time()
    # The true body in the frame of the fit, in which heights, depths and sides are measured.
    limits = (np.asarray(limit_matrix() @ each) for each in (vertices, fitted.vertices))
    turn, shift = _aligned(*limits)
    # Landmarks that the fit finds by rule are found so on the true body, too.
    true_atlas = found_landmarks(atlas_of_vertices(vertices @ turn.T + shift)).atlas
    truth = bm.measure_chart(true_atlas, only=keys, despite_errors=True)
    for item in truth.measured:
        key = item.definition.key
        mine = next((m for m in chart.measured if m.definition.key == key), None)
        if mine is None or item.unit == "deg" or not mine.input_uncertainty:
            continue
        error = mine.value - item.value
        if np.isfinite(error):
            ratios[key].append(error / mine.input_uncertainty)
            errors[key].append(error)
    for landmark in fitted.atlas.landmarks:
        if landmark in true_atlas.landmarks:
            true = true_atlas.position(landmark)
            off[landmark].append(float(np.linalg.norm(fitted.atlas.position(landmark) - true)))
    print(
        f"{name}: fit {middle - begin:.1f} s, chart {end - middle:.1f} s of processor time",
        flush=True,
    )


def _aligned(points: Array, targets: Array) -> tuple[Array, Array]:
    """Return the rotation and the shift that take points to targets best."""
    a, b = points.mean(axis=0), targets.mean(axis=0)
    u, _, vt = np.linalg.svd((targets - b).T @ (points - a))
    turn = u @ np.diag([1.0, 1.0, np.sign(np.linalg.det(u @ vt))]) @ vt
    return turn, b - turn @ a


if __name__ == "__main__":
    main()
