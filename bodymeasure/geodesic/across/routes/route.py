"""A route over an atlas: the seams that a path or a loop crosses, one after the other."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Crossing, Step, on_side

# Parameters this near to 0 or 1 are on the patch's edge, except for rounding.
ON_EDGE = 1e-9

# What distinguishes routes, wherever on their seams they cross.
RouteKey = tuple[int | None, tuple[Crossing, ...]]


@dataclass(frozen=True)
class Route:
    """The seams that a path crosses, and about where it crosses them.

    The patches between the crossings are the route's pieces. A path has one piece more than
    crossings. A loop has as many: crossing i enters its piece i, and the first crossing leaves its
    last piece.

    Parameters
    ----------
    ends : pair of AtlasPoint or None
        The start, on the first patch, and the end, on the last one; None for a loop.
    crossings : tuple of Crossing
        In order.
    along : tuple of float
        Where each seam is crossed: the parameter in [0, 1] along the side that is left.
    """

    ends: tuple[AtlasPoint, AtlasPoint] | None
    crossings: tuple[Crossing, ...] = ()
    along: tuple[float, ...] = ()

    @classmethod
    def of(cls, ends: tuple[AtlasPoint, AtlasPoint] | None, steps: Sequence[Step]) -> "Route":
        """Return the route of steps over seams."""
        crossings = tuple(step.crossing for step in steps)
        return cls(ends, crossings, tuple(step.along for step in steps))

    @property
    def closed(self) -> bool:
        """Whether the route is that of a loop."""
        return self.ends is None

    @cached_property
    def patches(self) -> tuple[int, ...]:
        """The patch of each piece."""
        entered = tuple(crossing.to_patch for crossing in self.crossings)
        return entered if self.ends is None else (self.ends[0].patch, *entered)

    @cached_property
    def key(self) -> RouteKey:
        """A value that routes over the same seams share, and loops wherever they begin."""
        if self.ends is not None:
            return self.ends[0].patch, self.crossings
        turns = (self.crossings[i:] + self.crossings[:i] for i in range(len(self.crossings)))
        return None, min(turns, default=())

    @cached_property
    def crossed(self) -> tuple[tuple[AtlasPoint, AtlasPoint], ...]:
        """The point of each crossing, on the patch that it leaves and on the one that it enters."""
        result = []
        # The patch before the first crossing of a loop is the last one, number -1.
        for number, (crossing, along) in enumerate(zip(self.crossings, self.along, strict=True)):
            patch = self.patches[number - self.closed]
            after = 1.0 - along if crossing.flipped else along
            before, there = on_side(crossing.from_side, along), on_side(crossing.to_side, after)
            if crossing.within is not None:
                line = (crossing.within, along)
                before = there = line if EDGES[crossing.from_side].fixed_axis == 0 else line[::-1]
            result.append((AtlasPoint(patch, *before), AtlasPoint(crossing.to_patch, *there)))
        return tuple(result)

    @cached_property
    def pieces(self) -> tuple[tuple[AtlasPoint, AtlasPoint], ...]:
        """The points where each piece starts and ends, on its patch."""
        left, entered = zip(*self.crossed, strict=True) if self.crossed else ((), ())
        if self.ends is None:
            return tuple(zip(entered, (*left[1:], *left[:1]), strict=True))
        start, end = self.ends
        return tuple(zip((start, *entered), (*left, end), strict=True))

    def begun_at(self, first: int) -> "Route":
        """Return the same loop, begun with another crossing."""
        return Route(
            self.ends,
            self.crossings[first:] + self.crossings[:first],
            self.along[first:] + self.along[:first],
        )

    def replaced(
        self, first: int, last: int, steps: Sequence[tuple[Crossing, float]] = ()
    ) -> "Route":
        """Return the route with its crossings from `first` to before `last` replaced by others."""
        return replace(
            self,
            crossings=(
                *self.crossings[:first],
                *(crossing for crossing, _ in steps),
                *self.crossings[last:],
            ),
            along=(*self.along[:first], *(along for _, along in steps), *self.along[last:]),
        )


def snapped(patch: int, u: float, v: float) -> AtlasPoint:
    """Return a point, put on the edge of its patch if it is beside it by rounding only."""
    u, v = (
        float(round(value)) if abs(value - round(value)) < ON_EDGE else float(value)
        for value in (u, v)
    )
    return AtlasPoint(patch, u, v)
