"""Wu's functions against Wu's own construction, in fractions and in many digits."""

from fractions import Fraction
from math import comb

import numpy as np
import pytest

from bodymeasure._typing import Array
from bodymeasure.geodesic import WU_C2, WU_C4, WU_C6, WU_C10, Kernel

KERNELS = [WU_C2, WU_C4, WU_C6, WU_C10]
# (l, k): the convolution of (1 - x^2)^l with itself, k times -f'(r) / r.
CONSTRUCTION = {WU_C2: (3, 2), WU_C4: (3, 1), WU_C6: (3, 0), WU_C10: (5, 0)}

all_kernels = pytest.mark.parametrize("kernel", KERNELS, ids=lambda kernel: kernel.name)

Polynomial = list[Fraction]  # constant term first


def multiply(a: Polynomial, b: Polynomial) -> Polynomial:
    product = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            product[i + j] += x * y
    return product


def power(a: Polynomial, exponent: int) -> Polynomial:
    product = [Fraction(1)]
    for _ in range(exponent):
        product = multiply(product, a)
    return product


def convolution(l: int) -> Polynomial:  # noqa: E741
    """The integral of (1 - x^2)^l (1 - (2r - x)^2)^l over 2r - 1 <= x <= 1, for 0 <= r <= 1.

    Its support is [0, 2] in the distance 2r, so that the kernel's is [0, 1] in r.
    """
    factor = [Fraction((-1) ** (i // 2) * comb(l, i // 2) * (i % 2 == 0)) for i in range(2 * l + 1)]
    result = [Fraction(0)]
    for i, a in enumerate(factor):
        for j, b in enumerate(factor):
            # a x^i b (2r - x)^j, expanded by powers of 2r
            for m in range(j + 1):
                scale = a * b * comb(j, m) * (-1) ** (j - m)
                n = i + j - m + 1
                lower = power([Fraction(-1), Fraction(2)], n)
                integral = [-c / n for c in lower]
                integral[0] += Fraction(1, n)
                term = [Fraction(0)] * m + [scale * 2**m * c for c in integral]
                size = max(len(result), len(term))
                result = [
                    sum((p[q] for p in (result, term) if q < len(p)), Fraction(0))
                    for q in range(size)
                ]
    return result


def wu(kernel: Kernel) -> Polynomial:
    l, k = CONSTRUCTION[kernel]  # noqa: E741
    polynomial = convolution(l)
    for _ in range(k):
        slope = [-q * c for q, c in enumerate(polynomial)][1:]
        assert slope[0] == 0  # so that it can be divided by r
        polynomial = slope[1:]
    while polynomial[-1] == 0:
        polynomial.pop()
    return polynomial


@all_kernels
def test_the_kernel_is_wus_up_to_a_constant(kernel: Kernel) -> None:
    constructed = wu(kernel)
    scale = constructed[0] / kernel.coefficients[0]
    assert constructed == [scale * c for c in kernel.coefficients]
    assert kernel.degree == len(constructed) - 1


@all_kernels
def test_it_is_smooth_at_its_center_as_far_as_stated_and_no_further(kernel: Kernel) -> None:
    # |r|^k with an odd k is k - 1 times continuously differentiable.
    odd = [k for k, c in enumerate(kernel.coefficients) if k % 2 and c]
    assert min(odd) - 1 == kernel.smoothness


@all_kernels
def test_it_is_smooth_at_the_end_of_its_support(kernel: Kernel) -> None:
    # A zero of order e at r = 1 joins zero e - 1 times continuously differentiable.
    polynomial = [Fraction(c) for c in kernel.coefficients]
    order = 0
    while sum(polynomial) == 0:
        polynomial = [q * c for q, c in enumerate(polynomial)][1:]
        order += 1
    assert order == kernel.exponent
    assert order - 1 >= kernel.smoothness


@all_kernels
def test_values_agree_with_the_exact_polynomial(kernel: Kernel) -> None:
    for r in (Fraction(0), Fraction(1, 64), Fraction(1, 3), Fraction(1, 2), Fraction(15, 16)):
        exact = sum(c * r**q for q, c in enumerate(kernel.coefficients))
        assert kernel(float(r)) == pytest.approx(float(exact), rel=1e-13)


@all_kernels
def test_it_is_zero_from_the_end_of_its_support_on(kernel: Kernel) -> None:
    np.testing.assert_array_equal(kernel([1.0, np.nextafter(1.0, 2.0), 1.5, 1e9]), 0.0)
    assert kernel(1.0 - 1e-3) > 0.0


@all_kernels
def test_it_falls_from_its_center_on(kernel: Kernel) -> None:
    assert (np.diff(kernel(np.linspace(0.0, 1.0, 201))) < 0.0).all()


def test_values_have_the_shape_of_the_distances() -> None:
    assert WU_C2(0.5).shape == ()
    assert WU_C2(np.zeros((2, 3))).shape == (2, 3)


def is_positive_definite(matrix: list[list[Fraction]]) -> bool:
    """Whether all pivots of exact elimination without exchanges are positive."""
    rows = [list(row) for row in matrix]
    for k in range(len(rows)):
        if rows[k][k] <= 0:
            return False
        for i in range(k + 1, len(rows)):
            factor = rows[i][k] / rows[k][k]
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k], strict=True)]
    return True


def gram(kernel: Kernel, points: list[tuple[int, ...]], radius: int) -> list[list[Fraction]]:
    """Kernel values at the pairwise distances of points on a line, which are rational."""

    def value(r: Fraction) -> Fraction:
        if r >= 1:
            return Fraction(0)
        return sum((c * r**q for q, c in enumerate(kernel.coefficients)), Fraction(0))

    return [
        [
            value(Fraction(sum(abs(x - y) for x, y in zip(a, b, strict=True)), radius))
            for b in points
        ]
        for a in points
    ]


@all_kernels
@pytest.mark.parametrize("radius", [3, 17, 100])
def test_gram_matrices_are_positive_definite(
    kernel: Kernel, radius: int, rng: np.random.Generator
) -> None:
    # The arithmetic is exact, since the eigenvalues are far below the rounding errors of the
    # entries.
    places = rng.choice(100, size=12, replace=False).tolist()
    assert is_positive_definite(gram(kernel, [(place,) for place in places], radius))


@all_kernels
def test_gram_matrices_are_positive_definite_in_space(
    kernel: Kernel, rng: np.random.Generator
) -> None:
    points: Array = rng.random((40, 3))
    distance = np.linalg.norm(points[:, None] - points[None], axis=-1)
    for radius in (0.3, 0.6):
        assert np.linalg.eigvalsh(kernel(distance / radius))[0] > 0.0


def test_a_function_that_is_not_positive_definite_is_told_apart() -> None:
    # A truncated parabola fails the test above, which shows that it is a test.
    parabola = Kernel("1 - r^2", 1, (1, 1), 0)
    assert not is_positive_definite(gram(parabola, [(i,) for i in range(12)], 5))
