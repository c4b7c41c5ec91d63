"""The process in which rhino3dm reads a file: ``python rhino_worker.py FILE RESULT``."""

import json
import sys
from typing import Any, NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.formats.foreign.rhino_objects import UNMOVED, called, seen_objects

# The limit in bytes: a file with one wrong byte may ask for more memory than the machine has.
MEMORY = 4 * 2**30
# Points along an edge at which it is compared with the sides of its face's surface.
ALONG = 5
# Segments of a surface's sides for that; their sag on a half circle is 1e-4 of its radius.
SEGMENTS = 256
# NURBS that are this close to the surface that they were made from at equal parameters, as a part
# of the coordinates, have the surface's own.
SAME = 1e-9
# Where the two are compared, as parts of the range: at no half, third or quarter of a turn, where a
# circle and the spline that it is converted to have the same point.
PARTS = np.array([0.0, 0.07, 0.19, 0.31, 0.43, 0.56, 0.68, 0.81, 0.93, 1.0])
# A face whose edges run this close to its surface's sides, as a part of the surface's size, is not
# trimmed. Rhino's own edges follow the sides within 1e-5 or so.
ON_SIDE = 1e-3


class _Found(NamedTuple):
    """One surface of a file, whether its face covers only a part of it, and has its parameters."""

    place: str
    layer: str
    surface: Any
    reversed: bool
    trimmed: bool
    own: bool = True


def main(file: str, result: str) -> int:
    """Read all surfaces of a file and save them; 1 if it cannot be read."""
    import rhino3dm

    _limit_memory()
    model: Any = rhino3dm.File3dm.Read(file)
    if model is None:
        return 1
    arrays: dict[str, Any] = {}
    faces: list[dict[str, Any]] = []
    without: dict[str, str] = {}
    objects, notes = seen_objects(model)
    surfaces: dict[int, list[_Found]] = {}
    for number, item, name, transform in objects:
        if number not in surfaces:
            place = called(number, item)
            try:
                surfaces[number] = _surfaces(model, item, place)
                notes += _notes(surfaces[number], item, place)
            except Exception as error:  # whatever rhino3dm stumbles over
                surfaces[number] = []
                notes.append(f"{place} cannot be made NURBS surfaces ({error}); it is left out")
                without[place] = f"it is left out, since it cannot be made NURBS ({error})"
        for one in surfaces[number]:
            own = _arrays(one, transform)
            arrays |= {f"{key} {len(faces)}": array for key, array in own.items()}
            degrees = [one.surface.OrderU - 1, one.surface.OrderV - 1]
            faces.append(
                {
                    "name": name,
                    "group": one.layer,
                    "place": one.place,
                    "degrees": degrees,
                    "own": one.own,
                    "mirrored": _is_turned(one, transform),
                }
            )
    document = {
        "unit": model.Settings.ModelUnitSystem.name,
        "notes": notes,
        "without": without,
        "faces": faces,
    }
    np.savez(result, document=np.array(json.dumps(document)), **arrays)
    return 0


def _limit_memory() -> None:
    if sys.platform == "win32":
        return
    import resource

    _, most = resource.getrlimit(resource.RLIMIT_AS)
    least = MEMORY if most == resource.RLIM_INFINITY else min(MEMORY, most)
    resource.setrlimit(resource.RLIMIT_AS, (least, most))


def _notes(found: list[_Found], item: Any, place: str) -> list[str]:
    if not found:
        kind = type(item.Geometry).__name__
        return [f"{place} is a {kind}, which has no NURBS surface; it is left out"]
    return [
        f"{one.place} is trimmed; its whole underlying surface is taken"
        for one in found
        if one.trimmed
    ]


def _surfaces(file: Any, item: Any, place: str) -> list[_Found]:
    import rhino3dm

    geometry = item.Geometry
    layer = _layer(file, item.Attributes.LayerIndex)
    if isinstance(geometry, rhino3dm.Extrusion):
        geometry = geometry.ToBrep(True)
    if isinstance(geometry, rhino3dm.Brep):
        listed: Any = geometry.Faces
        faces = [listed[number] for number in range(len(listed))]
        surfaces = [face.ToNurbsSurface() for face in faces]
        kept = [number for number, surface in enumerate(surfaces) if surface is not None]
        return [
            _Found(
                place if len(kept) == 1 else f"{place}, face {number}",
                layer,
                surfaces[number],
                bool(faces[number].OrientationIsReversed),
                not geometry.IsSurface and _is_trimmed(geometry, faces[number], surfaces[number]),
                _has_own_parameters(faces[number], surfaces[number]),
            )
            for number in kept
        ]
    if isinstance(geometry, rhino3dm.Surface):
        surface = geometry.ToNurbsSurface()
        own = surface is not None and _has_own_parameters(geometry, surface)
        return [] if surface is None else [_Found(place, layer, surface, False, False, own)]
    return []


def _has_own_parameters(surface: Any, nurbs: Any) -> bool:
    """Whether NURBS have the same points as a surface at equal parameters."""
    domains = [(each.T0, each.T1) for each in (nurbs.Domain(0), nurbs.Domain(1))]
    (first_s, last_s), (first_t, last_t) = domains
    for s in first_s + PARTS * (last_s - first_s):
        for t in first_t + PARTS * (last_t - first_t):
            pair = surface.PointAt(s, t), nurbs.PointAt(s, t)
            there, here = (np.array([p.X, p.Y, p.Z]) for p in pair)
            if not np.abs(there - here).max() <= SAME * max(1.0, np.abs(there).max()):
                return False
    return True


def _is_turned(found: _Found, transform: Array) -> bool:
    """Whether a face is turned around, so that a mirrored solid still faces outwards."""
    return bool(found.reversed != (np.linalg.det(transform[:3, :3]) < 0.0))


def _layer(file: Any, index: int) -> str:
    return str(file.Layers[index].Name) if 0 <= index < len(file.Layers) else ""


def _is_trimmed(brep: Any, face: Any, surface: Any) -> bool:
    """Return whether a face's edges run elsewhere than along its surface's sides."""
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


def _spacing(sides: Array) -> float:
    return 0.5 * float(np.median(np.linalg.norm(np.diff(sides, axis=0), axis=1)))


def _sides(surface: Any) -> list[Array]:
    u, v = surface.Domain(0), surface.Domain(1)
    along_u = np.linspace(u.T0, u.T1, SEGMENTS + 1)
    along_v = np.linspace(v.T0, v.T1, SEGMENTS + 1)
    pairs = [[(t, end) for t in along_u] for end in (v.T0, v.T1)]
    pairs += [[(end, t) for t in along_v] for end in (u.T0, u.T1)]
    points = [[surface.PointAt(*pair) for pair in side] for side in pairs]
    return [np.array([[p.X, p.Y, p.Z] for p in side]) for side in points]


def _arrays(found: _Found, transform: Array) -> dict[str, Array]:
    surface = found.surface
    shape = surface.Points.CountU, surface.Points.CountV
    points = [
        surface.Points.GetControlPoint(i, j) for i in range(shape[0]) for j in range(shape[1])
    ]
    # Homogeneous: the coordinates are times the weight.
    net = np.array([[p.X, p.Y, p.Z, p.W] for p in points]).reshape(*shape, 4)
    if transform is not UNMOVED:
        net = net @ transform.T
    turned = _is_turned(found, transform)
    if turned:
        net = net[::-1]
    knots = []
    for axis, vector in enumerate((surface.KnotsU, surface.KnotsV)):
        inner = np.array([vector[number] for number in range(len(vector))])
        # Rhino leaves out the first and the last knot, on which nothing depends.
        full = np.concatenate([inner[:1], inner, inner[-1:]])
        knots.append(full[-1] + full[0] - full[::-1] if turned and axis == 0 else full)
    weights = net[..., 3]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        places = net[..., :3] / weights[..., None]
    return {"points": places, "weights": weights, "knots u": knots[0], "knots v": knots[1]}


if __name__ == "__main__":
    raise SystemExit(main(*sys.argv[1:]))
