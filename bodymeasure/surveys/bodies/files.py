"""Bodies in files of their own: atlases, and scans to which a body is fitted."""

import hashlib
import os
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from bodymeasure.atlas import Atlas
from bodymeasure.errors import InputError, ReadWarning
from bodymeasure.files import read_bytes
from bodymeasure.fit import fit_body
from bodymeasure.fit.by_topology import topology_of
from bodymeasure.fit.fit import KNOWN
from bodymeasure.formats import EXTENSIONS, format_of, read_atlas
from bodymeasure.formats.obj.triangles import TRIANGLE_MESHES, is_of_triangles
from bodymeasure.samples import sample_names, sample_path
from bodymeasure.surveys.bodies.surveyed import Asked, Body, Layout, unique_names

# What a user may say about a file, and what of it a format may have itself: those with landmarks
# are bodymeasure's own, which have axes, too.
SETTINGS = {"unit": "unit", "up": "landmarks", "front": "landmarks"}


@dataclass(frozen=True, eq=False)
class FileBody:
    """A body in a file.

    Parameters
    ----------
    name : str
    source : str
        The file as tables name it.
    path : Path
    settings : mapping of str to str or bool
        What the user says about all files: unit, up and front, where a file does not say so itself;
        topology of scans; quads, to make patches of triangles.
    """

    name: str
    source: str
    path: Path
    settings: Mapping[str, Any] = field(default_factory=dict)

    def atlas(self, asked: Asked) -> Atlas:  # noqa: ARG002
        """Return the atlas in the file, or that of the body which is fitted to a scan."""
        # A note about each of thousands of files is read by nobody; `bodymeasure info` says it.
        with warnings.catch_warnings(action="ignore", category=ReadWarning):
            if self._is_scan():
                return fit_body(
                    self.path,
                    file_unit=self.settings.get("unit"),
                    up=self.settings.get("up"),
                    front=self.settings.get("front"),
                    topology=self.settings.get("topology", KNOWN),
                ).atlas
            kept = format_of(self.path).keeps
            given = {
                name: self.settings[name]
                for name, had in SETTINGS.items()
                if name in self.settings and had not in kept
            }
            return read_atlas(self.path, quads=bool(self.settings.get("quads")), **given)

    def _is_scan(self) -> bool:
        """Whether the file is a triangle mesh, or quads of a model that is known."""
        suffix = self.path.suffix.lower()
        if suffix != ".obj" or self.settings.get("quads"):
            return suffix in TRIANGLE_MESHES
        if "topology" in self.settings:
            return True
        lines = read_bytes(self.path).splitlines()
        sizes = np.array([len(line.split()) - 1 for line in lines if line[:2] in (b"f ", b"f\t")])
        return len(sizes) > 0 and (is_of_triangles(sizes) or topology_of(self.path) is not None)


class Files:
    """Files as the bodies of a survey.

    Parameters
    ----------
    paths : sequence of Path
    folder : Path
        The folder of the survey, from which tables name the files.
    settings : mapping
        See `FileBody`.
    """

    layout: Layout = None

    def __init__(self, paths: Sequence[Path], folder: Path, settings: Mapping[str, Any]) -> None:
        self._paths, self._settings = tuple(paths), dict(settings)
        self._names = tuple(unique_names([path.stem for path in paths]))
        self._sources = tuple(seen_from(path, folder) for path in paths)

    def __len__(self) -> int:
        return len(self._paths)

    def identity(self) -> dict[str, object]:
        """Return a digest of the files' names, sizes and times, and what the user says of them."""
        digest = hashlib.sha256()
        for name, path in zip(self._names, self._paths, strict=True):
            try:
                at = path.stat()
                told: tuple[object, ...] = (name, str(path), at.st_size, at.st_mtime_ns)
            except OSError:
                # It fails by itself, and with it nothing else.
                told = (name, str(path))
            digest.update(repr(told).encode("utf-8", "surrogatepass"))
        return {"files": len(self), "SHA-256": digest.hexdigest(), "settings": self._settings}

    def between(self, start: int, stop: int) -> Sequence[Body]:
        """Return some of the bodies."""
        names, sources = self._names[start:stop], self._sources[start:stop]
        chosen = zip(names, sources, self._paths[start:stop], strict=True)
        return [FileBody(name, source, path, self._settings) for name, source, path in chosen]


def seen_from(path: Path, folder: Path) -> str:
    """Return a path from a folder, so that both may be moved together; or the whole path."""
    try:
        return Path(os.path.relpath(path, folder)).as_posix()
    except ValueError:  # on another drive
        return path.as_posix()


def file_bodies(names: Sequence[str | Path], folder: Path, settings: Mapping[str, Any]) -> Files:
    """Return the bodies of files, of folders of such files, and of samples by their names.

    A file that is no body is no error here: it fails when it is measured, and the others do not.

    Raises
    ------
    InputError
        If there is no file, one is given twice, or a folder holds none.
    """
    paths = [path for name in names for path in _paths(name)]
    if not paths:
        raise InputError("there is no body to survey; expected at least one")
    seen: set[Path] = set()
    for path in paths:
        if path in seen:
            raise InputError(f"{path}: is given twice; give every subject once")
        seen.add(path)
    return Files(paths, folder.resolve(), settings)


def _paths(name: str | Path) -> list[Path]:
    path = Path(name)
    if str(name) in sample_names() and not path.is_file():
        return [sample_path(str(name)).resolve()]
    if not path.is_dir():
        if not path.exists():
            raise InputError(
                f"{name}: no such file or folder, and no sample of that name; check the path "
                "(`bodymeasure samples` lists the samples)"
            )
        return [path.resolve()]
    # The values of charts, in .json, may lie beside the bodies.
    suffixes = {*EXTENSIONS, *TRIANGLE_MESHES} - {".json"}
    found = sorted(file for file in path.iterdir() if file.suffix.lower() in suffixes)
    if not found:
        raise InputError(
            f"{name}: is a folder without an atlas or a scan; give a file, or such a folder"
        )
    return [file.resolve() for file in found]
