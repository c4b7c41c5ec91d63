"""Errors against the number of functions, a method a column."""

from bodymeasure.paper.tables.table import Column, Table, rows_of
from bodymeasure.paper.tables.tables_3_and_4 import key

# Families of `beyond_table`: those of the page's charts that tell most.
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
    """The median errors of paths, read off the table of all methods and settings.

    Parameters
    ----------
    beyond : Table
        By `beyond_table`.
    """
    found = {(r["patches"], r["functions"], r["family"]): r["raw_median"] for r in beyond.records}
    places = dict.fromkeys((patches, count) for patches, count, _ in found)
    rows = [
        (*place, *(found[(*place, family)] for family in SHOWN))
        for place in sorted(places, key=lambda place: [p for p, _ in places].index(place[0]))
    ]
    return Table(
        "beyond_medians",
        "Median error of the path's length, by number of functions",
        (
            Column("patches", "Patches", "text"),
            Column("functions", "Functions", "count"),
            *(Column(key(family), family, "small") for family in SHOWN),
        ),
        rows_of(rows),
        (
            "Relative, of the path as it is, without the correction. Centers from 1 on with even "
            "nodes are the paper's own; a dash: the system is degenerate.",
        ),
    )
