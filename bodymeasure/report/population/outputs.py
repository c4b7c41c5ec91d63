"""The files of several bodies: the page, and tables for programs."""

from pathlib import Path

from bodymeasure.report.files import write_files
from bodymeasure.report.population.page import render_population
from bodymeasure.report.population.records import PopulationDocument
from bodymeasure.report.population.tables import long_csv, summary_csv, wide_csv
from bodymeasure.report.serial import schema_bytes, to_json


def write_population_chart(document: PopulationDocument, folder: Path | str) -> tuple[Path, ...]:
    """Write ``population.html``, tables as CSV, and ``measurements.json``: all or none.

    Parameters
    ----------
    document : PopulationDocument
    folder : Path or str
        Made if it is not there; files of these names in it are replaced.

    Returns
    -------
    tuple of Path
        The files, the page first.

    Raises
    ------
    MissingExtraError
        If jinja2 is not installed.
    InputError
        If the folder cannot be made or written to, or the disk is full.
    """
    contents = {
        "population.html": render_population(document),
        "wide.csv": wide_csv(document),
        "summary.csv": summary_csv(document),
        "measurements.csv": long_csv(document),
        "measurements.json": to_json(document),
        "measurements.schema.json": schema_bytes(type(document)),
    }
    return write_files(folder, contents)
