"""Lengths of the boundary curves of patches."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas import Atlas, sides_of
from bodymeasure.atlas.atlas import require_atlas
from bodymeasure.bezier import bernstein
from bodymeasure.threads import one_blas_thread
from bodymeasure.trust import is_known

# The number of Gauss points on each part of a curve; parts are halved until two results agree.
POINTS = 16
# Points treated at once, which bounds the memory: each takes some 100 bytes.
MOST_POINTS = 2**18
# Relative agreement that is required: the rounding of a sum of this kind.
AGREEMENT = 1e-14
# The most halvings. Only a cusp inside an edge needs more, which its error estimate shows.
MAX_HALVINGS = 10
# The error at a cusp depends on where in its part it lies, and jumps from one division to the next:
# it may be several times the last change.
CUSP_SAFETY = 10.0
# The relative rounding error of a sum of some dozens of positive terms.
ROUNDING = 4e-16


@dataclass(frozen=True, eq=False)
class BoundaryLengths:
    """Lengths of the four sides of each patch, in the order of `bodymeasure.atlas.EDGES`.

    Parameters
    ----------
    length : ndarray, shape (patches, 4)
        In the atlas's unit.
    error_estimate : ndarray, shape (patches, 4)
        In the same unit.
    """

    length: Array
    error_estimate: Array

    @property
    def converged(self) -> Bools:
        """Which lengths can be trusted, shape (patches, 4)."""
        return is_known(self.length, self.error_estimate, self.length.max(initial=0.0))

    def __repr__(self) -> str:
        span = f"from {self.length.min():.6g} to {self.length.max():.6g}"
        return f"<BoundaryLengths {span}, error at most {self.error_estimate.max():.1g}>"


@one_blas_thread()
def boundary_lengths(atlas: Atlas) -> BoundaryLengths:
    """Return the arc lengths of the boundary curves of all patches.

    The speed is integrated by Gauss and Legendre's rule on ever smaller parts of each curve, until
    two results agree to rounding. The paper's section 6.3 makes the same lengths equal to the
    physical ones.

    Returns
    -------
    BoundaryLengths

    Examples
    --------
    >>> import bodymeasure as bm
    >>> sides = bm.boundary_lengths(bm.load_sample("paraboloid"))
    >>> print(sides.length.round(6))
    [[1.478943 1.478943 1.478943 1.478943]]
    """
    require_atlas(atlas)
    nets = atlas.control_points
    flat = sides_of(nets).reshape(-1, *nets.shape[-2:])
    length, error = curve_lengths(flat)
    return BoundaryLengths(length.reshape(-1, 4), error.reshape(-1, 4))


def curve_lengths(control_points: Array) -> tuple[Array, Array]:
    """Return the arc lengths of Bezier curves, and estimates of their errors.

    Parameters
    ----------
    control_points : ndarray, shape (curves, degree + 1, 3)
        Those of rational curves have a last axis of 4.

    Returns
    -------
    length, error : ndarray, shape (curves,)
    """
    length = _composite(control_points, parts=1)
    error = np.full_like(length, np.inf)
    rest = np.arange(len(control_points))
    for halvings in range(1, MAX_HALVINGS + 1):
        # The number is odd, so that two divisions share no inner end: next to a shared one, both
        # would miss a cusp.
        finer = _composite(control_points[rest], parts=2**halvings + 1)
        error[rest] = np.abs(finer - length[rest]) + ROUNDING * finer
        length[rest] = finer
        rest = rest[error[rest] > AGREEMENT * finer]
        if len(rest) == 0:
            break
    error[rest] *= CUSP_SAFETY
    return length, error


def _composite(control_points: Array, parts: int) -> Array:
    nodes, weights = np.polynomial.legendre.leggauss(POINTS)
    t = ((np.arange(parts)[:, None] + (nodes + 1.0) / 2.0) / parts).ravel()
    weights = np.tile(weights / (2.0 * parts), parts)
    result = np.empty(len(control_points))
    curves = max(1, MOST_POINTS // len(t))
    for first in range(0, len(result), curves):
        block = slice(first, first + curves)
        speed = np.linalg.norm(_slopes(control_points[block], t), axis=-1)
        result[block] = speed @ weights
    return result


def _slopes(control_points: Array, t: Array) -> Array:
    """Derivatives of curves (curves, degree + 1, 3 or 4) at t, shape (curves, len(t), 3)."""
    basis = bernstein(control_points.shape[1] - 1, t, order=1)
    slopes = np.asarray(basis[:, 1] @ control_points)
    if control_points.shape[-1] == 3:
        return slopes
    points = basis[:, 0] @ control_points
    weight = points[..., 3:]
    return np.asarray((slopes[..., :3] - slopes[..., 3:] * points[..., :3] / weight) / weight)
