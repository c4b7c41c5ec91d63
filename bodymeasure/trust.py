"""The rule of accuracy: no length whose error may be a notable part of it is called converged."""

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Bools

LARGEST_ERROR = 1e-4
"""A length is known if its estimated error is at most this part of it: 0.1 mm of a meter.

It holds for every kind of measurement. Tapes differ by more in the hands of one measurer; a larger
estimate means that the surface, or the path on it, was not resolved, and may itself be wrong."""

NEGLIGIBLE = 1e-6
"""Lengths shorter than this part of the measured surface are treated as if they were as long.

Between points that are one but for rounding, the rounding is all that is measured."""


def is_known(length: ArrayLike, error: ArrayLike, size: ArrayLike) -> Bools:
    """Return which lengths are known well enough to be called converged.

    Parameters
    ----------
    length, error : array_like
        Lengths and their estimated errors, in one unit; NaN is not known.
    size : array_like
        The size of the surface that is measured, in the same unit.
    """
    least = NEGLIGIBLE * np.asarray(size)
    return np.asarray(np.asarray(error) <= LARGEST_ERROR * np.maximum(np.abs(length), least))
