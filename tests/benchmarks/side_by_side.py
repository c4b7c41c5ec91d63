"""How two states of the package compare in speed, in one run on one machine.

Run it by hand: ``python tests/benchmarks/side_by_side.py BEFORE_PYTHON AFTER_PYTHON
[--repeats N] [--default-threads] [WORKLOAD ...]``, with the interpreters of two environments in
which the two states are installed. Both use one thread. With ``--default-threads`` the second one
uses as many as its libraries choose: the same interpreter twice shows what threads cost.

Both interpreters are started once and take turns at the same small workloads, so that whatever
else the machine does affects both alike. For each workload the script prints processor times and
the ratios of the least and of the median ones, after / before; ratios of the least are steadier.
Every run works on fresh atlases, since some results are kept with an atlas. Names that differ
between the states are looked up under both.
"""

import os
import sys

os.environ["OMP_NUM_THREADS"] = str(os.cpu_count() if "--default-threads" in sys.argv else 1)
import argparse
import importlib
import json
import resource
import subprocess
import tempfile
import time
from collections.abc import Callable
from itertools import combinations
from pathlib import Path
from typing import IO, Any, NamedTuple

import numpy as np

Work = Callable[[], object]
PAIRS = 30
# Patches of the large atlas, along either side.
SIDE = 100
# Patches with random heights.
PATCHES = 20
# Patches on which the paper's two-function system is solved.
SYSTEMS = 20
ENDS = ("back neck point", "back hip point")


def named(*places: str) -> Any:
    """The first of several ``module:name`` that there is."""
    for place in places:
        module, name = place.split(":")
        try:
            return getattr(importlib.import_module(module), name)
        except (ImportError, AttributeError):
            continue
    raise SystemExit(f"none of these can be imported: {', '.join(places)}")


def body() -> Any:
    """A sample body that no other run has used."""
    return named("bodymeasure:load_sample")("female_average")


def patches() -> Work:
    heights = np.random.default_rng(2).uniform(-2.0, 2.0, (PATCHES, 4, 4))
    x, y = np.meshgrid(np.arange(4) / 3.0, np.arange(4) / 3.0, indexing="ij")
    solve = named("bodymeasure:solve_geodesic")
    nets = [np.stack([x, y, height], axis=-1) for height in heights]
    return lambda: [solve(net, (0.0, 0.0), (1.0, 1.0), on_failure="status") for net in nets]


def diagonals() -> Work:
    atlas, solve = body(), named("bodymeasure:diagonals")
    return lambda: solve(atlas)


def pairs() -> Work:
    atlas, between = body(), named("bodymeasure:geodesic_between")
    every = list(combinations((atlas.landmarks[name] for name in sorted(atlas.landmarks)), 2))
    some = np.random.default_rng(5).choice(len(every), PAIRS, replace=False)
    return lambda: [between(atlas, *every[number], on_failure="status") for number in some]


def chart() -> Work:
    atlas, measure = body(), named("bodymeasure:measure_chart")
    return lambda: measure(atlas)


def girths() -> Work:
    atlas, girth = body(), named("bodymeasure:body_girth")
    limb = named("bodymeasure:limb_girth")

    def work() -> None:
        for landmark in ("bust point left", "front waist point", "side hip point left"):
            girth(atlas, landmark)
        limb(atlas, "shoulder point left", "elbow point left", at=0.7)
        limb(atlas, "side hip point left", "patella point left", at=0.6)

    return work


def taut_tape() -> Work:
    atlas, draw = body(), named("bodymeasure:taut_tape")
    start, end = (atlas.landmarks[name] for name in ENDS)
    return lambda: draw(atlas, start, end)


def large_atlas() -> Any:
    """An atlas of a wavy surface, with patches joined by the points that they share."""
    count = 3 * SIDE + 1
    x, y = np.meshgrid(np.arange(count) / 3.0, np.arange(count) / 3.0, indexing="ij")
    points = np.stack([x, y, 0.2 * np.sin(x + 2.0 * y)], axis=-1)
    number = np.arange(count**2).reshape(count, count)
    windows = np.lib.stride_tricks.sliding_window_view(number, (4, 4))[::3, ::3]
    unit = named("bodymeasure:Unit")
    return named("bodymeasure:Atlas")(points.reshape(-1, 3), windows.reshape(-1, 4, 4), unit.CM)


def write_atlas() -> Work:
    atlas, write = large_atlas(), named("bodymeasure:write_atlas")

    def work() -> None:
        with tempfile.TemporaryDirectory() as folder:
            write(atlas, Path(folder) / "large.atlas")

    return work


def read_atlas() -> Work:
    read, write = named("bodymeasure:read_atlas"), named("bodymeasure:write_atlas")
    folder = tempfile.TemporaryDirectory()
    path = Path(folder.name) / "large.atlas"
    write(large_atlas(), path)

    def work() -> None:
        with folder:
            read(path)

    return work


def import_package() -> Work:
    # -P: not what happens to lie in the current folder.
    command = [sys.executable, "-P", "-c", "import bodymeasure"]
    return lambda: subprocess.run(command, check=True)


def two_functions() -> Work:
    solve = named(
        "bodymeasure.paper.method.two_function_solve:solve_two_functions",
        "bodymeasure.paper.two_function_solve:solve_two_functions",
    )
    heights = np.random.default_rng(2007).integers(0, 6, (SYSTEMS, 4, 4)) / 5.0
    heights[:, 0, 0], heights[:, 3, 3] = 0.0, 1.0
    x, y = np.meshgrid(np.arange(4) * 0.2, np.arange(4) * 0.2, indexing="ij")
    base = np.broadcast_to(np.stack([x, y], axis=-1), (SYSTEMS, 4, 4, 2))
    nets = np.concatenate([base, heights[..., None]], axis=-1)
    return lambda: solve(nets, "inside")


WORKLOADS: dict[str, Callable[[], Work]] = {
    make.__name__: make
    for make in (
        *(import_package, patches, diagonals, pairs, girths, taut_tape),
        *(write_atlas, read_atlas, two_functions, chart),
    )
}


def processor_seconds() -> float:
    """The processor time of this process and of those that it started and waited for."""
    others = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + others.ru_utime + others.ru_stime


def seconds(work: Work) -> float:
    before = processor_seconds()
    work()
    return processor_seconds() - before


def serve() -> None:
    """Run the workloads that are named on standard input, and answer with their times."""
    for line in sys.stdin:
        work = WORKLOADS[line.strip()]()
        print(json.dumps(seconds(work)), flush=True)


class Side(NamedTuple):
    """One of the two interpreters, and the pipes to it."""

    ask: IO[str]
    answer: IO[str]

    def run(self, name: str) -> float:
        """The processor time of one run of a workload."""
        self.ask.write(f"{name}\n")
        self.ask.flush()
        line = self.answer.readline()
        if not line:
            raise SystemExit(f"{name}: the interpreter has ended; its message is above")
        return float(json.loads(line))


def start(python: str, *options: str) -> Side:
    """Start an interpreter that waits for workloads."""
    command = [python, __file__, "--serve", *options]
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    assert process.stdin is not None
    assert process.stdout is not None
    return Side(process.stdin, process.stdout)


def compare(sides: list[Side], name: str, repeats: int) -> None:
    """Run a workload under both interpreters in turn, and print how they compare."""
    for side in sides:
        side.run(name)  # imports, and whatever is kept between runs
    times: list[list[float]] = [[], []]
    for repeat in range(repeats):
        # Neither side is always the first.
        for which in (0, 1) if repeat % 2 == 0 else (1, 0):
            times[which].append(sides[which].run(name))
    before, after = (np.array(each) for each in times)
    print(
        f"{name:16} {before.min():9.3f} {after.min():9.3f} {after.min() / before.min():8.3f} "
        f"{np.median(after) / np.median(before):8.3f}",
        flush=True,
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--serve", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("before", nargs="?", help="the interpreter with the state before")
    parser.add_argument("after", nargs="?", help="the interpreter with the state after")
    parser.add_argument("workloads", nargs="*", help=f"some of {', '.join(WORKLOADS)}; else all")
    parser.add_argument("--repeats", type=int, default=7, help="runs of each under each")
    parser.add_argument("--default-threads", action="store_true", help="for the second interpreter")
    options = parser.parse_intermixed_args()
    if options.serve:
        serve()
        return
    if options.before is None or options.after is None:
        parser.error("give two interpreters")
    if unknown := set(options.workloads) - WORKLOADS.keys():
        parser.error(f"there is no workload {', '.join(sorted(unknown))}")
    threads = ["--default-threads"] if options.default_threads else []
    sides = [start(options.before), start(options.after, *threads)]
    print("workload            before     after    ratio    ratio of medians; processor seconds")
    for name in options.workloads or WORKLOADS:
        compare(sides, name, options.repeats)


if __name__ == "__main__":
    main()
