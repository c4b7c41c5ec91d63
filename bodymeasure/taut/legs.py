"""Where the legs of a path through several points meet."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic import AtlasPath


def leg_ends(path: AtlasPath) -> Array:
    """Parameters at which a path passes through its points, shape (points,); from 0 to 1.

    Each leg of a path ends where one of its pieces does. Of those, the ones that come closest to
    the points, in their order, are taken.
    """
    atlas = path.atlas
    positions = np.array([atlas.position(point) for point in path.points])
    nets = atlas.control_points[list(path.patches)]
    last = np.array([np.clip(piece.values[:, -1], 0.0, 1.0) for piece in path.pieces])
    lengths = np.array([piece.length for piece in path.pieces])
    passed = np.cumsum(lengths)
    gaps = np.linalg.norm(evaluate(nets, last) - positions[1:, None], axis=2)
    # Least sum of gaps with the legs in order, by dynamic programming over the pieces.
    pieces, legs = len(lengths), len(positions) - 1
    cost = np.full((legs, pieces), np.inf)
    came = np.zeros((legs, pieces), dtype=np.int64)
    cost[0] = gaps[0]
    for leg in range(1, legs):
        best, at = np.inf, 0
        for piece in range(leg, pieces):
            if cost[leg - 1, piece - 1] < best:
                best, at = cost[leg - 1, piece - 1], piece - 1
            cost[leg, piece], came[leg, piece] = best + gaps[leg, piece], at
    ends = [pieces - 1]
    for leg in range(legs - 1, 0, -1):
        ends.append(int(came[leg, ends[-1]]))
    total = passed[-1] if passed[-1] > 0.0 else 1.0
    result = np.concatenate([[0.0], passed[ends[::-1]] / total])
    result[-1] = 1.0
    return np.asarray(result)
