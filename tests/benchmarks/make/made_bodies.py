"""How well bodies are made to measure: held-out bodies, round trips, refusals, derivatives.

python tests/benchmarks/make/made_bodies.py            ten held-out bodies, and round trips
python tests/benchmarks/make/made_bodies.py --sets     makes the file of possible sets anew
"""

import argparse
import json
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).parents[3]
sys.path.insert(0, str(ROOT / "tests"))

from helpers.impossible import WOMAN  # noqa: E402

import bodymeasure as bm  # noqa: E402
from bodymeasure.atlas import Unit  # noqa: E402
from bodymeasure.fit.model import body_model  # noqa: E402
from bodymeasure.make.body.atlases import COUNT  # noqa: E402
from bodymeasure.make.body.measuring import Measuring  # noqa: E402
from bodymeasure.report.body import chart_document, to_smis  # noqa: E402

# Four girths, six geodesics, four heights.
FOURTEEN = (
    "bust_girth", "waist_girth", "hip_girth", "knee_girth_left", "shoulder_length_left",
    "neck_base_girth", "back_neck_to_bust_left", "arm_length_left", "crotch_length",
    "waist_to_hip_left", "back_neck_height", "waist_height_left", "knee_height_left",
    "inner_leg_length",
)  # fmt: skip
SAMPLES = ("female_average", "male_average", "female_heavy", "female_full_bust", "female_old")
# What the sets of the file are drawn from.
FORTY = (
    *WOMAN, "neck_girth", "top_hip_girth", "elbow_girth_right", "calf_girth_right",
    "shoulder_width_over_neck", "bust_span", "front_neck_to_waist", "side_neck_to_bust_right",
    "side_neck_to_waist_back_right", "waist_to_hip_right", "crotch_length",
    "upper_arm_length_right", "outer_leg_length_right", "hip_height_right", "body_rise",
    "bust_front_arc", "waist_front_arc", "hip_front_arc", "shoulder_breadth", "hip_breadth",
    "shoulder_slope_right", "high_bust_girth",
)  # fmt: skip
# What is asked for in round trips, by the presets of the default set.
PRESETS = ("core", "trousers")
SETS = ROOT / "tests" / "data" / "make" / "possible_sets.json"


def held_out(count: int) -> None:
    covered = np.unique(body_model().quads[body_model().covered])
    components = body_model().components[:, covered]
    weights = body_model().vertex_weight[covered]
    measuring = Measuring(bm.load_definitions(), FOURTEEN)
    bm.make_body(WOMAN, unit="cm")  # What is made once only is not counted.
    print("body  rounds  seconds  largest miss, mm  vertex RMS, mm  that of the mean body, mm")
    rows = []
    for number in range(count):
        truth = np.random.default_rng(100 + number).normal(size=COUNT)
        values = measuring.of(truth, slopes=False).values.tolist()
        begin = time.process_time()
        body = bm.make_body(dict(zip(FOURTEEN, values, strict=True)), unit="m", components=60)
        seconds = time.process_time() - begin
        found, mean = (
            np.tensordot(b - truth, components, 1) for b in (body.coefficients, np.zeros(COUNT))
        )
        rms = [
            1e3 * np.sqrt(np.average((each**2).sum(axis=1), weights=weights))
            for each in (found, mean)
        ]
        rows.append((body.rounds, seconds, 1e3 * body.largest_miss, *rms))
        print(
            f"{number:4d}  {body.rounds:6d}  {seconds:7.1f}  {rows[-1][2]:16.4f}"
            f"  {rms[0]:14.1f}  {rms[1]:25.1f}",
            flush=True,
        )
    table = np.array(rows)
    print(
        f"mean  {table[:, 0].mean():6.1f}  {table[:, 1].mean():7.1f}  {table[:, 2].mean():16.4f}"
        f"  {table[:, 3].mean():14.1f}  {table[:, 4].mean():25.1f}"
    )


def round_trips() -> None:
    for name in SAMPLES:
        chart = bm.measure_chart(bm.load_sample(name), only=PRESETS)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"{name}.smis"
            path.write_bytes(to_smis(chart_document(chart, Unit.CM)))
            (wanted,) = bm.read_measurements(path)
        begin = time.process_time()
        body = bm.make_body(wanted)
        seconds = time.process_time() - begin
        again = bm.measure_chart(body.atlas, only=[one.key for one in wanted.values])
        misses = {
            one.key: 1e3 * abs(again[one.key].value - one.base)
            for one in wanted.values
            if one.unit != "deg"
        }
        worst = max(misses, key=misses.__getitem__)
        over = {key: round(miss, 2) for key, miss in misses.items() if miss > 0.1}
        print(
            f"{name}: {len(wanted.values)} measurements, {body.rounds} rounds, {seconds:.1f} s,"
            f" worst {misses[worst]:.3f} mm ({worst}),"
            f" chi-square {body.chi_square:.0f}, over 0.1 mm: {over}, {body.warnings}",
            flush=True,
        )


def possible_sets() -> None:
    measuring = Measuring(bm.load_definitions(), FORTY)
    choose = np.random.default_rng(17)
    lines = []
    for number in range(100):
        truth = np.random.default_rng(1000 + number).normal(size=COUNT)
        values = measuring.of(truth, slopes=False).values
        rows = np.sort(choose.choice(len(FORTY), int(choose.integers(4, 21)), replace=False))
        held = {}
        for row in rows.tolist():
            if np.isfinite(values[row]):
                # In centimeters with what a hand adds, 3 mm; or in degrees.
                length = "slope" not in FORTY[row]
                value = 100.0 * values[row] if length else values[row]
                held[FORTY[row]] = round(value + (0.3 if length else 1.0) * choose.normal(), 1)
        lines.append(json.dumps(held))
    SETS.write_text("[\n" + ",\n".join(lines) + "\n]\n")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--sets", action="store_true", help="make the file of possible sets anew")
    parser.add_argument("--bodies", type=int, default=10, help="number of held-out bodies")
    parser.add_argument("--no-round-trips", action="store_true")
    given = parser.parse_args()
    if given.sets:
        possible_sets()
        return
    held_out(given.bodies)
    if not given.no_round_trips:
        round_trips()


if __name__ == "__main__":
    main()
