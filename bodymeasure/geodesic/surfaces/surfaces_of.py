"""The solver's surface for control points of either kind."""

from typing import Any

from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.geodesic.surfaces.rational import RationalSurfaces


def surfaces_of(control_points: Any) -> BezierSurfaces | RationalSurfaces:
    """Polynomial or rational patches, by the number of their coordinates.

    Parameters
    ----------
    control_points : array, shape (problems, m + 1, n + 1, 3) or (problems, m + 1, n + 1, 4)
    """
    if control_points.shape[-1] == 4:
        return RationalSurfaces(control_points)
    return BezierSurfaces(control_points)
