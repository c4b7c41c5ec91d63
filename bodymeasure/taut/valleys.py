"""Second feet of positions, beyond the seams of valleys nearby."""

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.seams import AXIS, VALUE
from bodymeasure.bezier.power_form import jets
from bodymeasure.taut.skin import Feet, Skin

# Valleys between two patches whose angle has a smaller sine are so shallow that they hold no
# string.
FLAT = 1e-7


def feet_over_valleys(skin: Skin, positions: Array, feet: Feet, reach: Array) -> tuple[Ints, Feet]:
    """Return feet on the other side of valleys between patches that pass within reach of feet.

    Parameters
    ----------
    skin : Skin
    positions : ndarray, shape (k, 3)
    feet : Feet
        The feet of the positions.
    reach : ndarray, shape (k,)

    Returns
    -------
    row : ndarray of int, shape (m,)
        The positions that have such a foot.
    feet : Feet
        On the neighboring patch, continued by its tangent plane where a position is not over it.
    """
    side, away = _nearest_sides(skin, feet)
    row = np.flatnonzero(away <= reach)
    if not len(row):
        return row, feet.rows(row)
    side, patch = side[row], feet.patch[row]
    seam = feet.parameters[row]
    seam[np.arange(len(row)), AXIS[side]] = VALUE[side]
    to_patch, start = skin.entered(patch, seam, side)
    rises = _rises(skin, patch, seam, side)
    row, to_patch, start = row[rises], to_patch[rises], start[rises]
    x, _ = skin.descend(to_patch, positions[row], start)
    foot, normal, bend = skin.frame(to_patch, x)
    gap = np.einsum("kc,kc->k", positions[row] - foot, normal)
    return row, Feet(to_patch, x, foot, normal, gap, np.maximum(0.0, -gap), bend)


def _nearest_sides(skin: Skin, feet: Feet) -> tuple[Ints, Array]:
    """Return the joined side that is nearest to each foot, and about how far away it is."""
    s = jets(skin.coefficients[feet.patch], feet.parameters)
    speed = np.linalg.norm(np.stack([s[:, 1, 0], s[:, 0, 1]], axis=1), axis=2)
    away = np.abs(feet.parameters[:, AXIS] - VALUE) * speed[:, AXIS]
    away[skin.to_patch[feet.patch] < 0] = np.inf
    side = np.argmin(away, axis=1)
    return side, away[np.arange(len(side)), side]


def _rises(skin: Skin, patch: Ints, seam: Array, side: Ints) -> Bools:
    """Return whether the patches over some sides rise from the tangent planes of those before."""
    _, normal, _ = skin.frame(patch, seam)
    to_patch, start = skin.entered(patch, seam, side)
    inward = skin.inward(to_patch, start, skin.to_side[patch, side])
    rise = np.einsum("kc,kc->k", inward, normal)
    return np.asarray(rise > FLAT * np.linalg.norm(inward, axis=1))
