"""Geodesics between landmarks, on which rules find others."""

from collections.abc import Mapping
from functools import lru_cache

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.chart.landmarks.choice import TIE
from bodymeasure.errors import InputError
from bodymeasure.geodesic import AtlasPath, geodesic_between
from bodymeasure.geodesic.across.routes.topology import extent


# As many paths as a large set of measurements of a body needs; each takes some kilobytes.
@lru_cache(maxsize=512)
def leg_between(atlas: Atlas, start: AtlasPoint, end: AtlasPoint) -> AtlasPath:
    """Return the geodesic between two points, which rules and measurements share.

    It is found once; whether its length can be trusted is in its status.
    """
    return geodesic_between(atlas, start, end, on_failure="status")


def path_between(
    atlas: Atlas, start: str, end: str, landmarks: Mapping[str, AtlasPoint]
) -> AtlasPath:
    """Return the geodesic between two landmarks.

    Raises
    ------
    InputError
        If no seams join the landmarks, or the geodesic cannot be trusted.
    MissingExtraError
        If the package for routes is not installed.
    """
    path = leg_between(atlas, landmarks[start], landmarks[end])
    if not path.converged:
        raise InputError(
            f"the geodesic from {start!r} to {end!r} cannot be trusted ({path.status.name}); pick "
            "the landmark, or derive it from others"
        )
    return path


def point_at(path: AtlasPath, fraction: float) -> AtlasPoint:
    """Return the point of a path at a fraction of its length; of two mirror images, the left."""
    patch, (u, v) = path.path(fraction)
    return on_the_left(path, AtlasPoint(int(patch), float(u), float(v)))


def on_the_left(path: AtlasPath, point: AtlasPoint) -> AtlasPoint:
    """Return the point of a path, or its mirror image if that is a point of the body on the left.

    A shortest path along the ridge of a symmetric body leaves the middle to one side, and its
    mirror image is as short; which of the two is found is an accident.
    """
    atlas = path.atlas
    start, end = (atlas.position(place) for place in (path.points[0], path.points[-1]))
    left, near = atlas.axes.left_vector, TIE * extent(atlas)
    aside = float((atlas.position(point) - start) @ left)
    if aside >= 0.0 or abs(float((end - start) @ left)) > near:
        return point
    mirrored = atlas.position(point) - 2.0 * aside * left
    (twin,), (apart,) = closest_points(atlas, mirrored[None])
    return twin if apart <= near else point
