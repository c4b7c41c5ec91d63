"""The chart of one body, or of several, as it is printed."""

from typing import TYPE_CHECKING

import click
from rich.text import Text

from bodymeasure.cli.console import RESULTS, print_table
from bodymeasure.cli.tables import facts_table, new_table
from bodymeasure.wording import counted

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.report.body import BodyRecord, ChartDocument
    from bodymeasure.report.population import PopulationDocument

# The number of names that are listed of what could not be measured; the page has all.
NAMED = 6
# The number of points to pick that are listed.
PICKS = 3


def print_chart(document: "ChartDocument", form: str) -> None:
    """Print a chart: a table with remarks, or CSV or JSON."""
    from bodymeasure.report.body import chart_to_csv, scan_sentences
    from bodymeasure.report.serial import to_json

    # Bytes are UTF-8, whatever the encoding of the terminal.
    if form == "json":
        click.echo(to_json(document), nl=False)
    elif form == "csv":
        click.echo(chart_to_csv(document), nl=False)
    else:
        print_table(_table(document))
        for sentence in (*(document.approximation or ()), *scan_sentences(document)):
            RESULTS.print(Text(f"\n{sentence}"), soft_wrap=True)
        reasons = _reasons(document)
        if reasons:
            RESULTS.print(Text("\n".join(["", *reasons])), soft_wrap=True)


def _reasons(document: "ChartDocument") -> list[str]:
    """Return why measurements have no value, and remarks, each cause once."""
    from bodymeasure.report.body import absences, gains, remarked

    lines = []
    for each in gains(document):
        lines.append(f"pick {each.landmarks} to gain {each.count}: {each.measurements}")
        lines += (f"    {place}" for place in each.places)
    if lines:
        lines.append("`bodymeasure landmarks add` adds landmarks.")
    lines += (f"{each.names}: {each.reason}" for each in absences(document))
    return [*lines, *(f"{record.name}: {record.reason}" for record in remarked(document))]


def _table(document: "ChartDocument") -> "Table":
    from bodymeasure.report.body import input_text, largest_shift, tailor_inches, tape_text

    inches = document.unit == "inch"
    lengths = (document.unit, *(("fraction",) if inches else ()), "along skin", "taut", "error")
    shifted = any(record.shifts for record in document.measurements)
    lengths = (*lengths, *(("5 mm off",) if shifted else ()))
    if document.scan:
        lengths = (*lengths, "from the scan")
    if document.approximation:
        lengths = (*lengths, "approximation", "on the mesh")
    table = new_table("measurement", *lengths, "status", words=("status",))
    group = ""
    for record in document.measurements:
        if record.group != group:
            group = record.group
            table.add_row(Text(group, "bold"))
        error = record.error_estimate
        angle = record.unit != document.unit

        def shown(value: float | None, unit: str = record.unit, error: float | None = error) -> str:
            return "" if value is None else tape_text(value, unit, error)

        value = f"{shown(record.value)}°" if angle and record.value is not None else None
        fraction = "" if angle or record.value is None else tailor_inches(record.value, error)
        good = record.outcome == "measured"
        table.add_row(
            Text(record.name),
            value or shown(record.value),
            *((fraction,) if inches else ()),
            shown(record.contact),
            shown(record.taut),
            "" if error is None or record.value is None else f"{error:.0e}",
            *((largest_shift(record),) if shifted else ()),
            *(("" if record.value is None else input_text(record),) if document.scan else ()),
            *(_costs(record) if document.approximation else ()),
            Text(record.outcome, "" if good else "yellow"),
        )
    return table


def _costs(record: "BodyRecord") -> tuple[str, str]:
    """Return the error from the approximation and the difference on the mesh."""
    error, difference = record.approximation_error, record.mesh_difference
    return f"{error:.0e}" if error else "", f"{difference:+.1g}" if difference else ""


def summary_table(document: "ChartDocument", seconds: float) -> "Table":
    """Return the facts that a reader wants to know first."""
    from bodymeasure.report.body import asked_freesewing, gains, missing_freesewing

    table = facts_table(document.name)
    total, measured = len(document.measurements), document.outcomes.get("measured", 0)
    table.add_row("set", Text(document.definitions))
    table.add_row(
        "measured", Text(f"{measured:,} of {total:,}", "green" if measured == total else "yellow")
    )
    for outcome in document.outcomes:
        if outcome != "measured":
            table.add_row("", Text(f"{outcome}: {_named(document, outcome)}", "yellow"))
    for number, pick in enumerate(gains(document)[:PICKS]):
        words = f"{pick.landmarks}, which gains {pick.count}"
        table.add_row("" if number else "to pick", Text(words, "yellow"))
    absent = missing_freesewing(document)
    asked = len(asked_freesewing(document))
    if asked:
        table.add_row("FreeSewing", f"{asked - len(absent)} of {asked} keys")
    if absent:
        table.add_row("", Text(f"missing: {', '.join(absent)}"))
    table.add_row("time", f"{seconds:.1f} s")
    return table


def _named(document: "ChartDocument", outcome: str) -> str:
    return _first([record.name for record in document.measurements if record.outcome == outcome])


def _first(names: list[str]) -> str:
    """Return the first names, and how many more there are."""
    more = len(names) - NAMED
    # Names have commas in them.
    return "; ".join(names[:NAMED]) + (f"; and {more} more" if more > 0 else "")


def print_population(document: "PopulationDocument", form: str) -> None:
    """Print the charts of several bodies: a table of means, or CSV or JSON."""
    from bodymeasure.report.body import tape_text
    from bodymeasure.report.population import long_csv
    from bodymeasure.report.serial import to_json

    if form == "json":
        click.echo(to_json(document), nl=False)
        return
    if form == "csv":
        click.echo(long_csv(document), nl=False)
        return
    table = new_table(
        "measurement", "subjects", f"mean, {document.unit}", "deviation", "least", "greatest"
    )
    for each in document.summaries:
        degrees = "°" if each.unit != document.unit else ""
        values = (each.mean, each.deviation, each.minimum, each.maximum)
        shown = (tape_text(value, each.unit) + degrees for value in values)
        table.add_row(Text(each.name), str(each.subjects), *shown)
    print_table(table)


def population_facts(document: "PopulationDocument") -> "Table":
    """Return the facts on several bodies that a reader wants to know first."""
    table = facts_table(counted(len(document.subjects), "subject"))
    table.add_row("set", Text(document.definitions))
    table.add_row("subjects", Text(_first(document.subjects)))
    total = len(document.summaries)
    whole = sum(each.missing == 0 for each in document.summaries)
    color = "green" if whole == total else "yellow"
    table.add_row("measured", Text(f"{whole:,} of {total:,} on every subject", color))
    lacking = [f"{each.name} ({each.missing})" for each in document.summaries if each.missing]
    if lacking:
        table.add_row("", Text(f"without a value on some: {_first(lacking)}", "yellow"))
    return table
