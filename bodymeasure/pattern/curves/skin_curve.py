"""A curve on the skin as chains of points, one for each patch, with its exact length."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import AtlasPoint

# Parameters this near to 0 or 1 are on the side: a plane that runs through a seam is moved off it
# by 1e-11 of the body's size, and the solver of geodesics leaves about as much.
ON_SIDE = 2e-7
# In meters: the distance of points along a chain, which is taken as straight in (u, v) between
# them. A chain of twice that is 0.1 per mill shorter than a neckline, which only moves the border
# by hundredths of a millimeter; lengths are never taken from it.
STEP = 0.003

# Parameters by which the end of a curve may differ from the point to which it leads: the place of a
# section nearest to a point is found to the square root of rounding.
SAME_END = 1e-5


class Run(NamedTuple):
    """The part of a curve on one patch.

    Parameters
    ----------
    patch : int
    parameters : ndarray, shape (k, 2)
        (u, v), in order; those on a side are on it exactly.
    """

    patch: int
    parameters: Array

    @property
    def reversed(self) -> "Run":
        """The run from its end to its start."""
        return Run(self.patch, self.parameters[::-1])


@dataclass(frozen=True, eq=False)
class SkinCurve:
    """A curve on the skin.

    Parameters
    ----------
    length : float
        Its length on the smooth surface, or on the cloth above it, in the atlas's unit.
    runs : tuple of Run
        In order.
    places : callable
        Takes lengths (n,) from the start, and returns patches (n,) and (u, v) (n, 2) there.
    turns : ndarray, shape (k,)
        The lengths from the start at which it goes over to another patch, growing.
    """

    length: float
    runs: tuple[Run, ...]
    places: Callable[[Array], tuple[Ints, Array]]
    turns: Array

    @property
    def reversed(self) -> "SkinCurve":
        """The same curve from its end to its start."""
        places, length = self.places, self.length
        return replace(
            self,
            runs=tuple(run.reversed for run in self.runs[::-1]),
            places=lambda arc: places(length - arc),
            turns=length - self.turns[::-1],
        )

    def with_ends(self, start: AtlasPoint, end: AtlasPoint) -> "SkinCurve":
        """Return the curve with the ends of its chains exactly at points that others share."""
        runs = [*self.runs]
        for row, column, point in ((0, 0, start), (-1, -1, end)):
            run, place = runs[row], np.array([point.u, point.v])
            if run.patch == point.patch:
                parameters = run.parameters.copy()
                if np.abs(parameters[column] - place).max() < SAME_END:
                    parameters[column] = on_sides(place)
                runs[row] = Run(run.patch, parameters)
        return replace(self, runs=tuple(runs))


def on_sides(parameters: Array) -> Array:
    """Return parameters with those beside a side of their patch moved onto it."""
    near_0, near_1 = parameters < ON_SIDE, parameters > 1.0 - ON_SIDE
    return np.where(near_0, 0.0, np.where(near_1, 1.0, parameters))


def steps_of(length: float, meters: float) -> int:
    """Return the number of equal steps into which a chain is cut, for a length in meters."""
    return max(2, int(np.ceil(length * meters / STEP)))
