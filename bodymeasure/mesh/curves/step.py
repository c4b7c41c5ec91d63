"""Curves as the text of a STEP file (ISO 10303-21, AP 214), which no library is needed for."""

from collections.abc import Sequence

from bodymeasure.atlas import Unit
from bodymeasure.mesh.curves.curve import Curve

# SI units of lengths; other units are written in millimeters.
_PREFIX = {Unit.M: "$", Unit.CM: ".CENTI.", Unit.MM: ".MILLI."}
# The numbers of the first lines, and where those of the curves begin.
_HEAD = """\
#1=APPLICATION_CONTEXT('core data for automotive mechanical design processes');
#2=APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1);
#3=PRODUCT_CONTEXT('',#1,'mechanical');
#4=PRODUCT('paths','paths','',(#3));
#5=PRODUCT_DEFINITION_FORMATION('','',#4);
#6=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#7=PRODUCT_DEFINITION('design','',#5,#6);
#8=PRODUCT_DEFINITION_SHAPE('','',#7);
#9=SHAPE_DEFINITION_REPRESENTATION(#8,#15);
#10=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({prefix},.METRE.));
#11=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#12=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#13=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({accuracy:.1E}),#10,'distance_accuracy_value','');
#14=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#13))\
GLOBAL_UNIT_ASSIGNED_CONTEXT((#10,#11,#12))REPRESENTATION_CONTEXT('',''));
#15=GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(#16),#14);
#16=GEOMETRIC_CURVE_SET('paths',({curves}));
"""
_FIRST = 17
# In millimeters: what a CAD program may take for a gap.
_ACCURACY = 1e-3


def to_step(curves: Sequence[Curve], unit: Unit) -> bytes:
    """Return curves as a STEP file.

    Parameters
    ----------
    curves : sequence of Curve
    unit : Unit
        Unit of their points.
    """
    written = unit if unit in _PREFIX else Unit.MM
    scale = unit.meters / written.meters
    lines: list[str] = []
    numbers = []
    number = _FIRST
    for curve in curves:
        points = []
        for x, y, z in (scale * curve.control_points).tolist():
            lines.append(f"#{number}=CARTESIAN_POINT('',({_real(x)},{_real(y)},{_real(z)}));")
            points.append(f"#{number}")
            number += 1
        times = ",".join(map(str, curve.multiplicities))
        knots = ",".join(map(_real, curve.breaks.tolist()))
        lines.append(
            f"#{number}=B_SPLINE_CURVE_WITH_KNOTS({_text(curve.name)},{curve.degree},"
            f"({','.join(points)}),.UNSPECIFIED.,.F.,.F.,({times}),({knots}),.UNSPECIFIED.);"
        )
        numbers.append(f"#{number}")
        number += 1
    head = _HEAD.format(
        prefix=_PREFIX[written],
        accuracy=_ACCURACY * Unit.MM.meters / written.meters,
        curves=",".join(numbers),
    )
    return (
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('paths'),'2;1');\n"
        "FILE_NAME('paths','',(''),(''),'bodymeasure','bodymeasure','');\n"
        "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n"
        f"{head}" + "\n".join(lines) + "\nENDSEC;\nEND-ISO-10303-21;\n"
    ).encode("ascii")


def _real(value: float) -> str:
    """Return a number as STEP writes it: with a point, and an E."""
    mantissa, _, exponent = repr(float(value)).partition("e")
    mantissa = mantissa if "." in mantissa else f"{mantissa}."
    return f"{mantissa}E{exponent}" if exponent else mantissa


def _text(value: str) -> str:
    """Return a text in quotes; signs beyond ASCII are written by their numbers."""
    signs = []
    for sign in value:
        code = ord(sign)
        if sign in "'\\":
            signs.append(2 * sign)
        elif 32 <= code < 127:
            signs.append(sign)
        else:
            signs.append(f"\\X4\\{code:08X}\\X0\\")
    return f"'{''.join(signs)}'"
