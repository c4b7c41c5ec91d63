"""Many scans fitted into one folder, each skipped that is done already."""

from collections import Counter
from collections.abc import Sequence
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from bodymeasure.cli.console import print_note
from bodymeasure.cli.fitting.done import Done, key_of
from bodymeasure.cli.fitting.files import page_of, write_fit
from bodymeasure.cli.fitting.scans import fitted, scan_files, scan_settings
from bodymeasure.errors import BodymeasureError, InputError, MissingExtraError
from bodymeasure.formats import read_atlas

if TYPE_CHECKING:
    from bodymeasure.atlas import Atlas


class NamedScan(NamedTuple):
    """A file of a scan by the name of its subject."""

    name: str
    path: Path


def named_scans(files: Sequence[str]) -> list[NamedScan]:
    """Return scans under the names of their files; equal ones are numbered.

    Raises
    ------
    InputError
        If a file is given twice.
    """
    paths = [Path(file) for file in files]
    places = Counter(path.resolve() for path in paths)
    for path in paths:
        if places[path.resolve()] > 1:
            raise InputError(f"{path}: is given twice; give every subject once")
    counts = Counter(path.stem for path in paths)
    taken = set(counts)
    found = []
    for path in paths:
        name = path.stem
        if counts[name] > 1:
            # Two files of one name in two folders are two subjects.
            numbered = (f"{path.stem} {number}" for number in count(1))
            name = next(each for each in numbered if each not in taken)
            taken.add(name)
        found.append(NamedScan(name, path))
    return found


class Batch:
    """Fits in a folder, and what has failed.

    Parameters
    ----------
    folder : Path
    page, pictures : bool
        Whether each fit has a page, and whether that has pictures.
    """

    def __init__(self, folder: Path, *, page: bool, pictures: bool) -> None:
        self.folder, self.page, self.pictures = folder, page, pictures
        self.done = Done(folder)
        self.fitted: dict[str, Atlas] = {}
        self.failures: dict[str, str] = {}
        self.skipped: set[str] = set()

    def fit(self, scan: NamedScan) -> "Atlas | None":
        """Return the atlas of a scan, as it is in the folder or made now; None if it fails."""
        path = self.folder / f"{scan.name}.atlas"
        try:
            key = key_of(scan_files(scan.path), scan_settings())
            files = (path, page_of(path)) if self.page else (path,)
            if self.done.has(key, *files):
                atlas = read_atlas(path)
                self.skipped.add(scan.name)
            else:
                body = fitted(scan.path, None)
                write_fit(body, path, page=self.page, pictures=self.pictures)
                self.done.add(key, *files)
                atlas = body.atlas
        except MissingExtraError:
            # It would be the same for all.
            raise
        except BodymeasureError as error:
            self.failures[scan.name] = str(error)
            return None
        self.fitted[scan.name] = atlas
        return atlas

    def result(self, name: str) -> str:
        """Return what became of a scan, in words."""
        if name in self.failures:
            return "failed"
        return "done before" if name in self.skipped else "fitted"

    def listed_failures(self) -> str:
        """Return the failures, each on its own line."""
        return "".join(f"\n  {name}: {reason}" for name, reason in self.failures.items())


def print_failures(batch: Batch) -> None:
    """Print what could not be fitted, each with the reason."""
    if batch.failures:
        total = len({*batch.failures, *batch.fitted})
        print_note(f"{len(batch.failures)} of {total} failed:{batch.listed_failures()}")


def fits_csv(batch: Batch, folder: Path) -> tuple[Path, ...]:
    """Write a row for each scan: what became of it, and how good the fit is."""
    from bodymeasure.report.files import write_files
    from bodymeasure.report.serial import csv_bytes

    columns = (
        "subject", "result", "distance_rms_m", "coverage", "uncovered_patches", "warnings", "reason"
    )  # fmt: skip
    rows: list[tuple[object, ...]] = []
    for name, atlas in batch.fitted.items():
        scan = atlas.scan
        assert scan is not None
        bare = "; ".join(atlas.patch_names[patch] for patch in scan.uncovered)
        mean = float(scan.coverage.mean())
        rows.append((name, "fitted", scan.rms, mean, bare, " ".join(scan.warnings), ""))
    rows += [(name, "failed", *[None] * 4, why) for name, why in batch.failures.items()]
    return write_files(folder, {"fits.csv": csv_bytes(columns, rows)})


def pages(batch: Batch) -> list[Path]:
    """Return the pages of the fits of a folder."""
    return [page_of(batch.folder / f"{name}.atlas") for name in batch.fitted]
