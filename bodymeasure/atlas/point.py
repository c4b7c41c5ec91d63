"""The value type of a point on an atlas."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array

# Parameters this near to 0 or 1 are 0 or 1, but for rounding. The search for a closest point ends
# with a step of 1e-12, and sums and products of parameters are good to some 1e-15. Nothing that is
# measured changes by more than this part of a patch's size.
ON_EDGE = 4e-12


class AtlasPoint(NamedTuple):
    """A point of an atlas: its patch and the parameters on it.

    A point on a seam, a corner or a pole can be written in several ways, which
    `bodymeasure.atlas.topology.neighbors` lists.

    Parameters
    ----------
    patch : int
        Number of the patch, from 0.
    u, v : float
        Parameters in [0, 1].

    Examples
    --------
    >>> import bodymeasure as bm
    >>> atlas = bm.load_sample("paraboloid")
    >>> atlas.position(bm.AtlasPoint(0, 0.5, 0.5)).tolist()
    [0.5, 0.5, 0.5]
    """

    patch: int
    u: float
    v: float

    def on_edge(self) -> "AtlasPoint":
        """Return the point, on the edge or corner beside which it lies only by rounding."""
        return AtlasPoint(self.patch, *on_edges(np.array([self.u, self.v])).tolist())


def on_edges(parameters: Array) -> Array:
    """Return parameters of any shape in which those within `ON_EDGE` of 0 or 1 are exactly that."""
    nearest = np.round(parameters)
    return np.where(np.abs(parameters - nearest) <= ON_EDGE, nearest, parameters)
