"""The charts of several bodies as one table."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from bodymeasure.cli.console import print_files, print_table
from bodymeasure.cli.measuring.chart_tables import population_facts, print_population
from bodymeasure.cli.measuring.subjects import Subject
from bodymeasure.files import output_folder

if TYPE_CHECKING:
    from bodymeasure.report.body import ChartDocument

EXIT_LACKING = 1


def chart_several(
    bodies: Sequence[Subject],
    charting: Callable[[], list["ChartDocument"]],
    output: Path | None,
    form: str | None,
) -> int:
    """Chart several bodies; return 1 if a subject lacks a value that others have."""
    from bodymeasure.report.population import population_document, write_population_chart

    names = [name for name, _ in bodies]
    if output is None:
        document = population_document(names, charting())
        print_population(document, form or "table")
    else:
        with output_folder(output):
            document = population_document(names, charting())
            files = write_population_chart(document, output)
        print_table(population_facts(document))
        print_files(files)
    return EXIT_LACKING if any(each.missing for each in document.summaries) else 0
