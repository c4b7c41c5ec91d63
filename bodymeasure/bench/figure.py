"""Figures of error against time of all methods, on patches and on a body, as SVG files."""

import io
from dataclasses import dataclass
from typing import Any, Literal

from bodymeasure.bench.bodies.kinds import EXACT, FLIPS, ISOLINE, PYGEODESIC, SECTION
from bodymeasure.bench.bodies.sets import OURS, OURS_IN_NUMPY
from bodymeasure.bench.entrants.entrants import DEFAULT, NUMPY
from bodymeasure.bench.problems.sets import BODY, DIAGONALS
from bodymeasure.bench.records import BenchDocument, Result, SetRecord
from bodymeasure.scene.figures.chart_style import TEXT_SIZE, chart_style, power_of_ten

CAPTION_INK, GRID = "#57606a", "#d8dee4"
# Smaller errors are drawn at this one, which is half the spacing of numbers near 1: a smaller
# relative error is none.
LEAST_ERROR = 1.1e-16
# The lower end of the axis of errors.
FLOOR = 3e-17
# The factor by which the axes extend beyond the outermost points.
MARGIN = 3.0
# Labels of the axis of time, by microseconds.
TICKS = {
    1e0: "1 µs",
    1e1: "10 µs",
    1e2: "100 µs",
    1e3: "1 ms",
    1e4: "10 ms",
    1e5: "100 ms",
    1e6: "1 s",
    1e7: "10 s",
}
KEYS_A_COLUMN = 5
METADATA: Any = {
    "Title": "Error of a geodesic's length against processor time",
    "Date": None,
    "Creator": None,
}


@dataclass(frozen=True)
class Look:
    """The look of a method in the figure.

    Parameters
    ----------
    color, marker : str
    size, width : float
        Sizes of the marker and the line.
    layer : int
        Higher layers are drawn over lower ones.
    """

    color: str
    marker: str
    size: float = 6.0
    width: float = 1.3
    layer: int = 3


# Colors after M. Okabe and K. Ito, "Color universal design" (2008), darkened where they would be
# faint on white. bodymeasure's methods share a color; markers distinguish all methods without it.
# pygeodesic is drawn under libigl, with which it agrees.
_OURS, _OTHERS = "#0072B2", "#3a9bd1"
LOOKS = {
    DEFAULT: Look(_OURS, "*", size=13.0, layer=5),
    NUMPY: Look(_OURS, "h", size=7.0, layer=4),
    "RBF, full form": Look(_OTHERS, "o"),
    "RBF, weak form": Look(_OTHERS, "X", size=6.0),
    "RBF, 8 of Wu's C2": Look(_OTHERS, "s", size=5.5),
    "polynomial collocation": Look(_OTHERS, "D", size=5.0),
    "Ritz": Look(_OTHERS, "^"),
    "relaxation": Look(_OTHERS, "v"),
    "shooting": Look(_OTHERS, "P", size=6.5),
    "solve_bvp": Look("#D55E00", "o"),
    "libigl exact": Look("#000000", "s", size=4.5, layer=4),
    "pygeodesic exact": Look("#CC79A7", "D", size=9.0, width=4.0),
    "potpourri3d edge flips": Look("#009E73", "^", layer=4),
    "libigl heat": Look("#B8860B", "v"),
    "straightest [4], potpourri3d": Look("#56B4E9", "P", size=6.5),
    "unfolding [5]": Look("#8a5a2b", "X", size=6.0),
    "straightest, normals [6]": Look("#7a7a7a", "D", size=5.0),
    "fast marching [7], potpourri3d": Look("#7B4EA3", "o"),
}
# On a body the same methods look the same.
BODY_LOOKS = {
    OURS: LOOKS[DEFAULT],
    OURS_IN_NUMPY: LOOKS[NUMPY],
    FLIPS: LOOKS["potpourri3d edge flips"],
    EXACT: LOOKS["libigl exact"],
    PYGEODESIC: LOOKS["pygeodesic exact"],
    SECTION: Look("#D55E00", "s", size=5.5, layer=4),
    ISOLINE: Look("#B8860B", "v"),
}
On = Literal["patches", "body"]
# The part of failures from which on a method is drawn hollow.
MANY_FAILURES = 0.1
COLUMNS = 3


@dataclass(frozen=True)
class Words:
    """What a figure says: of what the time is, and what stands below it."""

    each: str
    caption: str


ON_PATCHES = Words(
    "a diagonal",
    "Bars: the middle 80 % of the diagonals. Hollow: no length for more than a tenth of the "
    "diagonals.\nLines: tolerances 1e-3, 1e-6 and 1e-8; meshes of 17, 33 and 65 points a side. "
    "Errors under 1e-16 are drawn there.",
)
ON_A_BODY = Words(
    "a measurement",
    f"On {BODY}. Bars: the middle 80 % of the measurements. Lines: meshes of 4, 8 and 16 segments "
    "along each edge of a patch.\nbodymeasure's errors are those that it states; the others' are "
    "differences from its lengths, which an extrapolated peer confirms.",
)


def error_against_time(document: BenchDocument, *, on: On) -> bytes:
    """Return the median error against the median time of a problem, with a panel for each set.

    Bars span the errors of the middle 80 % of the problems. The background is white, so that the
    picture can be shown on dark pages, too.

    Parameters
    ----------
    document : BenchDocument
    on : {"patches", "body"}
        Which of the sets are shown.

    Returns
    -------
    bytes

    Raises
    ------
    MissingExtraError
        If matplotlib is not installed.
    """
    with chart_style("the figure", "bench"):
        figure = draw(document, on=on)
        file = io.BytesIO()
        figure.savefig(file, format="svg", metadata=METADATA)
    return file.getvalue()


def draw(document: BenchDocument, *, on: On) -> Any:
    """Return the picture as a figure of matplotlib."""
    from matplotlib.figure import Figure

    words, looks = (ON_PATCHES, LOOKS) if on == "patches" else (ON_A_BODY, BODY_LOOKS)
    sets = [each for each in document.sets if (each.noun == DIAGONALS) == (on == "patches")]
    rows = -(-len(sets) // COLUMNS)
    # The keys take as much room below one row of panels as below two.
    height = 5.9 + 3.1 * (rows - 1)
    figure = Figure(figsize=(10.4, height), facecolor="white")
    grid = figure.subplots(rows, COLUMNS, sharex=True, sharey=True, squeeze=False)
    panels = grid.ravel()[: len(sets)]
    names = {each.name for each in sets}
    _scale(panels[0], [result for result in document.results if result.set in names])
    keys: dict[bool, dict[str, Any]] = {True: {}, False: {}}
    for axes, record in zip(panels, sets, strict=True):
        _dress(axes, record)
        chosen = [result for result in document.results if result.set == record.name]
        for method in dict.fromkeys(result.method for result in chosen):
            points = [result for result in chosen if result.method == method]
            key = _plot(axes, looks[method], points)
            keys[points[0].family == "bodymeasure"].setdefault(method, key)
    for first in grid[:, 0]:
        first.set_ylabel("relative error of the length")
    grid[-1, COLUMNS // 2].set_xlabel(f"processor time of {words.each}, one thread")
    below = 0.41 * 5.9 / height
    _legend(figure, "bodymeasure", keys[True], (0.065, 0.2 * below))
    _legend(figure, "others", keys[False], (0.53, 0.2 * below))
    figure.text(0.065, 0.02, words.caption, size=TEXT_SIZE - 1.0, color=CAPTION_INK)
    figure.subplots_adjust(
        left=0.065, right=0.985, top=1.0 - 0.06 * 5.9 / height, bottom=below, wspace=0.06
    )
    return figure


def _scale(axes: Any, results: list[Result]) -> None:
    """Set the limits and ticks, which all panels share."""
    times = [result.time_median for result in results]
    errors = [result.error_ninetieth for result in results if result.error_ninetieth is not None]
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(min(times) / MARGIN, MARGIN * max(times))
    axes.set_ylim(FLOOR, MARGIN * max(errors, default=1.0))
    # Ticks outside the limits would widen them.
    low, high = axes.get_xlim()
    ticks = {time: text for time, text in TICKS.items() if low <= time <= high}
    axes.set_xticks([*ticks], [*ticks.values()])
    powers = [power for power in range(-16, 1, 2) if 10.0**power <= axes.get_ylim()[1]]
    axes.set_yticks([10.0**power for power in powers], [power_of_ten(power) for power in powers])


def _legend(figure: Any, title: str, keys: dict[str, Any], place: tuple[float, float]) -> None:
    legend = figure.legend(
        keys.values(),
        keys,
        title=title,
        loc="lower left",
        bbox_to_anchor=place,
        ncols=-(-len(keys) // KEYS_A_COLUMN),
        frameon=False,
        borderpad=0.0,
        handlelength=2.2,
        columnspacing=1.6,
        alignment="left",
    )
    legend.get_title().set_fontweight("bold")


def _dress(axes: Any, record: SetRecord) -> None:
    axes.minorticks_off()
    axes.tick_params(length=0)
    axes.grid(color=GRID, linewidth=0.6)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_title(record.title, size=TEXT_SIZE + 1.0, loc="left", weight="bold")


def _plot(axes: Any, look: Look, points: list[Result]) -> Any:
    """Draw the points of one method, joined in the order of its settings; return its key."""
    from matplotlib.lines import Line2D

    known = [point for point in points if point.error_median is not None]
    time = [point.time_median for point in known]
    median, low, high = (
        [max(getattr(point, name), LEAST_ERROR) for point in known]
        for name in ("error_median", "error_tenth", "error_ninetieth")
    )
    axes.vlines(time, low, high, color=look.color, linewidth=1.6, alpha=0.35, zorder=2)
    failed = sum(point.failures for point in points)
    hollow = failed > MANY_FAILURES * sum(point.problems for point in points)
    style = _style(look, joined=len(points) > 1)
    hollow_style = {
        "markeredgecolor": look.color,
        "markerfacecolor": "white",
        "markeredgewidth": 1.2,
    }
    axes.plot(time, median, **{**style, **(hollow_style if hollow else {})}, zorder=look.layer)
    return Line2D([], [], **style)


def _style(look: Look, *, joined: bool) -> dict[str, Any]:
    """Return how matplotlib draws a method, and its key in the legend."""
    return {
        "color": look.color,
        "linewidth": look.width,
        "linestyle": "-" if joined else "none",
        "marker": look.marker,
        "markersize": look.size,
        "markeredgecolor": "white",
        "markerfacecolor": look.color,
        "markeredgewidth": 0.7,
    }
