"""Measurements along the surface: through landmarks, and down vertical planes."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Atlas
from bodymeasure.chart.body import Body
from bodymeasure.chart.definitions import DropMeasure, PathMeasure
from bodymeasure.chart.measured import Measured, Outcome, Tape, TapeKind
from bodymeasure.geodesic import AtlasPath
from bodymeasure.measure import drop
from bodymeasure.taut import taut_tape

# Points of a drawn tape on each patch that it crosses: closer than a picture's pixels.
STEPS = 8


def measure_path(body: Body, definition: PathMeasure) -> Measured:
    """The geodesic through landmarks, and the tape drawn taut between them."""
    path = body.path(definition.through)
    landmarks = tuple(dict.fromkeys(definition.through))
    if not path.converged:
        return _not_converged(definition, path.status.name, path.status.sentence, landmarks)
    tapes = [contact_tape(body, path)]
    taut, status, error = np.nan, path.status.name, path.error_estimate
    if definition.tape != "contact":
        start, *via, end = path.points
        tape = taut_tape(body.atlas, start, end, via, contact=path, on_failure="status")
        if not tape.converged:
            return _not_converged(definition, tape.status.name, tape.status.sentence, landmarks)
        tapes.append(Tape(TapeKind.TAUT, tape.points, tape.normals))
        taut, status = tape.length, tape.status.name
        error = max(error, tape.error_estimate)
    return Measured(
        definition,
        Outcome.MEASURED,
        status=status,
        value=taut if definition.tape == "taut" else path.length,
        contact=path.length,
        taut=taut,
        error_estimate=error,
        landmarks=landmarks,
        tapes=tuple(tapes),
        length_by_region=_length_by_region(body.atlas, path),
    )


def measure_drop(body: Body, definition: DropMeasure) -> Measured:
    """The way down or up the vertical plane through a landmark, to the height of another."""
    start, level = definition.start, definition.level
    found = drop(body.atlas, body.point(start), body.point(level), plane=definition.plane)
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


def _not_converged(
    definition: PathMeasure, status: str, sentence: str, landmarks: tuple[str, ...]
) -> Measured:
    return Measured(definition, Outcome.NOT_CONVERGED, sentence, status, landmarks=landmarks)


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
