"""The limits on the size of an atlas."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError

# Sizes and coordinates beyond this, and sizes below its inverse, are mistakes.
LARGEST = 1e60


def require_size(points: Array, unit: str = "", what: str = "the atlas") -> None:
    """Refuse points so far away or so close together that squares of their areas overflow.

    Parameters
    ----------
    points : ndarray, shape (n, 3)
    unit, what : str
        Words for the message.

    Raises
    ------
    InputError
        The message names the extent, and what was expected.
    """
    extent = np.abs(points).max(initial=0.0)
    if extent <= LARGEST:
        extent = np.abs(points - points[:1]).max(initial=0.0)
    if extent > LARGEST or 0.0 < extent < 1.0 / LARGEST:
        over = f"{extent:.3g} {unit}".rstrip()
        raise InputError(
            f"{what} extends over {over}; expected a size between "
            f"{1.0 / LARGEST:g} and {LARGEST:g}: choose another unit"
        )


def patch_sizes(control_points: Array) -> Array:
    """Return the diagonal of the box around each patch's points (..., 3), shape (patches,)."""
    nets = control_points.reshape(len(control_points), -1, 3)
    return np.asarray(np.linalg.norm(np.ptp(nets, axis=1), axis=-1))
