"""Girths of trunk and limbs."""

from __future__ import annotations

import numpy as np

from bodymeasure.chart.body import Body
from bodymeasure.chart.definitions import (
    ExtremeGirthMeasure,
    GirthMeasure,
    LimbGirthMeasure,
    Measurement,
    TapeWanted,
    TiltedGirthMeasure,
)
from bodymeasure.chart.measured import Measured, Outcome, TapeKind
from bodymeasure.errors import InputError
from bodymeasure.measure import Extremum, Girth, body_girth, extreme_girth, limb_girth
from bodymeasure.section import Plane


def measure_girth(body: Body, definition: GirthMeasure) -> Measured:
    """The horizontal girth at a landmark's height."""
    at, cut = definition.at, definition.cut
    if cut is None:
        return _measured(body, definition, body.level_girth(at, limb=definition.limb), (at,))
    girth = body_girth(body.atlas, body.point(at), cut=(body.point(cut[0]), body.point(cut[1])))
    return _measured(body, definition, girth, (at, *cut))


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


def _measured(
    body: Body,
    definition: Measurement,
    girth: Girth,
    landmarks: tuple[str, ...],
    remark: str = "",
) -> Measured:
    remarks = [remark, f"{girth.remark[:1].upper()}{girth.remark[1:]}." if girth.remark else ""]
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
