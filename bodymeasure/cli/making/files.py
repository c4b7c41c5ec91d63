"""The files that `bodymeasure make` writes."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from bodymeasure.arguments import repeated
from bodymeasure.errors import InputError

if TYPE_CHECKING:
    from bodymeasure.make import MadeBody

SUFFIX = ".atlas"
# What the names of files must not hold on any system.
_UNSAFE = re.compile(r"[^\w+.,=\- ]+")


@dataclass(frozen=True)
class FileNames:
    """Where bodies are written.

    Parameters
    ----------
    folder : Path
    single : Path or None
        The file, if there is one body.
    """

    folder: Path
    single: Path | None

    def path_of(self, name: str) -> Path:
        """Return the file of a body."""
        return self.single or self.folder / f"{_plain(name)}{SUFFIX}"


def file_names(names: Sequence[str], output: Path | None, *, several: bool) -> FileNames:
    """Return where bodies are written.

    Raises
    ------
    InputError
        If the output is not a folder or an .atlas file, as their number asks.
    """
    if several:
        folder = Path("made") if output is None else output
        if folder.suffix.lower() == SUFFIX:
            raise InputError(f"{folder}: there are several bodies; expected a folder for them")
        if (twice := repeated(map(_plain, names))) is not None:
            raise InputError(
                f"two bodies would be written to {twice}{SUFFIX}; give them names that differ "
                "in letters and digits"
            )
        return FileNames(folder, None)
    path = Path(f"{_plain(names[0])}{SUFFIX}") if output is None else output
    if path.suffix.lower() != SUFFIX:
        if path.suffix and not path.is_dir():
            raise InputError(f"{path}: expected a name that ends in {SUFFIX}, or a folder")
        path = path / f"{_plain(names[0])}{SUFFIX}"
    return FileNames(path.parent, path)


def _plain(name: str) -> str:
    return _UNSAFE.sub("_", name).strip(" .") or "body"


def atlas_content(body: "MadeBody") -> bytes:
    """Return the .atlas file of a body."""
    from bodymeasure.formats.atlas_json import write

    return write(body.atlas)


def values_content(made: "dict[str, MadeBody]", path: Path) -> bytes:
    """Return the charts of bodies with the deviation of each value, as CSV or JSON."""
    from bodymeasure.make.records import made_document, made_to_csv
    from bodymeasure.report.serial import to_json

    document = made_document(made)
    return made_to_csv(document) if path.suffix.lower() == ".csv" else to_json(document)
