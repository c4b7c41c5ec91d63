"""Which format reads and writes which extension."""

from __future__ import annotations

from collections.abc import Callable
from os import PathLike
from pathlib import Path
from typing import NamedTuple

from bodymeasure.atlas import Atlas
from bodymeasure.errors import InputError
from bodymeasure.files import read_bytes, write_bytes
from bodymeasure.formats import native


class Format(NamedTuple):
    """A file format: its name, and how bytes become an atlas and back."""

    name: str
    read: Callable[[bytes, str], Atlas]
    write: Callable[[Atlas], bytes]


FORMATS = {".atlas": Format("bodymeasure atlas", native.read, native.write)}


def read_atlas(path: str | PathLike[str]) -> Atlas:
    """Read an atlas from a file; the extension tells the format.

    Parameters
    ----------
    path : path-like
        A ``.atlas`` file; README.md documents the format.

    Returns
    -------
    Atlas

    Raises
    ------
    InputError
        If the file is missing, unreadable or not a valid atlas. The message names the file and the
        place in it.
    """
    path = Path(path)
    # First the content: of a missing file or a folder, the extension is beside the point.
    content = read_bytes(path)
    return _format(path).read(content, str(path))


def write_atlas(atlas: Atlas, path: str | PathLike[str]) -> None:
    """Write an atlas to a file, without loss; the extension tells the format.

    Parameters
    ----------
    atlas : Atlas
    path : path-like

    Raises
    ------
    InputError
        If the extension is unknown or the file cannot be written; nothing half-written is left.
    """
    path = Path(path)
    write_bytes(path, _format(path).write(atlas))


def _format(path: Path) -> Format:
    try:
        return FORMATS[path.suffix.lower()]
    except KeyError:
        known = ", ".join(FORMATS)
        raise InputError(
            f"{path}: unknown kind of file {path.suffix!r}; expected one of {known}"
        ) from None
