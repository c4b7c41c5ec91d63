"""The page of a comparison, one self-contained file."""

from bodymeasure.compare import shown
from bodymeasure.compare.plots import Plot, plot_of
from bodymeasure.compare.records import VERDICTS, Comparison, Difference
from bodymeasure.report.body.tape import tape_text
from bodymeasure.report.numbers import MINUS, NONE
from bodymeasure.report.templating import moment, render_page
from bodymeasure.report.units import UNIT_NAMES

TONES = {"within": "good", "exceeds": "poor", "too few subjects": "fair", "no class": ""}
MARKS = {"within": "✓", "exceeds": "✕", "too few subjects": "△", "no class": NONE}


def render_comparison(comparison: Comparison) -> bytes:
    """Return a comparison as an HTML page that loads nothing else.

    Differences are listed one by one if there is one subject; if there are several, those of each
    measurement are taken together.

    Raises
    ------
    MissingExtraError
        If jinja2 is not installed.
    """
    used = {each.verdict for each in comparison.agreements}
    context = {
        "comparison": comparison,
        "single": len(comparison.subjects) == 1,
        "sentences": shown.summary(comparison),
        "created": moment(comparison.created),
        "unit_name": UNIT_NAMES[comparison.unit],
        "verdicts": {verdict: words for verdict, words in VERDICTS.items() if verdict in used},
        "tones": TONES,
        "marks": MARKS,
        "plots": [] if len(comparison.subjects) == 1 else _plots(comparison),
    }
    return render_page(
        "bodymeasure.compare",
        "comparison.html.j2",
        context,
        feature="the page of a comparison",
        styles=("measurements.css",),
        filters={
            "tape": tape_text,
            "signed": shown.signed,
            "error": shown.error_text,
            "interval": shown.interval,
            "limits": shown.limits,
            "icc": shown.icc,
            "icc_interval": shown.icc_interval,
            "tick": lambda value: f"{round(value, 9):g}".replace("-", MINUS),
        },
    )


def _plots(comparison: Comparison) -> list[Plot]:
    """Return the Bland-Altman plot of each measurement that has one."""
    by_key: dict[str, list[Difference]] = {}
    for each in comparison.differences:
        by_key.setdefault(each.key, []).append(each)
    plots = (plot_of(each, by_key[each.key]) for each in comparison.agreements)
    return [plot for plot in plots if plot is not None]
