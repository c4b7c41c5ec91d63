"""Girths of trunk and limbs, and parts of them."""

import numpy as np

from bodymeasure.chart.body import Body
from bodymeasure.chart.chart import Measured, Outcome, TapeKind
from bodymeasure.chart.kinds.definitions import (
    ExtremeGirthMeasure,
    GirthArcMeasure,
    GirthMeasure,
    LimbGirthMeasure,
    Measurement,
    TapeWanted,
    TiltedGirthMeasure,
)
from bodymeasure.errors import InputError
from bodymeasure.measure import (
    Extremum,
    Girth,
    body_girth,
    extreme_girth,
    girth_arc,
    limb_girth,
)
from bodymeasure.section import Plane


def measure_girth(body: Body, definition: GirthMeasure) -> Measured:
    """The horizontal girth at a landmark's height."""
    girth = _level_girth(body, definition.at, definition.cut, limb=definition.limb)
    return _measured(body, definition, girth, (definition.at, *(definition.cut or ())))


def measure_girth_arc(body: Body, definition: GirthArcMeasure) -> Measured:
    """The front or the back of the horizontal girth at a landmark's height."""
    names = (definition.at, definition.start, definition.end, *(definition.cut or ()))
    start, end = body.position(definition.start), body.position(definition.end)
    girth = _level_girth(body, definition.at, definition.cut)
    arc = girth_arc(girth, start, end, body.atlas.axes.front_vector, definition.side)
    wanted = [(TapeKind.CONTACT, arc.contact_tape)]
    if definition.tape != "contact":
        wanted.append((TapeKind.TAUT, arc.taut_tape))
    return Measured(
        definition,
        Outcome.MEASURED,
        _sentence(girth.remark),
        value=arc.taut if definition.tape == "taut" else arc.contact,
        contact=arc.contact,
        taut=arc.taut,
        error_estimate=arc.error_estimate,
        landmarks=tuple(dict.fromkeys(names)),
        tapes=tuple(body.tape(kind, tape) for kind, tape in wanted),
        length_by_region=arc.length_by_region,
    )


def measure_tilted_girth(body: Body, definition: TiltedGirthMeasure) -> Measured:
    """The girth in the plane through two landmarks that is level from left to right."""
    front, back = (body.position(name) for name in (definition.front, definition.back))
    normal = np.cross(body.atlas.axes.left_vector, front - back)
    if not normal.any():
        raise InputError(
            f"{definition.front!r} and {definition.back!r} lie one beside the other or at one "
            "place, so that many planes hold them; choose a front and a back landmark"
        )
    girth = body.girth(Plane(front, normal), definition.front)
    return _measured(body, definition, girth, (definition.front, definition.back))


def measure_limb_girth(body: Body, definition: LimbGirthMeasure) -> Measured:
    """The girth perpendicular to the line between two landmarks."""
    start, end, at = definition.start, definition.end, definition.at
    place = body.point(at) if isinstance(at, str) else float(at)
    girth = limb_girth(body.atlas, body.point(start), body.point(end), at=place)
    names = (start, end, at) if isinstance(at, str) else (start, end)
    return _measured(body, definition, girth, tuple(dict.fromkeys(names)))


def measure_extreme_girth(body: Body, definition: ExtremeGirthMeasure) -> Measured:
    """The largest or smallest girth between two landmarks."""
    found = extreme_girth(
        body.atlas,
        body.point(definition.start),
        body.point(definition.end),
        definition.extreme,
        tape="contact" if definition.tape == "contact" else "taut",
        limb=definition.limb,
    )
    remark = "" if found.status is Extremum.INSIDE else f"The extreme is {found.status.value}."
    names = (definition.start, definition.end)
    return _measured(body, definition, found.girth, names, remark)


def _level_girth(body: Body, at: str, cut: tuple[str, str] | None, *, limb: bool = False) -> Girth:
    """The horizontal girth at a landmark's height, cut at two others if they are given."""
    if cut is None:
        return body.level_girth(at, limb=limb)
    return body_girth(body.atlas, body.point(at), cut=(body.point(cut[0]), body.point(cut[1])))


def _sentence(remark: str) -> str:
    return f"{remark[:1].upper()}{remark[1:]}." if remark else ""


def _measured(
    body: Body,
    definition: Measurement,
    girth: Girth,
    landmarks: tuple[str, ...],
    remark: str = "",
) -> Measured:
    remarks = [remark, _sentence(girth.remark)]
    wanted: TapeWanted = getattr(definition, "tape", "contact")
    tapes = [body.tape(TapeKind.CONTACT, girth.contact_tape)]
    if wanted != "contact":
        tapes.append(body.tape(TapeKind.TAUT, girth.taut_tape))
    return Measured(
        definition,
        Outcome.MEASURED,
        " ".join(filter(None, remarks)),
        value=girth.taut if wanted == "taut" else girth.contact,
        contact=girth.contact,
        taut=girth.taut,
        error_estimate=girth.error_estimate,
        landmarks=landmarks,
        tapes=tuple(tapes),
        length_by_region=girth.tape.length_by_region,
    )
