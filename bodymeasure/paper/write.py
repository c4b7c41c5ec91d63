"""The files of a reproduction."""

from pathlib import Path
from typing import Final

from bodymeasure.paper.page.page import render_page
from bodymeasure.paper.page.summary import render_summary
from bodymeasure.paper.reproduction import Reproduction
from bodymeasure.paper.tables.table import to_csv, to_record
from bodymeasure.report.files import write_files
from bodymeasure.report.serial import indented_json

SCHEMA: Final = "bodymeasure paper"
VERSION: Final = 1


def write_reproduction(found: Reproduction, folder: Path) -> tuple[Path, ...]:
    """Write ``paper.html``, ``summary.md``, ``tables.json`` and ``tables.csv``: all or none.

    Parameters
    ----------
    found : Reproduction
    folder : Path
        Made if it is not there; files of these names in it are replaced.

    Returns
    -------
    tuple of Path
        The files, the page first.

    Raises
    ------
    MissingExtraError
        If jinja2 or matplotlib is not installed.
    InputError
        If the folder cannot be made or written to, or the disk is full.
    """
    return write_files(
        folder,
        {
            "paper.html": render_page(found),
            "summary.md": render_summary(found),
            "tables.json": to_json(found),
            "tables.csv": to_csv(found.tables),
        },
    )


def to_json(found: Reproduction) -> bytes:
    """Return all tables with the seed, versions and times; every float round-trips."""
    document = {
        "schema": SCHEMA,
        "version": VERSION,
        "settings": {
            "seed": found.settings.seed,
            "quick": found.settings.quick,
            "processes": found.settings.processes,
            "patches_a_set": found.settings.group_size,
        },
        "versions": found.versions,
        "seconds": found.seconds,
        "tables": {table.name: to_record(table) for table in found.tables},
    }
    return indented_json(document)
