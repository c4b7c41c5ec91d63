"""Writing a benchmark's files."""

from pathlib import Path

from bodymeasure.bench.figure import error_against_time
from bodymeasure.bench.records import BenchDocument, to_csv
from bodymeasure.report.files import write_files
from bodymeasure.report.serial import indented_json


def write_benchmark(document: BenchDocument, folder: Path) -> tuple[Path, ...]:
    """Write two pictures, ``bench.json`` and ``bench.csv``, all or none.

    Parameters
    ----------
    document : BenchDocument
    folder : Path
        Made if it is not there; files of these names in it are replaced.

    Returns
    -------
    tuple of Path
        The files, the pictures first: ``error_against_time.svg`` of methods on patches, and
        ``bodies.svg`` of measurements of a body.

    Raises
    ------
    MissingExtraError
        If matplotlib is not installed.
    InputError
        If the folder cannot be made or written to, or the disk is full.
    """
    return write_files(
        folder,
        {
            "error_against_time.svg": error_against_time(document, on="patches"),
            "bodies.svg": error_against_time(document, on="body"),
            "bench.json": indented_json(document),
            "bench.csv": to_csv(document),
        },
    )
