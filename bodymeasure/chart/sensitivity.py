"""The change of a value if a landmark lies elsewhere."""

from dataclasses import replace

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.normals import unit_normals
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.chart.body import Body
from bodymeasure.chart.kinds.base import Measured, Shift
from bodymeasure.chart.taken import Taken

# In meters: experienced measurers find a landmark again within about this distance.
DISTANCE = 0.005
# Where the part of a direction along the skin is smaller than this, it is not a way to move there.
LEVEL = 0.05


def with_shifts(taken: Taken, key: str) -> Measured:
    """Return a measurement together with what its value owes to the places of its landmarks.

    Each landmark is moved by itself, 5 mm up over the skin and 5 mm to the side, and the
    measurement is taken again; landmarks that rules have made of others stay where they are.

    Parameters
    ----------
    taken : Taken
        The measurements of the body.
    key : str
    """
    item, body = taken[key], taken.body
    if not np.isfinite(item.value):
        return item
    # Formulas list the landmarks of what they are made of.
    names = [name for name in item.landmarks if name in body.landmarks]
    shifts = []
    for name in names:
        higher, aside = _moved(body.atlas, body.landmarks[name])
        up, across = (_value(taken, key, name, place) - item.value for place in (higher, aside))
        shifts.append(Shift(name, up, across))
    return replace(item, shifts=tuple(shifts))


def _value(taken: Taken, key: str, name: str, place: AtlasPoint) -> float:
    """Return the value of a measurement with a landmark elsewhere; NaN if it has none then."""
    landmarks = {**taken.body.landmarks, name: place}
    body = Body(taken.body.atlas, landmarks, taken.body.missing, taken.body.trust)
    return Taken(body, taken.definitions)[key].value


def _moved(atlas: Atlas, point: AtlasPoint) -> tuple[AtlasPoint, AtlasPoint]:
    """Return the points of the skin 5 mm above a point and 5 mm beside it."""
    up, front = atlas.axes.up_vector, atlas.axes.front_vector
    normal = unit_normals(atlas.control_points[[point.patch]], np.array([[[point.u, point.v]]]))
    higher = _along(up, front, normal[0, 0])
    aside = np.cross(normal[0, 0], higher)
    distance = DISTANCE / atlas.unit.meters
    position = atlas.position(point)
    places, _ = closest_points(atlas, position + distance * np.stack([higher, aside]))
    return places[0], places[1]


def _along(direction: Array, other: Array, normal: Array) -> Array:
    """Return the unit vector along the skin nearest to a direction, or to another one."""
    tangent = direction - (direction @ normal) * normal
    if np.linalg.norm(tangent) < LEVEL:
        tangent = other - (other @ normal) * normal
    return np.asarray(tangent / np.linalg.norm(tangent))
