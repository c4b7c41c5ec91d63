"""Measurements along the surface: through landmarks, and down vertical planes."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Atlas
from bodymeasure.chart.body import Body
from bodymeasure.chart.chart import Measured, Outcome, Tape, TapeKind
from bodymeasure.chart.kinds.definitions import ClosedMeasure, DropMeasure, PathMeasure
from bodymeasure.errors import InputError
from bodymeasure.geodesic import AtlasPath
from bodymeasure.measure import closed_geodesic, vertical_drop
from bodymeasure.taut import taut_tape

# Points of a drawn tape on each patch that it crosses: closer than a picture's pixels.
STEPS = 8


def measure_path(body: Body, definition: PathMeasure) -> Measured:
    """The geodesic through landmarks, and the tape drawn taut between them."""
    path = body.path(definition.through)
    contact = _along(body, definition, path, tuple(dict.fromkeys(definition.through)))
    if definition.tape == "contact" or contact.outcome is not Outcome.MEASURED:
        return contact
    taut = _drawn_taut(body, path, contact)
    if taut.outcome is not Outcome.MEASURED and definition.tape == "both":
        # The length asked for is there; the one beside it is not.
        return replace(contact, reason=f"There is no taut length: {taut.reason}")
    return taut


def measure_closed(body: Body, definition: ClosedMeasure) -> Measured:
    """The closed geodesic that a horizontal loop contracts to."""
    path = closed_geodesic(body.atlas, body.point(definition.at), on_failure="status")
    return _along(body, definition, path, (definition.at,))


def _along(
    body: Body, definition: PathMeasure | ClosedMeasure, path: AtlasPath, landmarks: tuple[str, ...]
) -> Measured:
    """A path along the skin, measured."""
    status = path.status
    if not path.converged:
        return Measured(
            definition, Outcome.NOT_CONVERGED, status.sentence, status.name, landmarks=landmarks
        )
    return Measured(
        definition,
        Outcome.MEASURED,
        status=status.name,
        value=path.length,
        contact=path.length,
        error_estimate=path.error_estimate,
        landmarks=landmarks,
        tapes=(contact_tape(body, path),),
        length_by_region=_length_by_region(body.atlas, path),
    )


def _drawn_taut(body: Body, path: AtlasPath, contact: Measured) -> Measured:
    """The same with the tape drawn taut, as far as that can be done."""
    start, *via, end = path.points
    try:
        tape = taut_tape(body.atlas, start, end, via, contact=path, on_failure="status")
    except InputError as error:
        return Measured(contact.definition, Outcome.REFUSED, str(error))
    status = tape.status
    if not tape.converged:
        return Measured(
            contact.definition,
            Outcome.NOT_CONVERGED,
            status.sentence,
            status.name,
            landmarks=contact.landmarks,
        )
    wanted = getattr(contact.definition, "tape", "contact")
    return replace(
        contact,
        status=status.name,
        value=tape.length if wanted == "taut" else path.length,
        taut=tape.length,
        error_estimate=max(path.error_estimate, tape.error_estimate),
        tapes=(*contact.tapes, Tape(TapeKind.TAUT, tape.points, tape.normals)),
    )


def measure_drop(body: Body, definition: DropMeasure) -> Measured:
    """The way down or up the vertical plane through a landmark, to the height of another."""
    start, level = definition.start, definition.level
    found = vertical_drop(body.atlas, body.point(start), body.point(level), plane=definition.plane)
    wanted = [(TapeKind.CONTACT, found.contact_tape)]
    if definition.tape != "contact":
        wanted.append((TapeKind.TAUT, found.taut_tape))
    return Measured(
        definition,
        Outcome.MEASURED,
        value=found.taut if definition.tape == "taut" else found.contact,
        contact=found.contact,
        taut=found.taut,
        error_estimate=found.error_estimate,
        landmarks=(start, level),
        tapes=tuple(body.tape(kind, tape) for kind, tape in wanted),
        length_by_region=found.arc.length_by_region,
    )


def contact_tape(body: Body, path: AtlasPath) -> Tape:
    """A path over the skin, to be drawn."""
    times = _drawn_times(path)
    return Tape(TapeKind.CONTACT, path.position(times), body.normals(*path.path(times)))


def _drawn_times(path: AtlasPath) -> NDArray[np.float64]:
    """Parameters of the path, evenly on each of its pieces, so that no corner is cut."""
    lengths = np.array([piece.length for piece in path.pieces])
    total = float(lengths.sum())
    if total == 0.0:
        return np.array([0.0, 1.0])
    before = np.cumsum(lengths) - lengths
    times = (before[:, None] + lengths[:, None] * (np.arange(STEPS) / STEPS)).ravel()
    # Rounding may take the last but one past the end.
    return np.append(np.clip(times / total, 0.0, 1.0), 1.0)


def _length_by_region(atlas: Atlas, path: AtlasPath) -> Mapping[str, float]:
    result: dict[str, float] = {}
    for piece in path.pieces:
        region = atlas.regions[piece.patch]
        result[region] = result.get(region, 0.0) + piece.length
    return result
