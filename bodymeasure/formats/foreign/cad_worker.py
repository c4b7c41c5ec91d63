"""The process in which Open CASCADE reads a file: ``python cad_worker.py FILE RESULT``."""

import json
import sys
from typing import Any

import numpy as np

from bodymeasure._typing import Array

# Edges that run this close to the border of a face's range in u or v, as a part of the range, bound
# all of it.
ON_BORDER = 1e-6
# The number of points along an edge at which its distance to the border is taken.
ALONG = 9
# A B-spline that is this close to the surface that it was made from, as a part of the coordinates,
# at equal parameters has the surface's own.
SAME = 1e-9
# Where the two are compared, as parts of the range: at no half, third or quarter of a turn, where a
# circle and the spline that it is converted to have the same point.
PARTS = np.array([0.0, 0.07, 0.19, 0.31, 0.43, 0.56, 0.68, 0.81, 0.93, 1.0])


def main(file: str, result: str) -> int:
    """Read all faces of a file and save their B-spline surfaces; 1 if it cannot be read."""
    from OCP.Message import Message

    # Without this, Open CASCADE prints its remarks on the file.
    _static(Message, "DefaultMessenger")().ChangePrinters().Clear()
    shape = _shape(file)
    if shape is None:
        return 1
    arrays: dict[str, Any] = {}
    faces: list[dict[str, Any]] = []
    notes: list[str] = []
    without: dict[str, str] = {}
    for number, face in enumerate(_faces(shape)):
        place = f"face {number + 1}"
        try:
            surface, own_notes = _surface(face)
            own = _arrays(surface, face)
            has_own = _has_own_parameters(surface, face)
        except Exception as error:  # whatever Open CASCADE stumbles over
            notes.append(f"{place} cannot be made a B-spline ({error}); it is left out")
            without[place] = f"it is left out, since it cannot be made a B-spline ({error})"
            continue
        notes += [f"{place} {note}" for note in own_notes]
        arrays |= {f"{name} {len(faces)}": array for name, array in own.items()}
        degrees = [surface.UDegree(), surface.VDegree()]
        faces.append(
            {
                "name": place,
                "group": "",
                "place": place,
                "degrees": degrees,
                "own": has_own,
                "mirrored": _is_reversed(face),
            }
        )
    document = {"unit": "mm", "notes": notes, "without": without, "faces": faces}
    np.savez(result, document=np.array(json.dumps(document)), **arrays)
    return 0


def _static(owner: Any, name: str) -> Any:
    """A static method, whose name ends in ``_s`` in some versions of OCP."""
    return getattr(owner, f"{name}_s", None) or getattr(owner, name)


def _shape(file: str) -> Any:
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.IGESControl import IGESControl_Reader
    from OCP.STEPControl import STEPControl_Reader

    reader = STEPControl_Reader() if file.endswith(".step") else IGESControl_Reader()
    if reader.ReadFile(file) != IFSelect_ReturnStatus.IFSelect_RetDone:
        return None
    reader.TransferRoots()
    shape = reader.OneShape()
    return None if shape is None or shape.IsNull() else shape


def _faces(shape: Any) -> list[Any]:
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    explorer, faces = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_FACE), []
    while explorer.More():
        faces.append(_static(TopoDS, "Face")(explorer.Current()))
        explorer.Next()
    return faces


def _surface(face: Any) -> tuple[Any, list[str]]:
    """The B-spline under a face over the face's range, and notes on where the two differ."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepTools import BRepTools
    from OCP.Geom import Geom_RectangularTrimmedSurface
    from OCP.GeomConvert import GeomConvert

    bounds = _static(BRepTools, "UVBounds")(face)
    surface = _static(BRep_Tool, "Surface")(face)
    own, (covered, beyond) = np.array(surface.Bounds()), _covered(surface, bounds)
    if (covered != own).any():
        surface = Geom_RectangularTrimmedSurface(surface, *covered)
    spline = _static(GeomConvert, "SurfaceToBSplineSurface")(surface)
    if spline.IsUPeriodic():
        spline.SetUNotPeriodic()
    if spline.IsVPeriodic():
        spline.SetVNotPeriodic()
    notes = ["is trimmed; its underlying surface is taken"] if _is_trimmed(face, bounds) else []
    if beyond > ON_BORDER:
        notes.append(
            f"runs past the border of its surface by {beyond:.2g} of the surface's range; it is "
            "taken up to the border"
        )
    return spline, notes


def _has_own_parameters(spline: Any, face: Any) -> bool:
    """Whether the B-spline has the same points as the surface of a face at equal parameters.

    One that a cylinder or a sphere is converted to has others.
    """
    from OCP.BRep import BRep_Tool

    surface = _static(BRep_Tool, "Surface")(face)
    first_s, last_s, first_t, last_t = spline.Bounds()
    for s in first_s + PARTS * (last_s - first_s):
        for t in first_t + PARTS * (last_t - first_t):
            there, here = surface.Value(s, t), spline.Value(s, t)
            size = max(abs(there.X()), abs(there.Y()), abs(there.Z()), 1.0)
            if not there.Distance(here) <= SAME * size:
                return False
    return True


def _is_reversed(face: Any) -> bool:
    from OCP.TopAbs import TopAbs_Orientation

    return bool(face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED)


def _covered(surface: Any, bounds: tuple[float, ...]) -> tuple[Array, float]:
    """A face's range in u and v on its surface, and the part of it by which the face overhangs.

    It is put on the surface's own borders where it is beside or beyond them: Open CASCADE converts
    nothing of a range that goes past them, or of more than a full turn, even if by rounding alone.
    """
    own, covered = np.array(surface.Bounds()), np.array(bounds)
    near = np.abs(covered - own) <= ON_BORDER * max(1.0, np.abs(covered).max())
    covered[near] = own[near]
    turns = (surface.IsUPeriodic(), surface.IsVPeriodic())
    for axis, is_periodic in zip((slice(0, 2), slice(2, 4)), turns, strict=True):
        if is_periodic and np.ptp(covered[axis]) >= np.ptp(own[axis]) * (1.0 - ON_BORDER):
            covered[axis] = own[axis]
    beyond = 0.0
    for axis, is_periodic in zip((slice(0, 2), slice(2, 4)), turns, strict=True):
        if not is_periodic:
            inside = np.clip(covered[axis], *own[axis])
            beyond = max(beyond, np.abs(covered[axis] - inside).max() / np.ptp(own[axis]))
            covered[axis] = inside
    return covered, beyond


def _is_trimmed(face: Any, bounds: tuple[float, ...]) -> bool:
    """Return whether edges run elsewhere than along the borders of the face's range."""
    from OCP.BRepAdaptor import BRepAdaptor_Curve2d
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    low, high = np.array(bounds[::2]), np.array(bounds[1::2])
    room = ON_BORDER * (high - low)
    explorer = TopExp_Explorer(face, TopAbs_ShapeEnum.TopAbs_EDGE)
    while explorer.More():
        curve = BRepAdaptor_Curve2d(_static(TopoDS, "Edge")(explorer.Current()), face)
        for t in np.linspace(curve.FirstParameter(), curve.LastParameter(), ALONG):
            point = curve.Value(t)
            place = np.array([point.X(), point.Y()])
            if not ((place <= low + room) | (place >= high - room)).any():
                return True
        explorer.Next()
    return False


def _arrays(surface: Any, face: Any) -> dict[str, Array]:
    rows, columns = surface.NbUPoles(), surface.NbVPoles()
    points = np.empty((rows, columns, 3))
    weights = np.empty((rows, columns))
    for i in range(rows):
        for j in range(columns):
            pole = surface.Pole(i + 1, j + 1)
            points[i, j] = pole.X(), pole.Y(), pole.Z()
            weights[i, j] = surface.Weight(i + 1, j + 1)
    knots_u = _knots(surface.UKnot, surface.UMultiplicity, surface.NbUKnots())
    knots_v = _knots(surface.VKnot, surface.VMultiplicity, surface.NbVKnots())
    # Patches face the way the solid does.
    if _is_reversed(face):
        points, weights = points[::-1], weights[::-1]
        knots_u = knots_u[-1] + knots_u[0] - knots_u[::-1]
    return {"points": points, "weights": weights, "knots u": knots_u, "knots v": knots_v}


def _knots(knot: Any, multiplicity: Any, count: int) -> Array:
    values = [knot(number + 1) for number in range(count)]
    return np.repeat(values, [multiplicity(number + 1) for number in range(count)])


if __name__ == "__main__":
    raise SystemExit(main(*sys.argv[1:]))
