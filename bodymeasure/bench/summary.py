"""Times and lengths summed up to the numbers of the records."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from bodymeasure.bench.bodies.sets import OURS, OURS_IN_NUMPY, SEGMENTS, segments_setting
from bodymeasure.bench.entrants.entrants import (
    BVP,
    DEFAULT,
    IGL_EXACT,
    POINTS_A_SIDE,
    TOLERANCES,
    points_setting,
    tolerance_setting,
)
from bodymeasure.bench.problems.sets import ProblemSet
from bodymeasure.bench.records import Figure, GrowthRecord, Result, SetRecord
from bodymeasure.bench.timing.growth import Growth
from bodymeasure.bench.timing.timing import Trial

MICRO = 1e6
KILO = 1e3
# The number of patches from which on a diagonal is to take the same time in any batch.
FLAT_FROM = 1000


def set_record(problem_set: ProblemSet[Any]) -> SetRecord:
    """Return a set of problems in numbers."""
    return SetRecord(
        name=problem_set.name,
        title=problem_set.title,
        noun=problem_set.noun,
        drawn=problem_set.drawn,
        compared=len(problem_set),
        leaving_patch=problem_set.leaving,
        unresolved_truth=problem_set.unresolved,
        confirmed_to=problem_set.confirmed_to,
    )


def results(problem_set: ProblemSet[Any], trials: Sequence[Trial]) -> list[Result]:
    """Return times and errors of all methods on a set, that of bodymeasure's default first."""
    ours = _quartiles(trials[0].seconds, trials[0].count)[1]
    return [_result(problem_set, trial, ours) for trial in trials]


def _result(problem_set: ProblemSet[Any], trial: Trial, ours: float) -> Result:
    lower, median, upper = _quartiles(trial.seconds, trial.count)
    error = np.abs(trial.length / problem_set.truth[: trial.count] - 1.0)
    if problem_set.stated is not None and trial.entrant.family == "bodymeasure":
        error = np.maximum(error, problem_set.stated[: trial.count])
    # An infinite distance is no length, either.
    known = error[np.isfinite(error)]
    parts: list[float] | list[None] = [None] * 4
    if len(known):
        parts = np.quantile(known, [0.1, 0.5, 0.9, 1.0]).tolist()
    return Result(
        set=problem_set.name,
        method=trial.entrant.method,
        setting=trial.entrant.setting,
        family=trial.entrant.family,
        problems=trial.count,
        failures=trial.count - len(known),
        repeats=len(trial.seconds),
        time_median=median,
        time_lower_quartile=lower,
        time_upper_quartile=upper,
        times_ours=median / ours,
        error_tenth=parts[0],
        error_median=parts[1],
        error_ninetieth=parts[2],
        error_worst=parts[3],
    )


def growth_record(growth: Growth) -> GrowthRecord:
    """Return times and memory of a batch."""
    lower, median, upper = _quartiles(growth.seconds, growth.patches)
    return GrowthRecord(
        patches=growth.patches,
        failures=growth.failures,
        repeats=len(growth.seconds),
        time_median=median,
        time_lower_quartile=lower,
        time_upper_quartile=upper,
        peak_bytes=growth.peak_bytes,
    )


def _quartiles(seconds: Sequence[float], count: int) -> tuple[float, float, float]:
    """Return lower quartile, median and upper quartile in microseconds a diagonal."""
    lower, median, upper = MICRO / count * np.quantile(seconds, [0.25, 0.5, 0.75])
    return float(lower), float(median), float(upper)


def patch_meshes() -> dict[str, int]:
    """Return the segments a side of the meshes of patches, by their settings."""
    return {points_setting(points): points - 1 for points in POINTS_A_SIDE}


def orders(name: str, compared: Sequence[Result], settings: Mapping[str, int]) -> list[Figure]:
    """Return the orders at which methods on meshes converge on a set, by their median errors.

    An order p means errors that fall as the power p of the distance of neighboring points.

    Parameters
    ----------
    name : str
    compared : sequence of Result
    settings : mapping of str to int
        The segments a side of each mesh.
    """
    rows = [r for r in compared if (r.set, r.family) == (name, "mesh") and r.error_median]
    found = []
    for method in dict.fromkeys(row.method for row in rows):
        known = [
            (settings[r.setting], r.error_median)
            for r in rows
            if r.method == method and r.error_median is not None
        ]
        if len(known) < len(settings):
            continue
        segments, errors = np.log(np.array(known)).T
        order = -float(np.polyfit(segments, errors, 1)[0])
        found.append(Figure(name=f"{name}: {method}, order", value=order, unit=""))
    return found


def figures(
    compared: Sequence[Result], growth: Sequence[GrowthRecord], whole_body: Sequence[Figure]
) -> list[Figure]:
    """Return the numbers that a reader wants to know first."""
    found = []
    names = [result.set for result in compared if result.method == DEFAULT]
    for name in names:
        by_method = {(r.method, r.setting): r for r in compared if r.set == name}
        ours = by_method[DEFAULT, ""]
        found += [
            Figure(
                name=f"{name}: a diagonal, error estimate included",
                value=ours.time_median,
                unit="microseconds",
            ),
            Figure(name=f"{name}: worst relative error", value=ours.error_worst, unit=""),
        ]
        for method, setting in (
            (BVP, tolerance_setting(min(TOLERANCES))),
            (IGL_EXACT, points_setting(max(POINTS_A_SIDE))),
        ):
            other = by_method[method, setting]
            found.append(
                Figure(
                    name=f"{name}: {method}, {setting}",
                    value=other.times_ours,
                    unit="times as slow",
                )
            )
        found += orders(name, compared, patch_meshes())
    large = [record for record in growth if record.patches >= FLAT_FROM]
    times = [record.time_median for record in large]
    found += [
        Figure(
            name=f"slowest over fastest batch of {large[0].patches:,} to "
            f"{large[-1].patches:,} patches",
            value=max(times) / min(times),
            unit="",
        ),
        Figure(
            name=f"peak memory for {large[-1].patches:,} patches",
            value=large[-1].peak_bytes / 2**20,
            unit="MiB",
        ),
        *whole_body,
    ]
    return found


def body_figures(sets: Sequence[SetRecord], compared: Sequence[Result]) -> list[Figure]:
    """Return the same for measurements of a body."""
    meshes = {segments_setting(segments): segments for segments in SEGMENTS}
    found = []
    for record in sets:
        by_method = {r.method: r for r in compared if r.set == record.name}
        ours, plain = by_method[OURS], by_method[OURS_IN_NUMPY]
        found += [
            Figure(
                name=f"{record.name}: one, with its error estimate",
                value=ours.time_median / KILO,
                unit="milliseconds",
            ),
            Figure(
                name=f"{record.name}: without compiled kernels",
                value=plain.times_ours,
                unit="times as slow",
            ),
        ]
        if record.confirmed_to is not None:
            found.append(
                Figure(
                    name=f"{record.name}: difference from an extrapolated peer",
                    value=record.confirmed_to,
                    unit="",
                )
            )
        found += orders(record.name, compared, meshes)
    return found
