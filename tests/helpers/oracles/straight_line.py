"""Solutions from the straight line in (u, v), without a search for a shorter path."""

from typing import Any

from bodymeasure.geodesic import GeodesicSolution, solve_geodesic


def from_straight_line(surface: Any, start: Any, end: Any, **settings: Any) -> GeodesicSolution:
    """Call `solve_geodesic` without a search, so that a failure stays a failure."""
    return solve_geodesic(surface, start, end, search="straight", **settings)
