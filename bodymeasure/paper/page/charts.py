"""The charts of the page, which are drawn from the tables alone."""

import math
from collections.abc import Sequence
from typing import Any

from bodymeasure.paper.tables.spreads import LEVELS
from bodymeasure.paper.tables.table import Table
from bodymeasure.scene.figures.chart_style import chart_style, power_of_ten
from bodymeasure.scene.figures.color_bar import figure_svg

COLORS = ("#1f5f8b", "#c2571a", "#2e7d4f", "#7b4ea3", "#8a6d1f", "#b3202c", "#3b82b5", "#555555")
MARKERS = "osD^vPX*"
# Errors below this are rounding errors.
FLOOR = 1e-16
# The families in the two charts of `beyond`.
METHODS = (
    "RBF Wu C2, centers outside",
    "RBF Wu C10, centers outside",
    "polynomial collocation",
    "Ritz, u and v free",
    "Ritz, u = t",
)
PLACINGS = (
    "RBF Wu C2, centers outside",
    "RBF Wu C2, centers from 1 on, even nodes",
    "RBF Wu C2, centers from 1 on, Chebyshev nodes",
    "RBF Wu C2, centers at Chebyshev points",
    "RBF Wu C2, centers and nodes even",
)


def accuracy_chart(table: Table, families: Sequence[str], name: str) -> bytes:
    """Return errors of paths against the number of functions, as SVG."""
    with chart_style():
        figure, panels = _by_set(table, families, ("functions", "raw_median"), joined=True)
        for axes in panels:
            axes.set_xlabel("functions")
        panels[0].set_ylabel("relative error, median")
        return figure_svg(figure, name)


def cost_chart(table: Table, families: Sequence[str], name: str) -> bytes:
    """Return errors with the correction against time, as SVG."""
    with chart_style():
        figure, panels = _by_set(table, families, ("microseconds", "median"), joined=False)
        for axes in panels:
            axes.set_xlabel("microseconds a patch")
            # A set in which no method solved anything has no times.
            if not math.isfinite(axes.dataLim.minposx):
                continue
            axes.set_xscale("log")
            axes.xaxis.set_major_locator(_ticks())
            axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
            axes.xaxis.set_minor_formatter(lambda _value, _: "")
        panels[0].set_ylabel("relative error with correction")
        return figure_svg(figure, name)


def _by_set(
    table: Table, families: Sequence[str], across_and_up: tuple[str, str], *, joined: bool
) -> tuple[Any, list[Any]]:
    """Return panels for the sets of patches, each with a line for each family, by two columns."""
    across, up = across_and_up
    rows = [row for row in table.records if row[across] is not None and row[up] is not None]
    sets = list(dict.fromkeys(row["patches"] for row in table.records))
    figure, panels = new_panels(len(sets))
    for axes, patches in zip(panels, sets, strict=True):
        for number, family in enumerate(families):
            points = [
                (row[across], max(row[up], FLOOR))
                for row in rows
                if (row["patches"], row["family"]) == (patches, family)
            ]
            line(axes, points, number, family, joined=joined)
        axes.set_title(patches, fontsize=9)
        decades(axes.yaxis)
    legend(figure, panels[0])
    return figure, panels


def distribution_chart(table: Table, of: str, name: str) -> bytes:
    """Return the part of the lengths whose difference is below a size, as SVG."""
    with chart_style():
        figure, (axes,) = new_panels(1)
        rows = [row for row in table.records if row["of"] == of]
        for number, row in enumerate(rows):
            points = [
                (max(row[f"quantile_{level}"], FLOOR), level)
                for level in LEVELS
                if row[f"quantile_{level}"] is not None
            ]
            line(axes, points, number, row["difference"])
        decades(axes.xaxis)
        axes.set_xlabel("relative difference, without its sign")
        axes.set_ylabel("lengths up to that, %")
        legend(figure, axes)
        return figure_svg(figure, name)


def roots_chart(table: Table, name: str) -> bytes:
    """Return how many patches have how many real solutions, as SVG."""
    with chart_style():
        figure, (axes,) = new_panels(1)
        labels = [c for c in table.columns if c.name.startswith("real_")]
        # The number is odd with few exceptions; a line through the zeros between would zigzag.
        rows = [r for r in table.records if any(r[column.name] for column in labels)]
        axes.xaxis.get_major_locator().set_params(integer=True)
        for number, column in enumerate(labels):
            points = [(row["solutions"], row[column.name]) for row in rows]
            line(axes, points, number, column.label.removeprefix("Patches, "))
        axes.set_xlabel("real solutions of the two-function system")
        axes.set_ylabel("patches")
        legend(figure, axes)
        return figure_svg(figure, name)


def new_panels(count: int) -> tuple[Any, list[Any]]:
    """Return a figure, and so many panels beside each other."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.6 if count > 1 else 5.6, 3.9))
    panels = figure.subplots(1, count, sharey=count > 1, squeeze=False)[0]
    for axes in panels:
        axes.spines[["top", "right"]].set_visible(False)
        axes.grid(visible=True, color="#d5dae0", linewidth=0.5)
    return figure, list(panels)


def line(
    axes: Any,
    points: Sequence[tuple[float, float]],
    number: int,
    label: str,
    *,
    joined: bool = True,
) -> None:
    """Draw points as a line with the color and the marker of a number."""
    axes.plot(
        [x for x, _ in points],
        [y for _, y in points],
        color=COLORS[number % len(COLORS)],
        marker=MARKERS[number % len(MARKERS)],
        markersize=3.5,
        linewidth=1.1 if joined else 0.0,
        label=label,
    )


def _ticks() -> Any:
    """Return ticks at 1, 2 and 5 times powers of ten."""
    from matplotlib.ticker import LogLocator

    return LogLocator(subs=(1.0, 2.0, 5.0))


def decades(axis: Any) -> None:
    """Make an axis logarithmic, with powers of ten in plain letters."""
    axis.axes.set(**{f"{axis.axis_name}scale": "log"})
    axis.set_major_formatter(lambda value, _: power_of_ten(round(math.log10(value))))
    axis.set_minor_formatter(lambda _value, _: "")


def legend(figure: Any, axes: Any) -> None:
    """Put the legend below the panels, where it hides nothing."""
    handles, labels = axes.get_legend_handles_labels()
    rows = -(-len(labels) // 2)
    figure.subplots_adjust(left=0.1, right=0.97, top=0.92, bottom=0.16 + 0.058 * rows)
    figure.legend(handles, labels, loc="lower center", ncols=2, fontsize=8, frameon=False)
