"""The routes that a search has tried.

Along one route there may be several paths each of which is the shortest near it, as on both sides
of a corner, and a refinement ends at the one near its start. So a route is tried again from a start
that is far from those before.
"""

from collections.abc import Iterable

import numpy as np

from bodymeasure.geodesic.across.routes.route import Route, RouteKey

# Starts that cross every seam at parameters that differ by no more lead to the same path.
SAME_START = 0.1
# So many starts are tried along routes that were tried before.
MOST_AGAIN = 2


class TriedRoutes:
    """Routes with the places where the starts and the paths along them cross the seams.

    Parameters
    ----------
    routes : iterable of Route
    """

    def __init__(self, routes: Iterable[Route]) -> None:
        self._along: dict[RouteKey, list[tuple[float, ...]]] = {}
        self._again = 0
        self.add(*routes)
        self._again = 0

    def add(self, *routes: Route) -> None:
        """Note routes as tried: those of starts, and those of the paths to which they led."""
        self._again += any(route.key in self._along for route in routes)
        for route in routes:
            self._along.setdefault(route.key, []).append(route.along)

    def __contains__(self, route: Route) -> bool:
        """Return whether a route was tried from a start nearby; for a loop, from any start."""
        return any(
            route.closed
            or self._again >= MOST_AGAIN
            or np.allclose(route.along, place, rtol=0.0, atol=SAME_START)
            for place in self._along.get(route.key, ())
        )
