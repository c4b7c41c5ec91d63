r"""The error of a length because the elements of a path meet at angles.

A joint is a corner of the path, and the geodesics that the elements stand for meet there at an
angle

.. math:: r = [T] \cdot b + \int \kappa_g w \, ds,

with :math:`[T]` the difference of the unit tangents, b the direction across the path, and w the
hat function that is 1 at the joint and 0 at its neighbors (Green's formula, as in
`contact.tangency`). Moving the joints across the path by :math:`\delta` changes the length by
:math:`-r^T \delta + \tfrac12 \delta^T S \delta`, in which S is the matrix of hat functions for the
Jacobi operator. Its minimum :math:`-\tfrac12 r^T S^{-1} r` is tripled twice, since the tangents
have errors as large.

Where an arc along an edge ends, the joint can move along the edge only: the error is that of
`contact.tangency`.
"""

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.contact.edge_arc import edge_curvatures
from bodymeasure.geodesic.contact.legs import Contact
from bodymeasure.geodesic.elements.path import DEGREE
from bodymeasure.geodesic.elements.pieces import Pieces, unit
from bodymeasure.geodesic.lengths.equations import dot
from bodymeasure.geodesic.numerics.banded import solve_free
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.protocol import Surface

JOINT_SAFETY = 9.0
# See `contact.tangency`.
TANGENCY_SAFETY = 3.0
# No element counts as shorter, on a surface of size 1.
SHORTEST = 1e-15


def joint_errors(surface: Surface, pieces: Pieces, held: Bools) -> tuple[Array, Bools]:
    """Return the error that each joint makes, and which joints are free to move in the patch.

    Parameters
    ----------
    surface : Surface
        The surface of one problem.
    pieces : Pieces
    held : ndarray of bool, shape (elements, 2, DEGREE + 1)
        The coordinates of the nodes that their bounds hold.

    Returns
    -------
    error : ndarray, shape (elements - 1,)
        Infinite if the path is no minimum.
    free : ndarray of bool, shape (elements - 1,)
    """
    on_edge, places = pieces.on_edge, pieces.values[1:, :, 0]
    is_held = held[1:, :, 0].any(axis=1)
    free = ~(is_held | on_edge[1:] | on_edge[:-1])
    angle, doubt, bands = _system(pieces)
    shift = solve_free(bands, np.where(free, angle, 0.0), free)
    doubtful = solve_free(bands, np.where(free, doubt, 0.0), free)
    if shift is None or doubtful is None:
        error = np.full(len(free), np.inf)
    else:
        error = JOINT_SAFETY * 0.5 * (np.abs(angle * shift) + doubt * np.abs(doubtful)) * free
    in_corner = (np.abs(places - 0.5) == 0.5).all(axis=1)
    for number in np.flatnonzero(is_held & (on_edge[1:] != on_edge[:-1]) & ~in_corner):
        longest = float(pieces.lengths[number : number + 2].max())
        error[number] = _tangency(
            surface, places[number], float(abs(angle[number]) + doubt[number]), longest
        )
    return error, free


def _system(pieces: Pieces) -> tuple[Array, Array, Array]:
    """The angles at the joints, how far they may be off, and the lower bands of the matrix S.

    An angle is positive to the left of the path. Angles of a path that zigzags cancel: it is hardly
    longer than the one through the middle.
    """
    rule = polynomial_space(DEGREE).quadrature
    weights, lengths = rule.weights[:, None], pieces.lengths
    inverse = 1.0 / np.maximum(lengths, SHORTEST)
    after = rule.antiderivative @ pieces.speed * inverse
    before = 1.0 - after
    way = weights * pieces.speed * pieces.smooth
    turn, bend = way * pieces.kappa, way * pieces.curvature
    leaving, entering = pieces.tangents[:, :-1, 1], pieces.tangents[:, 1:, 0]
    across = np.cross(pieces.normals[:, 1:, 0], unit(leaving + entering), axis=0)
    at_end, at_start = (turn * after).sum(axis=0), (turn * before).sum(axis=0)
    angle = dot(entering - leaving, across) + at_end[:-1] + at_start[1:]
    # Hats are straight where Jacobi fields bend.
    bent = np.abs(bend).sum(axis=0) * lengths / 6.0
    doubt = np.abs(at_end * bent)[:-1] + np.abs(at_start * bent)[1:]
    bands = np.zeros((2, len(angle)))
    bands[0] = (inverse - (bend * after**2).sum(axis=0))[:-1]
    bands[0] += (inverse - (bend * before**2).sum(axis=0))[1:]
    bands[1, :-1] = (-inverse - (bend * after * before).sum(axis=0))[1:-1]
    return angle, doubt, bands


def _tangency(surface: Surface, place: Array, angle: float, longest: float) -> float:
    """The error because a path meets an edge, at a place (u, v), at an angle."""
    edges = [Contact(axis, float(place[axis])) for axis in (0, 1) if place[axis] in (0.0, 1.0)]
    curvatures = [edge_curvatures(surface, [edge], place[None])[0] for edge in edges]
    least = min(curvatures, default=0.0)
    off = min(longest, angle / (3.0 * least)) if least > 0.0 else longest
    return TANGENCY_SAFETY * 0.5 * angle**2 * off
