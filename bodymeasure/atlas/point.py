"""The value type of a point on an atlas."""

from typing import NamedTuple


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
