"""What a method finds from the straight line in (u, v), with no search for a shorter path."""

from typing import Any

from bodymeasure.geodesic import GeodesicSolution, solve_geodesic


def from_straight_line(surface: Any, start: Any, end: Any, **settings: Any) -> GeodesicSolution:
    """`solve_geodesic` without a search: a failure stays one."""
    return solve_geodesic(surface, start, end, search="straight", **settings)
