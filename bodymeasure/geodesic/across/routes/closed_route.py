"""A closed route over an atlas: the seams that a loop crosses, one after the other."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from bodymeasure.atlas.topology.neighbors import Crossing, Neighbors, Place, Step, on_side
from bodymeasure.errors import InputError

# Parameters this near to 0 or 1 are on the patch's edge, but for rounding.
ON_EDGE = 1e-9


@dataclass(frozen=True)
class ClosedRoute:
    """What a loop crosses on its way round, and about where.

    Parameters
    ----------
    crossings : tuple of Crossing
        In order; number i enters piece i, which crossing i + 1 leaves, and the first one the last.
    along : tuple of float
        Where each seam is crossed: the parameter in [0, 1] along the side that is left.
    """

    crossings: tuple[Crossing, ...]
    along: tuple[float, ...]

    @property
    def patches(self) -> tuple[int, ...]:
        """As many patches as crossings."""
        return tuple(crossing.to_patch for crossing in self.crossings)

    @property
    def key(self) -> tuple[Crossing, ...]:
        """Equal for loops over the same seams, wherever they begin."""
        turns = (self.crossings[i:] + self.crossings[:i] for i in range(len(self.crossings)))
        return min(turns, default=())

    def begun_at(self, first: int) -> "ClosedRoute":
        """The same loop, begun with another crossing."""
        return ClosedRoute(
            self.crossings[first:] + self.crossings[:first],
            self.along[first:] + self.along[:first],
        )

    def replaced(
        self, first: int, last: int, steps: Sequence[tuple[Crossing, float]]
    ) -> "ClosedRoute":
        """The loop with its crossings from first to before last replaced."""
        crossings, along = zip(*steps, strict=True) if steps else ((), ())
        return ClosedRoute(
            self.crossings[:first] + crossings + self.crossings[last:],
            self.along[:first] + along + self.along[last:],
        )

    def entry(self, piece: int) -> Place:
        """Where a piece starts, on its patch."""
        crossing, along = self.crossings[piece], self.along[piece]
        along = 1.0 - along if crossing.flipped else along
        return Place(crossing.to_patch, *on_side(crossing.to_side, along))

    def exit(self, piece: int) -> Place:
        """Where a piece ends, on its patch."""
        following = (piece + 1) % len(self.crossings)
        side = self.crossings[following].from_side
        return Place(self.crossings[piece].to_patch, *on_side(side, self.along[following]))


def route_through(neighbors: Neighbors, places: Sequence[Place]) -> ClosedRoute:
    """The route of a loop through places, straight from each to the next, the last to the first.

    Raises
    ------
    InputError
        If two places in a row are on patches that meet at neither of them.
    """
    snapped = [Place(place.patch, _snapped(place.u), _snapped(place.v)) for place in places]
    steps: list[Step] = []
    for number, (here, there) in enumerate(pairwise([*snapped, snapped[0]])):
        if here.patch == there.patch:
            continue
        way = _way(neighbors, here, there)
        if way is None:
            raise InputError(
                f"points {number} and {(number + 1) % len(places)} of the loop are on patches "
                f"{here.patch} and {there.patch}, which meet at neither of them; give a point on "
                "each seam that the loop crosses"
            )
        steps += way
    return ClosedRoute(tuple(step.crossing for step in steps), tuple(step.along for step in steps))


def _way(neighbors: Neighbors, here: Place, there: Place) -> tuple[Step, ...] | None:
    """The steps from one place to another, at the one or the other."""
    for place in neighbors.same(there):
        if place.patch == here.patch:
            return neighbors.ways(place, there)[0]
    for place in neighbors.same(here):
        if place.patch == there.patch:
            return neighbors.ways(here, place)[0]
    return None


def _snapped(value: float) -> float:
    return float(round(value)) if abs(value - round(value)) < ON_EDGE else float(value)
