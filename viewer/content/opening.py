"""Files that become bodies: those that are dropped on the page, and those that have changed."""

import os
import warnings
from dataclasses import replace
from pathlib import Path

from bodymeasure.viewer.content.requests import OpenFile
from bodymeasure.viewer.content.shown import ShownBody

from bodymeasure.atlas import check_sentences
from bodymeasure.errors import InputError, ReadWarning
from bodymeasure.formats import format_of, read_atlas
from bodymeasure.formats.options import ReadOptions
from bodymeasure.formats.registry import decode


def opened(request: OpenFile) -> ShownBody:
    """Return the body in a file that came with a request; it has no id yet.

    Raises
    ------
    InputError
        If it is none that can be read; for a mesh of triangles, what to do with it.
    """
    # The name is shown, and its ending says what the file holds; nothing is looked up by it.
    name = Path(request.name.replace("\\", "/")).name or "body"
    options = ReadOptions.checked(request.unit, None, None, (), None, None, False, False)
    with warnings.catch_warnings(record=True, action="always", category=ReadWarning) as noted:
        atlas = decode(request.content, name, format_of(Path(name)), options)
    notes = tuple(str(note.message) for note in noted if issubclass(note.category, ReadWarning))
    noticed = (*notes, *check_sentences(atlas))
    return ShownBody("", atlas, atlas.name or Path(name).stem, name, warnings=noticed)


def read_again(body: ShownBody) -> ShownBody:
    """Return a body as its file has it now.

    Raises
    ------
    InputError
        If it cannot be read any more.
    """
    if body.settings is None:
        raise InputError(f"{body.name}: was not opened from a file that can be read again")
    with warnings.catch_warnings(record=True, action="always", category=ReadWarning) as noted:
        atlas = read_atlas(body.file, **dict(body.settings))
    notes = tuple(str(note.message) for note in noted if issubclass(note.category, ReadWarning))
    known = body.differences if atlas.digest == body.atlas.digest else None
    noticed = (*notes, *check_sentences(atlas))
    return replace(body, atlas=atlas, version=body.version + 1, warnings=noticed, differences=known)


def may_write(path: str) -> bool:
    """Whether a file can be written to."""
    return os.access(path, os.W_OK)
