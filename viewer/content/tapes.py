"""Tapes between points: the answers about paths, girths and closed loops."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from bodymeasure.viewer.content.requests import (
    MeasureClosed,
    MeasureGirth,
    MeasurePath,
    place_of,
)
from bodymeasure.viewer.content.shown import ShownBody

from bodymeasure._typing import Array
from bodymeasure.atlas.queries.approximation_error import nearest_patches
from bodymeasure.atlas.queries.locations import atlas_point
from bodymeasure.chart import Tape, TapeKind
from bodymeasure.chart.input.uncertainty import surface_uncertainty, unseen_patches
from bodymeasure.geodesic import AtlasPath, geodesic_between
from bodymeasure.measure import body_girth, closed_geodesic
from bodymeasure.section import DrawnTape
from bodymeasure.taut import taut_tape

# Distance of the points along a drawn tape as a part of the body's size: 5 mm on a body.
SPACING = 1.0 / 300.0
MOST_STEPS = 1_000
# Digits of positions in meters and of normals: a tenth of a micrometer is less than a page draws.
PLACES, PARTS = 7, 4
# In meters: steps of a tape that are shorter have no direction, since points are rounded.
LEAST_STEP = 1e-5
REMARK = (
    " The body was fitted to a scan: how far its surface is from it counts as the error, where "
    "that is more; how well the points are placed comes on top."
)


def path_answer(body: ShownBody, request: MeasurePath) -> dict[str, Any]:
    """Return the geodesic through some points, or the tape drawn taut through them."""
    atlas = body.atlas
    names = [f"point {number}" for number in range(1, len(request.locations) + 1)]
    spots = zip(request.locations, names, strict=True)
    places = [atlas_point(atlas, place_of(spot), name) for spot, name in spots]
    contact = geodesic_between(atlas, places[0], places[-1], places[1:-1], on_failure="status")
    ends = np.array([atlas.position(place) for place in places])
    answer = {
        "kind": request.kind,
        "straight": _meters(body, float(np.linalg.norm(np.diff(ends, axis=0), axis=1).sum())),
        "closed": False,
    }
    if request.kind == "contact":
        return _on_scan(body, {**answer, **_path_members(body, contact)})
    taut = taut_tape(
        atlas, places[0], places[-1], places[1:-1], contact=contact, on_failure="status"
    )
    found = {
        **answer,
        "length": _meters(body, taut.length),
        "error_estimate": _meters(body, taut.error_estimate),
        "status": taut.status.name.lower(),
        "words": taut.status.sentence,
        "contact": _meters(body, contact.length),
        "gap": _meters(body, taut.gap),
        **_drawn(body, taut.points, taut.normals),
    }
    return _on_scan(body, found)


def closed_answer(body: ShownBody, request: MeasureClosed) -> dict[str, Any]:
    """Return the closed geodesic to which the horizontal loop at a point contracts."""
    path = closed_geodesic(body.atlas, place_of(request.location), on_failure="status")
    answer = {"kind": "contact", "straight": None, "closed": True, **_path_members(body, path)}
    return _on_scan(body, answer)


def girth_answer(body: ShownBody, request: MeasureGirth) -> dict[str, Any]:
    """Return the horizontal girth at the height of a point."""
    girth = body_girth(body.atlas, place_of(request.location))
    taut = request.kind == "taut"
    remark = f" {girth.remark[:1].upper()}{girth.remark[1:]}." if girth.remark else ""
    words = (
        "The girth is that of the level section; its length holds to the stated error."
        if girth.converged
        else "The girth is not known well enough; measure a little higher or lower."
    )
    value = girth.taut if taut else girth.contact
    answer = {
        "kind": request.kind,
        "straight": None,
        "closed": True,
        "length": _meters(body, value) if girth.converged else None,
        "error_estimate": _meters(body, girth.error_estimate),
        "status": "converged" if girth.converged else "inaccurate",
        "words": words + remark,
        "contact": _meters(body, girth.contact),
        "gap": _meters(body, girth.gap),
        **_section(body, girth.taut_tape if taut else girth.contact_tape),
    }
    return _on_scan(body, answer)


def _on_scan(body: ShownBody, answer: dict[str, Any]) -> dict[str, Any]:
    """Return the answer about a tape with what the scan leaves open, as a chart tells it.

    A tape over patches that the scan does not show has no length. Other lengths get
    ``uncertainty``, in meters. On a body that is no fit, the answer stays as it is.
    """
    if body.atlas.scan is None or answer["length"] is None:
        return answer
    points, normals = np.array(answer["points"]), np.array(answer["normals"])
    apart = np.linalg.norm(np.diff(points, axis=0), axis=1)
    kept = np.concatenate([[True], apart > LEAST_STEP])
    points, normals = points[kept], normals[kept]
    positions = points @ body.rotation / body.meters
    under = np.unique(nearest_patches(body.atlas, positions[normals.any(axis=1)]))
    if unseen := unseen_patches(body.atlas, under):
        words = f"{unseen[:1].upper()}{unseen[1:]}."
        return {**answer, "length": None, "status": "not_scanned", "words": words}
    tape = Tape(TapeKind(answer["kind"]), positions, normals)
    uncertainty = surface_uncertainty(body.atlas, tape, under) * body.meters
    return {**answer, "uncertainty": uncertainty, "words": answer["words"] + REMARK}


def _path_members(body: ShownBody, path: AtlasPath) -> dict[str, Any]:
    return {
        "length": _meters(body, path.length),
        "error_estimate": _meters(body, path.error_estimate),
        "status": path.status.name.lower(),
        "words": path.status.sentence,
        **_along(body, path),
    }


def _along(body: ShownBody, path: AtlasPath) -> dict[str, Any]:
    """Return points and normals along a path, at its via points, too; none if there is no path."""
    if not path.pieces:
        return {"points": [], "normals": []}
    size = float(np.ptp(body.atlas.points, axis=0).max())
    steps = min(max(2, math.ceil(path.raw_length / (SPACING * size))), MOST_STEPS)
    times = np.union1d(np.linspace(0.0, 1.0, steps + 1), path.leg_ends)
    patch, parameters = path.path(times)
    points, normals = body.surface(patch, parameters[:, None])
    return _rounded(points[:, 0], normals[:, 0])


def _drawn(body: ShownBody, points: Array, normals: Array) -> dict[str, Any]:
    return _rounded(body.positions_on_page(points), body.vectors_on_page(normals))


def _section(body: ShownBody, tape: DrawnTape) -> dict[str, Any]:
    normals = np.zeros_like(tape.positions)
    on_skin = tape.patch >= 0
    _, found = body.surface(tape.patch[on_skin], tape.parameters[on_skin][:, None])
    normals[on_skin] = found[:, 0]
    return _rounded(body.positions_on_page(tape.positions), normals)


def _rounded(points: Array, normals: Array) -> dict[str, Sequence[Any]]:
    return {
        "points": np.round(points, PLACES).tolist(),
        "normals": np.round(normals, PARTS).tolist(),
    }


def _meters(body: ShownBody, length: float) -> float | None:
    return float(length) * body.meters if math.isfinite(length) else None
