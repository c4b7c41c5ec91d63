"""Relaxation: central differences on a uniform mesh (Maekawa 1996, the paper's [2])."""

from dataclasses import dataclass

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.geodesic.lengths.equations import linearization
from bodymeasure.geodesic.methods.settings import check_positive, whole_numbers
from bodymeasure.geodesic.numerics.damped_newton import damped_newton
from bodymeasure.geodesic.solving.on_spaces import TOLERANCE, straight
from bodymeasure.geodesic.solving.protocol import MethodResult
from bodymeasure.geodesic.solving.resampled import Path, resampled
from bodymeasure.geodesic.surfaces.protocol import Surface

POINTS = 129
# The spline through the mesh points must not add to their error of second order.
SPLINE_DEGREE = 5
LEAST_POINTS = SPLINE_DEGREE + 2
# The equations of neighboring points: two unknowns each, so three diagonals on each side.
BANDS = 3


@dataclass(frozen=True)
class Relaxation:
    """Finite differences on a uniform mesh, relaxed to the solution by Newton's method.

    u and v at equidistant t meet the geodesic equations with central differences for their
    derivatives; the start is the straight line in (u, v); each step solves one block-tridiagonal
    system (T. Maekawa, *Journal of Mechanical Design* 118 (1996) 499-508). The path is
    off by O(h^2), h being the mesh's width; its length, which is stationary at a geodesic, by
    O(h^4), and the correction takes most of that away.

    The path between the mesh points, a quintic spline, is put on polynomials, and its length is
    measured as with the other methods; their degree is the solution's `functions`.

    Parameters
    ----------
    points : int
        The number of points of the mesh, with both ends; at least 7.
    tolerance : float
        The relative error of the length that is asked for.

    Raises
    ------
    InputError
        If a setting makes no sense.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> net = bm.load_sample("paraboloid").control_points[0]
    >>> method = bm.geodesic.Relaxation(points=257)
    >>> round(bm.solve_geodesic(net, (0, 0), (1, 1), method=method).length, 8)
    2.56200714
    """

    points: int = POINTS
    tolerance: float = TOLERANCE

    def __post_init__(self) -> None:
        if np.ndim(self.points) != 0:
            raise InputError(f"points is {self.points!r}; expected one whole number")
        whole_numbers("points", self.points, LEAST_POINTS)
        check_positive("tolerance", self.tolerance)

    def solve(self, surface: Surface, start: Array, end: Array) -> MethodResult:
        """Return paths from start to end, both of shape (problems, 2), on a batch of surfaces."""
        mesh = np.linspace(0.0, 1.0, self.points)
        # Moves away from the start: however close the ends, differences of these are exact.
        moves = straight(0.0 * start, end - start, mesh)
        paths: list[Path | None] = []
        iterations = np.zeros(len(start), np.int64)
        for problem in range(len(start)):
            one = surface.take(np.array([problem]))
            relaxed, iterations[problem] = _relaxed(one, start[problem, :, None], moves[problem])
            paths.append(None if relaxed is None else _spline(mesh, start[problem], relaxed))
        pieces = resampled(surface, paths, (start, end), tolerance=self.tolerance)
        return MethodResult(pieces, iterations)


def _spline(mesh: Array, start: Array, moves: Array) -> Path:
    from scipy.interpolate import make_interp_spline  # A slow import.

    spline = make_interp_spline(mesh, moves.T, k=SPLINE_DEGREE)
    return lambda t: start[:, None] + np.asarray(spline(t).T)


def _relaxed(surface: Surface, start: Array, moves: Array) -> tuple[Array | None, int]:
    """The moves on one mesh, shape (2, points), if Newton's method finds them, and its steps."""
    steps = 0

    def system(moves: Array) -> tuple[Array, Array]:
        nonlocal steps
        steps += 1
        return _system(surface, start, moves)

    def direction(residual: Array, bands: Array) -> Array:
        result = np.zeros_like(moves)
        try:
            solution = scipy.linalg.solve_banded((BANDS, BANDS), bands, -residual)
        except (np.linalg.LinAlgError, ValueError):
            # The system is singular, or not finite.
            return np.full_like(moves, np.nan)
        result[:, 1:-1] = solution.reshape(-1, 2).T
        return result

    solved = damped_newton(system, direction, moves, span=float(np.abs(moves[:, -1]).max()))
    return None if solved is None else solved.unknowns, steps


def _system(surface: Surface, start: Array, moves: Array) -> tuple[Array, Array]:
    """Residual and Jacobian of the difference equations at the inner points.

    Both equations of a point stand next to each other, as do both unknowns.

    Returns
    -------
    residual : ndarray, shape (2 m,)
    bands : ndarray, shape (7, 2 m)
        The Jacobian's diagonals, as `scipy.linalg.solve_banded` takes them.
    """
    h = 1.0 / (moves.shape[1] - 1)
    velocity = (moves[:, 2:] - moves[:, :-2]) / (2.0 * h)
    second = (moves[:, 2:] - 2.0 * moves[:, 1:-1] + moves[:, :-2]) / h**2
    jet = surface.jet((start + moves[:, 1:-1]).T[None], 3)[:, :, 0]
    here = linearization(jet, velocity, second)
    size = velocity.shape[1]
    bands = np.zeros((2 * BANDS + 1, 2 * size))
    for row in range(2):
        for column in range(2):
            value, slope, bend = (
                here.by_value[row][column],
                here.by_velocity[row][column] / (2.0 * h),
                here.by_second[row][column] / h**2,
            )
            by_neighbor = {-1: bend - slope, 0: value - 2.0 * bend, 1: bend + slope}
            for shift, entries in by_neighbor.items():
                points = np.arange(max(0, -shift), size - max(0, shift))
                band = BANDS + row - column - 2 * shift
                bands[band, 2 * (points + shift) + column] = entries[points]
    return here.residual.T.ravel(), bands
