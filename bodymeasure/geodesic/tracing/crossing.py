"""The passage of a geodesic over a seam to the next patch."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Crossing, on_side
from bodymeasure.geodesic.tracing.motion import LostError, State, Surfaces, jet_at

# The sine of the angle between a side and a direction that still counts as along the side.
ALONG = 1e-9


def left_side(surface: Surfaces, state: State) -> int | None:
    """Return the side on which a point lies and over which it moves out of its patch, if any."""
    tangents = jet_at(surface, state.parameters)[1:3]
    steepest = None
    for side, edge in enumerate(EDGES):
        if state.parameters[edge.fixed_axis] != edge.fixed_value:
            continue
        outward = state.velocity[edge.fixed_axis] * (1.0 if edge.fixed_value else -1.0)
        sine = outward * _height(tangents, edge.fixed_axis)
        if sine > ALONG and (steepest is None or sine > steepest[0]):
            steepest = sine, side
    return None if steepest is None else steepest[1]


def _height(tangents: Array, axis: int) -> float:
    """Return the length of one tangent across the other one."""
    across, along = tangents[axis], tangents[1 - axis]
    squared = along @ along
    if squared > 0.0:
        across = across - (across @ along) / squared * along
    return float(np.linalg.norm(across))


def over_seam(surface: Surfaces, state: State, crossing: Crossing, next_surface: Surfaces) -> State:
    """Return the point on the next patch, moving at the same angle to the seam.

    Where the patches meet smoothly, that is the same direction in space.

    Raises
    ------
    LostError
        If one of the patches has no tangent plane there.
    """
    edge = EDGES[crossing.from_side]
    along = float(state.parameters[1 - edge.fixed_axis])
    tangents = jet_at(surface, state.parameters)[1:3]
    direction = _unit(state.velocity @ tangents)
    seam = _unit(tangents[1 - edge.fixed_axis])
    cosine = float(direction @ seam)

    there = 1.0 - along if crossing.flipped else along
    parameters = np.array(on_side(crossing.to_side, there))
    to = EDGES[crossing.to_side]
    tangents = jet_at(next_surface, parameters)[1:3]
    seam = _unit(tangents[1 - to.fixed_axis])
    inward = tangents[to.fixed_axis] * (-1.0 if to.fixed_value else 1.0)
    inward = _unit(inward - (inward @ seam) * seam)
    if crossing.flipped:
        cosine = -cosine
    direction = cosine * seam + np.sqrt(max(0.0, 1.0 - cosine**2)) * inward
    metric = tangents @ tangents.T
    if not np.linalg.det(metric) > 0.0:
        raise LostError
    return State(crossing.to_patch, parameters, np.linalg.solve(metric, tangents @ direction))


def _unit(vector: Array) -> Array:
    size = float(np.linalg.norm(vector))
    if not size > 0.0:
        raise LostError
    return np.asarray(vector / size)
