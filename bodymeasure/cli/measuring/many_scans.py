"""The charts of many bodies with scans among them, into a folder that a second run completes."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import msgspec

from bodymeasure.cli.console import print_files, print_note, print_table, progress_bar
from bodymeasure.cli.fitting.batch import Batch, NamedScan, named_scans, print_failures
from bodymeasure.cli.fitting.done import key_of
from bodymeasure.cli.fitting.scans import is_scan, scan_files, scan_settings
from bodymeasure.cli.inputs import load_sound_atlas, path_of_atlas, require_sound
from bodymeasure.cli.measuring.chart_tables import population_facts
from bodymeasure.cli.options import OWN, file_settings
from bodymeasure.errors import BodymeasureError, InputError, MissingExtraError
from bodymeasure.files import output_folder, read_bytes, write_bytes

if TYPE_CHECKING:
    from bodymeasure.chart import Definitions
    from bodymeasure.report.body import ChartDocument

EXIT_LACKING = 1


class Charting(NamedTuple):
    """What is measured, and how: everything that a value depends on besides the body."""

    definitions: "Definitions"
    unit: str
    only: Sequence[str]
    sensitivity: bool
    despite_errors: bool


def chart_scans(names: Sequence[str], folder: Path, charting: Charting, *, pictures: bool) -> int:
    """Chart bodies and scans one after another; what fails is listed, and the rest done.

    Returns
    -------
    int
        1 if a body failed or lacks a value that others have.

    Raises
    ------
    InputError
        If a file is given twice, or every body failed.
    """
    from bodymeasure.report.population import population_document, write_population_chart

    scans = named_scans([str(path_of_atlas(name)) for name in names])
    charts: dict[str, ChartDocument] = {}
    with output_folder(folder):
        batch = Batch(folder, page=True, pictures=pictures)
        for number, scan in enumerate(scans, start=1):
            print_note(f"{number} of {len(scans)}: {scan.path}", style="dim")
            found = _chart(scan, batch, charting)
            if found is not None:
                charts[scan.name] = found
        if not charts:
            raise InputError("no body could be charted:" + batch.listed_failures())
        document = population_document(
            list(charts), list(charts.values()), failures=dict(batch.failures)
        )
        files = write_population_chart(document, folder)
    print_table(population_facts(document))
    print_files(files)
    before = len(batch.skipped & charts.keys())
    if before:
        print_note(f"{before} of {len(scans)} were done before.", style="dim")
    print_failures(batch)
    lacking = any(each.missing for each in document.summaries)
    return EXIT_LACKING if batch.failures or lacking else 0


def _chart(scan: NamedScan, batch: Batch, charting: Charting) -> "ChartDocument | None":
    """Return the chart of one body, as it is in the folder or taken now; None if it fails."""
    from bodymeasure.chart import both_sides, measure_chart, restricted
    from bodymeasure.report.body import ChartDocument, chart_document
    from bodymeasure.report.serial import to_json

    path = batch.folder / f"{scan.name}.json"
    definitions, unit, only, sensitivity, despite_errors = charting
    try:
        key = key_of(
            scan_files(scan.path),
            {
                **file_settings(),
                **scan_settings(),
                "definitions": msgspec.to_builtins(definitions),
                "charted": [unit, list(only), sensitivity, despite_errors],
            },
        )
        if batch.done.has(key, path):
            batch.skipped.add(scan.name)
            return msgspec.json.decode(read_bytes(path), type=ChartDocument)
        if is_scan(str(scan.path)):
            atlas = batch.fit(scan)
            if atlas is None:
                return None
            require_sound(atlas, str(scan.path), despite_errors=despite_errors)
        else:
            atlas = load_sound_atlas(str(scan.path), despite_errors=despite_errors, if_none=True)
        total = len(both_sides(restricted(definitions, only)[0].measurement))
        with progress_bar(f"measuring {scan.name}", total) as progress:
            chart = measure_chart(
                atlas,
                definitions,
                only=only,
                sensitivity=sensitivity,
                progress=lambda done, _total: progress(done),
                # Errors that were to be refused have been.
                despite_errors=True,
            )
    except MissingExtraError:
        # It would be the same for all.
        raise
    except BodymeasureError as error:
        batch.failures[scan.name] = str(error)
        return None
    document = chart_document(chart, atlas.unit.value if unit == OWN else unit, subject=scan.name)
    write_bytes(path, to_json(document))
    batch.done.add(key, path)
    return document
