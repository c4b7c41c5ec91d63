"""What a survey was asked for, so that another one does not go on in its folder."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import msgspec

from bodymeasure.errors import InputError
from bodymeasure.files import read_bytes, write_bytes
from bodymeasure.report.serial import indented_json

FILE = "survey.json"
FORMAT = "bodymeasure survey settings"
# What a person is told differs, by the members of the settings.
WORDS = {
    "bodies": "other bodies, or files that have changed since",
    "definitions": "other definitions of measurements",
    "only": "other measurements",
    "unit": "another unit",
    "despite_errors": "another choice about bodies with errors",
    "versions": "other versions of bodymeasure, NumPy or SciPy",
}


def agree_on_settings(folder: Path, settings: Mapping[str, Any]) -> bool:
    """Write the settings into a folder, or find that they are there already.

    Parameters
    ----------
    folder : Path
    settings : mapping
        With the members of `WORDS`, and others that may change.

    Returns
    -------
    bool
        Whether a survey was begun there before.

    Raises
    ------
    InputError
        If the folder holds a survey with other settings.
    """
    path = folder / FILE
    wanted = msgspec.json.decode(msgspec.json.encode({"format": FORMAT, **settings}))
    if path.exists():
        found = read_settings(path)
        differing = [words for name, words in WORDS.items() if found.get(name) != wanted[name]]
        if differing:
            raise InputError(
                f"{folder}: holds a survey of {'; '.join(differing)}; choose another folder, or "
                "remove this one"
            )
        return True
    write_bytes(path, indented_json(wanted))
    return False


def read_settings(path: Path) -> dict[str, Any]:
    """Return the settings in a file.

    Raises
    ------
    InputError
        If the file is none of settings.
    """
    try:
        found = msgspec.json.decode(read_bytes(path), type=dict[str, Any])
    except msgspec.DecodeError:
        found = {}
    if found.get("format") != FORMAT:
        raise InputError(
            f"{path}: is no file of `bodymeasure survey`; choose another folder, or remove it"
        )
    return found
