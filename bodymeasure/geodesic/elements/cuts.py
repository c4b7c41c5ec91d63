"""Where the elements of a path are cut."""

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.elements.measure import ElementLength
from bodymeasure.geodesic.elements.path import DEGREE, ElementPath
from bodymeasure.geodesic.spaces.polynomials import polynomial_space

# Only elements with more than this part of the largest error are cut at a time.
WORST = 1e-3
# A cut is no nearer to the ends of an element than this.
NEAREST = 0.15
# The same for cuts beside the place where an edge begins to hold a path, and for their distance.
CLOSEST = 0.02


def cuts(path: ElementPath, measured: ElementLength, held: Bools, goal: float) -> list[list[float]]:
    """Return for each element the parameters, between 0 and 1, where it is cut.

    Parameters
    ----------
    path : ElementPath
    measured : ElementLength
    held : ndarray of bool, shape (elements, 2, DEGREE + 1)
        The coordinates of the nodes that their bounds hold.
    goal : float
        The error that is wanted, all elements together.
    """
    space = polynomial_space(DEGREE)
    share = max(goal / (2.0 * len(held)), WORST * float(measured.error.max()))
    enough = (measured.error <= share) & ~path.overshoots
    result: list[list[float]] = []
    for number in range(len(held)):
        nodes = held[number].any(axis=0)
        if enough[number]:
            result.append([])
        elif nodes.any() and not nodes.all() and not path.on_edge[number]:
            result.append(_round_changes(space.nodes, nodes))
        else:
            # Half of the curvature on either side: beside a bend, elements become short at once.
            bend = np.cumsum(measured.bend[number] * space.quadrature.weights)
            middle = 0.5
            if np.isfinite(bend[-1]) and bend[-1] > 0.0:
                middle = float(np.interp(0.5 * bend[-1], bend, space.quadrature.points))
            result.append([min(max(middle, NEAREST), 1.0 - NEAREST)])
    return result


def _round_changes(nodes: Array, held: Bools) -> list[float]:
    """Cuts on both sides of the places between nodes that are held and others."""
    places: list[float] = []
    for k in np.flatnonzero(held[1:] != held[:-1]):
        half = 0.5 * (nodes[k + 1] - nodes[k])
        places += [float(nodes[k] - half), float(nodes[k + 1] + half)]
    result: list[float] = []
    for place in sorted(places):
        if max(CLOSEST, result[-1] + CLOSEST if result else 0.0) < place < 1.0 - CLOSEST:
            result.append(place)
    return result or [0.5]
