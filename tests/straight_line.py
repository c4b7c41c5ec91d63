"""What a method finds from the straight line in (u, v), with no search for a shorter path."""

from __future__ import annotations

import inspect
from typing import Any

from bodymeasure.geodesic import GeodesicSolution, solve_geodesic

NO_SEARCH: dict[str, Any] = (
    {"search": "straight"} if "search" in inspect.signature(solve_geodesic).parameters else {}
)


def from_straight_line(surface: Any, start: Any, end: Any, **settings: Any) -> GeodesicSolution:
    """`solve_geodesic` without a search: a failure stays one."""
    return solve_geodesic(surface, start, end, **NO_SEARCH, **settings)
