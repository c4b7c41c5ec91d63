"""Many bodies in one file ``.npz``: coefficients, vertices, or control points of one layout."""

import hashlib
from collections.abc import Sequence
from pathlib import Path

from bodymeasure._typing import Array
from bodymeasure.atlas import GivenLength
from bodymeasure.errors import InputError
from bodymeasure.fit.model import body_model
from bodymeasure.formats import npz
from bodymeasure.surveys.bodies.files import seen_from
from bodymeasure.surveys.bodies.held import PointsBody, ShapeBody, VerticesBody
from bodymeasure.surveys.bodies.rows import NpzFile, Rows
from bodymeasure.surveys.bodies.surveyed import Body, Layout, unique_names

# The arrays that each of the three kinds of files may have; the first holds the bodies.
KINDS = {
    "coefficients": ({"coefficients"}, {"names"}),
    "vertices": ({"vertices"}, {"names"}),
    "points": (set(npz.KINDS) - npz.OPTIONAL, set(npz.OPTIONAL)),
}
EXPECTED = (
    "expected `coefficients` (bodies, k) of the space of bodies, or `vertices` (bodies, 13380, 3) "
    "of its mesh in meters, with `names` or without, or what bodymeasure.write_population writes"
)
BLOCK = 1 << 20


class Population:
    """The bodies of a file.

    Parameters
    ----------
    file : NpzFile
    rows : Rows
        The coefficients, vertices or control points.
    kind : str
        One of `KINDS`.
    folder : Path
        The folder of the survey, from which tables name the file.
    """

    def __init__(self, file: NpzFile, rows: Rows, kind: str, folder: Path) -> None:
        self._file, self._rows, self._kind = file, rows, kind
        self.layout: Layout = None
        self._given: list[dict[str, GivenLength]] = []
        path = file.path
        names = [""] * len(rows)
        if kind == "points":
            others = {name: file.small(name) for name in file.names if name != "points"}
            if len(rows.shape) != 3:
                raise InputError(f"{path}: points have shape {rows.shape}; expected (bodies, n, 3)")
            try:
                self.layout, names, self._given = npz.first_body(
                    others, rows.between(0, 1)[0], rows.shape
                )
            except InputError as error:
                raise InputError(f"{path}: {error}") from None
        elif "names" in file.names:
            given = file.small("names")
            if given.shape != (len(rows),) or given.dtype.kind != "U":
                raise InputError(
                    f"{path}: names are {given.dtype} of shape {given.shape}; expected "
                    f"{len(rows)} texts, one for each body"
                )
            names = given.tolist()
        numbered = enumerate(names, start=1)
        self._names = tuple(
            unique_names([name or f"{path.stem} {number}" for number, name in numbered])
        )
        self._source = seen_from(path.resolve(), folder.resolve())

    def __len__(self) -> int:
        return len(self._rows)

    def identity(self) -> dict[str, object]:
        """Return the digest of the file."""
        digest = hashlib.sha256()
        with self._file.path.open("rb") as file:
            while block := file.read(BLOCK):
                digest.update(block)
        return {"population": len(self), "SHA-256": digest.hexdigest()}

    def between(self, start: int, stop: int) -> Sequence[Body]:
        """Return some of the bodies."""
        rows = self._rows.between(start, stop)
        return [self._body(start + place, row) for place, row in enumerate(rows)]

    def _body(self, number: int, row: Array) -> Body:
        name, source = self._names[number], f"{self._source}#{number + 1}"
        if self._kind == "coefficients":
            return ShapeBody(name, source, row)
        if self._kind == "vertices":
            return VerticesBody(name, source, row)
        return PointsBody(name, source, row, self._given[number])


def is_population(path: Path, *, alone: bool = False) -> bool:
    """Whether a file holds many bodies, rather than one atlas.

    One that is given alone and is neither was meant to, and is refused when it is opened.
    """
    if path.suffix.lower() != ".npz" or not path.is_file():
        return False
    try:
        with NpzFile(path) as file:
            if "points" not in file.names:
                return alone or bool(file.names & {"coefficients", "vertices"})
            shape = file.rows("points").shape
            return len(shape) == 3 and shape[0] > 1
    except InputError:
        # Among others, it fails by itself.
        return alone


def open_population(path: Path, folder: Path) -> Population:
    """Return the bodies of a file.

    Parameters
    ----------
    path : Path
    folder : Path
        The folder of the survey, from which tables name the file.

    Raises
    ------
    InputError
        If it is missing, damaged or of another kind; the message says what was expected.
    """
    file = NpzFile(path)
    try:
        kind = next((kind for kind in KINDS if kind in file.names), "")
        needed, optional = KINDS.get(kind, (set(), set()))
        if not kind or not needed <= file.names <= needed | optional:
            listed = ", ".join(sorted(file.names)) or "nothing"
            raise InputError(f"{path}: holds {listed}; {EXPECTED}")
        rows = file.rows(kind)
        model = body_model()
        if kind == "vertices" and rows.shape[1:] != model.mean.shape:
            raise InputError(f"{path}: vertices have shape {rows.shape}; {EXPECTED}")
        most = len(model.components)
        if kind == "coefficients" and (len(rows.shape) != 2 or rows.shape[1] > most):
            raise InputError(
                f"{path}: coefficients have shape {rows.shape}; expected (bodies, k) with k from 1 "
                f"to {most}"
            )
        return Population(file, rows, kind, folder)
    except BaseException:
        file.close()
        raise
