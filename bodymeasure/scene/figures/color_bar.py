"""The color bar, and figures as SVG files."""

import io
import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.scene.colors import (
    NO_LENGTH,
    NOT_COMPARED,
    ColorScale,
    color_map,
)
from bodymeasure.scene.figures.canvas import figure_pixels
from bodymeasure.scene.figures.chart_style import TEXT_SIZE, chart_style, power_of_ten
from bodymeasure.scene.model import PathKind, Paths


def color_bar(paths: Paths) -> bytes:
    """Explain the colors of paths in an SVG file.

    Parameters
    ----------
    paths : Paths
        The paths of the whole body, which the pictures' scale spans.
    """
    with chart_style():
        return figure_svg(_draw_color_bar(paths), "color-bar")


def color_bar_image(paths: Paths, dots_per_inch: int) -> NDArray[np.uint8]:
    """Explain the colors of paths in a picture, shape (height, width, 3)."""
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


def _decades(axes: Any, ends: Array) -> None:
    """Label the powers of ten along an axis of logarithms."""
    powers = np.arange(np.ceil(ends[0]), np.floor(ends[1]) + 1).astype(int)
    axes.set_xticks(powers, [power_of_ten(power) for power in powers])
    axes.tick_params(length=2.5, labelsize=TEXT_SIZE)


def figure_svg(figure: Any, name: str) -> bytes:
    """Return a figure as an SVG element that may stand in a page beside others."""
    file = io.BytesIO()
    figure.savefig(file, format="svg", transparent=True, metadata={"Date": None, "Creator": None})
    text = file.getvalue().decode()
    text = text[text.index("<svg") :]
    # Two figures of one page must not share identifiers.
    text = re.sub(r'(\bid="|url\(#|href="#)', rf"\g<1>{name}-", text)
    return text.encode()
