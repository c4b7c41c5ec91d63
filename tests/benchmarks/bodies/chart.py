"""The time and memory that whole charts of bodies take, and the measurements that they lack.

python tests/benchmarks/bodies/chart.py [BODY ...] [--random N] [--first K] [--values]

BODY is a sample; random bodies begin at number K and take some 12 s each. The share of all
measurements that were taken is printed last.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"

import argparse
import resource
import sys
import time
from itertools import chain
from pathlib import Path

import bodymeasure as bm
from bodymeasure.atlas import convert_length
from bodymeasure.chart import Chart, Outcome, load_definitions, measure_chart

sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.bodies import BODIES
from helpers.body_space import random_body

MEBIBYTE = 2**20


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("bodies", nargs="*", help="samples; all, unless random bodies are wanted")
    parser.add_argument("--random", type=int, default=0, help="number of random bodies")
    parser.add_argument("--first", type=int, default=0, help="number of the first random body")
    parser.add_argument("--values", action="store_true", help="print every measurement")
    options = parser.parse_args()
    load_definitions()
    samples = options.bodies or (() if options.random else BODIES)
    numbers = range(options.first, options.first + options.random)
    bodies = chain(map(bm.load_sample, samples), map(random_body, numbers))
    taken = every = 0
    for body in bodies:
        begin = time.process_time()
        chart, times = timed_chart(body)
        seconds = times[-1] - begin
        # In kibibytes on Linux: the most that this process has had so far.
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / MEBIBYTE
        outcomes = {kind: sum(one.outcome is kind for one in chart.measured) for kind in Outcome}
        counts = ", ".join(f"{count} {kind}" for kind, count in outcomes.items() if count)
        print(f"{body.name}: {counts}; {seconds:.1f} s of processor time, {peak:.0f} MiB")
        print(f"  first measurement, and with it the landmarks: {times[0] - begin:.1f} s")
        for one in chart.measured:
            if one.outcome is not Outcome.MEASURED:
                print(f"  {one.definition.key}: {one.outcome}: {one.reason}")
        if options.values:
            print_values(chart)
        taken += outcomes[Outcome.MEASURED]
        every += len(chart.measured)
    print(f"{taken} of {every} measurements taken: {100.0 * taken / every:.2f} %")


def timed_chart(atlas: bm.Atlas) -> tuple[Chart, list[float]]:
    """A chart, and the processor time at which each measurement was done."""
    times: list[float] = []
    chart = measure_chart(atlas, progress=lambda *_: times.append(time.process_time()))
    return chart, times


def print_values(chart: Chart) -> None:
    print(f"  {'':36s} {'value':>9s} {'contact':>9s} {'taut':>9s} {'error':>8s}  cm, degrees")
    for one in chart.measured:
        scale = 1.0
        if not getattr(one.definition, "angle", False):
            scale = convert_length(1.0, chart.atlas.unit, bm.Unit.CM)
        lengths = " ".join(f"{scale * x:9.3f}" for x in (one.value, one.contact, one.taut))
        print(f"  {one.definition.key:36s} {lengths} {scale * one.error_estimate:8.0e}")


if __name__ == "__main__":
    main()
