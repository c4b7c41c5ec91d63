r"""Bounds of a patch's Gaussian curvature and area that hold at every point of it.

With :math:`m = S_u \times S_v` and
:math:`d = (S_{uu} \cdot m)(S_{vv} \cdot m) - (S_{uv} \cdot m)^2`, the Gaussian curvature is
:math:`K = d / |m|^4`, a quotient of two polynomials. Written in one Bernstein basis, with
coefficients :math:`d_i` and :math:`c_i > 0`, it is at most the largest :math:`d_i / c_i`, since
:math:`k |m|^4 - d` then has no negative coefficient. On parts of the patch the bound is closer.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.bezier.split import halves
from bodymeasure.geodesic.proofs.bernstein import elevated, multiplied, scaled, unscaled

# On bicubic patches, fewer than 900 roundings enter any coefficient, halvings included: 1e-13 of
# the product of the sizes of its factors. Ten times that is left on the safe side. On patches of
# higher degrees there are more, in proportion to the terms of the products.
MARGIN = 1e-12
BICUBIC = 16
SQUARE_OF_BICUBIC = 121
# The same for sums of positive terms, whose roundings are relative to the sum itself.
RELATIVE = 1e-13
# Each halving quarters what the bounds are too large by; after five of them, a thousandth is left.
MOST_HALVINGS = 5
# Patches are taken in groups whose arrays stay in the processor's cache.
GROUP = 64


class Forms(NamedTuple):
    """The polynomials of parts of patches, as Bernstein coefficients (m + 1, n + 1, parts).

    Parameters
    ----------
    numerator : ndarray
        Coefficients of d, not smaller than the true ones.
    square : ndarray
        Coefficients of ``|m|^2``, not larger than the true ones.
    above : ndarray
        Coefficients of ``|m|^2``, not smaller than the true ones.
    """

    numerator: Array
    square: Array
    above: Array

    def take(self, rows: Ints | Bools) -> "Forms":
        """Return some of the parts."""
        return Forms(*(values[..., rows] for values in self))

    def quarters(self) -> "Forms":
        """Return the four quarters of each part, all first quarters first."""
        return Forms(*map(_quarters, self))


@dataclass(frozen=True)
class CurvatureBounds:
    """What is known of the curvature everywhere on patches; arrays of shape (patches,).

    Parameters
    ----------
    curvature : ndarray
        An upper bound of the Gaussian curvature, at least 0; infinite where the patch is not shown
        to be regular, that is to have ``S_u x S_v`` unlike 0 everywhere.
    positive : ndarray
        An upper bound of the integral of the positive part of the curvature over the patch.
    area : ndarray
        An upper bound of the area of the patch.
    """

    curvature: Array
    positive: Array
    area: Array

    @classmethod
    def concatenated(cls, groups: "Sequence[CurvatureBounds]") -> "CurvatureBounds":
        """Return the bounds of several groups of patches as those of one."""
        names = ("curvature", "positive", "area")
        return cls(*(np.concatenate([getattr(each, name) for each in groups]) for name in names))

    def take(self, rows: Ints) -> "CurvatureBounds":
        """Return the bounds of some of the patches."""
        return CurvatureBounds(self.curvature[rows], self.positive[rows], self.area[rows])

    def put(self, rows: Ints, bounds: "CurvatureBounds") -> None:
        """Put in the bounds of some of the patches."""
        self.curvature[rows] = bounds.curvature
        self.positive[rows] = bounds.positive
        self.area[rows] = bounds.area

    def scaled(self, factor: Array) -> "CurvatureBounds":
        """Return the bounds of patches that are larger by a factor, a power of 2."""
        # Of the smallest patches the area vanishes, and of the largest the curvature.
        with np.errstate(over="ignore", under="ignore"):
            return CurvatureBounds(
                self.curvature / factor / factor, self.positive, self.area * factor * factor
            )


def forms(control_points: Array) -> Forms:
    """Return the polynomials of patches of about size 1, shape (patches, m + 1, n + 1, 3)."""
    points = np.ascontiguousarray(control_points.transpose(3, 1, 2, 0))
    along_u, along_v = _derivative(points, 1), _derivative(points, 2)
    s_u, s_v = _largest(along_u), _largest(along_v)
    p, q = points.shape[1] - 1, points.shape[2] - 1
    # What second derivatives are the differences of.
    s_uu, s_vv = 2.0 * max(p - 1, 0) * s_u, 2.0 * max(q - 1, 0) * s_v
    s_uv = 2.0 * np.minimum(q * s_u, p * s_v)
    normal = _cross(_scaled(along_u), _scaled(along_v))
    bend_u = _dot(_scaled(_derivative(along_u, 1)), normal)
    bend_v = _dot(_scaled(_derivative(along_v, 2)), normal)
    twist = _dot(_scaled(_derivative(along_u, 2)), normal)
    numerator = _difference(multiplied(bend_u, bend_v), multiplied(twist, twist))
    square = unscaled(_dot(normal, normal))
    size = (s_u * s_v) ** 2
    margin = MARGIN * max(1.0, (p + 1) * (q + 1) / BICUBIC)
    slack = margin * size
    return Forms(
        unscaled(numerator) + margin * (s_uu * s_vv + s_uv**2) * size,
        square - slack,
        square + slack,
    )


def curvature_bounds(
    control_points: Array, wanted: Array, steep: Array, *, most_halvings: int = MOST_HALVINGS
) -> CurvatureBounds:
    """Return bounds of the curvature of patches, refined until they are as small as wanted.

    Parameters
    ----------
    control_points : ndarray, shape (patches, m + 1, n + 1, 3)
        Patches of about size 1; those of the solver are.
    wanted : ndarray, shape (patches,)
        A part of a patch whose bound is this small is not refined further.
    steep : ndarray, shape (patches,)
        Where the curvature at a corner of a part is larger than this, the patch is given up: what
        is returned then holds, but is no closer than it has to be.
    most_halvings : int
    """
    found = []
    for first in range(0, len(control_points), GROUP):
        some = slice(first, first + GROUP)
        parts = forms(control_points[some])
        found.append(_bounds_of_group(parts, wanted[some], steep[some], most_halvings))
    return CurvatureBounds.concatenated(found)


def _bounds_of_group(
    parts: Forms, wanted: Array, steep: Array, most_halvings: int
) -> CurvatureBounds:
    count = len(wanted)
    owner, size = np.arange(count), 1.0
    curvature, positive, area = np.zeros((3, count))
    for halvings in range(most_halvings + 1):
        bound = _bound(parts)
        # The mean of the coefficients is the mean square, which is at least the squared mean.
        areas = size * np.sqrt(parts.above.mean(axis=(0, 1))) * (1.0 + RELATIVE)
        lost = np.zeros(count, bool)
        lost[owner[_exceeds(parts, steep[owner])]] = True
        done = (bound <= wanted[owner]) | lost[owner] | (halvings == most_halvings)
        np.maximum.at(curvature, owner[done], bound[done])
        np.add.at(area, owner[done], areas[done])
        np.add.at(positive, owner[done], bound[done] * areas[done])
        if done.all():
            break
        parts, owner, size = parts.take(~done).quarters(), np.tile(owner[~done], 4), size / 4.0
    return CurvatureBounds(curvature, positive * (1.0 + RELATIVE), area * (1.0 + RELATIVE))


def _bound(parts: Forms) -> Array:
    """An upper bound of the curvature on each part, at least 0; infinite where it has none."""
    regular = (parts.square > 0.0).all(axis=(0, 1))
    products = scaled(np.where(regular, parts.square, 1.0))
    terms = products.shape[0] * products.shape[1]
    relative = RELATIVE * max(1.0, terms / SQUARE_OF_BICUBIC)
    fourth = unscaled(multiplied(products, products)) * (1.0 - relative)
    degrees = fourth.shape[0] - 1, fourth.shape[1] - 1
    numerator = unscaled(elevated(scaled(parts.numerator), *degrees))
    return np.where(regular, np.maximum(numerator / fourth, 0.0).max(axis=(0, 1)), np.inf)


def _exceeds(parts: Forms, steep: Array) -> Bools:
    """Which parts have, at a corner, a curvature above a limit, or no regular point."""
    numerator, square, above = (
        values[::step, ::other]
        for values, step, other in (
            (values, values.shape[0] - 1, values.shape[1] - 1) for values in parts
        )
    )
    exceeds = (square <= 0.0) | (numerator > steep * above**2)
    return np.asarray(exceeds.any(axis=(0, 1)))


def _quarters(coefficients: Array) -> Array:
    lower_u, upper_u = halves(coefficients.shape[0] - 1, 0.5)
    lower_v, upper_v = halves(coefficients.shape[1] - 1, 0.5)
    return np.concatenate(
        [
            np.einsum("ai,bj,ijc->abc", rows_u, rows_v, coefficients, optimize=True)
            for rows_u in (lower_u, upper_u)
            for rows_v in (lower_v, upper_v)
        ],
        axis=2,
    )


def _derivative(coefficients: Array, axis: int) -> Array:
    """The derivative of vector polynomials (3, m + 1, n + 1, patches) along axis 1 or 2."""
    degree = coefficients.shape[axis] - 1
    return degree * np.diff(coefficients, axis=axis) if degree else np.zeros_like(coefficients)


def _largest(vectors: Array) -> Array:
    """The largest size of a coefficient, shape (patches,)."""
    return np.asarray(np.sqrt((vectors**2).sum(axis=0).max(axis=(0, 1))))


def _scaled(vectors: Array) -> Array:
    return np.stack([scaled(each) for each in vectors])


def _cross(a: Array, b: Array) -> Array:
    return np.stack(
        [multiplied(a[i], b[j]) - multiplied(a[j], b[i]) for i, j in ((1, 2), (2, 0), (0, 1))]
    )


def _dot(a: Array, b: Array) -> Array:
    return multiplied(a[0], b[0]) + multiplied(a[1], b[1]) + multiplied(a[2], b[2])


def _difference(a: Array, b: Array) -> Array:
    """The difference of polynomials, of which a derivative of 0 may have raised the degree."""
    degrees = [max(pair) - 1 for pair in zip(a.shape[:2], b.shape[:2], strict=True)]
    return elevated(a, *degrees) - elevated(b, *degrees)
