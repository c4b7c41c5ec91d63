"""Bounds of lengths brought closer by finer paths between the same ends.

Any path on the patch bounds the shortest one, and bounds are quadratic in how far the path is from
a geodesic. So where those of the computed path are wide, a path on more functions is found.
"""

from collections.abc import Sequence

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.methods.polynomial_collocation import PolynomialCollocation
from bodymeasure.geodesic.methods.rbf_collocation import RBFCollocation
from bodymeasure.geodesic.proofs.bounds import Bounds
from bodymeasure.geodesic.proofs.curvature import CurvatureBounds
from bodymeasure.geodesic.proofs.patches import TOGETHER, PatchesOfPaths
from bodymeasure.geodesic.solving.protocol import Method, PathBatch

# Bounds whose relative width is above this are wide.
WIDE = 1e-10
# Every path counts whose correction can be trusted at all.
ANY = 1.0
# Lengths of two paths, summed at other points, differ by rounding errors of up to this.
APART = 1e-15
FINER: tuple[Method, ...] = (
    RBFCollocation(functions=20, tolerance=ANY),
    PolynomialCollocation(degrees=32, tolerance=ANY),
)


def closer_bounds(
    patches: PatchesOfPaths,
    batches: Sequence[PathBatch],
    ends: tuple[Array, Array],
    curvature: CurvatureBounds,
    may_be_closer: Bools,
) -> Bounds:
    """Return bounds by the computed paths and, where they are wide, by finer ones.

    Parameters
    ----------
    patches : PatchesOfPaths
    batches : sequence of PathBatch
        The computed paths.
    ends : tuple of ndarray
        The starts and the ends, both of shape (paths, 2).
    curvature : CurvatureBounds
        Of the patches, around these paths.
    may_be_closer : ndarray of bool, shape (paths,)
        Which paths finer ones may help.
    """
    lower, upper = patches.bounds(batches, curvature)
    for method in FINER:
        # Where the theorem says nothing, no path is close enough.
        wide = np.isinf(upper) | (upper - lower > WIDE * upper)
        every = np.flatnonzero(wide & may_be_closer & np.isfinite(curvature.curvature))
        for first in range(0, len(every), TOGETHER):
            rows = every[first : first + TOGETHER]
            part = patches.take(rows)
            surface = part.surfaces.take(part.surface_of)
            found = method.solve(surface, *(each[rows] for each in ends))
            closer = part.bounds(found.batches, curvature.take(rows))
            lower[rows], upper[rows] = (
                np.fmax(lower[rows], closer.lower * (1.0 - APART)),
                np.fmin(upper[rows], closer.upper * (1.0 + APART)),
            )
    return Bounds(np.minimum(lower, upper), upper)
