r"""A geodesic whose ends may move along edges of the patch.

A shortest path in the patch joins its boundary tangentially: there, the derivative of the
coordinate that the edge fixes is zero. That is the equation for the place on the edge. (That the
length is stationary in it adds nothing: its derivative is cos(angle) - 1.)

At a collapsed edge, u = 0 say, :math:`S_v = S_{vv} = 0`, and the equation :math:`S_v \cdot a = 0`
is void there. Divided by u it says :math:`S_{uv} \cdot a = 0` in the limit; with
:math:`S_u \cdot a = 0` that leaves, for :math:`b = S_{uu} u'^2 + 2 S_{uv} u' v'`,

.. math:: (S_u \cdot S_u) (b \cdot S_{uv}) - (S_u \cdot S_{uv}) (b \cdot S_u) = 0:

the geodesic curvature vanishes at the pole as well. That is the equation for where it leaves.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.contact.legs import End, Pole
from bodymeasure.geodesic.lengths.equations import residual_and_jacobian
from bodymeasure.geodesic.numerics.damped_newton import damped_newton
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

# Where S_u, S_uu, S_uv, S_uuv and S_uvv are in a jet, and the same with u and v exchanged.
_AT_POLE = ((1, 3, 4, 7, 8), (2, 5, 4, 8, 7))


def solve_free_piece(
    surface: Surface, space: TrialSpace, guess: Array, ends: tuple[End, End]
) -> Array | None:
    """Return a geodesic between two ends, each fixed or moving along an edge.

    Parameters
    ----------
    surface : Surface
        The surface of one problem.
    space : TrialSpace
        With n + 1 nodes.
    guess : ndarray, shape (2, n + 1)
    ends : pair of End
        The edges along which the first and the last point move; None for a fixed end.

    Returns
    -------
    ndarray, shape (2, n + 1), or None
        u and v at the nodes; None if Newton's method failed.
    """
    problem = _Moving(surface, space, ends)
    values = guess.copy()
    for node, end in zip((0, -1), ends, strict=True):
        if end is not None:
            values[end.axis, node] = end.value
    span = np.ptp(values, axis=1).max()
    solved = damped_newton(problem.system, problem.direction, values, span=span)
    return None if solved is None else solved.unknowns


@dataclass(frozen=True)
class _Moving:
    """The collocation equations, and one more for each end that moves."""

    surface: Surface
    space: TrialSpace
    ends: tuple[End, End]

    @cached_property
    def unknowns(self) -> Ints:
        """The places of the unknowns among the nodal values of u and then v."""
        unknown = np.zeros((2, self.space.size + 1), bool)
        unknown[:, 1:-1] = True
        for node, end in zip((0, -1), self.ends, strict=True):
            if end is not None:
                unknown[1 - end.axis, node] = True
        return np.flatnonzero(unknown)

    @cached_property
    def slopes(self) -> Array:
        """The map from nodal values to derivatives at both ends, shape (2, n + 1)."""
        slopes: Array = self.space.matrices(np.array([0.0, 1.0]))[1]
        return slopes

    def system(self, values: Array) -> tuple[Array, Array]:
        """Return the equations' left sides, and their derivatives by the unknowns."""
        residual, jacobian = residual_and_jacobian(
            self.surface, self.space, values[None], ends=True
        )
        sides, rows = [residual.ravel()], [jacobian.reshape(residual.size, -1)]
        for number, end in enumerate(self.ends):
            if end is not None:
                at_end = self._at_pole if isinstance(end, Pole) else self._at_contact
                side, row = at_end(values, number, end.axis)
                sides.append(np.array([side]))
                rows.append(row.reshape(1, -1))
        return np.concatenate(sides), np.concatenate(rows)[:, self.unknowns]

    def _at_contact(self, values: Array, number: int, axis: int) -> tuple[float, Array]:
        """The derivative of the coordinate that the edge fixes."""
        row = np.zeros_like(values)
        row[axis] = self.slopes[number]
        return float(row[axis] @ values[axis]), row

    def _at_pole(self, values: Array, number: int, axis: int) -> tuple[float, Array]:
        """The geodesic curvature at a collapsed edge, with u and v named as on u = 0."""
        node = (0, -1)[number]
        jet = self.surface.jet(values[None, :, node, None].swapaxes(1, 2), 3)[:, :, 0, 0]
        s_u, s_uu, s_uv, s_uuv, s_uvv = jet[list(_AT_POLE[axis])]
        du, dv = self.slopes[number] @ values[axis], self.slopes[number] @ values[1 - axis]
        square, mixed = s_u @ s_u, s_u @ s_uv
        b = s_uu * du**2 + 2.0 * s_uv * du * dv
        b_v = s_uuv * du**2 + 2.0 * s_uvv * du * dv

        def by(change: Array) -> float:
            return float(square * (change @ s_uv) - mixed * (change @ s_u))

        row = np.zeros_like(values)
        row[axis] = by(2.0 * (s_uu * du + s_uv * dv)) * self.slopes[number]
        row[1 - axis] = by(2.0 * s_uv * du) * self.slopes[number]
        row[1 - axis, node] += by(b_v) + square * (b @ s_uvv) + 2.0 * mixed * (b @ s_uv)
        row[1 - axis, node] -= (s_uv @ s_uv + s_u @ s_uvv) * (b @ s_u) + mixed * (b @ s_uv)
        return by(b), row

    def direction(self, residual: Array, jacobian: Array) -> Array:
        """Return Newton's direction, of the shape of the values; NaN if the system is singular."""
        direction = np.zeros(2 * (self.space.size + 1))
        try:
            direction[self.unknowns] = np.linalg.solve(jacobian, -residual)
        except np.linalg.LinAlgError:
            direction[:] = np.nan
        return direction.reshape(2, -1)
