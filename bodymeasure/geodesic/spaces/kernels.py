"""Wu's compactly supported, positive definite radial functions."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bodymeasure.arguments import numbers


@dataclass(frozen=True)
class Kernel:
    """A radial function ``(1 - r)^exponent * (factor[0] + factor[1] r + ...)`` for r <= 1, else 0.

    Parameters
    ----------
    name : str
    exponent : int
        The power of the cut-off factor.
    factor : tuple of int
        The coefficients of the other factor, constant term first.
    smoothness : int
        The number of continuous derivatives, in one dimension at r = 0.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> bm.WU_C2([0.0, 0.5, 1.0])
    array([8.        , 1.35742188, 0.        ])
    """

    name: str
    # Where settings are printed, the name is enough.
    exponent: int = field(repr=False)
    factor: tuple[int, ...] = field(repr=False)
    smoothness: int = field(repr=False)

    @property
    def degree(self) -> int:
        """The degree of the polynomial that the function is on each side of its center."""
        return self.exponent + len(self.factor) - 1

    @property
    def coefficients(self) -> tuple[int, ...]:
        """The exact coefficients of the polynomial in r, constant term first."""
        product: tuple[int, ...] = self.factor
        for _ in range(self.exponent):
            product = tuple(
                here - before for here, before in zip((*product, 0), (0, *product), strict=True)
            )
        return product

    def __call__(self, r: ArrayLike) -> NDArray[np.float64]:
        """Return values at scaled distances r >= 0, of any shape."""
        distance = numbers(r, "r", "scaled distances")
        inside = np.clip(1.0 - distance, 0.0, None) ** self.exponent
        return np.asarray(inside * np.polynomial.polynomial.polyval(distance, self.factor))


# Z. Wu, "Compactly supported positive definite radial functions", Adv. Comput. Math. 4 (1995)
# 283-292: the family psi_{k,3}, made from the convolution of (1 - r^2)^3 with itself (k = 0) by
# k times taking -f'(r) / r. Listed in G. Fasshauer, "Meshfree Approximation Methods with MATLAB"
# (2007), section 11.3; psi_{0,5} is the same construction from (1 - r^2)^5. The tests carry out the
# construction and compare.
WU_C2 = Kernel("Wu C2", 5, (8, 40, 48, 25, 5), 2)
"""Wu's psi_{2,3}, the function of the paper's section 4."""

WU_C4 = Kernel("Wu C4", 6, (6, 36, 82, 72, 30, 5), 4)
"""Wu's psi_{1,3}."""

WU_C6 = Kernel("Wu C6", 7, (5, 35, 101, 147, 101, 35, 5), 6)
"""Wu's psi_{0,3}."""

WU_C10 = Kernel(
    "Wu C10",
    11,
    (3, 33, 163, 473, 883, 1089, 883, 473, 163, 33, 3),
    10,
)
"""Wu's psi_{0,5}; on centers outside [0, 1] it spans polynomials up to degree 21."""
