"""The part of a patch around two points, as a patch of its own, by exact rational arithmetic.

Between points 1e-12 apart, parameters in double precision tell four digits of the way. On the part
of the patch about them they tell all, if its control points are those of the patch as given.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array

# The part reaches further by this many times the distance of the points, each way, in the patch.
MARGIN = 2


class Enlarged(NamedTuple):
    """A patch (4, 4, 3) with one control point at 0, the points (2, 2) on it, and where it lies.

    ``(u, v) = low + size * (its own parameters)``.
    """

    net: Array
    ends: Array
    low: Array
    size: Array


def enlarged(net: Array, ends: Array, path: Array) -> Enlarged:
    """The part of a patch around two points that are apart, and around a path between them."""
    points = [[Fraction(float(x)) for x in point] for point in ends]
    reach = MARGIN * max(abs(a - b) for a, b in zip(*points, strict=True))
    low, high = [], []
    for axis, pair in enumerate(zip(*points, strict=True)):
        far = [Fraction(float(x)) for x in (path[:, axis].min(), path[:, axis].max())]
        low.append(max(Fraction(0), min(*far, *pair) - reach))
        high.append(min(Fraction(1), max(*far, *pair) + reach))
    exact = np.vectorize(Fraction, otypes=[object])(net)
    part = _between(exact, low[0], high[0])
    part = _between(part.swapaxes(0, 1), low[1], high[1]).swapaxes(0, 1)
    size = [b - a for a, b in zip(low, high, strict=True)]
    own = [[float((x - a) / s) for x, a, s in zip(p, low, size, strict=True)] for p in points]
    return Enlarged(
        (part - part[0, 0]).astype(np.float64), np.array(own), _floats(low), _floats(size)
    )


def _floats(numbers: Sequence[Fraction]) -> Array:
    return np.array([float(x) for x in numbers])


def _between(net: NDArray[np.object_], low: Fraction, high: Fraction) -> NDArray[np.object_]:
    """Control points of the part from low to high along the first axis, by blossoming."""
    degree = len(net) - 1
    result = []
    for number in range(degree + 1):
        points = net
        for place in [low] * (degree - number) + [high] * number:
            points = points[:-1] * (1 - place) + points[1:] * place
        result.append(points[0])
    return np.array(result)
