"""Geodesics by `scipy.integrate.solve_bvp`, a general solver of boundary value problems."""

import numpy as np
from scipy.integrate import solve_bvp

from bodymeasure._typing import Array
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces

# Nodes of the first mesh, which the solver refines.
FIRST_NODES = 17
# With the default of 1000, the tightest tolerance fails on curved patches, as nodes run out.
MAX_NODES = 20_000
# Gauss points on each piece of the solver's cubic spline, whose errors are far larger.
GAUSS, WEIGHTS = np.polynomial.legendre.leggauss(4)


class BoundaryValueProblem:
    """One geodesic as a problem in y = (u, v, u', v'), with the metric's 2 x 2 system inverted.

    The solver is given the best conditions: the surface evaluation that bodymeasure itself uses, on
    the whole mesh at once. Its Jacobian is found by differences, which take a quarter of its time.

    Parameters
    ----------
    net : ndarray, shape (4, 4, 3)
    start, end : ndarray, shape (2,)
    tolerance : float
        The solver's ``tol``.
    """

    def __init__(self, net: Array, start: Array, end: Array, tolerance: float) -> None:
        self._surface = BezierSurfaces(net[None])
        self._start, self._end = start, end
        self._tolerance = tolerance

    def __call__(self) -> float:
        """Return the length; NaN if the solver gives up."""
        t = np.linspace(0.0, 1.0, FIRST_NODES)
        way = (self._end - self._start)[:, None]
        guess = np.vstack([self._start[:, None] + way * t, np.broadcast_to(way, (2, len(t)))])
        # A path may leave the patch for places where its continuation is singular.
        with np.errstate(all="ignore"):
            solution = solve_bvp(
                self._slope, self._ends, t, guess, tol=self._tolerance, max_nodes=MAX_NODES
            )
        if not solution.success:
            return np.nan
        half = 0.5 * np.diff(solution.x)[:, None]
        y = solution.sol((solution.x[:-1, None] + half * (1.0 + GAUSS)).ravel())
        jet = self._surface.jet(y[None, :2].swapaxes(1, 2), 1)[:, :, 0]
        speed = np.sqrt(((jet[1] * y[2] + jet[2] * y[3]) ** 2).sum(axis=0))
        return float(speed @ (half * WEIGHTS).ravel())

    def _slope(self, _: Array, y: Array) -> Array:
        _, s_u, s_v, s_uu, s_uv, s_vv = self._surface.jet(y[None, :2].swapaxes(1, 2), 2)[:, :, 0]
        du, dv = y[2:]
        bend = s_uu * (du * du) + s_uv * (2.0 * du * dv) + s_vv * (dv * dv)
        e, f, g = (s_u * s_u).sum(axis=0), (s_u * s_v).sum(axis=0), (s_v * s_v).sum(axis=0)
        p, q = (s_u * bend).sum(axis=0), (s_v * bend).sum(axis=0)
        determinant = e * g - f * f
        return np.stack([du, dv, (f * q - g * p) / determinant, (f * p - e * q) / determinant])

    def _ends(self, first: Array, last: Array) -> Array:
        return np.concatenate([first[:2] - self._start, last[:2] - self._end])
