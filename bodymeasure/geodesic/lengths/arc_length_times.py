"""The times at which paths of varying speed have covered given parts of their lengths."""

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.geodesic.spaces.quadrature import Quadrature

# The most Newton steps, within a bracket that each of them narrows; four are enough where speeds
# vary little.
STEPS = 50
# From an arc length this close to the one that is sought, relative to the whole, one more step
# reaches it to within rounding errors.
CLOSE = 1e-9


def checked_times(t: ArrayLike) -> Array:
    """Return the parameters of a path that a user gives as an array.

    Raises
    ------
    InputError
        If one is not a number in [0, 1].
    """
    try:
        times = np.asarray(t, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"path parameters are {t!r}; expected numbers in [0, 1]") from None
    # `not inside` rather than `outside`, so that NaN is refused too.
    if not ((times >= 0.0) & (times <= 1.0)).all():
        raise InputError(f"path parameters must lie in [0, 1]; got {times}")
    return times


def times_at(quadrature: Quadrature, speed: Array, parts: Array) -> Array:
    """Return the parameters at which paths have covered given parts of their lengths.

    Parameters
    ----------
    quadrature : Quadrature
    speed : ndarray, shape (problems, points)
        The speeds at the quadrature's points; positive.
    parts : ndarray, shape (k,)
        The parts, in [0, 1].

    Returns
    -------
    ndarray, shape (problems, k)
        In [0, 1].
    """
    pieces = speed.reshape(len(speed), len(quadrature.widths), quadrature.count)
    # Legendre coefficients of speed and arc length on each piece, (coefficient, problem, piece).
    analysis = quadrature.rule.analysis
    rate = np.moveaxis(pieces @ analysis * quadrature.widths[:, None] / 2.0, -1, 0)
    gone = legendre.legint(rate, lbnd=-1.0)
    through = np.cumsum(legendre.legval(1.0, gone), axis=1)
    before = np.concatenate([np.zeros((len(speed), 1)), through[:, :-1]], axis=1)
    wanted = through[:, -1:] * parts
    piece = (through[:, None, :-1] < wanted[:, :, None]).sum(axis=2)
    row = np.arange(len(speed))[:, None]
    wanted = wanted - before[row, piece]
    rate, gone = rate[:, row, piece], gone[:, row, piece]
    # A start that rounding put outside the bracket would be sent to its middle.
    x = np.clip(2.0 * wanted / gone.sum(axis=0) - 1.0, -1.0, 1.0)
    low, high = np.full_like(x, -1.0), np.full_like(x, 1.0)
    # A few paths nearly stand still somewhere and take many steps: the others wait no longer.
    found, rest = x.copy(), np.arange(len(x))
    for _ in range(STEPS):
        # One basis for both: what takes the time is to make it.
        basis = np.moveaxis(legendre.legvander(x, len(gone) - 1), -1, 0)
        excess = (basis * gone).sum(axis=0) - wanted
        close = (np.abs(excess) <= CLOSE * through[rest, -1:]).all(axis=1)
        low, high = np.where(excess < 0.0, x, low), np.where(excess > 0.0, x, high)
        step = x - excess / (basis[:-1] * rate).sum(axis=0)
        x = np.where((step >= low) & (step <= high), step, (low + high) / 2.0)
        if close.any():
            found[rest] = x
            keep = ~close
            rest, x, low, high, wanted = (each[keep] for each in (rest, x, low, high, wanted))
            rate, gone = rate[:, keep], gone[:, keep]
            if len(rest) == 0:
                break
    found[rest] = x
    x = found
    edges = np.concatenate([[0.0], np.cumsum(quadrature.widths)])
    times: Array = edges[piece] + quadrature.widths[piece] * (x + 1.0) / 2.0
    return np.clip(times, 0.0, 1.0)
