"""The measurement of a straight line."""

from collections.abc import Callable, Mapping

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.chart.body import Body
from bodymeasure.chart.input.slopes import STEEPEST
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, Outcome
from bodymeasure.chart.tapes import Tape, TapeKind
from bodymeasure.section import SectionLoop

# These are fractions of the body's size: the rounding of a difference of two of its coordinates,
# and the error of an extent, whose search stops as soon as it is that good
# (`bodymeasure.section.places`).
ROUNDING = 4.0 * float(np.finfo(np.float64).eps)
EXTENT = 1e-13


def straight(
    body: Body,
    definition: MeasurementDefinition,
    value: float,
    line: tuple[Array, Array],
    relative: float = ROUNDING,
) -> Measured:
    """Return the measurement of a line; its error is `relative` times the body's size."""
    size = float(np.abs(body.atlas.points).max())
    return Measured(
        definition,
        Outcome.MEASURED,
        value=value,
        error_estimate=relative * size,
        landmarks=definition.landmarks,
        tapes=(Tape(TapeKind.STRAIGHT, np.stack(line), np.zeros((2, 3))),),
    )


def extent(
    body: Body,
    definition: MeasurementDefinition,
    at: str,
    direction: Array,
    extent_of: Callable[[Atlas, SectionLoop], float],
) -> Measured:
    """Return the measurement of the extent of the horizontal loop at a landmark's height."""
    loop = body.level_girth(at).loop
    line = _through_middle(loop.positions, direction)
    return straight(body, definition, extent_of(body.atlas, loop), line, EXTENT)


def extent_slope(body: Body, at: str, direction: Array) -> Mapping[str, Array]:
    """Return the change of an extent with the landmark at whose height it is taken."""
    up = body.atlas.axes.up_vector
    drawn = body.level_girth(at).contact_tape
    along = drawn.positions @ direction
    ends = np.array([along.argmax(), along.argmin()])
    normals = body.normals(drawn.patch[ends], drawn.parameters[ends])
    # An end that stays on the skin moves outwards as the skin leans.
    out = np.maximum(np.abs(normals @ direction), STEEPEST)
    return {at: float(-(normals @ up / out).sum()) * up}


def _through_middle(points: Array, direction: Array) -> tuple[Array, Array]:
    """Return the ends of the line through the middle of a loop that spans it in a direction."""
    along = points @ direction
    low, high = float(along.min()), float(along.max())
    others = points - along[:, None] * direction
    middle = 0.5 * (others.min(axis=0) + others.max(axis=0))
    return middle + low * direction, middle + high * direction
