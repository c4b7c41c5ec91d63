"""A place on an atlas."""

from dataclasses import dataclass


@dataclass(frozen=True)
class AtlasPoint:
    """A point of an atlas: its patch and the parameters on it.

    Parameters
    ----------
    patch : int
        Number of the patch, from 0.
    u, v : float
        Parameters in [0, 1].
    """

    patch: int
    u: float
    v: float
