"""The whole benchmark in one run."""

import os
import platform
from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime

from bodymeasure.bench.bodies.kinds import KINDS
from bodymeasure.bench.bodies.sets import BodySet, body_entrants, make_body_set
from bodymeasure.bench.entrants.entrants import entrants
from bodymeasure.bench.problems.patches import Problems
from bodymeasure.bench.problems.sets import ProblemSet, body_set, mild_set, wild_set
from bodymeasure.bench.records import (
    FORMAT,
    VERSION,
    BenchDocument,
    Machine,
    Result,
    ThreadsRecord,
)
from bodymeasure.bench.size import FULL, Size
from bodymeasure.bench.summary import body_figures, figures, growth_record, results, set_record
from bodymeasure.bench.timing.growth import measure_growth
from bodymeasure.bench.timing.stages import stage_shares
from bodymeasure.bench.timing.threads import one_thread
from bodymeasure.bench.timing.timing import take_turns
from bodymeasure.bench.timing.whole_body import whole_body
from bodymeasure.measure import package_versions

PACKAGES = ("bodymeasure", "numpy", "scipy", "libigl", "potpourri3d", "pygeodesic", "trimesh")
PATCH_SETS = 3


def benchmark_steps(size: Size = FULL) -> int:
    """Return the number of steps in which `run_benchmark` counts its progress."""
    on_bodies = len(KINDS) * (size.body_rounds + 2)
    return PATCH_SETS * (size.rounds + 2) + on_bodies + size.largest_exponent


def run_benchmark(
    size: Size = FULL, *, progress: Callable[[int], object] | None = None
) -> BenchDocument:
    """Compare methods side by side in processor time, on one thread.

    Parameters
    ----------
    size : Size
        `FULL`, or `QUICK` for few problems and repeats.
    progress : callable, optional
        Called with the number of `benchmark_steps` that are done.

    Returns
    -------
    BenchDocument

    Raises
    ------
    MissingExtraError
        If libigl is not installed.
    ImportError
        If another package of the extra ``bench`` is not installed.
    """
    exponents = range(1, size.largest_exponent + 1)
    half = replace(size, rounds=size.body_rounds)
    done = 0

    def advance() -> None:
        nonlocal done
        done += 1
        if progress is not None:
            progress(done)

    sets: list[ProblemSet[Problems]] = []
    body_sets: list[BodySet] = []
    compared: list[Result] = []
    on_bodies: list[Result] = []
    with one_thread() as threads:
        for make, count in ((mild_set, size.mild), (wild_set, size.wild), (body_set, size.body)):
            problem_set = make(count)
            advance()
            sets.append(problem_set)
            compared += results(problem_set, take_turns(entrants(), problem_set, size, advance))
        for kind in KINDS:
            measurements = make_body_set(kind, size.measurements)
            advance()
            body_sets.append(measurements)
            turns = take_turns(body_entrants(kind), measurements, half, advance)
            on_bodies += results(measurements, turns)
        stages = {each.name: stage_shares(each) for each in sets}
        body = whole_body(size.rounds)
        growth = []
        for exponent in exponents:
            growth.append(growth_record(measure_growth(10**exponent)))
            advance()
    return BenchDocument(
        format=FORMAT,
        version=VERSION,
        created=datetime.now(UTC).isoformat(timespec="seconds"),
        quick=size is not FULL,
        machine=Machine(
            system=platform.system(), architecture=platform.machine(), cores=os.cpu_count() or 1
        ),
        versions=package_versions(PACKAGES),
        threads=ThreadsRecord(
            limit=threads.limit, pools=list(threads.pools), others=threads.other_threads
        ),
        processor_seconds=threads.processor_seconds,
        sets=[*map(set_record, sets), *map(set_record, body_sets)],
        results=compared + on_bodies,
        growth=growth,
        stages=stages,
        figures=[
            *figures(compared, growth, body),
            *body_figures([*map(set_record, body_sets)], on_bodies),
        ],
    )
