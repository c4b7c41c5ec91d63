"""The color bar, and the histogram of differences, as SVG files."""

import io
import re
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure.errors import InputError
from bodymeasure.scene.colors import (
    NO_LENGTH,
    NOT_COMPARED,
    SMALLEST,
    ColorScale,
    color_map,
)
from bodymeasure.scene.figures.canvas import INK, figure_pixels
from bodymeasure.scene.figures.chart_style import TEXT_SIZE, chart_style, power_of_ten
from bodymeasure.scene.model import PathKind, Paths

if TYPE_CHECKING:
    from bodymeasure.measure import Survey

BINS_PER_DECADE = 4


def color_bar(paths: Paths) -> bytes:
    """What the colors of paths mean, as an SVG file.

    Parameters
    ----------
    paths : Paths
        Of the whole body, as the pictures' scale.
    """
    with chart_style():
        return figure_svg(_draw_color_bar(paths), "color-bar")


def color_bar_image(paths: Paths, dots_per_inch: int) -> NDArray[np.uint8]:
    """What the colors of paths mean, as pixels, shape (height, width, 3)."""
    with chart_style():
        figure = _draw_color_bar(paths)
        figure.set_dpi(dots_per_inch)
        return figure_pixels(figure)


def _draw_color_bar(paths: Paths) -> Any:
    from matplotlib.figure import Figure

    scale = ColorScale.of(paths)
    figure = Figure(figsize=(5.6, 0.72))
    if scale is not None:
        axes = figure.add_axes((0.04, 0.40, 0.56, 0.20))
        axes.imshow(
            color_map(np.linspace(0.0, 1.0, 128))[None],
            extent=(np.log10(scale.low), np.log10(scale.high), 0, 1),
            aspect="auto",
        )
        _decades(axes, np.log10([scale.low, scale.high]))
        axes.set_yticks([])
        axes.set_title(f"relative {PathKind.COMPARED.value}", size=TEXT_SIZE, loc="left", pad=4.0)
    key = figure.add_axes((0.66, 0.0, 0.34, 1.0))
    key.set_axis_off()
    key.set_xlim(0, 1)
    key.set_ylim(0, 1)
    kinds = (
        (PathKind.NO_LENGTH, NO_LENGTH, (0, (2.2, 1.6))),
        (PathKind.NOT_COMPARED, NOT_COMPARED, "-"),
    )
    rows = [row for row in kinds if (paths.kind == row[0]).any()]
    for place, (kind, color, dashes) in zip((0.68, 0.34), rows, strict=False):
        key.plot([0.0, 0.16], [place, place], color=color, linewidth=2.4, linestyle=dashes)
        key.text(0.20, place, kind.value, va="center", size=TEXT_SIZE)
    return figure


def histogram(survey: "Survey") -> bytes:
    """How many diagonals differ how much from libigl exact, as an SVG file.

    Raises
    ------
    InputError
        If the survey has no cross-check, or none of its lengths could be compared.
    """
    check = survey.cross_check
    good = np.isfinite(survey.diagonals.length)
    value = np.abs(check.relative_difference[good]) if check is not None else np.array([])
    value = value[np.isfinite(value)]
    if len(value) == 0:
        raise InputError(
            "there are no differences to draw a histogram of; run the survey with its cross-check"
        )
    with chart_style():
        return figure_svg(_draw_histogram(value), "histogram")


def _draw_histogram(value: NDArray[np.float64]) -> Any:
    from matplotlib.figure import Figure

    place = np.log10(np.maximum(value, SMALLEST))
    low, high = np.floor(place.min()), np.ceil(place.max())
    high = max(high, low + 1)
    edges = np.linspace(low, high, round((high - low) * BINS_PER_DECADE) + 1)
    count, _ = np.histogram(place, edges)

    figure = Figure(figsize=(5.6, 2.5))
    axes = figure.add_axes((0.105, 0.19, 0.865, 0.78))
    colors = ColorScale.spanning(value).rgb(10.0 ** ((edges[:-1] + edges[1:]) / 2))
    axes.bar(edges[:-1], count, np.diff(edges), align="edge", color=colors, ec="white", lw=0.8)
    axes.set_xlim(low, high)
    axes.set_ylim(0, 1.25 * count.max())
    _decades(axes, np.array([low, high]))
    # One caption below the other, so that they never meet.
    for line, (caption, at) in enumerate((("median", np.median(place)), ("largest", place.max()))):
        axes.axvline(at, color=INK, linewidth=0.9, linestyle=(0, (4, 2)))
        on_right = at < low + 0.7 * (high - low)
        axes.annotate(
            f"{caption} {_number(10.0**at)}",
            (at, 1.0),
            xycoords=("data", "axes fraction"),
            xytext=(4 if on_right else -4, -1.25 * TEXT_SIZE * line),
            textcoords="offset points",
            ha="left" if on_right else "right",
            va="top",
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5},
        )
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_xlabel(f"relative {PathKind.COMPARED.value}, without its sign")
    axes.set_ylabel("diagonals")
    return figure


def _decades(axes: Any, ends: NDArray[np.float64]) -> None:
    """Label the powers of ten along an axis of logarithms."""
    powers = np.arange(np.ceil(ends[0]), np.floor(ends[1]) + 1).astype(int)
    axes.set_xticks(powers, [power_of_ten(power) for power in powers])
    axes.tick_params(length=2.5, labelsize=TEXT_SIZE)


def _number(value: float) -> str:
    """Two digits and a power of ten."""
    digits, power = f"{value:.1e}".split("e")
    return f"{digits} \N{MULTIPLICATION SIGN} {power_of_ten(int(power))}"


def figure_svg(figure: Any, name: str) -> bytes:
    """A figure as an SVG element that may stand in a page beside others."""
    file = io.BytesIO()
    figure.savefig(file, format="svg", transparent=True, metadata={"Date": None, "Creator": None})
    text = file.getvalue().decode()
    text = text[text.index("<svg") :]
    # Two charts of one page must not share identifiers.
    text = re.sub(r'(\bid="|url\(#|href="#)', rf"\g<1>{name}-", text)
    return text.encode()
