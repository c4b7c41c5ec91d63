r"""The paper's system for two functions as polynomials in two unknowns.

With :math:`u(t) = a_0 + a_1 \phi(t, c_1) + a_2 \phi(t, c_2)`, the same for v, and the end
conditions (7) to (10), a path is determined by its place (x, y) = (u, v)(t*) at the one collocation
point t*. There u' and u'' are linear in x, and v' and v'' in y. Equations (11) and (12), times the
metric, are :math:`S_u \cdot a = 0 = S_v \cdot a`, with a the acceleration. On a bicubic patch,
these are polynomials in (x, y) of the degrees (5, 6) and (6, 5). Where the metric is regular, they
have the roots of (1) and (2).
"""

from functools import lru_cache
from math import comb

import numpy as np
from numpy.polynomial import polynomial

from bodymeasure._typing import Array, Bools, Complex
from bodymeasure.geodesic.spaces.kernels import WU_C2
from bodymeasure.geodesic.spaces.rbf import rbf_space
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.paper.method.polynomial_pair import PolynomialPair, of_size_one

# The values of section 7 of the paper.
SUPPORT_RADIUS = 2.0
COLLOCATION_POINT = 0.5
# Polynomials are in powers of (x - 1/2) and (y - 1/2), which are not large near the patch.
MIDDLE = 0.5
# Degrees in x and y.
FIRST, SECOND, DIFFERENCE = (5, 6), (6, 5), (4, 4)
# The number of points on the unit circle that determine a polynomial of degree 7 in one variable.
_POINTS = 8
# Parts of a net that are smaller than this, relative to the whole, are rounding errors.
ROUNDING = 1e-12


def paper_centers(functions: int) -> tuple[float, ...]:
    """Return the centers 1 + i / N of N functions, which continue the paper's 1 and 1.5."""
    return tuple(1.0 + i / functions for i in range(functions))


def even_points(functions: int) -> tuple[float, ...]:
    """Return the N - 1 evenly spaced collocation points of section 3."""
    return tuple(i / functions for i in range(1, functions))


def paper_space(collocation_points: tuple[float, ...] = (COLLOCATION_POINT,)) -> TrialSpace:
    """Return the paper's trial space: a constant and Wu's C2 functions, one more than points.

    Raises
    ------
    InputError
        If the linear system of the functions is degenerate, however the points are moved.
    """
    functions = len(collocation_points) + 1
    return rbf_space(WU_C2, paper_centers(functions), collocation_points, SUPPORT_RADIUS)


def collocation_equations(control_points: Array, space: TrialSpace) -> PolynomialPair:
    """Return equations (11) and (12) for diagonals from (0, 0) to (1, 1), times the metric.

    Parameters
    ----------
    control_points : ndarray, shape (patches, 4, 4, 3)
    space : TrialSpace
        Trial space of two functions with one collocation point.
    """
    first, second = _products(control_points, space)
    return PolynomialPair(_coefficients(first, FIRST), _coefficients(second, SECOND))


def graph_directions(control_points: Array) -> tuple[Array, Bools]:
    """Return the direction e along which a patch is a graph, and whether it is a graph.

    A graph is ``S(u, v) = P + u U + v V + z(u, v) e``, with constant U and V perpendicular to e.

    Returns
    -------
    directions : ndarray, shape (patches, 3)
    is_graph : ndarray of bool, shape (patches,)
    """
    u, v = np.meshgrid(np.arange(4) / 3.0, np.arange(4) / 3.0, indexing="ij")
    affine = np.stack([np.ones(16), u.ravel(), v.ravel()], axis=1)
    nets = control_points.reshape(len(control_points), 16, 3)
    bent = nets - affine @ (np.linalg.pinv(affine) @ nets)
    _, sizes, rows = np.linalg.svd(bent, full_matrices=False)
    scale = np.ptp(nets, axis=1).max(axis=1)
    return rows[:, 0], (sizes[:, 0] > ROUNDING * scale) & (sizes[:, 1] <= ROUNDING * scale)


def graph_equations(control_points: Array, space: TrialSpace, direction: Array) -> PolynomialPair:
    r"""Return (11), and the difference of (11) and (12) times z_v and z_u, for graphs.

    There (11) and (12) read :math:`U \cdot L + z_u z'' = 0 = V \cdot L + z_v z''` with
    :math:`L = U u'' + V v''`. Far from the patch the second terms are larger by many powers, and
    the two equations are nearly the same; in :math:`z_v U \cdot L - z_u V \cdot L = 0` these terms
    cancel. The pair has the same roots, and a few more with :math:`z_u = 0`.

    Parameters
    ----------
    direction : ndarray, shape (patches, 3)
        The result of `graph_directions`.
    """
    along = direction[:, None, None, :]
    height = (control_points * along).sum(axis=-1, keepdims=True)
    base = control_points - height * along
    along_u, along_v = base[:, 3, 0] - base[:, 0, 0], base[:, 0, 3] - base[:, 0, 0]
    _, bend = _motion(space)
    z_u, z_v = (_derivative(height, i, j)[0] for i, j in ((1, 0), (0, 1)))
    straight = along_u[:, :, None, None] * bend[:, None] + along_v[:, :, None, None] * bend[None, :]
    first = np.einsum("pc,pcab->pab", along_u, straight)
    second = np.einsum("pc,pcab->pab", along_v, straight)
    return PolynomialPair(
        _coefficients(_products(control_points, space)[0], FIRST),
        _coefficients(z_v * first - z_u * second, DIFFERENCE),
    )


def _circle() -> Complex:
    return np.asarray(np.exp(2j * np.pi * np.arange(_POINTS) / _POINTS))


def _motion(space: TrialSpace) -> tuple[Complex, Complex]:
    """Return first and second derivatives of u or of v at t*, for unknowns on the circle."""
    # The rows give them by the values at the start, which is 0, at t*, and at the end, which is 1.
    (_, slope, to_end), (_, bend, bend_to_end) = space.differentiation[:, 0]
    place = MIDDLE + _circle()
    return slope * place + to_end, bend * place + bend_to_end


def _products(control_points: Array, space: TrialSpace) -> tuple[Complex, Complex]:
    """Return ``S_u . a`` and ``S_v . a`` for unknowns on the product of two circles."""
    nets = control_points - control_points.mean(axis=(1, 2), keepdims=True)
    s_u, s_v, s_uu, s_uv, s_vv = (
        _derivative(nets, i, j) for i, j in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
    )
    slope, bend = _motion(space)
    du, dv = slope[:, None], slope[None]
    a = s_uu * du**2 + 2.0 * s_uv * du * dv + s_vv * dv**2 + s_u * bend[:, None] + s_v * bend[None]
    return (s_u * a).sum(axis=0), (s_v * a).sum(axis=0)


def _derivative(nets: Array, by_u: int, by_v: int) -> Complex:
    """Return a derivative on the product of two circles, shape (coordinates, patches, k, k)."""
    along_v = nets.transpose(3, 0, 1, 2) @ _rows(by_v).T
    return np.asarray(_rows(by_u) @ along_v)


@lru_cache
def _rows(order: int) -> Complex:
    """Return the matrix from Bezier points of a cubic to its derivative on the circle."""
    s, columns = _circle(), []
    for i in range(4):
        powers = polynomial.polymul(
            polynomial.polypow([MIDDLE, 1.0], i), polynomial.polypow([1.0 - MIDDLE, -1.0], 3 - i)
        )
        powers = polynomial.polyder(comb(3, i) * powers, order)
        columns.append(polynomial.polyval(s, powers))
    return np.stack(columns, axis=1)


def _coefficients(values: Complex, degrees: tuple[int, int]) -> Array:
    """Return coefficients of real polynomials on the circles, by a Fourier transform."""
    coefficients = np.fft.fft2(values).real / _POINTS**2
    return of_size_one(coefficients[:, : degrees[0] + 1, : degrees[1] + 1])
