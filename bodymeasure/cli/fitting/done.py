"""What is done already in a folder of many bodies, so that a second run goes on from there."""

import hashlib
from collections.abc import Mapping
from pathlib import Path

import msgspec

from bodymeasure.files import read_bytes, write_bytes
from bodymeasure.measure import package_versions

FILE = "done.json"


class Done:
    """The list of the bodies that a folder holds, each with a key of what it was made from.

    The files of a body are written before its name is, and the list is replaced as a whole, so that
    a run that is killed leaves nothing half-written.

    Parameters
    ----------
    folder : Path
    """

    def __init__(self, folder: Path) -> None:
        self.path = folder / FILE
        self.keys: dict[str, str] = {}
        if self.path.is_file():
            try:
                self.keys = msgspec.json.decode(read_bytes(self.path), type=dict[str, str])
            except msgspec.DecodeError:
                # Somebody else's file, or a damaged one: everything is done again.
                self.keys = {}

    def has(self, key: str, *files: Path) -> bool:
        """Whether files are there that were made with a key."""
        return all(self.keys.get(file.name) == key and file.is_file() for file in files)

    def add(self, key: str, *files: Path) -> None:
        """Note that files have been made with a key."""
        self.keys |= dict.fromkeys((file.name for file in files), key)
        write_bytes(
            self.path, msgspec.json.format(msgspec.json.encode(self.keys), indent=1) + b"\n"
        )


def key_of(files: tuple[Path, ...], settings: Mapping[str, object]) -> str:
    """Return a key of the content of files and of settings, equal if the result will be.

    Raises
    ------
    InputError
        If a file cannot be read.
    """
    parts = [hashlib.sha256(read_bytes(file)).digest() for file in files]
    versions = package_versions()
    parts.append(msgspec.json.encode({**settings, "versions": versions}, order="deterministic"))
    return hashlib.sha256(b"\0".join(parts)).hexdigest()
