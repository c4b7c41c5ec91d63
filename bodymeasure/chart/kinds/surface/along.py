"""The measurement of a path along the surface."""

from collections.abc import Mapping

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.chart.body import Body
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, Outcome
from bodymeasure.chart.tapes import Tape, TapeKind
from bodymeasure.geodesic import AtlasPath

# Points of a drawn tape on each patch that it crosses: closer than the pixels of a picture.
STEPS = 8


def along(body: Body, definition: MeasurementDefinition, path: AtlasPath) -> Measured:
    """Return the measurement of a path along the skin, if it converged."""
    status = path.status
    if not path.converged:
        return Measured(
            definition,
            Outcome.NOT_CONVERGED,
            status.sentence,
            status.name,
            landmarks=definition.landmarks,
        )
    patch, parameters = path.path(_drawn_times(path))
    position = evaluate(path.atlas.control_points[patch], parameters)
    tape = Tape(TapeKind.CONTACT, position, body.normals(patch, parameters))
    return Measured(
        definition,
        Outcome.MEASURED,
        status=status.name,
        value=path.length,
        contact=path.length,
        error_estimate=path.error_estimate,
        landmarks=definition.landmarks,
        tapes=(tape,),
        length_by_region=_length_by_region(path),
    )


def _drawn_times(path: AtlasPath) -> Array:
    """Return parameters that lie evenly on each piece of the path, so that no corner is cut."""
    lengths = np.array([piece.length for piece in path.pieces])
    total = float(lengths.sum())
    if total == 0.0:
        return np.array([0.0, 1.0])
    before = np.cumsum(lengths) - lengths
    times = (before[:, None] + lengths[:, None] * (np.arange(STEPS) / STEPS)).ravel()
    # Rounding may take the last but one past the end.
    return np.append(np.clip(times / total, 0.0, 1.0), 1.0)


def _length_by_region(path: AtlasPath) -> Mapping[str, float]:
    result: dict[str, float] = {}
    for piece in path.pieces:
        region = path.atlas.regions[piece.patch]
        result[region] = result.get(region, 0.0) + piece.length
    return result
