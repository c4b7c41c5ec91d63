"""The skin of a body as an obstacle: feet of positions on it, and how far outside they are."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.seams import EDGES, EdgeTable, edge_table
from bodymeasure.bezier import evaluate
from bodymeasure.taut.foot_search import descend
from bodymeasure.taut.jets import jets, power_coefficients
from bodymeasure.taut.outside import Outside, outward_signs
from bodymeasure.taut.tangents import normals_and_bends

_Array = NDArray[np.float64]
_Ints = NDArray[np.int64]

# Samples a side of each patch, whose closest one tells where a search starts: closer than what
# bends a body's surface.
SAMPLES = 12
# Seams that a search for one foot may cross: all round a corner of five patches, and back.
MAX_CROSSINGS = 6
# Of the atlas's size: positions this close to the skin have no direction from their foot.
TOUCHING = 1e-9
# Sine: valleys so shallow between two patches hold no string.
FLAT = 1e-7


class Feet(NamedTuple):
    """The closest points of the skin to k positions.

    Parameters
    ----------
    patch : ndarray of int, shape (k,)
    parameters : ndarray, shape (k, 2)
    position : ndarray, shape (k, 3)
    normal : ndarray, shape (k, 3)
        Unit vectors out of the body; on a seam's kink, towards the position.
    gap : ndarray, shape (k,)
        How far the positions are outside the plane through their foot, negative inside.
    depth : ndarray, shape (k,)
        How deep they are inside the body, 0 outside: the distance of the foot.
    bend : ndarray, shape (k, 3, 3)
        Second derivatives of the gap by the position, at the foot: minus the shape operator.
    """

    patch: _Ints
    parameters: _Array
    position: _Array
    normal: _Array
    gap: _Array
    depth: _Array
    bend: _Array


class Skin:
    """An atlas prepared for many searches of feet.

    Parameters
    ----------
    atlas : Atlas
    outside : {"told", "along normals", "against normals"}

    Notes
    -----
    Beyond an open boundary, the surface is taken to go on straight: what lies behind the boundary's
    tangent plane counts as inside.
    """

    def __init__(self, atlas: Atlas, outside: Outside) -> None:
        self.coefficients = power_coefficients(atlas.control_points)
        side = np.linspace(0.0, 1.0, SAMPLES)
        grid = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1)
        samples = evaluate(atlas.control_points, np.broadcast_to(grid, (len(atlas), *grid.shape)))
        table = edge_table(atlas.index)
        self.signs = outward_signs(atlas, samples, table, outside)
        self.grid = grid.reshape(-1, 2)
        flat = samples.reshape(-1, 3)
        self.tree = scipy.spatial.KDTree(flat)
        self.size = float(np.ptp(flat, axis=0).max())
        self.to_patch, self.to_side, self.flipped = _neighbors(table)

    def feet(self, positions: _Array) -> Feet:
        """The closest points of the skin to positions (k, 3)."""
        _, nearest = self.tree.query(positions)
        patch, sample = np.divmod(np.asarray(nearest, dtype=np.int64), SAMPLES**2)
        x, squared = descend(self.coefficients[patch], positions, self.grid[sample])
        self._cross(positions, patch, x, squared)
        return self._read(positions, patch, x)

    def _cross(self, positions: _Array, patch: _Ints, x: _Array, squared: _Array) -> None:
        """Go on over the seams on which searches ended, where that leads closer; in place."""
        pending = np.arange(len(patch))
        for _ in range(MAX_CROSSINGS):
            row, side = _sides(x[pending])
            row = pending[row]
            joined = self.to_patch[patch[row], side] >= 0
            row, side = row[joined], side[joined]
            if not len(row):
                return
            here = patch[row]
            to_patch, to_side = self.to_patch[here, side], self.to_side[here, side]
            start = _entered(x[row], side, to_side, self.flipped[here, side])
            there, closer = descend(self.coefficients[to_patch], positions[row], start)
            # A position may have reached two sides of its patch: the better one counts.
            improved: list[int] = []
            limit = (TOUCHING * self.size) ** 2
            for k in np.argsort(closer):
                if closer[k] < squared[row[k]] - limit * 1e-3 and row[k] not in improved:
                    patch[row[k]], x[row[k]], squared[row[k]] = to_patch[k], there[k], closer[k]
                    improved.append(int(row[k]))
            pending = np.array(sorted(improved), dtype=np.int64)
            if not len(pending):
                return

    def _read(self, positions: _Array, patch: _Ints, x: _Array) -> Feet:
        foot, normal, bend = self._frame(patch, x)
        offset = positions - foot
        gap = np.einsum("kc,kc->k", offset, normal)
        distance = np.linalg.norm(offset, axis=1)
        row, side = _sides(x)
        at_side, beyond = np.zeros((2, len(x)), dtype=np.bool_)
        at_side[row] = True
        beyond[row[self.to_patch[patch[row], side] < 0]] = True
        # Over a ridge the way to the position is normal to the skin, but neither patch's normal.
        ridge = at_side & ~beyond & (gap > 0.0) & (distance > TOUCHING * self.size)
        gap[ridge] = distance[ridge]
        normal[ridge] = offset[ridge] / distance[ridge, None]
        bend[ridge | beyond] = 0.0
        depth = np.where(gap < 0.0, np.where(beyond, -gap, distance), 0.0)
        return Feet(patch, x, foot, normal, gap, depth, bend)

    def creases(self, positions: _Array, feet: Feet, reach: _Array) -> tuple[_Ints, Feet]:
        """Feet on the other side of valleys between patches that pass within reach of feet.

        Parameters
        ----------
        positions : ndarray, shape (k, 3)
        feet : Feet
            Of the positions.
        reach : ndarray, shape (k,)

        Returns
        -------
        row : ndarray of int, shape (m,)
            The positions that have one.
        feet : Feet
            On the neighboring patch, continued by its tangent plane where the position is not
            over it.
        """
        s = jets(self.coefficients[feet.patch], feet.parameters)
        speed = np.linalg.norm(np.stack([s[:, 1, 0], s[:, 0, 1]], axis=1), axis=2)
        away = np.abs(feet.parameters[:, _AXIS] - _VALUE) * speed[:, _AXIS]
        away[self.to_patch[feet.patch] < 0] = np.inf
        side = np.argmin(away, axis=1)
        row = np.flatnonzero(away[np.arange(len(side)), side] <= reach)
        here, side = feet.patch[row], side[row]
        to_patch, to_side = self.to_patch[here, side], self.to_side[here, side]
        start = _entered(feet.parameters[row], side, to_side, self.flipped[here, side])
        on_seam = feet.parameters[row].copy()
        on_seam[np.arange(len(row)), _AXIS[side]] = _VALUE[side]
        _, own, _ = self._frame(here, on_seam)
        entered = jets(self.coefficients[to_patch], start)
        # From the seam into the patch on its other side; a valley if that leads up from the first.
        inward = np.where(_AXIS[to_side] == 0, 1, 0)
        along_axis = entered[np.arange(len(row)), inward, 1 - inward]
        rises = np.einsum("kc,kc->k", along_axis, own) * np.where(_VALUE[to_side] == 0.0, 1.0, -1.0)
        valley = rises > FLAT * np.linalg.norm(along_axis, axis=1)
        row, to_patch, start = row[valley], to_patch[valley], start[valley]
        x, _ = descend(self.coefficients[to_patch], positions[row], start)
        foot, normal, bend = self._frame(to_patch, x)
        gap = np.einsum("kc,kc->k", positions[row] - foot, normal)
        return row, Feet(to_patch, x, foot, normal, gap, np.maximum(0.0, -gap), bend)

    def _frame(self, patch: _Ints, x: _Array) -> tuple[_Array, _Array, _Array]:
        """Positions, unit normals out of the body, and second derivatives of the gap."""
        position, normal, bend = normals_and_bends(self.coefficients[patch], x)
        sign = self.signs[patch]
        return position, sign[:, None] * normal, sign[:, None, None] * bend


@lru_cache(maxsize=4)
def skin_of(atlas: Atlas, outside: Outside) -> Skin:
    """The skin of an atlas, made once."""
    return Skin(atlas, outside)


def _neighbors(table: EdgeTable) -> tuple[_Ints, _Ints, NDArray[np.bool_]]:
    """Patch and side over each side (patches, 4), -1 on a boundary, and whether it runs against."""
    to_patch = np.full(table.edge.shape, -1, dtype=np.int64)
    to_side = np.full(table.edge.shape, -1, dtype=np.int64)
    flipped = np.zeros(table.edge.shape, dtype=np.bool_)
    shared = np.flatnonzero(table.sides[table.edge.ravel()] == 2)
    pairs = shared[np.argsort(table.edge.ravel()[shared], kind="stable")].reshape(-1, 2)
    against = table.reversed.ravel()[pairs]
    for one, other in ((0, 1), (1, 0)):
        here, there = np.divmod(pairs[:, one], 4), np.divmod(pairs[:, other], 4)
        to_patch[here], to_side[here] = there
        flipped[here] = against[:, 0] != against[:, 1]
    return to_patch, to_side, flipped


def _sides(x: _Array) -> tuple[_Ints, _Ints]:
    """Rows and sides of the parameters that lie on sides; a corner lies on two."""
    on = np.stack([x[:, edge.fixed_axis] == edge.fixed_value for edge in EDGES], axis=1)
    row, side = np.nonzero(on)
    return row, side


_AXIS = np.array([edge.fixed_axis for edge in EDGES])
_VALUE = np.array([edge.fixed_value for edge in EDGES])


def _entered(x: _Array, side: _Ints, to_side: _Ints, flipped: NDArray[np.bool_]) -> _Array:
    """Parameters of the same points on the patches over their sides."""
    rows = np.arange(len(x))
    along = x[rows, 1 - _AXIS[side]]
    result = np.empty_like(x)
    result[rows, _AXIS[to_side]] = _VALUE[to_side]
    result[rows, 1 - _AXIS[to_side]] = np.where(flipped, 1.0 - along, along)
    return result
