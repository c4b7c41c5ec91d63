"""Measurements along straight lines."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.chart.body import Body
from bodymeasure.chart.chart import Measured, Outcome, Tape, TapeKind
from bodymeasure.chart.kinds.definitions import (
    BreadthMeasure,
    ChordMeasure,
    DepthMeasure,
    HeightMeasure,
    Measurement,
)
from bodymeasure.errors import InputError
from bodymeasure.measure import breadth, depth

# Of the body's size: rounding of a difference of two of its coordinates, and of an extent, whose
# search stops where it is as good (`bodymeasure.section.extent`).
ROUNDING = 4.0 * float(np.finfo(np.float64).eps)
EXTENT = 1e-13
# Of the body's extent: how far soles may reach below the floor, as those of a scan do.
SUNKEN = 0.02


def measure_height(body: Body, definition: HeightMeasure) -> Measured:
    """The vertical distance from the floor, or from another landmark.

    The floor is where the coordinate along the atlas's way up is 0: an atlas may end above the
    ankles, so that its lowest point tells nothing, unless it lies below.

    Raises
    ------
    InputError
        If the body reaches below the floor from which a height is asked for.
    """
    up = body.atlas.axes.up_vector
    top = body.position(definition.at)
    above = definition.above
    if above is None:
        _require_floor(body)
    floor = 0.0 if above is None else float(body.position(above) @ up)
    names = (definition.at,) if above is None else (definition.at, above)
    height = float(top @ up) - floor
    return _straight(body, definition, abs(height), names, (top, top - height * up))


def _require_floor(body: Body) -> None:
    degree, unit = body.atlas.degree, body.atlas.unit
    numbers = body.atlas.index[:, ::degree, ::degree]
    corners = body.atlas.points[numbers] @ body.atlas.axes.up_vector
    low, high = float(corners.min()), float(corners.max())
    if low < -SUNKEN * (high - low):
        raise InputError(
            f"the body reaches {-low:.4g} {unit} below the floor, which is where the coordinate "
            "along the way up is 0; move the body onto the floor, or check the atlas's axes"
        )


def measure_chord(body: Body, definition: ChordMeasure) -> Measured:
    """The straight distance between two landmarks."""
    names = (definition.start, definition.end)
    start, end = (body.position(name) for name in names)
    return _straight(body, definition, float(np.linalg.norm(end - start)), names, (start, end))


def measure_breadth(body: Body, definition: BreadthMeasure) -> Measured:
    """How wide the body is at a landmark's height."""
    loop = body.level_girth(definition.at).loop
    line = _through_middle(loop.positions, body.atlas.axes.left_vector)
    width = breadth(body.atlas, loop)
    return _straight(body, definition, width, (definition.at,), line, EXTENT)


def measure_depth(body: Body, definition: DepthMeasure) -> Measured:
    """How deep the body is at a landmark's height."""
    loop = body.level_girth(definition.at).loop
    line = _through_middle(loop.positions, body.atlas.axes.front_vector)
    width = depth(body.atlas, loop)
    return _straight(body, definition, width, (definition.at,), line, EXTENT)


def _through_middle(points: Array, direction: Array) -> tuple[Array, Array]:
    """The line through the middle of a loop that spans it in a direction."""
    along = points @ direction
    low, high = float(along.min()), float(along.max())
    others = points - along[:, None] * direction
    middle = 0.5 * (others.min(axis=0) + others.max(axis=0))
    return middle + low * direction, middle + high * direction


def _straight(
    body: Body,
    definition: Measurement,
    value: float,
    landmarks: tuple[str, ...],
    line: tuple[Array, Array],
    relative: float = ROUNDING,
) -> Measured:
    size = float(np.abs(body.atlas.points).max())
    return Measured(
        definition,
        Outcome.MEASURED,
        value=value,
        error_estimate=relative * size,
        landmarks=landmarks,
        tapes=(Tape(TapeKind.STRAIGHT, np.stack(line), np.zeros((2, 3))),),
    )
