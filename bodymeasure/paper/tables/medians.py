"""Errors against the number of functions, with a column for each method."""

from collections.abc import Callable
from typing import Any

from bodymeasure.paper.tables.statistics import key
from bodymeasure.paper.tables.table import Column, Table

# The families of `beyond_table` that are shown, which are the main ones of the page's charts.
SHOWN = (
    "RBF Wu C2, centers from 1 on, even nodes",
    "RBF Wu C2, centers at Chebyshev points",
    "RBF Wu C2, centers outside",
    "RBF Wu C10, centers outside",
    "polynomial collocation",
    "Ritz, u and v free",
    "Ritz, u = t",
)


def medians_table(beyond: Table) -> Table:
    """Return the median errors of paths, read off the table of all methods and settings.

    Parameters
    ----------
    beyond : Table
        The result of `beyond_table`.
    """
    found = {(r["patches"], r["functions"], r["family"]): r["raw_median"] for r in beyond.records}
    sets = list(dict.fromkeys(patches for patches, _, _ in found))
    places = dict.fromkeys((patches, count) for patches, count, _ in found)

    def median(family: str) -> Callable[[tuple[Any, Any]], Any]:
        return lambda place: found[(*place, family)]

    return Table.of(
        "beyond_medians",
        "Median error of the path's length, by number of functions",
        (
            Column("patches", "Patches", "text", lambda place: place[0]),
            Column("functions", "Functions", "count", lambda place: place[1]),
            *(Column(key(family), family, "small", median(family)) for family in SHOWN),
        ),
        sorted(places, key=lambda place: sets.index(place[0])),
        "Relative, of the path as it is, without the correction. Centers from 1 on with even "
        "nodes are the paper's own; a dash: the system is degenerate.",
    )
