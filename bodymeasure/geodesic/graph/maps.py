"""Constant matrices that turn a patch into polynomials across its straight line."""

from functools import lru_cache
from math import factorial

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bezier import bernstein

# Each field as a sum of derivatives of S by u and v: (times by u, times by v, factor).
_ACROSS = ((1, 0, 1.0), (0, 1, -1.0))
_ALONG = ((1, 0, 1.0), (0, 1, 1.0))
_ALONG_TWICE = ((2, 0, 1.0), (1, 1, 2.0), (0, 2, 1.0))
FIELDS = (_ACROSS, _ALONG, _ALONG_TWICE)


@lru_cache(maxsize=64)
def offset_map(degrees: tuple[int, int], times: tuple[float, ...]) -> Array:
    """Return the map from control points to polynomials in the offset q, at each t.

    With ``T(t, q) = S(t + q, t - q)``, the derivatives T_q, T_t and T_tt are at each t polynomials
    in q of a degree less than m + n, whose coefficients are linear in the control points.

    Parameters
    ----------
    degrees : tuple of int
        m and n, of the patch.
    times : tuple of float, k of them

    Returns
    -------
    ndarray, shape ((m + n) * 3 * k, (m + 1) * (n + 1))
        Rows run over the power of q, then over T_q, T_t, T_tt, then over t.
    """
    in_u, in_v = (bernstein(degree, np.array(times), order=degree) for degree in degrees)
    powers = sum(degrees)
    rows = np.zeros((powers, len(FIELDS), len(times), degrees[0] + 1, degrees[1] + 1))
    for power in range(powers):
        for number, field in enumerate(FIELDS):
            for a in range(power + 1):
                b = power - a
                taylor = (-1.0) ** b / (factorial(a) * factorial(b))
                for by_u, by_v, factor in field:
                    i, j = a + by_u, b + by_v
                    if i <= degrees[0] and j <= degrees[1]:
                        product = in_u[:, i, :, None] * in_v[:, j, None, :]
                        rows[power, number] += taylor * factor * product
    return rows.reshape(powers * len(FIELDS) * len(times), -1)
