"""Profiles extruded along y, over which the taut tape is known in closed form.

The taut skin over such a surface is developable, too: it consists of extruded lines and arcs of
the profile. A tape is as long as the hypotenuse of its profile's length and its extent along y.
"""

import math

import numpy as np
from helpers.surfaces.grids import grid_index
from helpers.surfaces.surfaces import bicubic

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint, Unit

_Y = {(0, 1): 3}
# z = -x^2 over x from -1 to 1.
RIDGE = bicubic({(0, 0): -1, (1, 0): 2}, _Y, {(0, 0): -1, (1, 0): 4, (2, 0): -4})
# z = -x^3 has a hollow where x < 0 and a ridge where x > 0.
CUBIC = bicubic({(0, 0): -1, (1, 0): 2}, _Y, {(0, 0): 1, (1, 0): -6, (2, 0): 12, (3, 0): -8})
# z = 2 - x^2 within 1 of the middle, and (|x| - 2)^2 from there out to 3.
_HOLLOW = {(0, 0): 1, (1, 0): -4, (2, 0): 4}
HILL = (
    bicubic({(0, 0): -3, (1, 0): 2}, _Y, _HOLLOW),
    bicubic({(0, 0): -1, (1, 0): 2}, _Y, {(0, 0): 1, (1, 0): 4, (2, 0): -4}),
    bicubic({(0, 0): 1, (1, 0): 2}, _Y, _HOLLOW),
)
# z = -|x|.
ROOF = (
    bicubic({(0, 0): -1, (1, 0): 1}, _Y, {(0, 0): -1, (1, 0): 1}),
    bicubic({(1, 0): 1}, _Y, {(1, 0): -1}),
)


def row_of(*nets: Array) -> Atlas:
    """An atlas of patches that are joined along u."""
    lattice = np.concatenate([nets[0], *(net[1:] for net in nets[1:])])
    return Atlas(lattice.reshape(-1, 3), grid_index(len(nets), 1), Unit.CM)


def at(atlas: Atlas, x: float, y: float) -> AtlasPoint:
    """The point over (x, y), given that all these profiles run evenly along x."""
    ends = atlas.control_points[:, [0, -1], 0, 0]
    patch = int(np.clip(np.searchsorted(ends[:, 1], x), 0, len(atlas) - 1))
    left, right = ends[patch].tolist()
    return AtlasPoint(patch, (x - left) / (right - left), y / 3.0)


def parabola_arc(x: float) -> float:
    """The length of z = x^2 from 0 to x."""
    return 0.5 * x * math.hypot(1.0, 2.0 * x) + 0.25 * math.asinh(2.0 * x)
