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
# So many more starts are tried along a route that was tried before.
MOST_AGAIN = 2


class TriedRoutes:
    """Routes with the places where the starts and the paths along them cross the seams.

    Parameters
    ----------
    routes : iterable of Route
    """

    def __init__(self, routes: Iterable[Route]) -> None:
        self._along: dict[RouteKey, list[tuple[float, ...]]] = {}
        self._starts: dict[RouteKey, int] = {}
        self.add(*routes)

    def add(self, start: Route, *ends: Route) -> None:
        """Note the route of a start as tried, and those of the paths to which it led."""
        self._starts[start.key] = self._starts.get(start.key, 0) + 1
        for route in (start, *ends):
            self._along.setdefault(route.key, []).append(route.along)

    def __contains__(self, route: Route) -> bool:
        """Return whether a route was tried from a start nearby; for a loop, from any start."""
        return any(
            route.closed
            or self._starts.get(route.key, 0) > MOST_AGAIN
            or np.allclose(route.along, place, rtol=0.0, atol=SAME_START)
            for place in self._along.get(route.key, ())
        )
