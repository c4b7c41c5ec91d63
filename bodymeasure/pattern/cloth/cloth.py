"""Cloth over the skin: where it is above each place, and which way it faces."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas
from bodymeasure.atlas.normals import unit_normals
from bodymeasure.atlas.queries.outside import outward_sign
from bodymeasure.bezier import evaluate
from bodymeasure.pattern.cloth.creases import without_creases
from bodymeasure.pattern.cloth.ease import Ease
from bodymeasure.pattern.grid import CELLS, cell_triangles, regular_grid

# The part of a normal across the axis from which on the offset is across the axis, and below which
# it is along the normal, as on shoulders.
STEEP, LEVEL = 0.7, 0.35
# The step in (u, v) of differences that give the normals of cloth, which has no formula for them.
STEP = 1e-4


@dataclass(frozen=True, eq=False)
class Cloth:
    """The surface on which cloth lies.

    Parameters
    ----------
    atlas : Atlas
    ease : Ease, optional
        None if the cloth lies on the skin.

    Notes
    -----
    Where there is ease, places move across the body's axis, along the normal of the level curve,
    so that each level curve is longer by the ease that is asked for, however the skin leans. Where
    the skin is nearly level, as on the shoulders, they move along its normal. In creases, as in an
    armpit, where that would fold the cloth, they move more alike than their normals point. Where
    patches meet at an angle, as they may at the center front, they move between both normals, so
    that the cloth has no gap there.
    """

    atlas: Atlas
    ease: Ease | None = None

    def positions(self, patch: Ints, parameters: Array) -> Array:
        """Return where the cloth is above places (n,), (n, 2), shape (n, 3)."""
        nets = self.atlas.control_points[patch]
        skin = evaluate(nets, parameters)
        if self.ease is None:
            return np.asarray(skin)
        normals = self._outward * unit_normals(nets, parameters[:, None])[:, 0]
        ways = self._ways(normals) + _bilinear(self._aside, patch, parameters)
        return np.asarray(skin + self.ease.offsets(skin)[:, None] * ways)

    @cached_property
    def _outward(self) -> float:
        """The sign that turns normals outwards, found once."""
        return outward_sign(self.atlas)

    @cached_property
    def _aside(self) -> Array:
        """By how much ways differ at seams and in creases, at the grids of all patches."""
        assert self.ease is not None
        grid = regular_grid(self.atlas)
        patches = len(self.atlas)
        steps = np.linspace(0.0, 1.0, CELLS + 1)
        parameters = np.stack(np.meshgrid(steps, steps, indexing="ij"), axis=2).reshape(-1, 2)
        nets = self.atlas.control_points
        every = np.broadcast_to(parameters, (patches, *parameters.shape))
        skin = evaluate(nets, every).reshape(-1, 3)
        normals = self._outward * unit_normals(nets, every).reshape(-1, 3)
        own = self._ways(normals)
        vertex = grid.vertex.reshape(-1)
        positions, ways = np.zeros((grid.count, 3)), np.zeros((grid.count, 3))
        positions[vertex] = skin
        np.add.at(ways, vertex, own)
        size = np.linalg.norm(ways, axis=1, keepdims=True)
        ways /= np.where(size > 0.0, size, 1.0)
        places, _ = cell_triangles()
        triangles = grid.vertex[:, places[..., 0], places[..., 1]].reshape(-1, 3)
        even = without_creases(positions, triangles, ways, self.ease.offsets(positions))
        return (even[vertex] - own).reshape(patches, CELLS + 1, CELLS + 1, 3)

    def _ways(self, normals: Array) -> Array:
        """Return the unit vectors along which places move away from the skin."""
        assert self.ease is not None
        axis = self.ease.axis
        along = normals @ axis
        across = normals - along[:, None] * axis
        size = np.linalg.norm(across, axis=1)
        t = np.clip((STEEP - size) / (STEEP - LEVEL), 0.0, 1.0)
        leaning = t**3 * (10.0 - 15.0 * t + 6.0 * t**2)
        way = across + (leaning * along)[:, None] * axis
        return np.asarray(way / np.linalg.norm(way, axis=1, keepdims=True))

    def normals(self, patch: Ints, parameters: Array) -> Array:
        """Return unit normals of the cloth above places, either way, shape (n, 3)."""
        nets = self.atlas.control_points[patch]
        skin = unit_normals(nets, parameters[:, None])[:, 0]
        if self.ease is None:
            return skin
        steps = STEP * np.array([[1.0, 0.0], [0.0, 1.0]])
        inside = np.clip(parameters, STEP, 1.0 - STEP)
        tangents = [
            self.positions(patch, inside + step) - self.positions(patch, inside - step)
            for step in steps
        ]
        normal = np.cross(tangents[0], tangents[1])
        size = np.linalg.norm(normal, axis=1, keepdims=True)
        shortest = np.prod([np.linalg.norm(way, axis=1) for way in tangents], axis=0)[:, None]
        # At a pole of the skin's patch, tangents span no plane.
        usable = size > 1e-6 * np.maximum(shortest, 1e-300)
        return np.where(usable, normal / np.where(usable, size, 1.0), skin)


def _bilinear(values: Array, patch: Ints, parameters: Array) -> Array:
    """Return values (patches, CELLS + 1, CELLS + 1, d) of grids at places (n,), (n, 2) between."""
    scaled = parameters.clip(0.0, 1.0) * CELLS
    cell = np.minimum(scaled.astype(np.int64), CELLS - 1)
    part = scaled - cell
    i, j = cell.T
    u, v = part[:, :1], part[:, 1:]
    low = (1.0 - v) * values[patch, i, j] + v * values[patch, i, j + 1]
    high = (1.0 - v) * values[patch, i + 1, j] + v * values[patch, i + 1, j + 1]
    return np.asarray((1.0 - u) * low + u * high)
