"""The patches over which a geodesic is followed, and the poles that it may come close to."""

from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.geodesic.across.routes.topology import topology
from bodymeasure.geodesic.surfaces.rational import surfaces_of
from bodymeasure.geodesic.tracing.motion import Pole, State, Surfaces
from bodymeasure.geodesic.tracing.pole import place_on_side

# Part of the size of a patch at which a geodesic goes through its pole along the tangent plane. The
# error of its direction is of the order of the square of this, and of rounding divided by it.
NEAR_POLE = 1e-5


class PoleBeside(NamedTuple):
    """A pole of a patch as seen from a point of it, where the patch has size 1.

    Parameters
    ----------
    side : int
        The collapsed side.
    pole : Pole
    offset : ndarray, shape (3,)
        From the pole to the point.
    """

    side: int
    pole: Pole
    offset: Array

    @property
    def distance(self) -> float:
        """The distance of the point from the pole."""
        return float(np.linalg.norm(self.offset))


@dataclass(frozen=True, eq=False)
class Patches:
    """The patches of an atlas, each scaled to about size 1, and their poles."""

    atlas: Atlas
    _surfaces: dict[int, Surfaces] = field(default_factory=dict)

    @cached_property
    def neighbors(self) -> Neighbors:
        """The steps over the seams."""
        return topology(self.atlas).neighbors

    @cached_property
    def sizes(self) -> Array:
        """The sizes of the patches, shape (patches,)."""
        points = self.atlas.points[self.atlas.index].reshape(len(self.atlas), -1, 3)
        return np.asarray(np.ptp(points, axis=1).max(axis=1))

    def surface(self, patch: int) -> Surfaces:
        """Return the one patch, of size 1."""
        if patch not in self._surfaces:
            nets = self.atlas.control_points[[patch]].copy()
            nets[..., :3] /= self.sizes[patch]
            self._surfaces[patch] = surfaces_of(nets)
        return self._surfaces[patch]

    def pole_near(self, state: State) -> tuple[int, Pole] | None:
        """Return the collapsed side of a patch that a geodesic nears, and the pole there."""
        near = self.pole_beside(state)
        return None if near is None else (near.side, near.pole)

    def pole_beside(self, state: State) -> PoleBeside | None:
        """Return the pole of a patch that is the closest to a point."""
        found = []
        for side in np.flatnonzero(self.neighbors.collapsed[state.patch]).tolist():
            place = place_on_side(state.patch, side, 0.0)
            position = self.atlas.position(place) / self.sizes[state.patch]
            here = self.surface(state.patch).positions(state.parameters[None, None])[0, 0]
            found.append(PoleBeside(side, Pole(position, NEAR_POLE), here - position))
        return min(found, key=lambda each: each.distance, default=None)

    def around(self, patch: int, side: int, size: float) -> list[tuple[int, Surfaces, int]]:
        """Return the patches around a pole, each as a surface of one scale and with its side."""
        places = self.neighbors.same(place_on_side(patch, side, 0.0))
        result = []
        for place in places:
            other = self.neighbors.pole_side(place)
            if other is not None:
                nets = self.atlas.control_points[[place.patch]].copy()
                nets[..., :3] /= size
                result.append((place.patch, surfaces_of(nets), other))
        return result
