"""Roots of polynomials in Bernstein form, and of functions that change sign once in a bracket."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.native import is_compiled, roots_in_brackets

# The most steps: halving alone needs some 55 for all digits, and with Newton's steps it takes six.
MAX_STEPS = 120
# The rounding error of parameters, which lie in [0, 1].
FINEST = 4e-16


def polynomial_values(coefficients: Array, t: Array) -> tuple[Array, Array]:
    """Return values and slopes at t, shape (...), for Bernstein coefficients (..., degree + 1)."""
    # De Casteljau's algorithm takes few large operations, which counts where there are many calls.
    b = np.moveaxis(coefficients, -1, 0)
    degree = len(b) - 1
    s = 1.0 - t
    for _ in range(degree - 1):
        b = s * b[:-1] + t * b[1:]
    return s * b[0] + t * b[1], degree * (b[1] - b[0])


def bracketed_roots(coefficients: Array, lower: Array, upper: Array) -> Array:
    """Return the root of each polynomial in a bracket in which it is monotone, shape (k,).

    Where the sign does not change in the bracket, it is the end with the smaller value.

    Parameters
    ----------
    coefficients : ndarray, shape (k, degree + 1)
        In Bernstein form on [0, 1].
    lower, upper : ndarray, shape (k,)

    Notes
    -----
    It is Newton's method, with a halving wherever its step would leave the bracket.
    """
    if is_compiled():
        return roots_in_brackets(coefficients, lower, upper)
    low, high = lower.astype(np.float64), upper.astype(np.float64)
    at_low, at_high = (polynomial_values(coefficients, t)[0] for t in (low, high))
    crosses = (at_low < 0.0) != (at_high < 0.0)
    t = np.where(np.abs(at_low) <= np.abs(at_high), low, high)
    t[crosses] = 0.5 * (low + high)[crosses]
    rising = at_low < 0.0
    busy = np.flatnonzero(crosses)
    for _ in range(MAX_STEPS):
        if not len(busy):
            break
        here = t[busy]
        value, slope = polynomial_values(coefficients[busy], here)
        below = (value < 0.0) == rising[busy]
        low[busy[below]] = here[below]
        high[busy[~below]] = here[~below]
        step = np.divide(value, slope, out=np.full_like(value, np.inf), where=slope != 0.0)
        # This comes first, since a root that is met exactly is an end of its bracket.
        arrived = np.abs(step) <= FINEST
        new = here - step
        outside = ~((new > low[busy]) & (new < high[busy])) & ~arrived
        new[outside] = 0.5 * (low[busy] + high[busy])[outside]
        t[busy] = np.clip(new, lower[busy], upper[busy])
        busy = busy[~arrived & (high[busy] - low[busy] > FINEST)]
    return t


def roots_of_polynomials(coefficients: Array) -> Array:
    """Return the ascending roots on [0, 1] at which the sign changes, shape (k, degree).

    Rows are filled up with NaN. The number of roots agrees with the signs at both ends, whatever
    the rounding; zero counts as positive.

    Parameters
    ----------
    coefficients : ndarray, shape (k, degree + 1)
        In Bernstein form; the degree is at least 2.

    Notes
    -----
    Between stationary points, which are the roots of the slope, a polynomial is monotone.
    """
    stations = np.concatenate(
        [
            np.zeros((len(coefficients), 1)),
            _stationary_points(coefficients),
            np.ones((len(coefficients), 1)),
        ],
        axis=1,
    )
    value, _ = polynomial_values(coefficients[:, None], stations)
    negative = value < 0.0
    row, place = np.nonzero(negative[:, 1:] != negative[:, :-1])
    roots = np.full((len(coefficients), coefficients.shape[1] - 1), np.nan)
    roots[row, place] = bracketed_roots(
        coefficients[row], stations[row, place], stations[row, place + 1]
    )
    return np.sort(roots, axis=1)


def _stationary_points(coefficients: Array) -> Array:
    """Return where the slope changes sign, in [0, 1], upwards, shape (k, degree - 1); else 0."""
    if coefficients.shape[1] == 4:
        return _stationary_points_of_cubics(coefficients)
    slopes = np.diff(coefficients, axis=1)
    if slopes.shape[1] == 2:
        # A linear slope has one root.
        change = slopes[:, :1] - slopes[:, 1:]
        points = np.divide(slopes[:, :1], change, out=np.zeros_like(change), where=change != 0.0)
        return np.clip(points, 0.0, 1.0)
    return np.sort(np.nan_to_num(roots_of_polynomials(slopes)), axis=1)


def _stationary_points_of_cubics(coefficients: Array) -> Array:
    """The cancellation-free form of the quadratic formula; clipped to [0, 1]."""
    d0, d1, d2 = np.diff(coefficients, axis=1).T
    # The slope is a t^2 + 2 b t + c.
    a, b, c = d0 - 2.0 * d1 + d2, d1 - d0, d0
    discriminant = b * b - a * c
    real = discriminant > 0.0
    q = -(b + np.copysign(np.sqrt(np.where(real, discriminant, 0.0)), b))
    points = np.zeros((len(coefficients), 2))
    for column, (top, bottom) in enumerate(((q, a), (c, q))):
        usable = real & (bottom != 0.0) & (np.abs(top) <= np.abs(bottom))
        np.divide(top, bottom, out=points[:, column], where=usable)
    return np.sort(np.clip(points, 0.0, 1.0), axis=1)
