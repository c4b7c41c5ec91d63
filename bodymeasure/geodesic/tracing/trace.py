"""A geodesic from a point in a direction, patch by patch."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.tracing.crossing import left_side, over_seam
from bodymeasure.geodesic.tracing.motion import (
    LostError,
    Run,
    State,
    followed,
    jet_at,
    velocity_along,
)
from bodymeasure.geodesic.tracing.patches import NEAR_POLE, Patches, PoleBeside
from bodymeasure.geodesic.tracing.pole import beside_pole, place_on_side, pole_normal

# Runs over patches, and of those in a row that have no length, as where a path goes through a
# corner.
MOST_RUNS = 5_000
MOST_EMPTY = 24


@dataclass(frozen=True, eq=False)
class Trace:
    """A geodesic that was followed.

    Parameters
    ----------
    runs : list of Run
        In units of their patches' sizes.
    end : AtlasPoint
    direction : ndarray, shape (3,)
        The unit tangent at the end.
    length : float
        In the atlas's unit.
    poles : int
        The number of poles that it goes through.
    at_boundary : bool
        Whether it ends at a boundary before it is as long as asked.
    lost : bool
        Whether it could not be followed to its end.
    """

    runs: list[Run]
    end: AtlasPoint
    direction: Array
    length: float
    poles: int = 0
    at_boundary: bool = False
    lost: bool = False


def traced(
    patches: Patches, start: AtlasPoint, direction: Array, length: float, rtol: float
) -> Trace:
    """Follow a geodesic.

    Parameters
    ----------
    patches : Patches
    start : AtlasPoint
    direction : ndarray, shape (3,)
        Its part in the tangent plane counts.
    length : float
        In the atlas's unit.
    rtol : float
        The relative tolerance of a step.
    """
    tracing = _Tracing(patches, length, rtol)
    lost = False
    try:
        tracing.begin(start, direction)
        while not tracing.is_done and tracing.count < MOST_RUNS:
            tracing.step()
    except LostError:
        lost = True
    lost = lost or not tracing.is_done
    state = tracing.state
    end = start
    heading = direction / np.linalg.norm(direction)
    if state is not None:
        end = AtlasPoint(state.patch, *state.parameters.tolist())
        heading = state.velocity @ jet_at(patches.surface(state.patch), state.parameters)[1:3]
    return Trace(
        tracing.runs,
        end,
        heading,
        tracing.length - tracing.left,
        tracing.poles,
        tracing.at_boundary,
        lost,
    )


class _Tracing:
    """The state of a geodesic that is being followed."""

    def __init__(self, patches: Patches, length: float, rtol: float) -> None:
        self.patches, self.length, self.rtol = patches, length, rtol
        self.left = length
        self.runs: list[Run] = []
        self.state: State | None = None
        self.count = self.empty = self.poles = 0
        self.at_boundary = False

    @property
    def is_done(self) -> bool:
        """Whether the length is used up, or a boundary reached."""
        return self.left <= 0.0 or self.at_boundary

    def begin(self, start: AtlasPoint, direction: Array) -> None:
        """Put the point on its start, or on the other side of a pole if it is that or beside it."""
        side = self.patches.neighbors.pole_side(start)
        state = State(start.patch, np.array([start.u, start.v]), np.zeros(2))
        near = self.patches.pole_beside(state) if side is None else None
        if side is None and (near is None or near.distance >= NEAR_POLE):
            surface = self.patches.surface(start.patch)
            velocity = velocity_along(surface, state.parameters, direction)
            self.state = state._replace(velocity=velocity)
            return
        pole_side = side if near is None else near.side
        assert pole_side is not None
        around = self.patches.around(start.patch, pole_side, self.patches.sizes[start.patch])
        normal = pole_normal([(surface, each) for _, surface, each in around])
        flat, offset = direction, np.zeros(3)
        if near is not None:
            offset = near.offset - (near.offset @ normal) * normal
            flat = self._along_surface(state, near, normal, direction)
        flat = flat - (flat @ normal) * normal
        flat = flat / np.linalg.norm(flat)
        self._through(start.patch, pole_side, offset, flat, from_state=near and state)

    def _along_surface(
        self, state: State, near: PoleBeside, normal: Array, direction: Array
    ) -> Array:
        """Return the part of a direction along the surface right beside a pole.

        Tangents there are little more than rounding. The normal is taken in proportion between that
        of the pole and one that is farther away on the same patch.
        """
        farther = state.parameters.copy()
        axis = EDGES[near.side].fixed_axis
        value = EDGES[near.side].fixed_value
        part = near.distance / NEAR_POLE
        farther[axis] = np.clip(value + (farther[axis] - value) / part, 0.0, 1.0)
        there = np.cross(*jet_at(self.patches.surface(state.patch), farther)[1:3])
        there = there / (np.linalg.norm(there) * np.sign(there @ normal))
        here = normal + part * (there - normal)
        return np.asarray(direction - (direction @ here) / (here @ here) * here)

    def step(self) -> None:
        """Follow the geodesic over one patch, and over the seam or through the pole there."""
        assert self.state is not None
        state, surface = self.state, self.patches.surface(self.state.patch)
        size = float(self.patches.sizes[state.patch])
        self.count += 1
        side, at_pole = left_side(surface, state), False
        near = self.patches.pole_near(state)
        if side is None:
            run = followed(
                surface, state, self.left / size, None if near is None else near[1], self.rtol
            )
            self.runs.append(run)
            self.state, side, at_pole = run.end, run.side, run.at_pole
            self.left -= run.length * size
            self.empty = 0 if run.length > 0.0 else self.empty + 1
            if run.side is None and not run.at_pole:
                self.left = 0.0
        else:
            self.empty += 1
        if self.empty > MOST_EMPTY:
            raise LostError
        if at_pole:
            assert near is not None
            self._enter_pole(near[0], near[1].position)
        elif side is not None and self.left > 0.0:
            self._cross(side)

    def _cross(self, side: int) -> None:
        assert self.state is not None
        crossings = self.patches.neighbors.over.get((self.state.patch, side), ())
        # Three patches at one edge offer no single way to go on.
        if len(crossings) != 1:
            self.at_boundary = True
            return
        here, there = (
            self.patches.surface(number) for number in (self.state.patch, crossings[0].to_patch)
        )
        self.state = over_seam(here, self.state, crossings[0], there)

    def _enter_pole(self, side: int, pole: Array) -> None:
        assert self.state is not None
        state, surface = self.state, self.patches.surface(self.state.patch)
        tangents = jet_at(surface, state.parameters)[1:3]
        normal = np.cross(*tangents)
        normal /= np.linalg.norm(normal)
        offset = surface.positions(state.parameters[None, None])[0, 0] - pole
        direction = state.velocity @ tangents
        self._through(
            state.patch, side, offset - (offset @ normal) * normal, direction, from_state=state
        )

    def _through(
        self,
        patch: int,
        side: int,
        offset: Array,
        direction: Array,
        *,
        from_state: State | None = None,
    ) -> None:
        """Go straight over the tangent plane to the other side of a pole, or to the end."""
        self.poles += 1
        size = float(self.patches.sizes[patch])
        around = self.patches.around(patch, side, size)
        pole_normal([(surface, each) for _, surface, each in around])
        # As far as the circle round the pole, inside of which geodesics are taken for straight.
        nearing = -float(offset @ direction)
        way = nearing + max(nearing**2 + NEAR_POLE**2 - float(offset @ offset), 0.0) ** 0.5
        way = min(max(way, 0.0), self.left / size)
        pole = self.patches.atlas.position(place_on_side(patch, side, 0.0)) / size
        state = beside_pole(around, pole, offset + way * direction, direction)
        # Velocities are in units of each patch's own size.
        state = state._replace(velocity=state.velocity * self.patches.sizes[state.patch] / size)
        sides = {number: each for number, _, each in around}
        for number, begin, end in (
            *(() if from_state is None else ((patch, from_state, None),)),
            (state.patch, None, state),
        ):
            part = way if from_state is None else 0.5 * way
            self.runs.append(_straight(number, sides[number], begin, end, part, size, self.patches))
        self.state = state
        self.left = max(0.0, self.left - way * size)


def _straight(
    number: int,
    side: int,
    begin: State | None,
    end: State | None,
    way: float,
    size: float,
    patches: Patches,
) -> Run:
    """Return the way over one patch between a pole and a point beside it."""
    given = begin or end
    assert given is not None
    along = float(given.parameters[1 - (side >= 2)])
    at_pole = State(number, np.array(place_on_side(number, side, along)[1:]), given.velocity)
    first, last = begin or at_pole, end or at_pole
    length = way * size / float(patches.sizes[number])

    def course(s: Array) -> Array:
        t = np.asarray(s) / length if length else np.zeros_like(s)
        return np.asarray(
            np.multiply.outer(first.parameters, 1.0 - t) + np.multiply.outer(last.parameters, t)
        )

    return Run(first, last, length, course)


def apart(atlas: Atlas, one: Trace, other: Trace) -> float:
    """Return the distance of the ends of two geodesics, in the atlas's unit."""
    ends = [evaluate(atlas.control_points[t.end.patch], (t.end.u, t.end.v)) for t in (one, other)]
    return float(np.linalg.norm(ends[0] - ends[1]))


def runs_of(trace: Trace, patches: Patches) -> Iterator[tuple[Run, float]]:
    """Yield the runs that have a length, each with that length in the atlas's unit."""
    for run in trace.runs:
        if run.length > 0.0:
            yield run, run.length * float(patches.sizes[run.start.patch])
