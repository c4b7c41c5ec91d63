"""Which side of patches is the body's outside."""

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.normals import normal_vectors
from bodymeasure.bezier import evaluate

# Gauss points a side of each patch: the volume's sign takes few.
POINTS = 4


def outward_sign(atlas: Atlas) -> float:
    """1 where the patches' normals S_u x S_v point out of the body, -1 where into it.

    Notes
    -----
    By the sign of the volume between the patches and the middle of the body, which openings do not
    spoil. All patches are taken to face alike, as the atlas's check wants them to.
    """
    x, weights = np.polynomial.legendre.leggauss(POINTS)
    side = 0.5 * (1.0 + x)
    grid = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1)
    grid = np.broadcast_to(grid, (len(atlas), *grid.shape))
    position = evaluate(atlas.control_points, grid)
    offset = position - position.mean(axis=(0, 1, 2))
    flow = (offset * normal_vectors(atlas.control_points, grid)).sum(axis=-1)
    return -1.0 if float(np.einsum("pij,i,j->", flow, weights, weights)) < 0.0 else 1.0
