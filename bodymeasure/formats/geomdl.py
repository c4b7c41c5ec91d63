"""B-spline surfaces in the JSON of geomdl (NURBS-Python), ``.json``.

``{"shape": {"type": "surface", "data": [...]}}``, as `geomdl.exchange.export_json` writes it. Each
surface is cut into Bezier patches, which have its name. The format has no unit. Rational surfaces
are read, and trimmed ones are refused. Only the fields on which the shape depends are read.
"""

from typing import Any

import msgspec
import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.errors import InputError
from bodymeasure.formats.json_faults import place_of_fault
from bodymeasure.formats.patches import ReadPatches
from bodymeasure.formats.spline_patches import (
    DegreeError,
    SplinePatches,
    faces_of_surfaces,
    notes_of_refused,
    spline_patches,
)


class _ControlPoints(msgspec.Struct):
    points: list[list[float]]
    weights: list[float] | None = None


class _Trims(msgspec.Struct):
    count: int = 0
    data: list[object] = []


class _Surface(msgspec.Struct):
    degree_u: int
    degree_v: int
    knotvector_u: list[float]
    knotvector_v: list[float]
    size_u: int
    size_v: int
    control_points: _ControlPoints
    type: str = "spline"
    dimension: int = 3
    rational: bool = False
    name: str = ""
    trims: _Trims | None = None


class _Shape(msgspec.Struct):
    type: str
    data: list[_Surface]
    count: int | None = None


class _File(msgspec.Struct):
    shape: _Shape


class _Kind(msgspec.Struct):
    type: str = ""


class _Header(msgspec.Struct):
    """The fields that are read first, so that a curve is not reported as a wrong field."""

    shape: _Kind | None = None


def read(content: bytes, source: str) -> ReadPatches:
    """The patches in a file's content; `source` names the file in errors."""
    try:
        header = msgspec.json.decode(content, type=_Header)
        if header.shape is None or header.shape.type != "surface":
            kind = None if header.shape is None else header.shape.type
            raise InputError(
                f"{source}: has a shape of type {kind!r}; expected geomdl's JSON of a surface"
            )
        shape = msgspec.json.decode(content, type=_File).shape
    except msgspec.ValidationError as error:
        raise InputError(f"{source}: {error}; expected geomdl's JSON of a surface") from None
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise InputError(f"{source}{place_of_fault(content, str(error))}") from None
    if shape.count is not None and shape.count != len(shape.data):
        raise InputError(
            f"{source}: says {shape.count} surfaces, but holds {len(shape.data)}; it may have been "
            "edited by hand"
        )
    nets: list[Array] = []
    weights: list[Array] = []
    names: list[str] = []
    places: list[str] = []
    refused: list[str] = []
    corners: list[Array] = []
    without: dict[str, str] = {}
    for number, surface in enumerate(shape.data):
        place = f"surface {number}" + (f" ({surface.name!r})" if surface.name else "")
        try:
            own = _patches(surface)
        except DegreeError as error:
            refused.append(f"{place}: {error}")
            without[place] = f"it is left out, since it {error}"
            continue
        except InputError as error:
            raise InputError(f"{source}, {place}: {error}") from None
        nets += own.nets
        weights += own.weights
        corners.append(own.corners)
        names += [surface.name] * len(own.nets)
        places += [place] * len(own.nets)
    notes = notes_of_refused(refused, source, any_read=bool(nets))
    faces = faces_of_surfaces(places, corners, without)
    return ReadPatches(nets, weights, names, places=places, notes=notes, faces=faces)


def _patches(surface: _Surface) -> SplinePatches:
    """Return the patches of a surface."""
    if surface.type != "spline" or surface.dimension != 3:
        raise InputError(
            f"is a {surface.type} of dimension {surface.dimension}; expected a spline of "
            "dimension 3"
        )
    if surface.trims is not None and (surface.trims.count or surface.trims.data):
        raise InputError(
            "is trimmed; only whole surfaces can be read; take out its trims to have it untrimmed"
        )
    count = len(surface.control_points.points)
    if min(surface.size_u, surface.size_v) < 1 or surface.size_u * surface.size_v != count:
        raise InputError(
            f"has {count} control points; expected {surface.size_u} x {surface.size_v} of them"
        )
    widths = {len(point) for point in surface.control_points.points}
    if widths != {3}:
        raise InputError(f"has points of {sorted(widths)} coordinates; expected 3 each")
    weights = surface.control_points.weights if surface.rational else None
    if weights is None:
        weights = [1.0] * count
    if len(weights) != count:
        raise InputError(f"has {len(weights)} weights for {count} control points")
    # v runs fastest in the file, which is a net's order.
    shape = surface.size_u, surface.size_v
    return spline_patches(
        np.array(surface.control_points.points).reshape(*shape, 3),
        np.array(weights).reshape(shape),
        (surface.degree_u, surface.degree_v),
        (np.array(surface.knotvector_u), np.array(surface.knotvector_v)),
    )


def write(atlas: Atlas) -> bytes:
    """An atlas as the content of a file: a surface for each patch."""
    degree, nets = atlas.degree, atlas.points[atlas.index].reshape(len(atlas), -1, 3).tolist()
    # A Bezier patch as a B-spline.
    knots = [0.0] * (degree + 1) + [1.0] * (degree + 1)
    surfaces: list[dict[str, Any]] = [
        {
            "type": "spline",
            "rational": atlas.is_rational,
            "dimension": 3,
            "degree_u": degree,
            "degree_v": degree,
            "knotvector_u": knots,
            "knotvector_v": knots,
            "size_u": degree + 1,
            "size_v": degree + 1,
            "control_points": {"points": net},
            "name": name,
        }
        for name, net in zip(atlas.patch_names, nets, strict=True)
    ]
    if atlas.weights is not None:
        weights = atlas.weights.reshape(len(atlas), -1).tolist()
        for surface, own in zip(surfaces, weights, strict=True):
            surface["control_points"]["weights"] = own
    members = {"type": "surface", "count": len(surfaces), "data": surfaces}
    try:
        return msgspec.json.encode({"shape": members})
    except UnicodeEncodeError:
        raise InputError(
            "a patch name holds what is no character; expected text that UTF-8 can write"
        ) from None
