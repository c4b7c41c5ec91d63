"""The charts of "Future work of 2007", which are drawn from its tables alone."""

import math
from collections.abc import Iterable, Sequence
from typing import Any

from bodymeasure.paper.page.charts import FLOOR, decades, legend, line, new_panels
from bodymeasure.paper.tables.table import Table
from bodymeasure.scene.figures.chart_style import chart_style
from bodymeasure.scene.figures.color_bar import figure_svg

FORMS = ("weak", "collocation")


def orders_chart(table: Table, name: str) -> bytes:
    """Return errors on the linear model against the number of functions, as SVG."""
    with chart_style():
        figure, both = new_panels(2)
        for axes, form in zip(both, FORMS, strict=True):
            rows = [row for row in table.records if row["form"] == form]
            for number, kernel in enumerate(dict.fromkeys(row["kernel"] for row in rows)):
                _draw(
                    axes,
                    (r for r in rows if r["kernel"] == kernel),
                    ("functions", "l2"),
                    number,
                    kernel,
                )
            axes.set_title({"weak": "weak form"}.get(form, form), fontsize=9)
            axes.set_xscale("log")
            _plain(axes, [8, 11, 15, 20, 27, 36])
            axes.set_xlabel("functions, centers inside")
            _decades(axes, "y")
        both[0].set_ylabel("error in L2")
        legend(figure, both[0])
        return figure_svg(figure, name)


def forms_chart(table: Table, name: str) -> bytes:
    """Return errors of both forms on patches against the number of functions, as SVG."""
    with chart_style():
        sets = list(dict.fromkeys(row["functions"] for row in table.records))
        figure, both = new_panels(len(sets))
        for axes, functions in zip(both, sets, strict=True):
            rows = [row for row in table.records if row["functions"] == functions]
            for number, form in enumerate(FORMS):
                _draw(axes, rows, ("number", form), number, {"weak": "weak form"}.get(form, form))
            axes.set_title(functions, fontsize=9)
            axes.set_xlabel("functions")
            _decades(axes, "y")
        both[0].set_ylabel("error of the path's length, median")
        legend(figure, both[0])
        return figure_svg(figure, name)


def slopes_chart(table: Table, name: str) -> bytes:
    """Return errors of lengths against errors of paths, as SVG."""
    with chart_style():
        figure, (axes,) = new_panels(1)
        number = 0
        for form in FORMS:
            rows = [row for row in table.records if row["form"] == form]
            for key, what in (("raw", "length of the path"), ("corrected", "corrected length")):
                _draw(axes, rows, ("h1", key), number, f"{what}, {form}")
                number += 1
        _decades(axes, "x")
        _decades(axes, "y")
        axes.set_xlabel("error of the path's slopes, median")
        axes.set_ylabel("error of the length, median")
        legend(figure, axes)
        return figure_svg(figure, name)


def quadrature_chart(table: Table, name: str) -> bytes:
    """Return how many lengths are below the truth against the number of points, as SVG."""
    with chart_style():
        figure, (axes,) = new_panels(1)
        _draw(axes, table.records, ("points", "below_by_own"), 0, "by the same points", 0.0)
        _draw(axes, table.records, ("points", "below_by_fine"), 1, "by 64 points", 0.0)
        axes.set_xlabel("Gauss points")
        axes.set_ylabel("lengths below the truth")
        legend(figure, axes)
        return figure_svg(figure, name)


def conjugate_chart(table: Table, name: str) -> bytes:
    """Return errors of arcs against their lengths, as SVG."""
    with chart_style():
        figure, (axes,) = new_panels(1)
        _draw(axes, table.records, ("part", "raw"), 0, "length of the path")
        _draw(axes, table.records, ("part", "corrected"), 1, "corrected length")
        axes.set_xlabel("length / pi; at 1 the ends are conjugate")
        axes.set_ylabel("relative error")
        _decades(axes, "y")
        legend(figure, axes)
        return figure_svg(figure, name)


def _draw(
    axes: Any,
    rows: Iterable[dict[str, Any]],
    across_and_up: Sequence[str],
    number: int,
    label: str,
    floor: float = FLOOR,
) -> None:
    across, up = across_and_up
    points = [(r[across], max(r[up], floor)) for r in rows if None not in (r[across], r[up])]
    line(axes, points, number, label)


def _decades(axes: Any, along: str) -> None:
    """Make an axis logarithmic, unless nothing is drawn, as where no path was found."""
    least = axes.dataLim.minposx if along == "x" else axes.dataLim.minposy
    if math.isfinite(least):
        decades(axes.xaxis if along == "x" else axes.yaxis)


def _plain(axes: Any, ticks: Sequence[int]) -> None:
    axes.set_xticks(ticks)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.xaxis.set_minor_formatter(lambda _value, _: "")
