"""Measurements along the surface through landmarks."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Atlas
from bodymeasure.chart.body import Body
from bodymeasure.chart.definitions import PathMeasure
from bodymeasure.chart.measured import Measured, Outcome, Tape, TapeKind
from bodymeasure.geodesic import AtlasPath

# Points of a drawn tape on each patch that it crosses: closer than a picture's pixels.
STEPS = 8


def measure_path(body: Body, definition: PathMeasure) -> Measured:
    """The geodesic through landmarks."""
    path = body.path(definition.through)
    landmarks = tuple(dict.fromkeys(definition.through))
    if not path.converged:
        return Measured(
            definition,
            Outcome.NOT_CONVERGED,
            path.status.sentence,
            path.status.name,
            landmarks=landmarks,
        )
    return Measured(
        definition,
        Outcome.MEASURED,
        status=path.status.name,
        value=path.length,
        contact=path.length,
        error_estimate=path.error_estimate,
        landmarks=landmarks,
        tapes=(contact_tape(body, path),),
        length_by_region=_length_by_region(body.atlas, path),
    )


def contact_tape(body: Body, path: AtlasPath) -> Tape:
    """A path over the skin, to be drawn."""
    patch, parameters = path.path(_drawn_times(path))
    points = path.position(_drawn_times(path))
    return Tape(TapeKind.CONTACT, points, body.normals(patch, parameters))


def _drawn_times(path: AtlasPath) -> NDArray[np.float64]:
    """Parameters of the path, evenly on each of its pieces, so that no corner is cut."""
    lengths = np.array([piece.length for piece in path.pieces])
    before = np.cumsum(lengths) - lengths
    times = (before[:, None] + lengths[:, None] * (np.arange(STEPS) / STEPS)).ravel()
    total = lengths.sum()
    return np.append(times / total, 1.0) if total > 0.0 else np.array([0.0, 1.0])


def _length_by_region(atlas: Atlas, path: AtlasPath) -> Mapping[str, float]:
    result: dict[str, float] = {}
    for piece in path.pieces:
        region = atlas.regions[piece.patch]
        result[region] = result.get(region, 0.0) + piece.length
    return result
