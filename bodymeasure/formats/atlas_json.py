"""The native format: JSON, extension ``.atlas``, read and written without loss."""

import codecs
import json
from collections.abc import Sequence
from typing import Annotated, Any

import msgspec
import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import (
    LARGEST_DEGREE,
    LEAST_DEGREE,
    Approximation,
    ApproximationKind,
    Atlas,
    AtlasPoint,
    Axes,
    FileFaces,
    GivenLength,
    Unit,
)
from bodymeasure.errors import InputError
from bodymeasure.formats.json_faults import place_of_fault
from bodymeasure.formats.scan_record import ScanRecord, record_of, scan_of

FORMAT = "bodymeasure atlas"
VERSION = 1

_Number = Annotated[int, msgspec.Meta(ge=0, le=2**31 - 1)]
_Point = tuple[float, float, float]
_Pair = tuple[float, float]


class _PatchRecord(msgspec.Struct, forbid_unknown_fields=True):
    name: str
    points: list[list[_Number]]
    region: str = ""
    weights: list[list[float]] | None = None
    distance: float = 0.0
    stretch: float = 0.0
    face: str = ""
    corners: tuple[_Pair, _Pair, _Pair] | None = None


class _ApproximationRecord(msgspec.Struct, forbid_unknown_fields=True):
    kind: ApproximationKind
    mesh_distance: float
    mesh_rms: float
    mesh_lengths: float


class _LandmarkRecord(msgspec.Struct, forbid_unknown_fields=True):
    patch: str
    u: float
    v: float


class _GivenRecord(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True):
    value: float
    error_estimate: float = 0.0
    uncertainty: float = 0.0
    origin: str = ""


class _AxesRecord(msgspec.Struct, forbid_unknown_fields=True):
    up: str
    front: str


class _AtlasRecord(msgspec.Struct, forbid_unknown_fields=True):
    format: str
    version: int
    unit: str
    axes: _AxesRecord
    patches: list[_PatchRecord]
    points: list[_Point]
    name: str = ""
    provenance: dict[str, str] = {}
    landmarks: dict[str, _LandmarkRecord] = {}
    degree: int = LEAST_DEGREE
    approximation: _ApproximationRecord | None = None
    faces_without_parameters: dict[str, str] = {}
    scan: ScanRecord | None = None
    given: dict[str, _GivenRecord] = {}


class _Header(msgspec.Struct):
    """The fields that are read first, so that another version is not reported as a wrong field."""

    format: str | None = None
    version: int | None = None
    unit: Any = None


def read(content: bytes, source: str) -> Atlas:
    """The atlas in a file's content; `source` names the file in errors."""
    # Some editors put a byte order mark in front.
    content = content.removeprefix(codecs.BOM_UTF8)
    if not content.strip():
        raise InputError(f"{source}: is empty; expected a {FORMAT} file")
    try:
        _check_header(msgspec.json.decode(content, type=_Header), source)
        record = msgspec.json.decode(content, type=_AtlasRecord)
    except msgspec.ValidationError as error:
        place = _place_of_misfit(content) or str(error)
        remedy = "`bodymeasure docs atlas_format` describes the format"
        raise InputError(f"{source}: {place}; {remedy}") from None
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise InputError(f"{source}{place_of_fault(content, str(error))}") from None
    try:
        return _atlas(record)
    except InputError as error:
        raise InputError(f"{source}: {error}") from None


def write(atlas: Atlas) -> bytes:
    """Return an atlas as the content of a file: one patch, landmark or point on each line."""
    patches: list[dict[str, Any]] = [
        {"name": name, "region": region, "points": points}
        for name, region, points in zip(
            atlas.patch_names, atlas.regions, atlas.index.tolist(), strict=True
        )
    ]
    if atlas.weights is not None:
        for patch, weights in zip(patches, atlas.weights.tolist(), strict=True):
            patch["weights"] = weights
    approximation = atlas.approximation
    if approximation is not None:
        for key in ("distance", "stretch"):
            for patch, value in zip(patches, getattr(approximation, key).tolist(), strict=True):
                if value:
                    patch[key] = value
    faces = atlas.faces
    if faces is not None:
        for patch, face, corners in zip(patches, faces.names, faces.corners.tolist(), strict=True):
            if face:
                patch |= {"face": face, "corners": corners}
    landmarks = [
        f"{_line(name)}: "
        + _line({"patch": atlas.patch_names[point.patch], "u": point.u, "v": point.v})
        for name, point in atlas.landmarks.items()
    ]
    members = {
        "format": _line(FORMAT),
        "version": _line(VERSION),
        # Fields at their defaults are left out.
        **({} if atlas.degree == LEAST_DEGREE else {"degree": _line(atlas.degree)}),
        "name": _line(atlas.name),
        "unit": _line(atlas.unit.value),
        "axes": _line({"up": atlas.axes.up, "front": atlas.axes.front}),
        **({} if approximation is None else {"approximation": _line(_summary(approximation))}),
        **(
            {"faces_without_parameters": _line(faces.without)}
            if faces is not None and faces.without
            else {}
        ),
        **(
            {}
            if atlas.scan is None
            else {"scan": _line(msgspec.to_builtins(record_of(atlas.scan)))}
        ),
        "provenance": json.dumps(dict(atlas.provenance), ensure_ascii=False, indent=1),
        "landmarks": _block("{}", landmarks),
        **({"given": _block("{}", _given_lines(atlas))} if atlas.given else {}),
        "patches": _block("[]", [_line(patch) for patch in patches]),
        "points": _block("[]", [_line(point) for point in atlas.points.tolist()]),
    }
    body = ",\n".join(f"{_line(key)}: {value}" for key, value in members.items())
    try:
        return f"{{\n{body}\n}}\n".encode()
    except UnicodeEncodeError as error:
        raise InputError(
            f"a name holds {error.object[error.start]!r}, which is no character; "
            "expected text that UTF-8 can write"
        ) from None


def _given_lines(atlas: Atlas) -> list[str]:
    names = _GivenRecord.__struct_fields__
    records = {
        key: _GivenRecord(*(getattr(length, name) for name in names))
        for key, length in atlas.given.items()
    }
    return [
        f"{_line(key)}: {_line(msgspec.to_builtins(record))}" for key, record in records.items()
    ]


def _summary(approximation: Approximation) -> dict[str, Any]:
    names = _ApproximationRecord.__struct_fields__
    return {name: getattr(approximation, name) for name in names}


def _check_header(header: _Header, source: str) -> None:
    if header.format != FORMAT:
        raise InputError(
            f'{source}: is not a {FORMAT} file; expected "format": "{FORMAT}", '
            f"got {header.format!r}"
        )
    if header.version != VERSION:
        raise InputError(
            f"{source}: has version {header.version}; this bodymeasure reads version {VERSION}; "
            "update whichever of the two is older"
        )
    if header.unit is None:
        known = ", ".join(unit.value for unit in Unit)
        raise InputError(f'{source}: has no unit; add a line such as "unit": "cm" (one of {known})')


def _atlas(record: _AtlasRecord) -> Atlas:
    names = [patch.name for patch in record.patches]
    number = {name: i for i, name in enumerate(names)}
    landmarks = {}
    for name, place in record.landmarks.items():
        if place.patch not in number:
            raise InputError(f"landmark {name!r} lies on patch {place.patch!r}, which is not there")
        landmarks[name] = AtlasPoint(number[place.patch], place.u, place.v)
    return Atlas(
        points=np.array(record.points, dtype=np.float64).reshape(-1, 3),
        index=_index(record),
        unit=Unit.parse(record.unit),
        patch_names=tuple(names),
        regions=tuple(patch.region for patch in record.patches),
        landmarks=landmarks,
        axes=Axes(record.axes.up, record.axes.front),
        name=record.name,
        provenance=record.provenance,
        weights=_weights(record),
        approximation=_approximation(record),
        faces=_faces(record),
        scan=scan_of(record.scan),
        given=_given(record),
    )


def _given(record: _AtlasRecord) -> dict[str, GivenLength]:
    given = {}
    for key, length in record.given.items():
        try:
            given[key] = GivenLength(**msgspec.structs.asdict(length))
        except InputError as error:
            raise InputError(f"given {key!r}: {error}") from None
    return given


def _index(record: _AtlasRecord) -> Ints:
    """Return the numbers of the control points, shape (patches, degree + 1, degree + 1)."""
    numbers = _squares(record, "numbers", [patch.points for patch in record.patches])
    return numbers.astype(np.int64)


def _weights(record: _AtlasRecord) -> Array | None:
    """Return weights of the same shape; 1 for patches without weights."""
    if all(patch.weights is None for patch in record.patches):
        return None
    ones = [[1.0] * (record.degree + 1)] * (record.degree + 1)
    given = [ones if patch.weights is None else patch.weights for patch in record.patches]
    return _squares(record, "weights", given)


def _approximation(record: _AtlasRecord) -> Approximation | None:
    summary = record.approximation
    if summary is None:
        for patch in record.patches:
            if patch.distance or patch.stretch:
                raise InputError(
                    f"patch {patch.name!r} has the distance or the stretch of an approximation, "
                    "but the atlas has no approximation"
                )
        return None
    return Approximation(
        summary.kind,
        np.array([patch.distance for patch in record.patches]),
        np.array([patch.stretch for patch in record.patches]),
        summary.mesh_distance,
        summary.mesh_rms,
        summary.mesh_lengths,
    )


def _faces(record: _AtlasRecord) -> FileFaces | None:
    """Return the faces of patches; None if none has one."""
    for patch in record.patches:
        if bool(patch.face) != (patch.corners is not None):
            raise InputError(
                f"patch {patch.name!r} has a face without its corners there, or corners without "
                "their face; expected both, or neither"
            )
    without = record.faces_without_parameters
    if not without and not any(patch.face for patch in record.patches):
        return None
    corners = [patch.corners or ((0.0, 0.0),) * 3 for patch in record.patches]
    return FileFaces(tuple(patch.face for patch in record.patches), np.array(corners), without)


def _squares(record: _AtlasRecord, what: str, values: list[Any]) -> Array:
    """Return the values of all patches, if each has as many rows and columns as its degree asks."""
    if not LEAST_DEGREE <= record.degree <= LARGEST_DEGREE:
        raise InputError(
            f"the degree is {record.degree}; expected {LEAST_DEGREE} to {LARGEST_DEGREE}"
        )
    side = record.degree + 1
    for number, (patch, rows) in enumerate(zip(record.patches, values, strict=True)):
        counts = [len(rows), *(len(row) for row in rows)]
        wrong = [count for count in counts if count != side]
        if wrong:
            raise InputError(
                f"patch {number} ({patch.name!r}): expected {side} rows of {side} {what}, as of "
                f"degree {record.degree}; got {wrong[0]}"
            )
    return np.array(values, dtype=np.float64).reshape(-1, side, side)


def _place_of_misfit(content: bytes) -> str | None:
    """Say what is wrong with the first patch, point or landmark that does not fit, if any."""
    # The standard library also takes numbers that are too large, which are among the misfits.
    try:
        members = json.loads(content)
    except (ValueError, RecursionError):
        return None
    if not isinstance(members, dict):
        return None
    kinds: tuple[tuple[str, str, Any], ...] = (
        ("patches", "patch", _PatchRecord),
        ("points", "control point", _Point),
        ("landmarks", "landmark", _LandmarkRecord),
        ("given", "given length", _GivenRecord),
    )
    for key, noun, kind in kinds:
        values = members.get(key)
        if isinstance(values, dict):
            named = [(repr(name), value) for name, value in values.items()]
        elif isinstance(values, list):
            named = [(str(number), value) for number, value in enumerate(values)]
        else:
            continue
        for name, value in named:
            try:
                msgspec.convert(value, kind)
            except msgspec.ValidationError as error:
                label = value.get("name") if isinstance(value, dict) else None
                called = f" ({label!r})" if isinstance(label, str) else ""
                return f"{noun} {name}{called}: {error}"
    return None


def _line(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False)


def _block(brackets: str, lines: Sequence[str]) -> str:
    if not lines:
        return brackets
    return brackets[0] + "\n" + ",\n".join(lines) + "\n" + brackets[1]
