"""The skin of a body as an obstacle: feet of positions on it, and how far outside they are."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.normals import normals_and_bends
from bodymeasure.atlas.queries.closest import descend
from bodymeasure.atlas.queries.outside import Outside, outward_signs
from bodymeasure.atlas.seams import edge_table
from bodymeasure.atlas.topology.joins import entered, on_sides, over_sides
from bodymeasure.bezier import evaluate
from bodymeasure.bezier.power_form import jets, power_coefficients

# The number of samples along a side of each patch. A search starts at the closest one; they lie
# closer together than a body's surface bends.
SAMPLES = 12
# After a step of this size in (u, v), the error that is left is about its square, as in Newton's
# method.
LAST_STEP = 1e-6
# The most seams that a search for one foot may cross: all round a corner of five patches, and back.
MAX_CROSSINGS = 6
# Positions closer to the skin than this part of the atlas's size have no direction from their foot
# but rounding.
TOUCHING = 1e-9
# Feet on two patches whose distances differ by less than this part of the atlas's size are one foot
# on their seam.
TIED = 1e-12


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
        The distance of the positions from the plane through their foot, negative inside.
    depth : ndarray, shape (k,)
        Their depth inside the body, which is the distance of the foot; 0 outside.
    bend : ndarray, shape (k, 3, 3)
        Second derivatives of the gap by the position, at the foot: minus the shape operator.
    """

    patch: Ints
    parameters: Array
    position: Array
    normal: Array
    gap: Array
    depth: Array
    bend: Array


class Skin:
    """An atlas prepared for many searches of feet.

    Parameters
    ----------
    atlas : Atlas
    outside : {"determined", "along normals", "against normals"}

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
        self.to_patch, self.to_side, self.flipped = over_sides(table)

    def feet(self, positions: Array) -> Feet:
        """Return the closest points of the skin to positions (k, 3)."""
        _, nearest = self.tree.query(positions)
        patch, sample = np.divmod(np.asarray(nearest, dtype=np.int64), SAMPLES**2)
        x, squared = self.descend(patch, positions, self.grid[sample])
        self._cross(positions, patch, x, squared)
        return self._read(positions, patch, x)

    def descend(self, patch: Ints, positions: Array, start: Array) -> tuple[Array, Array]:
        """Return the closest points of single patches, and the squared distances."""
        coefficients = self.coefficients[patch]

        def jets_at(rows: Ints, x: Array) -> Array:
            return jets(coefficients[rows], x)

        return descend(jets_at, positions, start, LAST_STEP)

    def _cross(self, positions: Array, patch: Ints, x: Array, squared: Array) -> None:
        """Continue over the seams on which searches ended, where that leads closer, in place."""
        pending = np.arange(len(patch))
        for _ in range(MAX_CROSSINGS):
            row, side = on_sides(x[pending])
            row = pending[row]
            joined = self.to_patch[patch[row], side] >= 0
            row, side = row[joined], side[joined]
            if not len(row):
                return
            to_patch, start = self.entered(patch[row], x[row], side)
            there, closer = self.descend(to_patch, positions[row], start)
            # At a corner two sides lead on; the closer one is written last, and stays.
            order = np.argsort(-closer)
            better = order[closer[order] < squared[row[order]] - (TIED * self.size) ** 2]
            found = row[better]
            patch[found], x[found], squared[found] = to_patch[better], there[better], closer[better]
            pending = np.unique(found)

    def entered(self, patch: Ints, x: Array, side: Ints) -> tuple[Ints, Array]:
        """Return the patches over sides of patches, and the parameters of the same points there."""
        to_patch, to_side = self.to_patch[patch, side], self.to_side[patch, side]
        return to_patch, entered(x, side, to_side, self.flipped[patch, side])

    def _read(self, positions: Array, patch: Ints, x: Array) -> Feet:
        foot, normal, bend = self.frame(patch, x)
        offset = positions - foot
        gap = np.einsum("kc,kc->k", offset, normal)
        distance = np.linalg.norm(offset, axis=1)
        row, side = on_sides(x)
        at_side, beyond = np.zeros((2, len(x)), dtype=np.bool_)
        at_side[row] = True
        beyond[row[self.to_patch[patch[row], side] < 0]] = True
        # Over a ridge the way to the position is normal to the skin, but is neither patch's normal.
        ridge = at_side & ~beyond & (gap > 0.0) & (distance > TOUCHING * self.size)
        gap[ridge] = distance[ridge]
        normal[ridge] = offset[ridge] / distance[ridge, None]
        bend[ridge | beyond] = 0.0
        depth = np.where(gap < 0.0, np.where(beyond, -gap, distance), 0.0)
        return Feet(patch, x, foot, normal, gap, depth, bend)

    def frame(self, patch: Ints, x: Array) -> tuple[Array, Array, Array]:
        """Return positions, unit normals out of the body, and second derivatives of the gap."""
        position, normal, bend = normals_and_bends(self.coefficients[patch], x)
        sign = self.signs[patch]
        return position, sign[:, None] * normal, sign[:, None, None] * bend


@lru_cache(maxsize=4)
def skin_of(atlas: Atlas, outside: Outside) -> Skin:
    """Return the skin of an atlas, which is made once."""
    return Skin(atlas, outside)
