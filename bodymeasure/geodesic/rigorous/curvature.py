"""The bounds of `proofs.curvature` in exact arithmetic."""

from math import comb
from typing import Any, NamedTuple

import numpy as np
from flint import arb, fmpq

from bodymeasure.geodesic.rigorous.grids import Grid, cross, dot

MOST_HALVINGS = 5


class ExactBounds(NamedTuple):
    """Bounds of one patch: upper ends of these balls hold.

    Parameters
    ----------
    curvature : arb
        Of the Gaussian curvature, at least 0.
    positive : arb
        Of the integral of its positive part.
    """

    curvature: Any
    positive: Any


class Part(NamedTuple):
    """A part of a patch: control points times 2^scale, as integers, and its size in u and v."""

    points: Any
    scale: int


def exact_bounds(points: Any, scale: int, wanted: Any, steep: Any) -> ExactBounds | None:
    """Return bounds of a patch's curvature, refined until they are as small as wanted.

    Parameters
    ----------
    points : ndarray of fmpz, shape (m + 1, n + 1, 3)
        Control points times 2^scale.
    scale : int
    wanted : arb
        A part whose bound is this small is not refined further.
    steep : arb
        Where the curvature at a corner of a part is larger than this, the patch is given up.

    Returns
    -------
    ExactBounds or None
        None if the patch is not shown to be regular, or is given up.
    """
    parts = [Part(points, scale)]
    curvature, positive = arb(0), arb(0)
    for halvings in range(MOST_HALVINGS + 1):
        left = []
        for part in parts:
            found = _bound(part)
            last = halvings == MOST_HALVINGS
            if found is not None and (found.curvature <= wanted or last):
                curvature = curvature.max(found.curvature)
                positive += found.curvature * found.area
            elif last or (found is not None and found.at_corners > steep):
                return None
            else:
                left += _quarters(part)
        parts = left
    return ExactBounds(curvature, positive)


class PartBounds(NamedTuple):
    """Upper bounds of a part's curvature and area, and the largest curvature at its corners."""

    curvature: Any
    area: Any
    at_corners: Any


def _bound(part: Part) -> PartBounds | None:
    """Bounds of the curvature and the area of a part; None if it may be singular."""
    points = part.points
    s_u, s_v = _derivative(points, 0), _derivative(points, 1)
    along_u, along_v = _grids(s_u), _grids(s_v)
    normal = cross(along_u, along_v)
    square = dot(normal, normal)
    if any(value <= 0 for value in square.values):
        return None
    bend_u = dot(_grids(_derivative(s_u, 0)), normal)
    bend_v = dot(_grids(_derivative(s_v, 1)), normal)
    twist = dot(_grids(_derivative(s_u, 1)), normal)
    numerator = bend_u * bend_v - twist * twist
    fourth = square * square
    numerator = numerator.elevated(*fourth.degrees)
    ratios = [
        fmpq(above, below) for above, below in zip(numerator.values, fourth.values, strict=True)
    ]
    width = fourth.degrees[0]
    corners = max(ratios[number] for number in (0, width, -1 - width, -1))
    # The curvature has the unit of 1 / length^2; |m|^2, integrated, that of length^4.
    unit = arb(2) ** part.scale
    m, n = square.degrees
    binomials = [comb(m, i) * comb(n, j) for j in range(n + 1) for i in range(m + 1)]
    mean = sum(
        (fmpq(value, b) for value, b in zip(square.values, binomials, strict=True)), fmpq(0)
    ) / len(binomials)
    return PartBounds(
        arb(max(*ratios, fmpq(0))) * unit**2, arb(mean).sqrt() / unit**2, arb(corners) * unit**2
    )


def _quarters(part: Part) -> list[Part]:
    m, n = part.points.shape[0] - 1, part.points.shape[1] - 1
    return [
        Part(_half(_half(part.points, 0, upper_u), 1, upper_v), part.scale + m + n)
        for upper_u in (False, True)
        for upper_v in (False, True)
    ]


def _half(points: Any, axis: int, upper: bool) -> Any:
    """Half of a patch along an axis, times 2^degree, by sums of neighbors (de Casteljau)."""
    rows = np.moveaxis(points, axis, 0)
    degree = len(rows) - 1
    result = np.empty_like(rows)
    current = rows
    for step in range(degree + 1):
        place, end = (degree - step, -1) if upper else (step, 0)
        result[place] = current[end] * 2 ** (degree - step)
        current = current[1:] + current[:-1]
    return np.moveaxis(result, 0, axis)


def _derivative(points: Any, axis: int) -> Any:
    degree = points.shape[axis] - 1
    return np.diff(points, axis=axis) * degree if degree else points * 0


def _grids(vectors: Any) -> list[Grid]:
    return [Grid.of(vectors[..., c]) for c in range(3)]
