"""NumPy's ``.npz``, for large atlases and for many bodies with the same patches.

The arrays are `points`, shape (n, 3) or (bodies, n, 3); `index`, shape (patches, 4, 4); `weights`
of rational patches, of the same shape; `distance` and `stretch` of an approximation, shape
(patches,); `corners` of patches on the faces of the file that they were read from, shape
(patches, 3, 2); and `header`, a text with everything else in JSON. Nothing is unpickled.
"""

import io
from collections.abc import Mapping, Sequence
from dataclasses import astuple, replace
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.atlas import (
    Approximation,
    ApproximationKind,
    Atlas,
    AtlasPoint,
    Axes,
    FileFaces,
    GivenLength,
    ScanFit,
    Unit,
)
from bodymeasure.errors import InputError
from bodymeasure.formats.scan_record import ScanRecord, record_of, scan_of
from bodymeasure.npz_arrays import npz_arrays

FORMAT = "bodymeasure atlas"
VERSION = 1
# The kinds of values that each array may hold, as NumPy codes them.
KINDS = {
    "header": "U",
    "index": "iu",
    "points": "f",
    "weights": "f",
    "distance": "f",
    "stretch": "f",
    "corners": "f",
}
# The arrays that some files lack: weights, the deviation of an approximation, and the parameters of
# faces.
_DEVIATION = ("distance", "stretch")
OPTIONAL = frozenset({"weights", *_DEVIATION, "corners"})


class _Header(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True):
    format: str
    version: int
    unit: str
    up: str
    front: str
    patch_names: list[str]
    regions: list[str]
    landmarks: dict[str, tuple[int, float, float]]
    names: list[str]
    provenance: dict[str, str]
    # The kind of an approximation and its numbers on the mesh, in the order of `Approximation`.
    approximation: tuple[ApproximationKind, float, float, float] | None = None
    # The face of each patch, and faces without parameters.
    faces: list[str] | None = None
    faces_without_parameters: dict[str, str] = {}
    scan: ScanRecord | None = None
    # The given lengths of each body by their keys: value, both errors and origin.
    given: list[dict[str, tuple[float, float, float, str]]] = []


def read(content: bytes, source: str) -> Atlas:
    """The atlas in a file's content; `source` names the file in errors."""
    atlases = read_bodies(content, source)
    if len(atlases) > 1:
        raise InputError(
            f"{source}: holds {len(atlases)} bodies; expected one; read them all with "
            "bodymeasure.read_population, and write the one that is wanted"
        )
    return atlases[0]


def read_bodies(content: bytes, source: str) -> tuple[Atlas, ...]:
    """All atlases in a file's content."""
    arrays = npz_arrays(content, source, KINDS, OPTIONAL)
    try:
        points = arrays["points"]
        bodies = points[None] if points.ndim == 2 else points
        if bodies.ndim != 3 or not len(bodies):
            raise InputError(f"points have shape {points.shape}; expected (bodies, n, 3)")
        first, names, given = first_body(arrays, bodies[0], bodies.shape)
        rest = zip(bodies[1:], names[1:], strict=True)
        every = (first, *(replace(first, points=each, name=name) for each, name in rest))
        return tuple(replace(one, given=lengths) for one, lengths in zip(every, given, strict=True))
    except InputError as error:
        raise InputError(f"{source}: {error}") from None


def first_body(
    arrays: Mapping[str, NDArray[Any]], points: Array, shape: tuple[int, ...]
) -> tuple[Atlas, list[str], list[dict[str, GivenLength]]]:
    """Return the first body of a file, and the names and given lengths of all.

    The others differ from it in nothing else but their points.

    Parameters
    ----------
    arrays : mapping of str to ndarray
        All but the points.
    points : ndarray, shape (n, 3)
        Those of the first body.
    shape : tuple of int
        That of the points of all bodies, (bodies, n, 3).

    Raises
    ------
    InputError
        If the header is wrong, or of another number of bodies.
    """
    try:
        header = msgspec.json.decode(str(arrays["header"][()]).encode(), type=_Header)
    except (msgspec.DecodeError, UnicodeError) as error:
        raise InputError(f"its header is wrong: {error}") from None
    if (header.format, header.version) != (FORMAT, VERSION):
        raise InputError(
            f"has format {header.format!r}, version {header.version}; this bodymeasure reads "
            f"{FORMAT!r}, version {VERSION}"
        )
    count = shape[0]
    if count != len(header.names):
        raise InputError(
            f"points have shape {shape}, for {len(header.names)} names of bodies; expected "
            "(bodies, n, 3)"
        )
    if len(header.given) not in (0, count):
        raise InputError(
            f"holds given lengths of {len(header.given)} bodies; expected those of all "
            f"{count}, or none"
        )
    first = Atlas(
        points,
        arrays["index"],
        Unit.parse(header.unit),
        tuple(header.patch_names),
        tuple(header.regions),
        {name: AtlasPoint(*place) for name, place in header.landmarks.items()},
        Axes(header.up, header.front),
        header.names[0],
        header.provenance,
        arrays.get("weights"),
        _approximation(header, arrays),
        _faces(header, arrays),
        scan_of(header.scan),
    )
    given = [
        {key: GivenLength(*length) for key, length in lengths.items()}
        for lengths in header.given or [{}] * count
    ]
    return first, header.names, given


def write(atlas: Atlas) -> bytes:
    """An atlas as the content of a file, without loss."""
    return write_bodies([atlas])


def write_bodies(atlases: Sequence[Atlas]) -> bytes:
    """Atlases that differ in their points and names alone as the content of a file."""
    if not atlases:
        raise InputError("no atlas to write; expected at least one")
    first = atlases[0]
    for number, atlas in enumerate(atlases):
        for field in ("unit", "patch_names", "regions", "landmarks", "axes", "provenance"):
            if getattr(atlas, field) != getattr(first, field):
                raise InputError(
                    f"atlas {number} ({atlas.name!r}) has other {field} than the first; expected "
                    "the same patches, landmarks, unit and axes in all; write it to its own file"
                )
        if not (
            np.array_equal(atlas.index, first.index)
            and len(atlas.points) == len(first.points)
            and _same(atlas.weights, first.weights)
        ):
            raise InputError(
                f"atlas {number} ({atlas.name!r}) has another index or other weights than the "
                "first; expected the same patches in all; write it to its own file"
            )
        if not _same_approximation(atlas.approximation, first.approximation):
            raise InputError(
                f"atlas {number} ({atlas.name!r}) approximates its surface in another way than the "
                "first; expected the same numbers in all; write it to its own file"
            )
        if not _same_scan(atlas.scan, first.scan):
            raise InputError(
                f"atlas {number} ({atlas.name!r}) was fitted to another scan than the first, or to "
                "none; expected the same in all; write it to its own file"
            )
        if not _same_faces(atlas.faces, first.faces):
            raise InputError(
                f"atlas {number} ({atlas.name!r}) has other faces of a file than the first; "
                "expected the same in all; write it to its own file"
            )
    header = _Header(
        FORMAT,
        VERSION,
        first.unit.value,
        first.axes.up,
        first.axes.front,
        list(first.patch_names),
        list(first.regions),
        {name: (p.patch, p.u, p.v) for name, p in first.landmarks.items()},
        [atlas.name for atlas in atlases],
        dict(first.provenance),
        _summary(first.approximation),
        None if first.faces is None else list(first.faces.names),
        {} if first.faces is None else dict(first.faces.without),
        None if first.scan is None else record_of(first.scan),
        [
            {key: astuple(length) for key, length in atlas.given.items()}
            for atlas in (atlases if any(atlas.given for atlas in atlases) else ())
        ],
    )
    try:
        text = msgspec.json.encode(header).decode()
    except UnicodeEncodeError:
        raise InputError(
            "a name holds what is no character; expected text that UTF-8 can write"
        ) from None
    buffer = io.BytesIO()
    arrays: dict[str, Any] = {
        "points": np.stack([atlas.points for atlas in atlases]),
        "index": first.index,
        "header": np.array(text),
    }
    if first.weights is not None:
        arrays["weights"] = first.weights
    if first.approximation is not None:
        arrays["distance"] = first.approximation.distance
        arrays["stretch"] = first.approximation.stretch
    if first.faces is not None:
        arrays["corners"] = first.faces.corners
    np.savez_compressed(buffer, **arrays)
    return buffer.getvalue()


def _same(first: Array | None, second: Array | None) -> bool:
    if first is None or second is None:
        return first is second
    return np.array_equal(first, second)


def _same_approximation(first: Approximation | None, second: Approximation | None) -> bool:
    return first is second if first is None else first.is_same(second)


def _same_scan(first: ScanFit | None, second: ScanFit | None) -> bool:
    return first is second if first is None else first.is_same(second)


def _same_faces(first: FileFaces | None, second: FileFaces | None) -> bool:
    return first is second if first is None else first.is_same(second)


def _summary(
    approximation: Approximation | None,
) -> tuple[ApproximationKind, float, float, float] | None:
    if approximation is None:
        return None
    kind, distance = approximation.kind, approximation.mesh_distance
    return kind, distance, approximation.mesh_rms, approximation.mesh_lengths


def _approximation(header: _Header, arrays: Mapping[str, NDArray[Any]]) -> Approximation | None:
    there = arrays.keys() & {*_DEVIATION}
    if header.approximation is None and not there:
        return None
    if header.approximation is None or len(there) < 2:
        raise InputError("holds a part of an approximation; expected all of it, or none")
    kind, *numbers = header.approximation
    return Approximation(kind, arrays["distance"], arrays["stretch"], *numbers)


def _faces(header: _Header, arrays: Mapping[str, NDArray[Any]]) -> FileFaces | None:
    if header.faces is None and "corners" not in arrays:
        return None
    if header.faces is None or "corners" not in arrays:
        raise InputError("holds a part of the parameters of faces; expected all of it, or none")
    return FileFaces(tuple(header.faces), arrays["corners"], header.faces_without_parameters)
