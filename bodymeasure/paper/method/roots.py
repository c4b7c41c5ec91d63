r"""All roots of two polynomials in two variables: one variable hidden in a resultant.

For a fixed y, the two are polynomials in x alone, with a common root where their Sylvester matrix
:math:`M(y)` is singular; then :math:`(1, x, x^2, \dots)` is its null vector. M is a polynomial in y
with matrices for coefficients, so that the y are eigenvalues, of a companion matrix after the shift
:math:`y = \sigma + 1 / \mu`, which also takes care of a singular leading coefficient. (D. Cox,
J. Little, D. O'Shea, *Using Algebraic Geometry*, sections 3.1 and 3.6; Y. Nakatsukasa, V. Noferini,
A. Townsend, "Computing the common zeros of two bivariate functions via Bezout resultants", Numer.
Math. 129 (2015) 181-209, on what hiding a variable does to the accuracy.) Newton's method then
makes every root exact, and those found with either variable hidden are put together.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array, Bools, Complex, Ints
from bodymeasure.paper.method.polynomial_pair import PolynomialPair

# The shift of the eigenvalue problem, which is near zero and where no root is to be expected.
SHIFT = 0.1374
# The number of Newton steps that refine a root.
POLISH = 12
# The last step must be no larger than this, relative to the size of the root or 1; because of the
# quadratic convergence, only rounding errors remain then.
CONVERGED = 1e-9
# The largest residual, relative to the sum of the sizes of the terms.
RESIDUAL = 1e-10
# Roots that are closer to one another than this, relative to their size or 1, are one root.
SAME = 1e-7
# Newton's method converges slowly to a multiple root. A point with a residual below the first
# number, whose steps are below the second, stands for such a root and for all such points as close.
MULTIPLE_RESIDUAL, MULTIPLE_ROOT = 1e-13, 1e-3
# The number of neighbors among which the same root is looked for.
WINDOW = 16
_MIX = np.array([[0.7123, 0.4391], [0.5811, 0.3217]])
# A root whose imaginary part is below this, relatively, is a real one.
REAL = 1e-9
# Larger roots have no meaning, since their powers cannot be added without loss.
FURTHEST = 1e5


def all_roots(pair: PolynomialPair, units: tuple[float, ...]) -> Complex:
    """Return the isolated roots of each pair of a batch, real and complex.

    Parameters
    ----------
    pair : PolynomialPair
    units : tuple of float
        Units of length in which the roots are sought, in turn; with each, roots that are much
        larger or smaller may be missed.

    Returns
    -------
    ndarray, shape (pairs, most, 2)
        The roots (x, y); NaN where a pair has fewer.
    """
    found = []
    for unit in units:
        scaled = pair.in_units(unit)
        found += [unit * hidden_roots(scaled), unit * hidden_roots(scaled.turned)[..., ::-1]]
    simple, multiple = polish(pair, np.concatenate(found, axis=1))
    both = np.concatenate([simple, multiple], axis=1)
    radius = np.repeat([SAME, MULTIPLE_ROOT], [simple.shape[1], multiple.shape[1]])
    return distinct(both, radius)


def hidden_roots(pair: PolynomialPair) -> Complex:
    """Return approximate roots, with the second variable hidden, shape (pairs, eigenvalues, 2).

    They are NaN for eigenvalues that stand for no root.
    """
    matrices = _sylvester(pair)
    pairs, order, size = len(matrices), matrices.shape[1] - 1, matrices.shape[2]
    # Horner's scheme gives the coefficients by powers of (y - shift).
    for low in range(order):
        for k in range(order - 1, low - 1, -1):
            matrices[:, k] += SHIFT * matrices[:, k + 1]
    companion = np.zeros((pairs, order * size, order * size))
    companion[:, size:, :-size] = np.eye((order - 1) * size)
    rest = np.concatenate(list(matrices[:, 1:].swapaxes(0, 1)), axis=2)
    companion[:, :size] = -_solved(matrices[:, 0], rest)
    values, vectors = np.linalg.eig(companion)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        y = SHIFT + 1.0 / values
        blocks = vectors.reshape(pairs, order, size, order * size)
        # The largest of the blocks, which are the null vector times powers of the eigenvalue.
        largest = np.linalg.norm(blocks, axis=2).argmax(axis=1)
        null = np.take_along_axis(blocks, largest[:, None, None], axis=1)[:, 0]
        x = (null[:, :-1].conj() * null[:, 1:]).sum(axis=1)
        x /= (np.abs(null[:, :-1]) ** 2).sum(axis=1)
    roots = np.stack([x, y], axis=2)
    usable = (np.abs(roots) < FURTHEST).all(axis=2)
    return np.where(usable[..., None], roots, np.nan)


def _sylvester(pair: PolynomialPair) -> Array:
    """Return coefficients of Sylvester matrices by powers of y, (pairs, powers, size, size)."""
    degrees = [c.shape[1] - 1 for c in pair.both]
    size = sum(degrees)
    powers = max(c.shape[2] for c in pair.both)
    matrices = np.zeros((len(pair.first), powers, size, size))
    row = 0
    # Each polynomial is multiplied by as many powers of x as the degree of the other.
    for c, other in zip(pair.both, reversed(degrees), strict=True):
        for i in range(other):
            matrices[:, : c.shape[2], row, i : i + c.shape[1]] = c.swapaxes(1, 2)
            row += 1
    return matrices


def _solved(matrices: Array, right: Array) -> Array:
    try:
        return np.asarray(np.linalg.solve(matrices, right))
    except np.linalg.LinAlgError:
        # One of the batch is exactly singular, since its equations depend on one another.
        return np.asarray(np.linalg.pinv(matrices) @ right)


def polish(pair: PolynomialPair, guesses: Complex) -> tuple[Complex, Complex]:
    """Refine guesses (pairs, k, 2) by Newton's method.

    Returns
    -------
    simple, multiple : ndarray, shape (pairs, k, 2)
        The points that are roots, and those that converge slowly to one; NaN elsewhere.
    """
    points = np.array(guesses, dtype=np.complex128)
    size = np.full(points.shape[:2], np.inf)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        for _ in range(POLISH):
            here = pair.at(points)
            (f, g), (f_x, g_x), (f_y, g_y) = here.value, here.by_x, here.by_y
            determinant = f_x * g_y - g_x * f_y
            step = np.stack([f * g_y - g * f_y, g * f_x - f * g_x], axis=2)
            step /= determinant[..., None]
            points = points - step
            size = np.abs(step).max(axis=2) / np.maximum(1.0, np.abs(points).max(axis=2))
        near = (np.abs(points) < FURTHEST).all(axis=2)
        simple = near & (size < CONVERGED) & are_roots(pair, points, RESIDUAL)
        multiple = (
            near & ~simple & (size < MULTIPLE_ROOT) & are_roots(pair, points, MULTIPLE_RESIDUAL)
        )
    return (
        np.where(simple[..., None], points, np.nan),
        np.where(multiple[..., None], points, np.nan),
    )


def are_roots(pair: PolynomialPair, points: Complex, tolerance: float) -> Bools:
    """Return whether both polynomials vanish at points (pairs, k, 2), relative to their terms."""
    here = pair.at(points)
    with np.errstate(invalid="ignore"):
        small = [
            np.abs(value) <= tolerance * size
            for value, size in zip(here.value, here.size, strict=True)
        ]
    return np.asarray(small[0] & small[1])


def distinct(points: Complex, radius: Array) -> Complex:
    """Return each point once, shape (pairs, most, 2).

    Points that are NaN are left out, and so are those that have an earlier one within their radius,
    shape (k,).
    """
    valid = np.asarray(np.isfinite(points).all(axis=2))
    size = np.maximum(1.0, np.abs(points).max(axis=2))
    reach = np.where(valid, radius * size, 0.0)
    # Points are ordered by a number that two different ones share only by accident, so that equal
    # points are neighbors.
    number = points.real @ _MIX[0] + points.imag @ _MIX[1]
    order = np.argsort(number, axis=1)
    ordered, reach = np.take_along_axis(points, order[..., None], axis=1), _along(reach, order)
    dropped = np.zeros(valid.shape, bool)
    for gap in range(1, min(WINDOW, points.shape[1])):
        apart = np.abs(ordered[:, gap:] - ordered[:, :-gap]).max(axis=2)
        later = order[:, gap:] > order[:, :-gap]
        dropped[:, gap:] |= later & (apart < reach[:, gap:])
        dropped[:, :-gap] |= ~later & (apart < reach[:, :-gap])
    keep = valid.copy()
    np.put_along_axis(keep, order, _along(valid, order) & ~dropped, axis=1)
    order = np.argsort(~keep, axis=1, kind="stable")[:, : keep.sum(axis=1).max(initial=0)]
    kept = np.where(keep[..., None], points, np.nan)
    return np.take_along_axis(kept, order[..., None], axis=1)


def _along(values: NDArray[Any], order: Ints) -> NDArray[Any]:
    return np.take_along_axis(values, order, axis=1)


def counted(points: Complex) -> Ints:
    """Return the number of points of each member of the batch."""
    return np.asarray(np.isfinite(points).all(axis=2).sum(axis=1))


def real_roots(points: Complex) -> Array:
    """Return the real ones among the points (k, 2) of one pair, in order of x."""
    points = points[np.isfinite(points).all(axis=1)]
    size = np.maximum(1.0, np.abs(points).max(axis=1, initial=0.0))
    real = points[(np.abs(points.imag) < REAL * size[:, None]).all(axis=1)].real
    return np.asarray(real[np.lexsort(real.T[::-1])])
