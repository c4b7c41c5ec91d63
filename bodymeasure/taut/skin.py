"""The skin of a body as an obstacle: feet of positions on it, and how far outside they are."""

from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.check.degeneracy import collapsed_sides
from bodymeasure.atlas.normals import normals_and_bends
from bodymeasure.atlas.prepared import prepared
from bodymeasure.atlas.queries.feet import MAX_SEAMS, feet_over_seams
from bodymeasure.atlas.queries.outside import Outside, outward_signs
from bodymeasure.atlas.seams import AXIS, VALUE, parameters_on_sides
from bodymeasure.atlas.topology.edges import edges_of
from bodymeasure.atlas.topology.joins import entered, kink_angles, on_sides, over_sides, seams_of
from bodymeasure.bezier import evaluate, project
from bodymeasure.bezier.power_form import jets, power_coefficients
from bodymeasure.native import PatchSeams
from bodymeasure.taut.poles import Poles

# The number of samples along a side of each patch. A search starts at the closest one; they lie
# closer together than a body's surface bends.
SAMPLES = 12
# After a step of this size in (u, v), the error that is left is about its square, as in Newton's
# method.
LAST_STEP = 1e-6
# Degrees by which the skin turns over a seam, beyond which both patches are searched for a foot.
SHARP = 30.0
# The sine by which the skin falls over a ridge at one of some places along it, at least: two thirds
# of what holds a pin (`bodymeasure.taut.ridges.SHARP`), as it may fall more between the places.
BLUNT, PLACES = 0.033, 9
# Feet are known from places nearby if they are no farther away than this part of the atlas's size.
CLOSE = 1e-3
# Positions closer to the skin than this part of the atlas's size have no direction from their foot
# but rounding.
TOUCHING = 1e-9
# The cosine of the angle between the way from a foot and the normal there is short of 1 by less
# than this where the skin is smooth.
SMOOTH = 1e-7
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

    def rows(self, rows: Ints | slice) -> "Feet":
        """Return the feet of some of the positions."""
        return Feet._make(each[rows] for each in self)


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
        table = edges_of(atlas)
        self.signs = outward_signs(atlas, samples, table, outside)
        self.grid = grid.reshape(-1, 2)
        flat = samples.reshape(-1, 3)
        self.tree = scipy.spatial.KDTree(flat)
        self.size = float(np.ptp(flat, axis=0).max())
        self.touching = TOUCHING * self.size
        self.to_patch, self.to_side, self.flipped = over_sides(table)
        collapsed = table.collapsed | collapsed_sides(project(atlas.control_points))
        # A pole is neither a seam nor a boundary.
        self.to_patch[collapsed] = -1
        self.samples = flat.reshape(len(atlas), -1, 3)
        seams = seams_of(table, collapsed)
        angle = kink_angles(atlas.control_points, seams)
        self.sharp = np.zeros(collapsed.shape, dtype=np.bool_)
        for one in (0, 1):
            self.sharp[seams.patch[:, one], seams.side[:, one]] = angle > SHARP
        self.open = (self.to_patch < 0) & ~collapsed
        self.poles = Poles(self.coefficients, collapsed, self.size)
        self.pole_normals = self._pole_normals()
        self.ridge, self.near_ridge = self._ridges()

    def _pole_normals(self) -> Array:
        """Return the sums of the normals round each pole."""
        poles = self.poles
        row, patch, x = poles.beside()
        result = np.zeros((len(poles.first), 3))
        np.add.at(result, poles.first[row], self.frame(patch, x)[1])
        return result

    def _ridges(self) -> tuple[Bools, Bools]:
        """Return which sides are ridges (patches, 4), and which patches have or border on such."""
        patch, side = np.nonzero(self.to_patch >= 0)
        along = np.tile(np.linspace(0.0, 1.0, PLACES), len(patch))
        falls = self.falls(patch.repeat(PLACES), side.repeat(PLACES), along)
        ridge = np.zeros(self.to_patch.shape, dtype=np.bool_)
        ridge[patch, side] = (falls > BLUNT).reshape(-1, PLACES).any(axis=1)
        near: Bools = np.array(ridge.any(axis=1))
        over = self.to_patch[near]
        near[over[over >= 0]] = True
        return ridge, near

    def feet(self, positions: Array, near: Feet | None = None) -> Feet:
        """Return the closest points of the skin to positions (k, 3), sought as in `closest`."""
        return self.read(positions, *self.closest(positions, near))

    def closest(self, positions: Array, near: Feet | None = None) -> tuple[Ints, Array]:
        """Return the patches (k,) of these points, and the parameters there (k, 2), alone.

        Within `CLOSE` of the skin they are those that are found from feet of positions nearby, if
        such are given: there, other parts of a body are not closer.
        """
        close = CLOSE * self.size
        if near is None:
            best = self._sought(positions)
        else:
            best = near.patch.copy(), near.parameters.copy(), np.full(len(positions), np.inf)
            row = np.flatnonzero(np.abs(near.gap) <= close)
            found = self._search(positions[row], near.patch[row], near.parameters[row])
            best[0][row], best[1][row], best[2][row] = found
            row = np.flatnonzero(best[2] > close**2)
            best[0][row], best[1][row], best[2][row] = self._sought(positions[row])
        self._behind_ridges(positions, *best)
        self._round_poles(positions, *best)
        return best[0], best[1]

    def _sought(self, positions: Array) -> tuple[Ints, Array, Array]:
        """Return the closest points as found from the closest samples."""
        _, nearest = self.tree.query(positions)
        patch, sample = np.divmod(np.asarray(nearest, dtype=np.int64), SAMPLES**2)
        return self._search(positions, patch, self.grid[sample])

    def descend(self, patch: Ints, positions: Array, start: Array) -> tuple[Array, Array]:
        """Return the closest points of single patches, and the squared distances."""
        return self._search(positions, patch, start, most_seams=0)[1:]

    def _search(
        self, positions: Array, patch: Ints, start: Array, most_seams: int = MAX_SEAMS
    ) -> tuple[Ints, Array, Array]:
        """Return the closest points near places of patches, over seams where that leads closer."""
        return feet_over_seams(
            self.coefficients,
            PatchSeams(self.to_patch, self.to_side, self.flipped),
            positions,
            (patch, start),
            last_step=LAST_STEP,
            tied=(TIED * self.size) ** 2,
            most_seams=most_seams,
        )

    def _behind_ridges(self, positions: Array, patch: Ints, x: Array, squared: Array) -> None:
        """Search for feet beyond the sharp seams of their patches too, in place.

        Inside a sharp ridge both slopes have a closest point, and a sample of the farther one may
        be the closest of all samples.
        """
        row, side = np.nonzero(self.sharp[patch])
        if not len(row):
            return
        to_patch = self.to_patch[patch[row], side]
        offset = self.samples[to_patch] - positions[row, None]
        start = self.grid[np.einsum("ksc,ksc->ks", offset, offset).argmin(axis=1)]
        self._also(positions, (row, to_patch, start), (patch, x, squared))

    def _round_poles(self, positions: Array, patch: Ints, x: Array, squared: Array) -> None:
        """Search again for the feet that lie near poles, from other sides of these, in place."""
        if len(self.poles.patch):
            self._also(positions, self.poles.starts(positions, patch, x), (patch, x, squared))

    def _also(
        self, positions: Array, starts: tuple[Ints, Ints, Array], best: tuple[Ints, Array, Array]
    ) -> None:
        """Search for some rows' feet from other starts, and keep closer ones, in place."""
        row, to_patch, start = starts
        if not len(row):
            return
        patch, x, squared = best
        to_patch, there, closer = self._search(positions[row], to_patch, start)
        order = np.argsort(-closer)
        better = order[closer[order] < squared[row[order]] - (TIED * self.size) ** 2]
        found = row[better]
        patch[found], x[found], squared[found] = to_patch[better], there[better], closer[better]

    def entered(self, patch: Ints, x: Array, side: Ints) -> tuple[Ints, Array]:
        """Return the patches over sides of patches, and the parameters of the same points there."""
        to_patch, to_side = self.to_patch[patch, side], self.to_side[patch, side]
        return to_patch, entered(x, side, to_side, self.flipped[patch, side])

    def read(self, positions: Array, patch: Ints, x: Array) -> Feet:
        """Return feet whose patches (k,) and parameters (k, 2) are known."""
        foot, normal, bend = self.frame(patch, x)
        offset = positions - foot
        gap = np.einsum("kc,kc->k", offset, normal)
        distance = np.linalg.norm(offset, axis=1)
        row, side = on_sides(x)
        at_side, beyond = np.zeros((2, len(x)), dtype=np.bool_)
        at_side[row] = True
        beyond[row[self.open[patch[row], side]]] = True
        # Over a ridge the way to the position is normal to the skin, but is neither patch's normal.
        # Where the patches meet at an acute angle, it may even make an obtuse one with either.
        ridge = at_side & ~beyond & (distance > self.touching)
        row = np.flatnonzero(ridge)
        if len(row):
            mean = self._mean_normals(patch[row], x[row], normal[row])
            inside = row[np.einsum("kc,kc->k", offset[row], mean) <= 0.0]
            ridge[inside] = False
            gap[inside] = np.minimum(gap[inside], 0.0)
        # Over a smooth seam or pole they are the same, and the skin bends there as beside it.
        turned = ridge & (gap < distance * (1.0 - SMOOTH))
        gap[ridge] = distance[ridge]
        normal[ridge] = offset[ridge] / distance[ridge, None]
        bend[turned | beyond] = 0.0
        depth = np.where(gap < 0.0, np.where(beyond, -gap, distance), 0.0)
        return Feet(patch, x, foot, normal, gap, depth, bend)

    def _mean_normals(self, patch: Ints, x: Array, normal: Array) -> Array:
        """Return sums of the normals of the patches that meet at places on sides (k, 2)."""
        result = normal.copy()
        row, side = on_sides(x)
        joined = self.to_patch[patch[row], side] >= 0
        over, there = self.entered(patch[row[joined]], x[row[joined]], side[joined])
        np.add.at(result, row[joined], self.frame(over, there)[1])
        pole = self.poles.pole[patch[row], side]
        result[row[pole >= 0]] = self.pole_normals[pole[pole >= 0]]
        return result

    def falls(self, patch: Ints, side: Ints, along: Array) -> Array:
        """Return by which sine the skin turns away from the outside over seams (k,), at most 1.

        It is negative where the skin rises.
        """
        x = parameters_on_sides(side, along)
        over, there = self.entered(patch, x, side)
        _, first, _ = self.frame(patch, x)
        _, second, _ = self.frame(over, there)
        sine = np.linalg.norm(np.cross(first, second), axis=1)
        sine[(first * second).sum(axis=1) < 0.0] = 1.0
        inward = self.inward(over, there, self.to_side[patch, side])
        return np.asarray(np.where((inward * first).sum(axis=1) < 0.0, sine, -sine))

    def inward(self, patch: Ints, x: Array, side: Ints) -> Array:
        """Return the derivatives (k, 3) by the parameters that lead off sides, into the patches."""
        s = jets(self.coefficients[patch], x)
        off_side = np.where((AXIS[side] == 0)[:, None], s[:, 1, 0], s[:, 0, 1])
        return np.asarray(np.where(VALUE[side] == 0.0, 1.0, -1.0)[:, None] * off_side)

    def frame(self, patch: Ints, x: Array) -> tuple[Array, Array, Array]:
        """Return positions, unit normals out of the body, and second derivatives of the gap."""
        position, normal, bend = normals_and_bends(self.coefficients, patch, x)
        sign = self.signs[patch]
        return position, sign[:, None] * normal, sign[:, None, None] * bend


@prepared
def skin_of(atlas: Atlas, outside: Outside) -> Skin:
    """Return the skin of an atlas, which is made once."""
    return Skin(atlas, outside)
