"""Table 5 in the paper's form, and as a distribution over all curves of a body."""

from collections.abc import Callable
from dataclasses import replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Atlas, Unit, convert_length
from bodymeasure.paper.data import published
from bodymeasure.paper.method.normalization import normalize
from bodymeasure.paper.surface.surface_comparison import Comparison, distribution
from bodymeasure.paper.surface.table5 import Table5
from bodymeasure.paper.tables.scaling import solve_distributed
from bodymeasure.paper.tables.spreads import spread_row, spread_table
from bodymeasure.paper.tables.table import Column, Table, Value, rows_of

_Length = TypeVar("_Length", float, NDArray[np.float64])

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
    """The same diagonals, calculated as in the paper: two functions on the normalized patch.

    Parameters
    ----------
    diagonals : Comparison
        Of the atlas.
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


def table_5(found: Table5, two: Comparison) -> Table:
    """Four rows, in cm, beside the published ones.

    Parameters
    ----------
    found : Table5
    two : Comparison
        Its diagonals by two functions.
    """
    paper = {row.name: row for row in two.rows()}
    rows = []
    for number, (printed, row) in enumerate(found.in_the_papers_form(), start=1):
        own = paper[row.name]
        rows.append(
            (
                number,
                row.name,
                _cm(row.calculated, two.unit),
                _cm(row.physical, two.unit),
                row.relative_error,
                _cm(own.calculated, two.unit),
                own.relative_error,
                printed.calculated,
                printed.physical,
                printed.relative_error,
            )
        )
    return Table(
        "table_5",
        "Table 5: calculated and physical lengths, cm",
        (
            Column("data", "Data", "count"),
            Column("curve", "Diagonal", "text"),
            Column("calculated", "Calculated, cm", "length"),
            Column("physical", "Physical, cm", "length"),
            Column("error", "Relative error", "fine"),
            Column("two_functions", "By two functions, cm", "length"),
            Column("two_functions_error", "Relative error", "fine"),
            Column("published_calculated", "Paper: by two functions", "length"),
            Column("published_physical", "Paper: physical", "length"),
            Column("published_error", "Paper: error, as printed", "percent"),
        ),
        rows_of(rows),
        (
            "The paper does not say which diagonals its rows are, of which mannequin. For each, "
            "the diagonal is taken whose physical length is nearest to the printed one: by size "
            "alone, whatever its error. Calculated: the converged shortest path; by two functions: "
            "the shortest solution inside the normalized patch. Relative error: (17), which is "
            "calculated less physical by physical; the paper prints the sign the other way round "
            "in its first three rows. Physical: libigl's exact distances on the surface that the "
            "atlas was fitted to, extrapolated over meshes of it.",
        ),
    )


def spread_of_table_5(found: Table5, two: Comparison) -> Table:
    """How the errors of all curves are spread, and those of the paper's four rows."""
    rows: list[tuple[Value, ...]] = []
    explained = []
    for name, comparison in (
        (DIAGONALS, found.diagonals),
        (TWO_FUNCTIONS, two),
        (BOUNDARY, found.boundary),
    ):
        spread = distribution(comparison)
        largest = spread.largest
        rows.append(
            (
                name,
                spread.count,
                spread.without_length,
                spread.mean,
                spread.mean_absolute,
                spread.median_absolute,
                spread.quantile_95,
                None if largest is None else largest.relative_error,
                None if largest is None else largest.name,
                spread.uncertainty,
            )
        )
        if largest is not None and comparison is not two:
            explained.append(f"Largest of the {name}, {largest.name}: {spread.explanation}")
    printed = np.array([row.calculated / row.physical - 1.0 for row in published.TABLE_5])
    size = np.abs(printed)
    largest_printed = printed[size.argmax()]
    means = (printed.mean(), size.mean(), np.median(size), None)
    which = f"data {size.argmax() + 1}"
    rows.append((PAPERS_ROWS, len(size), 0, *means, largest_printed, which, None))
    return Table(
        "table_5_spread",
        "Relative errors of all curves",
        (
            Column("curves", "Curves", "text"),
            Column("count", "Count", "count"),
            Column("without_length", "No length", "count"),
            Column("mean", "Mean", "fine"),
            Column("mean_absolute", "Mean of its size", "share"),
            Column("median_absolute", "Median", "share"),
            Column("quantile_95", "95 %", "share"),
            Column("largest", "Largest", "fine"),
            Column("which", "Which", "text"),
            Column("uncertainty", "Physical lengths' own doubt, median", "small"),
        ),
        rows_of(rows),
        (
            *explained,
            "A boundary curve is compared with itself, laid on the surface. All rows, with what "
            "part of each error is the fit and what part the path, are in the files as "
            "curves_diagonals and curves_boundary.",
        ),
    )


def body_distribution(name: str, found: Table5, two: Comparison) -> Table:
    """Quantiles of the errors' sizes, for the chart."""
    return spread_table(
        "body_distribution",
        [
            spread_row(name, curves, comparison.relative_error)
            for curves, comparison in (
                (DIAGONALS, found.diagonals),
                (BOUNDARY, found.boundary),
                (TWO_FUNCTIONS, two),
            )
        ],
    )


def curve_tables(found: Table5, two: Comparison) -> tuple[Table, Table]:
    """Every diagonal and boundary curve, for the files."""
    return (
        _curves("curves_diagonals", "All diagonals of Table 5", found.diagonals, two),
        _curves("curves_boundary", "All boundary curves of Table 5", found.boundary, None),
    )


def _curves(name: str, title: str, comparison: Comparison, two: Comparison | None) -> Table:
    unit = comparison.unit
    nothing = np.full(len(comparison), np.nan)
    columns: list[tuple[Column, NDArray[np.float64] | tuple[str, ...] | NDArray[np.bool_]]] = [
        (Column("patch", "Patch"), comparison.patch),
        (Column("place", "Curve"), comparison.place),
        (Column("calculated", "Calculated, cm", "length"), _cm(comparison.calculated, unit)),
        (Column("physical", "Physical, cm", "length"), _cm(comparison.physical, unit)),
        (Column("uncertainty", "Its doubt, cm", "small"), _cm(comparison.uncertainty, unit)),
        (Column("error", "Relative error", "fine"), comparison.relative_error),
        (Column("of_fit", "of the fit", "fine"), comparison.of_fit),
        (Column("of_path", "of the path", "fine"), comparison.of_path),
        (Column("distance", "Farthest off, cm", "length"), _cm(comparison.distance, unit)),
        (Column("shorter_path", "Surface has a shorter one"), comparison.shorter_path),
        (
            Column("two_functions", "By two functions, cm", "length"),
            nothing if two is None else _cm(two.calculated, unit),
        ),
    ]
    values = zip(*(column for _, column in columns), strict=True)
    return Table(name, title, tuple(head for head, _ in columns), rows_of(values))


def _cm(length: _Length, unit: Unit) -> _Length:
    return convert_length(length, unit, Unit.CM)
