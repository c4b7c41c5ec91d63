"""Derivatives of tapes in planes: girths, parts of them, and drops."""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bezier import derivatives
from bodymeasure.make.gradient.chain import STEPS, Nodes, chain_weights
from bodymeasure.make.gradient.pull import Pull
from bodymeasure.section import Curve, Plane

# A node on the side of its patch; its place on a curve is as exact as rounding leaves it.
ON_SIDE = 1e-9
# A seam that runs along the plane, up to this slope, is not crossed.
LEVEL = 1e-3
TINY = 1e-12


class InPlane(NamedTuple):
    """Derivatives with respect to the nodes of a tape that stay in its plane.

    Parameters
    ----------
    positions : ndarray, shape (n, 3)
    rate : ndarray, shape (n,)
        The derivative with respect to the movement of the plane at each node, along its normal.
    """

    positions: Array
    rate: Array


def nodes_along(curve: Curve, first: float, last: float, spans: Array) -> tuple[Nodes, Array]:
    """Return nodes along a curve from one place forwards to another, straight over some spans.

    Parameters
    ----------
    curve : Curve
    first, last : float
        Places; along a closed curve `last` may be up to one round more than the number of pieces.
    spans : ndarray, shape (k, 2)
        Places at which straight parts start and end.

    Returns
    -------
    Nodes
    ndarray, shape (n,)
        Their places.
    """
    count = float(curve.count)
    bounds = [first, *np.arange(np.floor(first) + 1.0, np.ceil(last)), last]
    skipped = []
    for begin, end in spans.tolist():
        stop = end if end > begin else end + count
        for round_ in (-count, 0.0, count):
            low, high = max(begin + round_, first), min(stop + round_, last)
            if low < high:
                skipped.append((low, high))
                bounds += [low, high]
    places, coarse = [], []
    bounds = np.unique(bounds).tolist()
    for low, high in pairwise(bounds):
        middle = 0.5 * (low + high)
        steps = 1 if any(one < middle < other for one, other in skipped) else STEPS
        places += [low + (high - low) * k / steps for k in range(steps)]
        coarse += [k % 2 == 0 for k in range(steps)]
    within = [not any(one < place < other for one, other in skipped) for place in places]
    kept = np.array([*within, True])
    place = np.array([*places, last])[kept]
    again = np.where(place >= count, count, 0.0) if curve.closed else 0.0
    patch, parameters = curve.surface_points_at(place - again)
    positions = curve.positions_at(place - again)
    return Nodes(patch, parameters, positions, np.array([*coarse, True])[kept]), place


def whole_tape(curve: Curve, spans: Array) -> Nodes:
    """Return the nodes of a tape round a closed curve; its first one comes again at the end."""
    start = float(spans[0, 1]) if len(spans) else 0.0
    start = 0.0 if start >= curve.count else start
    return nodes_along(curve, start, start + curve.count, spans)[0]


def pull_in_plane(pull: Pull, nodes: Nodes, weights: Array, plane: Plane) -> InPlane:
    """Add the derivatives of what depends on nodes that stay on the skin and in a plane.

    A node of the skin leaves the plane when the skin moves, and slides back along the skin.

    Parameters
    ----------
    pull : Pull
    nodes : Nodes
    weights : ndarray, shape (n, 3)
        The derivative with respect to each node's position.
    plane : Plane
    """
    on_skin = nodes.patch >= 0
    patch, parameters = nodes.patch[on_skin], nodes.parameters[on_skin]
    normal, chosen = plane.normal, weights[on_skin]
    jet = derivatives(pull.atlas.control_points[patch], parameters[:, None], order=1)
    across = np.cross(jet[:, 0, 1, 0], jet[:, 0, 0, 1])
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    steep = across @ normal
    back = (normal - steep[:, None] * across) / np.maximum(1.0 - steep**2, TINY)[:, None]
    # Where the plane crosses a seam, the node slides along the seam, or the tape would leave one
    # of the two patches.
    side = np.minimum(parameters, 1.0 - parameters) < ON_SIDE
    along = np.where(side[:, :1], jet[:, 0, 0, 1], jet[:, 0, 1, 0])
    rise = along @ normal
    crossing = (side.sum(axis=1) == 1) & (np.abs(rise) > LEVEL * np.linalg.norm(along, axis=1))
    back[crossing] = along[crossing] / rise[crossing, None]
    rate = np.einsum("nc,nc->n", chosen, back)
    pull.skin(patch, parameters, chosen - rate[:, None] * normal)
    return InPlane(nodes.positions[on_skin], rate)


def pull_tape(pull: Pull, nodes: Nodes, plane: Plane) -> InPlane:
    """Add the derivatives of the length of a tape in a plane."""
    return pull_in_plane(pull, nodes, chain_weights(nodes), plane)
