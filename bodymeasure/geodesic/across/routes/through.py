"""The route of a loop through given points."""

from collections.abc import Sequence
from itertools import pairwise

from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.topology.neighbors import Neighbors, Step
from bodymeasure.errors import InputError
from bodymeasure.geodesic.across.routes.route import Route, snapped


def route_through(neighbors: Neighbors, places: Sequence[AtlasPoint]) -> Route:
    """Return the route of a loop that leads from each place to the next, the last to the first.

    Raises
    ------
    InputError
        If two places in a row are on patches that meet at neither of them.
    """
    places = [snapped(*place) for place in places]
    steps: list[Step] = []
    for number, (here, there) in enumerate(pairwise([*places, places[0]])):
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
    return Route.of(None, steps)


def _way(neighbors: Neighbors, here: AtlasPoint, there: AtlasPoint) -> tuple[Step, ...] | None:
    """The steps from one place to another over the seams at one of them; None if there are none."""
    for place in neighbors.same(there):
        if place.patch == here.patch:
            return neighbors.ways(place, there)[0]
    for place in neighbors.same(here):
        if place.patch == there.patch:
            return neighbors.ways(here, place)[0]
    return None
