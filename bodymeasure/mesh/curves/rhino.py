"""Curves as a Rhino file."""

import tempfile
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from bodymeasure.atlas import Unit
from bodymeasure.errors import MissingExtraError
from bodymeasure.mesh.curves.curve import Curve

_UNITS = {
    Unit.M: "Meters",
    Unit.CM: "Centimeters",
    Unit.MM: "Millimeters",
    Unit.INCH: "Inches",
}
_VERSION = 7


def to_rhino(curves: Sequence[Curve], unit: Unit) -> bytes:
    """Return curves as a ``.3dm`` file, each an object of its name.

    Raises
    ------
    MissingExtraError
        If rhino3dm is not installed.
    """
    try:
        rhino: Any = import_module("rhino3dm")
    except ImportError:
        raise MissingExtraError("a .3dm file", "rhino3dm", "rhino") from None
    model = rhino.File3dm()
    model.Settings.ModelUnitSystem = getattr(rhino.UnitSystem, _UNITS[unit])
    for curve in curves:
        spline = rhino.NurbsCurve(3, False, curve.degree + 1, len(curve.control_points))
        # Rhino leaves out the first and the last knot, on which nothing depends.
        for number, knot in enumerate(np.repeat(curve.breaks, curve.multiplicities)[1:-1].tolist()):
            spline.Knots[number] = knot
        for number, point in enumerate(curve.control_points.tolist()):
            spline.Points[number] = rhino.Point4d(*point, 1.0)
        attributes = rhino.ObjectAttributes()
        attributes.Name = curve.name
        model.Objects.AddCurve(spline, attributes)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "paths.3dm")
        model.Write(str(file), _VERSION)
        return file.read_bytes()
