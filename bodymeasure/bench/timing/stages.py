"""The parts of the time of the default method that its stages take."""

import cProfile
import pstats
from collections.abc import Mapping
from typing import Any

from bodymeasure.bench.problems.sets import ProblemSet
from bodymeasure.geodesic import RBFCollocation, solve_geodesic

# The functions of each stage, by module and name, and the caller under which they count (any, if
# it is None). None of these functions calls another one of the table.
_Function = tuple[str, str]
_FAST = "graph/solve"
STAGES: Mapping[str, tuple[tuple[_Function, _Function | None], ...]] = {
    "first guess": (((_FAST, "_guess"), None),),
    "Newton's method": (((_FAST, "_newton"), (_FAST, "_solve_block")),),
    "length, error and certificate": (((_FAST, "_measured"), None),),
    "paths left to the full form": ((("solving/on_spaces", "solve_on_spaces"), None),),
}
REST = "checks, scaling, sharing out, gathering"
CALLS = 5


def stage_shares(problem_set: ProblemSet) -> dict[str, float]:
    """Return the part of the time of `solve_geodesic` that each stage takes; the sum is 1.

    Parameters
    ----------
    problem_set : ProblemSet

    Returns
    -------
    dict of str to float
        The parts by the names of `STAGES`, and `REST`.
    """
    problems = problem_set.problems
    profile = cProfile.Profile()
    for _ in range(CALLS):
        profile.enable()
        solve_geodesic(*problems, method=RBFCollocation(), search="straight", on_failure="status")
        profile.disable()
    # The table, which typeshed lacks, has calls, own time, whole time and callers of functions.
    table: dict[tuple[str, int, str], Any] = pstats.Stats(profile).stats  # type: ignore[attr-defined]
    whole = _seconds(table, ("solve", "solve_geodesic"), None)
    shares = {
        stage: sum(_seconds(table, function, caller) for function, caller in functions) / whole
        for stage, functions in STAGES.items()
    }
    return {**shares, REST: 1.0 - sum(shares.values())}


def _seconds(
    table: Mapping[tuple[str, int, str], Any], function: _Function, caller: _Function | None
) -> float:
    """Return the time in a function and all that it calls, under one caller or under any."""
    for key, (_, _, _, whole, callers) in table.items():
        if _is(key, function):
            if caller is None:
                return float(whole)
            return float(sum(each[3] for by, each in callers.items() if _is(by, caller)))
    return 0.0


def _is(key: tuple[str, int, str], function: _Function) -> bool:
    module, name = function
    file = key[0].replace("\\", "/")
    return key[2] == name and file.endswith(f"bodymeasure/geodesic/{module}.py")
