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


def with_shifts(taken: Taken, key: str, elsewhere: dict[str, tuple[Taken, Taken]]) -> Measured:
    """Return a measurement together with what its value owes to the places of its landmarks.

    Each landmark is moved by itself, 5 mm up over the skin and 5 mm to the side, and the
    measurement is taken again; landmarks that rules have made of others stay where they are.

    Parameters
    ----------
    taken : Taken
        The measurements of the body.
    key : str
    elsewhere : dict of str to pair of Taken
        The measurements of the body with a landmark moved up, and to the side. What is taken for
        one measurement is added, so that others that share its parts find them.
    """
    item, body = taken[key], taken.body
    if not np.isfinite(item.value):
        return item
    # Formulas list the landmarks of what they are made of.
    names = [name for name in item.landmarks if name in body.landmarks]
    shifts = []
    for name in names:
        if name not in elsewhere:
            higher, aside = _moved(body.atlas, body.landmarks[name])
            elsewhere[name] = _with(taken, name, higher), _with(taken, name, aside)
        up, across = (_value(taken, one, key, name) - item.value for one in elsewhere[name])
        shifts.append(Shift(name, up, across))
    return replace(item, shifts=tuple(shifts))


def _with(taken: Taken, name: str, place: AtlasPoint) -> Taken:
    """Return the measurements of the body with a landmark elsewhere; none is taken yet."""
    body = taken.body
    landmarks = {**body.landmarks, name: place}
    return Taken(Body(body.atlas, landmarks, body.missing, body.trust), taken.definitions)


def _value(taken: Taken, moved: Taken, key: str, name: str) -> float:
    """Return the value of a measurement with a landmark elsewhere; NaN if it has none then."""
    # What a formula is made of stays the same where the landmark has no part in it.
    for operand in taken.definitions[key].operands:
        if operand in taken and name not in taken[operand].landmarks:
            moved.setdefault(operand, taken[operand])
    return moved[key].value


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
