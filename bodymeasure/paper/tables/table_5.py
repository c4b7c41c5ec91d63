"""Table 5 in the paper's form, and as a distribution over all curves of a body."""

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, Unit, convert_length
from bodymeasure.paper.data import published
from bodymeasure.paper.method.normalization import normalize
from bodymeasure.paper.surface.surface_comparison import Comparison, Distribution, Row, distribution
from bodymeasure.paper.surface.table5 import Table5
from bodymeasure.paper.tables.scaling import solve_distributed
from bodymeasure.paper.tables.spreads import spread_row, spread_table
from bodymeasure.paper.tables.table import Column, Table

# The kinds of curves, by which rows are named.
DIAGONALS = "diagonals"
TWO_FUNCTIONS = "diagonals, by two functions"
BOUNDARY = "boundary curves"
PAPERS_ROWS = "the paper's four rows"


def by_two_functions(
    diagonals: Comparison,
    atlas: Atlas,
    processes: int,
    progress: Callable[[int], None] | None = None,
) -> Comparison:
    """Return the same diagonals, calculated as in the paper: two functions on normalized patches.

    Parameters
    ----------
    diagonals : Comparison
        Diagonals of the atlas.
    atlas : Atlas
    processes : int
    progress : callable, optional
        Called with the number of parts that are done.
    """
    number = {name: place for place, name in enumerate(atlas.patch_names)}
    nets = atlas.control_points[[number[name] for name in diagonals.patch]]
    # The second diagonal runs from (1, 0) to (0, 1).
    second = np.array([place == "diagonal 2" for place in diagonals.place])
    nets[second] = nets[second, ::-1]
    normalized = normalize(nets)
    found = solve_distributed(normalized.control_points, processes, progress)
    return replace(diagonals, calculated=normalized.original_lengths(found.length))


class _Row(NamedTuple):
    """A row of Table 5: ours by collocation and by two functions, and the printed one."""

    number: int
    own: Row
    two: Row
    printed: published.Table5Row


def table_5(found: Table5, two: Comparison) -> Table:
    """Return four rows, in cm, beside the published ones.

    Parameters
    ----------
    found : Table5
    two : Comparison
        Its diagonals by two functions.
    """
    by_two = {row.name: row for row in two.rows()}
    rows = [
        _Row(number, row, by_two[row.name], printed)
        for number, (printed, row) in enumerate(found.in_the_papers_form(), start=1)
    ]

    def cm(length: float) -> float:
        return convert_length(length, two.unit, Unit.CM)

    columns = (
        Column("data", "Data", "count", lambda r: r.number),
        Column("curve", "Diagonal", "text", lambda r: r.own.name),
        Column("calculated", "Calculated, cm", "length", lambda r: cm(r.own.calculated)),
        Column("physical", "Physical, cm", "length", lambda r: cm(r.own.physical)),
        Column("error", "Relative error", "fine", lambda r: r.own.relative_error),
        Column("two_functions", "By two functions, cm", "length", lambda r: cm(r.two.calculated)),
        Column("two_functions_error", "Relative error", "fine", lambda r: r.two.relative_error),
        Column(
            "published_calculated",
            "Paper: by two functions",
            "length",
            lambda r: r.printed.calculated,
        ),
        Column("published_physical", "Paper: physical", "length", lambda r: r.printed.physical),
        Column(
            "published_error",
            "Paper: error, as printed",
            "percent",
            lambda r: r.printed.relative_error,
        ),
    )
    return Table.of(
        "table_5",
        "Table 5: calculated and physical lengths, cm",
        columns,
        rows,
        "The paper does not say which diagonals its rows are, of which mannequin. For each, "
        "the diagonal is taken whose physical length is nearest to the printed one: by size "
        "alone, whatever its error. Calculated: the shortest converged path found; by two "
        "functions: the shortest solution inside the normalized patch. Relative error: (17), which "
        "is calculated less physical by physical; the paper prints the sign the other way round "
        "in its first three rows. Physical: libigl's exact distances on the surface that the "
        "atlas was fitted to, extrapolated over meshes of it.",
    )


class _Spread(NamedTuple):
    """The spread of the errors of some curves, and the largest one."""

    curves: str
    spread: Distribution
    largest: float | None
    which: str | None


def spread_of_table_5(found: Table5, two: Comparison) -> Table:
    """Return how the errors of all curves are spread, and those of the paper's four rows."""
    rows, explained = [], []
    for name, comparison in _kinds(found, two):
        spread = distribution(comparison)
        largest = spread.largest
        if largest is None:
            rows.append(_Spread(name, spread, None, None))
            continue
        rows.append(_Spread(name, spread, largest.relative_error, largest.name))
        if comparison is not two:
            explained.append(f"Largest of the {name}, {largest.name}: {spread.explanation}")
    rows.append(_printed_spread())
    columns = (
        Column("curves", "Curves", "text"),
        Column("count", "Count", "count", lambda r: r.spread.count),
        Column("without_length", "No length", "count", lambda r: r.spread.without_length),
        Column("mean", "Mean", "fine", lambda r: r.spread.mean),
        Column("mean_absolute", "Mean of its size", "share", lambda r: r.spread.mean_absolute),
        Column("median_absolute", "Median", "share", lambda r: r.spread.median_absolute),
        Column("quantile_95", "95 %", "share", lambda r: r.spread.quantile_95),
        Column("largest", "Largest", "fine"),
        Column("which", "Which", "text"),
        Column(
            "uncertainty",
            "Physical lengths' own doubt, median",
            "small",
            lambda r: r.spread.uncertainty,
        ),
    )
    return Table.of(
        "table_5_spread",
        "Relative errors of all curves",
        columns,
        rows,
        *explained,
        "A boundary curve is compared with itself, laid on the surface. All rows, with what "
        "part of each error is the fit and what part the path, are in the files as "
        "curves_diagonals and curves_boundary.",
    )


def _kinds(found: Table5, two: Comparison) -> tuple[tuple[str, Comparison], ...]:
    return (DIAGONALS, found.diagonals), (TWO_FUNCTIONS, two), (BOUNDARY, found.boundary)


def _printed_spread() -> _Spread:
    """Return the spread of the paper's four errors, with the signs that its lengths have."""
    error = np.array([row.calculated / row.physical - 1.0 for row in published.TABLE_5])
    size = np.abs(error)
    spread = Distribution(
        count=len(error),
        without_length=0,
        mean=error.mean(),
        mean_absolute=size.mean(),
        median_absolute=float(np.median(size)),
        quantile_95=np.nan,
        largest=None,
        explanation="",
        uncertainty=np.nan,
    )
    return _Spread(PAPERS_ROWS, spread, error[size.argmax()], f"data {size.argmax() + 1}")


def body_distribution(name: str, found: Table5, two: Comparison) -> Table:
    """Return quantiles of the sizes of the errors, for the chart."""
    diagonals, by_two, boundary = (
        spread_row(name, curves, comparison.relative_error)
        for curves, comparison in _kinds(found, two)
    )
    return spread_table("body_distribution", [diagonals, boundary, by_two])


def curve_tables(found: Table5, two: Comparison) -> tuple[Table, Table]:
    """Return every diagonal and boundary curve, for the files."""
    return (
        _curves("curves_diagonals", "All diagonals of Table 5", found.diagonals, two),
        _curves("curves_boundary", "All boundary curves of Table 5", found.boundary, None),
    )


def _curves(name: str, title: str, each: Comparison, two: Comparison | None) -> Table:
    def cm(lengths: Array) -> Callable[[int], float]:
        return convert_length(lengths, each.unit, Unit.CM).item

    by_two = np.full(len(each), np.nan) if two is None else two.calculated
    columns = (
        Column("patch", "Patch", "text", each.patch.__getitem__),
        Column("place", "Curve", "text", each.place.__getitem__),
        Column("calculated", "Calculated, cm", "length", cm(each.calculated)),
        Column("physical", "Physical, cm", "length", cm(each.physical)),
        Column("uncertainty", "Its doubt, cm", "small", cm(each.uncertainty)),
        Column("error", "Relative error", "fine", each.relative_error.item),
        Column("of_fit", "of the fit", "fine", each.of_fit.item),
        Column("of_path", "of the path", "fine", each.of_path.item),
        Column("distance", "Farthest off, cm", "length", cm(each.distance)),
        Column("shorter_path", "Surface has a shorter one", "text", each.shorter_path.item),
        Column("two_functions", "By two functions, cm", "length", cm(by_two)),
    )
    return Table.of(name, title, columns, range(len(each)))
