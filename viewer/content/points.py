"""Points of a body: where the smooth surface is, and what lies opposite."""

from functools import lru_cache
from typing import Any

import numpy as np
from bodymeasure.viewer.content.requests import FindMirror, FindPoint, place_of
from bodymeasure.viewer.content.shown import ShownBody

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint, closest_point
from bodymeasure.atlas.queries.locations import atlas_point
from bodymeasure.chart.landmarks.symmetry import check_symmetry
from bodymeasure.errors import InputError
from bodymeasure.section import Plane

# Parts of a body's size: how far the mirrored surface may be from the surface in the root mean
# square, and how far a mirrored point may be from it, for there to be another side.
LEAST_SYMMETRY = 0.02
FARTHEST = 0.05


def point_answer(body: ShownBody, request: FindPoint) -> dict[str, Any]:
    """Return the position and the normal of the smooth surface at a point, and its names."""
    return point_members(body, atlas_point(body.atlas, place_of(request.location)))


def point_members(body: ShownBody, place: AtlasPoint) -> dict[str, Any]:
    """Return what a page knows about a point."""
    position, normal = body.point(place)
    return {
        "location": list(place),
        "position": position.tolist(),
        "normal": normal.tolist(),
        "name": body.atlas.patch_names[place.patch],
        "region": body.atlas.regions[place.patch],
    }


def mirror_answer(body: ShownBody, request: FindMirror) -> dict[str, Any]:
    """Return the point on the other side of a body.

    Raises
    ------
    InputError
        If the body has no other side there.
    """
    atlas = body.atlas
    place = atlas_point(atlas, place_of(request.location))
    plane, size = _mirror(atlas), float(np.ptp(atlas.points, axis=0).max())
    position = atlas.position(place)
    mirrored: Array = position - 2.0 * float(plane.distances(position)) * plane.normal
    found, distance = closest_point(atlas, mirrored)
    if distance > FARTHEST * size:
        raise InputError(
            f"the mirrored point is {distance:.3g} {atlas.unit} from the body, which is posed "
            "unevenly there; click the other side itself"
        )
    return point_members(body, found)


@lru_cache(maxsize=4)
def _mirror(atlas: Atlas) -> Plane:
    """Return the plane in which a body is most nearly symmetric; it is found once."""
    check = check_symmetry(atlas)
    size = float(np.ptp(atlas.points, axis=0).max())
    if check.deviation > LEAST_SYMMETRY * size:
        raise InputError(
            "the body has no two sides that are mirror images: its mirrored surface is "
            f"{check.deviation:.3g} {atlas.unit} from it; click the other side itself"
        )
    return check.plane
