"""Girths of trunk and limbs."""

from __future__ import annotations

import numpy as np
import scipy
from numpy.typing import NDArray

from bodymeasure.chart.body import Body
from bodymeasure.chart.definitions import (
    ExtremeGirthMeasure,
    GirthMeasure,
    LimbGirthMeasure,
    Measurement,
    TapeWanted,
    TiltedGirthMeasure,
)
from bodymeasure.chart.measured import Measured, Outcome, Tape, TapeKind
from bodymeasure.errors import InputError
from bodymeasure.measure import Extremum, Girth, extreme_girth, limb_girth
from bodymeasure.section import Plane, SectionLoop

_Array = NDArray[np.float64]


def measure_girth(body: Body, definition: GirthMeasure) -> Measured:
    """The horizontal girth at a landmark's height."""
    return _measured(body, definition, body.level_girth(definition.at), (definition.at,))


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
    wanted: TapeWanted = getattr(definition, "tape", "contact")
    tapes = [_contact_tape(body, girth.loop)]
    if wanted != "contact":
        tapes.append(_taut_tape(tapes[0], girth))
    return Measured(
        definition,
        Outcome.MEASURED,
        remark,
        value=girth.taut if wanted == "taut" else girth.contact,
        contact=girth.contact,
        taut=girth.taut,
        error_estimate=girth.error_estimate,
        landmarks=landmarks,
        tapes=tuple(tapes),
        length_by_region=girth.loop.length_by_region,
    )


def _contact_tape(body: Body, loop: SectionLoop) -> Tape:
    normals = body.normals(loop.patch, loop.parameters)
    around = np.append(np.arange(len(loop.positions)), 0)
    return Tape(TapeKind.CONTACT, loop.positions[around], normals[around])


def _taut_tape(contact: Tape, girth: Girth) -> Tape:
    """The hull of the drawn loop and of the exact ends of the bridges."""
    ends = girth.bridges.reshape(-1, 3)
    near = scipy.spatial.KDTree(contact.points).query(ends)[1] if len(ends) else []
    points = np.concatenate([contact.points[:-1], ends])
    normals = np.concatenate([contact.normals[:-1], contact.normals[near]])
    flat = (points - points[0]) @ girth.loop.surface.plane.frame().T
    corners = scipy.spatial.ConvexHull(flat).vertices
    around = np.append(corners, corners[0])
    return Tape(TapeKind.TAUT, points[around], normals[around])
