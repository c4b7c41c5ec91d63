"""The exact division of B-splines into Bezier pieces."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError


class BezierPieces(NamedTuple):
    """Polynomial pieces of a B-spline.

    Parameters
    ----------
    control_points : ndarray, shape (pieces, degree + 1, ...)
        Where neighboring pieces join, they have the same control point to the last bit.
    breaks : ndarray, shape (pieces, 2)
        The parameters at which each piece begins and ends.
    """

    control_points: Array
    breaks: Array


def bezier_pieces(control_points: ArrayLike, degree: int, knots: ArrayLike) -> BezierPieces:
    """Return the Bezier pieces of a B-spline, along axis 0.

    Parameters
    ----------
    control_points : array_like, shape (n, ...)
    degree : int
        At least 1.
    knots : array_like, shape (n + degree + 1,)
        Not decreasing, of any multiplicity, clamped or not. The spline runs from ``knots[degree]``
        to ``knots[n]``; a periodic one repeats its first `degree` control points at its end.

    Returns
    -------
    BezierPieces

    Raises
    ------
    InputError
        If knots are not what is said above.

    Notes
    -----
    The pieces are those that inserting each knot up to the degree's multiplicity gives. They are
    found by the blossom: the Bezier points of a piece on [a, b] are its values at
    (a, ..., a, b, ..., b). L. Ramshaw, *Blossoms are polar forms*, CAGD 6 (1989); Farin, 5th ed.,
    section 8.4. At a knot of multiplicity above the
    degree the spline may jump, and pieces keep an end each.
    """
    points = np.asarray(control_points, dtype=np.float64)
    vector = np.asarray(knots, dtype=np.float64)
    _check_knots(vector, len(points), degree)
    span, rows = _piece_matrices(degree, vector.tobytes())
    local = points[span[:, None] - degree + np.arange(degree + 1)]
    pieces = np.einsum("pab,pb...->pa...", rows, local)
    joined = span[1:] - span[:-1] <= degree
    pieces[1:, 0][joined] = pieces[:-1, -1][joined]
    return BezierPieces(pieces, np.stack([vector[span], vector[span + 1]], axis=-1))


def _check_knots(knots: Array, count: int, degree: int) -> None:
    if degree < 1 or count <= degree:
        raise InputError(
            f"a B-spline of degree {degree} has {count} control points; expected a degree of at "
            "least 1 and more control points than that"
        )
    if knots.shape != (count + degree + 1,):
        raise InputError(
            f"{knots.size} knots for {count} control points of degree {degree}; expected "
            f"{count + degree + 1}, as many as control points and degree + 1 together"
        )
    with np.errstate(over="ignore", invalid="ignore"):
        steps, extent = np.diff(knots), knots[-1] - knots[0]
    if not (np.isfinite(knots).all() and np.isfinite(extent)):
        raise InputError("knots are not finite numbers")
    if (steps < 0.0).any():
        at = int(np.flatnonzero(steps < 0.0)[0])
        raise InputError(
            f"knots decrease from {knots[at]:g} to {knots[at + 1]:g}; expected them in order"
        )
    if not knots[degree] < knots[count]:
        raise InputError(
            f"the knots from the {degree + 1}th to the {count + 1}th are all {knots[degree]:g}; "
            "expected the spline to have a domain"
        )


@lru_cache(maxsize=64)
def _piece_matrices(degree: int, knot_bytes: bytes) -> tuple[Ints, Array]:
    """Return the knot spans that are not empty, and the matrices to their Bezier points.

    Rows have the shape (pieces, degree + 1, degree + 1), and act on the control points from
    ``span - degree`` to ``span``.
    """
    knots = np.frombuffer(knot_bytes)
    inside = np.arange(degree, len(knots) - degree - 1)
    span = inside[knots[inside] < knots[inside + 1]]
    start, end = knots[span], knots[span + 1]
    rows = np.empty((len(span), degree + 1, degree + 1))
    for ends in range(degree + 1):
        weights = np.broadcast_to(np.eye(degree + 1), (len(span), degree + 1, degree + 1))
        for level in range(1, degree + 1):
            # de Boor's step from `level - 1`, each with its own argument.
            at = end if level <= ends else start
            i = np.arange(level, degree + 1)
            low = knots[span[:, None] - degree + i]
            high = knots[span[:, None] + 1 + i - level]
            upper = ((at[:, None] - low) / (high - low))[..., None]
            weights = (1.0 - upper) * weights[:, :-1] + upper * weights[:, 1:]
        rows[:, ends] = weights[:, 0]
    rows.flags.writeable = False
    return span, rows
