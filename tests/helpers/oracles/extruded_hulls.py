"""Taut tapes over extruded profiles, in closed form: hulls of the profile, unrolled.

A profile z(x) of cubics over x = 0, 1, 2, ... is extruded along y from -1 to 1. Between the ends of
a tape, the least concave function above the profile is the profile of the taut skin, which is
developable: a tape is as long as the hypotenuse of that function's arc length and its extent
along y.
"""

from typing import NamedTuple

import numpy as np
from helpers.surfaces.grids import grid_index

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, AtlasPoint, Unit

# Samples of the profile between two ends.
SAMPLES = 20001


class ProfileCase(NamedTuple):
    """A profile's control values, both ends as (x, y), and on which side the tape runs."""

    heights: Array
    start: tuple[float, float]
    end: tuple[float, float]
    above: bool

    @property
    def atlas(self) -> Atlas:
        """The profile extruded along y, each cubic a patch."""
        count = len(self.heights)
        x, y = np.meshgrid(np.arange(count) / 3.0, np.linspace(-1.0, 1.0, 4), indexing="ij")
        z = np.broadcast_to(self.heights[:, None], x.shape)
        return Atlas(np.stack([x, y, z], axis=-1).reshape(-1, 3), self._index, Unit.CM)

    @property
    def _index(self) -> Ints:
        return grid_index((len(self.heights) - 1) // 3, 1)

    @property
    def points(self) -> tuple[AtlasPoint, AtlasPoint]:
        """Both ends on the atlas."""
        first, last = (self._point(*place) for place in (self.start, self.end))
        return first, last

    def _point(self, x: float, y: float) -> AtlasPoint:
        patch = min(int(x), (len(self.heights) - 1) // 3 - 1)
        return AtlasPoint(patch, x - patch, 0.5 * (y + 1.0))

    def height(self, x: Array) -> Array:
        """The heights of the profile at x (k,)."""
        patch = np.minimum(x.astype(np.int64), (len(self.heights) - 1) // 3 - 1)
        t = x - patch
        weights = ((1.0 - t) ** 3, 3.0 * t * (1.0 - t) ** 2, 3.0 * t * t * (1.0 - t), t**3)
        return np.asarray(
            sum(w * self.heights[3 * patch + k] for k, w in enumerate(weights)), dtype=np.float64
        )

    @property
    def length(self) -> float:
        """The length of the tape."""
        low, high = sorted((self.start[0], self.end[0]))
        kinks = np.arange(np.ceil(low), np.floor(high) + 1.0)
        x = np.unique(np.concatenate([np.linspace(low, high, SAMPLES), kinks]))
        x = x[(x >= low) & (x <= high)]
        z = self.height(x) * (1.0 if self.above else -1.0)
        hull = _concave(x, z)
        chords = np.hypot(np.diff(x[hull]), np.diff(z[hull]))
        # Where no sample is bridged, two chords and extrapolation give the arc.
        middle = 0.5 * (x[hull][:-1] + x[hull][1:])
        rise = self.height(middle) * (1.0 if self.above else -1.0)
        halves = np.hypot(middle - x[hull][:-1], rise - z[hull][:-1])
        halves += np.hypot(x[hull][1:] - middle, z[hull][1:] - rise)
        arcs = (4.0 * halves - chords) / 3.0
        profile = float(np.where(np.diff(hull) == 1, arcs, chords).sum())
        return float(np.hypot(profile, self.start[1] - self.end[1]))


def random_profile(rng: np.random.Generator) -> ProfileCase:
    """A random profile of one to four cubics, with kinks or without, and a random tape over it."""
    count = int(rng.integers(1, 5))
    size = rng.choice([0.1, 0.3, 0.8, 2.0])
    heights = rng.uniform(-size, size, 3 * count + 1)
    if rng.random() < 0.3:
        for joint in range(3, 3 * count, 3):
            heights[joint] = 0.5 * (heights[joint - 1] + heights[joint + 1])
    ends = [(float(rng.uniform(0, count)), float(rng.uniform(-1, 1))) for _ in range(2)]
    return ProfileCase(heights, ends[0], ends[1], bool(rng.random() < 0.5))


def _concave(x: Array, z: Array) -> Ints:
    """The numbers of the points (k,) on the least concave function above points in order."""
    chain: list[int] = []
    for k in range(len(x)):
        while len(chain) > 1:
            i, j = chain[-2:]
            if (x[j] - x[i]) * (z[k] - z[i]) < (z[j] - z[i]) * (x[k] - x[i]):
                break
            chain.pop()
        chain.append(k)
    return np.array(chain)
