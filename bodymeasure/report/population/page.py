"""The page of several bodies, one self-contained file."""

from bodymeasure.report.body.tape import tape_text
from bodymeasure.report.population.records import PopulationDocument
from bodymeasure.report.population.tables import wide
from bodymeasure.report.templating import moment, render_page
from bodymeasure.report.units import UNIT_NAMES
from bodymeasure.wording import counted


def render_population(document: PopulationDocument) -> bytes:
    """Return the charts of several bodies as an HTML page that loads nothing else.

    Raises
    ------
    MissingExtraError
        If jinja2 is not installed.
    """
    rows = [
        (
            subject,
            [
                tape_text(value, each.unit)
                for value, each in zip(row, document.summaries, strict=True)
            ],
        )
        for subject, row in zip(document.subjects, wide(document), strict=True)
    ]
    groups = list(dict.fromkeys(each.group for each in document.summaries))
    context = {
        "document": document,
        "rows": rows,
        "groups": {
            group: [each for each in document.summaries if each.group == group] for group in groups
        },
        "unit_name": UNIT_NAMES[document.unit],
        "created": moment(document.created),
        "sentences": _sentences(document),
        "reasons": _reasons(document),
    }
    return render_page(
        "bodymeasure.report",
        "population.html.j2",
        context,
        feature="the page of measurements",
        filters={"tape": tape_text},
        styles=("measurements.css",),
    )


def _sentences(document: PopulationDocument) -> list[str]:
    whole = sum(each.missing == 0 for each in document.summaries)
    total, missing = len(document.summaries), sum(each.missing for each in document.summaries)
    sentences = [
        f"{counted(len(document.subjects), 'subject')}, {counted(total, 'measurement')} each, by "
        f"the set “{document.definitions}”.",
        f"{whole} of {total} measurements have a value on every subject"
        + (f"; {counted(missing, 'value')} in all are missing." if missing else "."),
    ]
    if document.failures:
        verb = "is" if len(document.failures) == 1 else "are"
        sentences.append(
            f"{counted(len(document.failures), 'body', 'bodies')} could not be "
            f"charted and {verb} not among them."
        )
    return sentences


def _reasons(document: PopulationDocument) -> list[tuple[str, str]]:
    """Return why values are missing, each reason once, with what and whom it concerns."""
    found: dict[str, dict[str, list[str]]] = {}
    for subject, chart in zip(document.subjects, document.charts, strict=True):
        for record in chart.measurements:
            if record.value is None:
                by_name = found.setdefault(record.reason or record.outcome, {})
                by_name.setdefault(record.name, []).append(subject)
    return [
        ("; ".join(f"{name} ({', '.join(subjects)})" for name, subjects in by_name.items()), reason)
        for reason, by_name in found.items()
    ]
