"""Rhino's files, ``.3dm``: NURBS surfaces, and the faces of polysurfaces, cut into Bezier patches.

Read by rhino3dm (extra ``rhino``). The unit is the file's; names of objects and layers become
those of patches and regions.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Unit
from bodymeasure.bezier import project
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.formats.patches import ReadPatches
from bodymeasure.formats.spline_patches import spline_patches

_Array = NDArray[np.float64]

UNITS = {
    "Millimeters": Unit.MM,
    "Centimeters": Unit.CM,
    "Meters": Unit.M,
    "Inches": Unit.INCH,
}
# What a file says that says no unit.
NO_UNIT = ("None", "Unset")
# Points along an edge at which it is compared with the sides of its face's surface.
ALONG = 5
# Segments of a surface's sides for that; their sag on a half circle is 1e-4 of its radius.
SEGMENTS = 256
# Of a surface's size: edges that run so close to its sides are those, the face is not trimmed.
# Rhino's own edges follow within 1e-5 or so.
ON_SIDE = 1e-3


class _Found(NamedTuple):
    """One surface of a file, and whether its face covers only a part of it."""

    name: str
    layer: str
    surface: Any
    reversed: bool
    trimmed: bool


def read(content: bytes, source: str) -> ReadPatches:
    """The patches in a file's content; `source` names the file in errors."""
    try:
        import rhino3dm
    except ImportError:
        raise MissingExtraError(f"reading {source}", "rhino3dm", "rhino") from None
    data: Any = content
    file = rhino3dm.File3dm.FromByteArray(data)
    if file is None:
        raise InputError(
            f"{source}: is no 3dm file that rhino3dm can read; expected one of Rhino's, whole"
        )
    unit = _unit(file, source)
    nets: list[_Array] = []
    weights: list[_Array] = []
    names: list[str] = []
    groups: list[str] = []
    places: list[str] = []
    notes: list[str] = []
    objects: Any = file.Objects
    for number, item in enumerate(objects):
        place = f"object {number}" + (
            f" ({item.Attributes.Name!r})" if item.Attributes.Name else ""
        )
        found = list(_surfaces(file, item))
        if not found:
            kind = type(item.Geometry).__name__
            notes.append(f"{place} is a {kind}, which has no NURBS surface; it is left out")
        for face, one in enumerate(found):
            where = place if len(found) == 1 else f"{place}, face {face}"
            if one.trimmed:
                notes.append(f"{where} is trimmed; its whole underlying surface is taken")
            try:
                own_nets, own_weights = _patches(one)
            except InputError as error:
                raise InputError(f"{source}, {where}: {error}") from None
            nets += own_nets
            weights += own_weights
            names += [one.name] * len(own_nets)
            groups += [one.layer] * len(own_nets)
            places += [where] * len(own_nets)
    return ReadPatches(nets, weights, names, groups, places, unit=unit, notes=notes)


def _unit(file: Any, source: str) -> Unit | None:
    name = file.Settings.ModelUnitSystem.name
    if name in NO_UNIT:
        return None
    if name not in UNITS:
        raise InputError(
            f"{source}: is in {name}; expected one of {', '.join(UNITS)}: change the unit in Rhino"
        )
    return UNITS[name]


def _surfaces(file: Any, item: Any) -> list[_Found]:
    import rhino3dm

    geometry, attributes = item.Geometry, item.Attributes
    layer = _layer(file, attributes.LayerIndex)
    if isinstance(geometry, rhino3dm.Extrusion):
        geometry = geometry.ToBrep(True)
    if isinstance(geometry, rhino3dm.Brep):
        listed: Any = geometry.Faces
        faces = [listed[number] for number in range(len(listed))]
        surfaces = [face.ToNurbsSurface() for face in faces]
        return [
            _Found(
                attributes.Name,
                layer,
                surface,
                bool(face.OrientationIsReversed),
                not geometry.IsSurface and _is_trimmed(geometry, face, surface),
            )
            for face, surface in zip(faces, surfaces, strict=True)
            if surface is not None
        ]
    if isinstance(geometry, rhino3dm.Surface):
        surface = geometry.ToNurbsSurface()
        return [] if surface is None else [_Found(attributes.Name, layer, surface, False, False)]
    return []


def _layer(file: Any, index: int) -> str:
    return str(file.Layers[index].Name) if 0 <= index < len(file.Layers) else ""


def _is_trimmed(brep: Any, face: Any, surface: Any) -> bool:
    """Whether a face's edges run elsewhere than along its surface's sides."""
    if len(face.Loops) != 1:
        return True
    sides = np.concatenate(_sides(surface))
    size = float(np.linalg.norm(np.ptp(sides, axis=0)))
    trims = face.Loops[0].Trims
    for number in range(len(trims)):
        # At a pole a side has no edge.
        if trims[number].EdgeIndex < 0:
            continue
        edge = brep.Edges[trims[number].EdgeIndex]
        for fraction in (np.arange(ALONG) + 0.5) / ALONG:
            t = edge.Domain.T0 + fraction * (edge.Domain.T1 - edge.Domain.T0)
            point = edge.PointAt(t)
            away = np.linalg.norm(sides - [point.X, point.Y, point.Z], axis=1).min()
            if away > ON_SIDE * size + _spacing(sides):
                return True
    return False


def _spacing(sides: _Array) -> float:
    return 0.5 * float(np.median(np.linalg.norm(np.diff(sides, axis=0), axis=1)))


def _sides(surface: Any) -> list[_Array]:
    u, v = surface.Domain(0), surface.Domain(1)
    along_u = np.linspace(u.T0, u.T1, SEGMENTS + 1)
    along_v = np.linspace(v.T0, v.T1, SEGMENTS + 1)
    pairs = [[(t, end) for t in along_u] for end in (v.T0, v.T1)]
    pairs += [[(end, t) for t in along_v] for end in (u.T0, u.T1)]
    points = [[surface.PointAt(*pair) for pair in side] for side in pairs]
    return [np.array([[p.X, p.Y, p.Z] for p in side]) for side in points]


def _patches(found: _Found) -> tuple[list[_Array], list[_Array]]:
    surface = found.surface
    shape = surface.Points.CountU, surface.Points.CountV
    points = [
        surface.Points.GetControlPoint(i, j) for i in range(shape[0]) for j in range(shape[1])
    ]
    # Homogeneous: the coordinates are times the weight.
    net = np.array([[p.X, p.Y, p.Z, p.W] for p in points]).reshape(*shape, 4)
    if found.reversed:
        net = net[::-1]
    knots = []
    for axis, vector in enumerate((surface.KnotsU, surface.KnotsV)):
        inner = np.array([vector[number] for number in range(len(vector))])
        # Rhino leaves out the first and the last knot, on which nothing depends.
        full = np.concatenate([inner[:1], inner, inner[-1:]])
        knots.append(full[-1] + full[0] - full[::-1] if found.reversed and axis == 0 else full)
    weights = net[..., 3]
    if not (weights > 0.0).all():
        raise InputError("has weights that are not positive, with which a surface has poles")
    degrees = surface.OrderU - 1, surface.OrderV - 1
    return spline_patches(project(net), weights, degrees, (knots[0], knots[1]))
