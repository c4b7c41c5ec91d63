r"""Geodesics whose ends may move along edges of their patches.

A shortest path in the patch joins its boundary tangentially: there, the derivative of the
coordinate that the edge fixes is zero. That is the equation for the place on the edge. (That the
length is stationary in it adds nothing: its derivative is cos(angle) - 1.)

At a collapsed edge, u = 0 say, :math:`S_v = S_{vv} = 0`, and the equation :math:`S_v \cdot a = 0`
is void there. Divided by u it says :math:`S_{uv} \cdot a = 0` in the limit; with
:math:`S_u \cdot a = 0` that leaves, for :math:`b = S_{uu} u'^2 + 2 S_{uv} u' v'`,

.. math:: (S_u \cdot S_u) (b \cdot S_{uv}) - (S_u \cdot S_{uv}) (b \cdot S_u) = 0:

the geodesic curvature vanishes at the pole as well. That is the equation for where it leaves.
"""

from collections.abc import Sequence

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.contact.legs import Ends, Pole
from bodymeasure.geodesic.lengths.equations import residual_and_jacobian
from bodymeasure.geodesic.numerics.damped_newton import (
    LAST_STEP,
    LONGEST_STEP,
    MOST_EVALUATIONS,
    SMALLEST_STEP,
    damped_newton_of_many,
)
from bodymeasure.geodesic.numerics.linear_systems import solved
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.bezier import compiled_patches
from bodymeasure.geodesic.surfaces.protocol import Surface
from bodymeasure.native import CollocationSettings, collocated

# Where S_u, S_uu, S_uv, S_uuv and S_uvv are in a jet, and the same with u and v exchanged.
_AT_POLE = ((1, 3, 4, 7, 8), (2, 5, 4, 8, 7))
# Any step that lowers the residual is taken.
_SETTINGS = CollocationSettings(0.0, LAST_STEP, LONGEST_STEP, SMALLEST_STEP)


def solve_with_moving_ends(
    surface: Surface, space: TrialSpace, guesses: Array, ends: Sequence[Ends]
) -> Array:
    """Return geodesics between pairs of ends, each fixed or moving along an edge.

    Parameters
    ----------
    surface : Surface
    space : TrialSpace
        With n + 1 nodes.
    guesses : ndarray, shape (problems, 2, n + 1)
    ends : sequence of pairs of End
        The edges along which the first and the last points move; None for a fixed end.

    Returns
    -------
    ndarray, shape (problems, 2, n + 1)
        u and v at the nodes; not numbers where Newton's method failed.
    """
    values, fixed = guesses.copy(), np.zeros(guesses.shape, bool)
    fixed[:, :, [0, -1]] = True
    for own, held, pair in zip(values, fixed, ends, strict=True):
        for node, end in zip((0, -1), pair, strict=True):
            if end is not None:
                own[end.axis, node] = end.value
                held[1 - end.axis, node] = False

    spans = np.ptp(values, axis=2).max(axis=1)
    patches = compiled_patches(surface)
    if patches is not None and not any(isinstance(end, Pole) for pair in ends for end in pair):
        by_edges = [[-1 if end is None else end.axis for end in pair] for pair in ends]
        solved_values, converged, singular, _ = collocated(
            patches,
            (space.differentiation, space.at_ends[1]),
            (values, np.array(by_edges), spans),
            MOST_EVALUATIONS,
            _SETTINGS,
        )
        solved_values[~converged | singular] = np.nan
        return solved_values

    def system(rows: Ints, values: Array) -> tuple[Array, Array]:
        residual, matrix = _system(surface.take(rows), space, values, [ends[row] for row in rows])
        size = residual[0].size
        direction = solved(matrix.reshape(-1, size, size), -residual.reshape(-1, size))
        # Elimination leaves rounding where nothing is to move.
        return residual, np.where(fixed[rows], 0.0, direction.reshape(values.shape))

    for own, found in zip(values, damped_newton_of_many(system, values, spans), strict=True):
        own[:] = np.nan if found is None else found.unknowns
    return values


def _system(
    surface: Surface, space: TrialSpace, values: Array, ends: Sequence[Ends]
) -> tuple[Array, Array]:
    """The equations' left sides and their derivatives, by u and v at all nodes.

    At the inner nodes they are those of collocation. At an end, the coordinate that is fixed has
    none to satisfy, and the other one that of its edge.
    """
    problems, _, nodes = values.shape
    residual = np.zeros((problems, 2, nodes))
    matrix = np.zeros((problems, 2, nodes, 2, nodes))
    inner = residual_and_jacobian(surface, space, values, ends=True)
    residual[:, :, 1:-1], matrix[:, :, 1:-1] = inner
    for axis in (0, 1):
        matrix[:, axis, [0, -1], axis, [0, -1]] = 1.0
    for row, pair in enumerate(ends):
        for number, end in enumerate(pair):
            if end is None:
                continue
            equation = (row, 1 - end.axis, -number)
            if isinstance(end, Pole):
                own = surface.take(np.array([row]))
                side, by_values = _at_pole(own, space, values[row], number, end.axis)
            else:
                # The derivative of the coordinate that the edge fixes.
                by_values = np.zeros((2, nodes))
                by_values[end.axis] = space.at_ends[1, number]
                side = by_values[end.axis] @ values[row, end.axis]
            residual[equation], matrix[equation] = side, by_values
    return residual, matrix


def _at_pole(
    surface: Surface, space: TrialSpace, values: Array, number: int, axis: int
) -> tuple[float, Array]:
    """The geodesic curvature at a collapsed edge, with u and v named as on u = 0."""
    node, slope = -number, space.at_ends[1, number]
    jet = surface.jet(values[None, :, node, None].swapaxes(1, 2), 3)[:, :, 0, 0]
    s_u, s_uu, s_uv, s_uuv, s_uvv = jet[list(_AT_POLE[axis])]
    du, dv = slope @ values[axis], slope @ values[1 - axis]
    square, mixed = s_u @ s_u, s_u @ s_uv
    b = s_uu * du**2 + 2.0 * s_uv * du * dv
    b_v = s_uuv * du**2 + 2.0 * s_uvv * du * dv

    def by(change: Array) -> float:
        return float(square * (change @ s_uv) - mixed * (change @ s_u))

    row = np.zeros_like(values)
    row[axis] = by(2.0 * (s_uu * du + s_uv * dv)) * slope
    row[1 - axis] = by(2.0 * s_uv * du) * slope
    row[1 - axis, node] += by(b_v) + square * (b @ s_uvv) + 2.0 * mixed * (b @ s_uv)
    row[1 - axis, node] -= (s_uv @ s_uv + s_u @ s_uvv) * (b @ s_u) + mixed * (b @ s_uv)
    return by(b), row
