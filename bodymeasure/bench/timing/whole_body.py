"""The time for which a user waits: all diagonals of a body."""

from functools import partial
from statistics import median

import numpy as np

from bodymeasure.bench.problems.sets import BODY
from bodymeasure.bench.records import Figure
from bodymeasure.bench.timing.timing import processor_seconds
from bodymeasure.geodesic import Search, Status
from bodymeasure.measure import diagonals
from bodymeasure.samples import load_sample

MILLI = 1e3
SEARCHES: tuple[Search, ...] = ("straight", "quick")


def whole_body(rounds: int) -> list[Figure]:
    """Return times of all diagonals of a body with their error estimates, and of paths along edges.

    Parameters
    ----------
    rounds : int
        Number of timings of each, whose median counts.
    """
    atlas = load_sample(BODY)
    # The first calls fill caches.
    solutions = [diagonals(atlas, search=search, on_failure="status") for search in SEARCHES]
    seconds: dict[Search, list[float]] = {search: [] for search in SEARCHES}
    for _ in range(rounds):
        for search in SEARCHES:
            call = partial(diagonals, atlas, search=search, on_failure="status")
            seconds[search].append(processor_seconds(call))
    straight, quick = (MILLI * median(seconds[search]) for search in SEARCHES)
    length = solutions[1].length
    on_edge = int((np.asarray(solutions[1].status) == Status.ON_BOUNDARY).sum())
    what = f"{length.size} diagonals of {BODY}"
    return [
        Figure(name=f"{what}, from straight lines alone", value=straight, unit="milliseconds"),
        Figure(name=f"{what}, {on_edge} of them along edges", value=quick, unit="milliseconds"),
        Figure(
            name="a path along an edge",
            value=(quick - straight) / on_edge if on_edge else None,
            unit="milliseconds",
        ),
    ]
