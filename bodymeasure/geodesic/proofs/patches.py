"""The patches that the paths of a solution lie on, kept for proofs that are made when asked for."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.numerics.array_libraries import to_numpy
from bodymeasure.geodesic.proofs.shortest import are_shortest


@dataclass(frozen=True, eq=False)
class PatchesOfPaths:
    """Polynomial patches of about size 1, and which of them each path lies on.

    Parameters
    ----------
    control_points : array, shape (patches, m + 1, n + 1, 3)
        An array of the library that the user gave.
    surface_of : ndarray of int, shape (paths,)
    scale : ndarray, shape (paths,)
        The factors that take lengths on these patches to the user's unit.
    """

    control_points: Any
    surface_of: Ints
    scale: Array

    def take(self, paths: Ints) -> "PatchesOfPaths":
        """Return the patches of some of the paths, which do not keep the others in memory."""
        needed, surface_of = np.unique(self.surface_of[paths], return_inverse=True)
        points = to_numpy(self.control_points)[needed]
        return PatchesOfPaths(points, surface_of.reshape(-1), self.scale[paths])

    def prove_shortest(self, lengths: Array) -> Bools:
        """Return which paths are proven to be the only shortest ones on their patches.

        Parameters
        ----------
        lengths : ndarray, shape (paths,)
            Upper bounds of the lengths in the user's unit; NaN where there is none.
        """
        return are_shortest(to_numpy(self.control_points), self.surface_of, lengths / self.scale)
