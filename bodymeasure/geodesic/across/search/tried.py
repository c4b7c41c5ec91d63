"""The routes that a search has tried, and the paths that it has come past.

Along one route there may be several paths each of which is the shortest near it, as on both sides
of a corner, and a refinement ends at the one near its start. So a route is tried again from a start
that is far from those before.
"""

from collections.abc import Iterable

import numpy as np

from bodymeasure.geodesic.across.pieces.refine import RefinedPath
from bodymeasure.geodesic.across.routes.route import Route, RouteKey

# Starts that cross every seam at parameters that differ by no more lead to the same path.
SAME_START = 0.1
# So many more starts are tried along a route that was tried before.
MOST_AGAIN = 2
# Paths along one route whose lengths differ by no more than this part of them are the same.
SAME_LENGTH = 1e-12


class PassedPaths:
    """The best paths that searches have come past, each of which went on from there."""

    def __init__(self) -> None:
        self._lengths: dict[RouteKey, list[float]] = {}

    def is_new(self, path: RefinedPath) -> bool:
        """Return whether no search has come past a path, and note it."""
        lengths, length = self._lengths.setdefault(path.route.key, []), path.length
        if any(abs(length - other) <= SAME_LENGTH * length for other in lengths):
            return False
        lengths.append(length)
        return True


class TriedRoutes:
    """Routes with the places where the starts and the paths along them cross the seams.

    Parameters
    ----------
    routes : iterable of Route
    passed : PassedPaths, optional
        The paths that other searches have come past with the same ends and degree.

    Attributes
    ----------
    passed : PassedPaths or None
    has_joined : bool
        Whether the search came to a path from which another one went on.
    """

    def __init__(self, routes: Iterable[Route], passed: PassedPaths | None = None) -> None:
        self.passed, self.has_joined = passed, False
        self._along: dict[RouteKey, list[tuple[float, ...]]] = {}
        self._starts: dict[RouteKey, int] = {}
        self.add(*routes)

    def joins(self, best: RefinedPath) -> bool:
        """Return whether another search went on from the best path, so that this one need not."""
        self.has_joined = self.passed is not None and not self.passed.is_new(best)
        return self.has_joined

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
