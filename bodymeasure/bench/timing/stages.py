"""The parts of the time of the default method that its stages take."""

import cProfile
import pstats
from collections.abc import Mapping
from typing import Any

from bodymeasure.bench.problems.patches import Problems
from bodymeasure.bench.problems.sets import ProblemSet
from bodymeasure.geodesic import RBFCollocation, solve_geodesic

# The functions of each stage, by module and name: those of the compiled form, and those of NumPy's.
# None of these functions calls another one of the table.
_Function = tuple[str, str]
STAGES: Mapping[str, tuple[_Function, ...]] = {
    "first guess, Newton's method, length, error and certificate": (
        ("graph/compiled", "climb"),
        ("graph/arrays", "climb"),
    ),
    "paths left to the full form": (("solving/on_spaces", "solve_on_spaces"),),
}
REST = "checks, scaling, sharing out, gathering"
CALLS = 5


def stage_shares(problem_set: ProblemSet[Problems]) -> dict[str, float]:
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
    whole = _seconds(table, ("solve", "solve_geodesic"))
    shares = {
        stage: sum(_seconds(table, function) for function in functions) / whole
        for stage, functions in STAGES.items()
    }
    return {**shares, REST: 1.0 - sum(shares.values())}


def _seconds(table: Mapping[tuple[str, int, str], Any], function: _Function) -> float:
    """Return the time in a function and all that it calls."""
    return float(sum(whole for key, (_, _, _, whole, _) in table.items() if _is(key, function)))


def _is(key: tuple[str, int, str], function: _Function) -> bool:
    module, name = function
    file = key[0].replace("\\", "/")
    return key[2] == name and file.endswith(f"bodymeasure/geodesic/{module}.py")
