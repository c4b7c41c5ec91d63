"""Rational Bezier patches as surfaces, and the choice between them and polynomial ones."""

from math import comb
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.geodesic.surfaces.protocol import JET, JET_SIZE


def surfaces_of(control_points: Any) -> "BezierSurfaces | RationalSurfaces":
    """Return polynomial or rational patches, by the number of their coordinates.

    Parameters
    ----------
    control_points : array, shape (problems, m + 1, n + 1, 3) or (problems, m + 1, n + 1, 4)
    """
    if control_points.shape[-1] == 4:
        return RationalSurfaces(control_points)
    return BezierSurfaces(control_points)


class RationalSurfaces:
    """Rational Bezier patches.

    Parameters
    ----------
    control_points : ndarray, shape (problems, m + 1, n + 1, 4)
        Control points in homogeneous coordinates; see `bodymeasure.bezier.homogeneous`.
    """

    def __init__(self, control_points: Array) -> None:
        self.control_points = control_points
        self._homogeneous = _Homogeneous(_normalized(control_points))

    def jet(self, parameters: Array, order: int) -> Array:
        """Return the derivatives in the order of `JET`, shape (derivatives, 3, problems, k).

        Notes
        -----
        Leibniz's rule for ``A = w S``, solved for the highest derivative of S: L. Piegl and W.
        Tiller, The NURBS Book, equation (4.20).
        """
        jet = self._homogeneous.jet(parameters, order)
        weight = jet[:, 3:]
        result = np.empty_like(jet[:, :3])
        for number, (i, j) in enumerate(JET[: JET_SIZE[order]]):
            value = jet[number, :3].copy()
            for other, (k, m) in enumerate(JET[1 : number + 1], start=1):
                if k <= i and m <= j:
                    rest = JET.index((i - k, j - m))
                    value -= comb(i, k) * comb(j, m) * weight[other] * result[rest]
            result[number] = value / weight[0]
        return result

    def positions(self, parameters: Array) -> Array:
        """Return points, shape (problems, k, 3)."""
        return evaluate(self.control_points, parameters)

    def magnitude(self, parameters: Array) -> Array:
        """Return the size of the terms of S_u and S_v, shape (2, problems, k)."""
        # The homogeneous coordinates are moved to the origin and divided by weights of 1 and more,
        # so that their terms are the greatest of all, up to a small factor.
        return self._homogeneous.magnitude(parameters)

    def take(self, problems: Ints) -> "RationalSurfaces":
        """Return the patches of some of the problems."""
        return RationalSurfaces(self.control_points[problems])


class _Homogeneous(BezierSurfaces):
    """Patches of four coordinates, which must not be moved before they are divided."""

    def _positions(self, points: Array) -> Array:
        return points


def _normalized(control_points: Array) -> Array:
    """The patches moved to the origin, their weights scaled to at least 1.

    They are scaled by powers of 2, so that nothing is rounded.
    """
    weight = control_points[..., 3:]
    least = weight.min(axis=(1, 2), keepdims=True)
    scaled = control_points * np.ldexp(1.0, 1 - np.frexp(least)[1])
    points = control_points[..., :3] / weight
    middle = 0.5 * (points.min(axis=(1, 2)) + points.max(axis=(1, 2)))[:, None, None]
    moved = scaled[..., :3] - middle * scaled[..., 3:]
    return np.concatenate([moved, scaled[..., 3:]], axis=-1)
