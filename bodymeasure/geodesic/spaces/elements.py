"""Trial spaces of many short polynomials, which meet at joints."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.spaces.trial_space import TrialSpace


@dataclass(frozen=True, eq=False)
class ElementPolynomials:
    """The cardinal functions of elements of one degree, each of which is zero on most of them.

    They have the interface of `PiecewisePolynomials`, and take far less memory.

    Parameters
    ----------
    edges : ndarray, shape (elements + 1,)
        Increasing, from 0 to 1.
    element : TrialSpace
        The space of polynomials on one element.
    """

    edges: Array
    element: TrialSpace

    @property
    def count(self) -> int:
        """The number of functions."""
        return self.element.size * (len(self.edges) - 1) + 1

    def __call__(self, t: Array) -> Array:
        """Return values and two derivatives at t of shape (k,), in shape (3, k, functions)."""
        number, own = self._places(t)
        maps = self.element.matrices(own) if len(t) else np.zeros((3, 0, self.element.size + 1))
        maps = maps / np.diff(self.edges)[number][:, None] ** np.arange(3)[:, None, None]
        result = np.zeros((3, len(t), self.count))
        columns = number[:, None] * self.element.size + np.arange(self.element.size + 1)
        result[:, np.arange(len(t))[:, None], columns] = maps
        return result

    def values(self, t: Array) -> Array:
        """Return values alone, in shape (k, functions)."""
        return np.asarray(self(t)[0])

    @cached_property
    def coefficients(self) -> NDArray[np.longdouble]:
        """The Chebyshev coefficients, as those of `PiecewisePolynomials`."""
        own = self.element.functions.coefficients[..., 0]
        pieces = len(self.edges) - 1
        result = np.zeros((*own.shape[:2], self.count, pieces), dtype=np.longdouble)
        for piece, width in enumerate(np.diff(self.edges)):
            first = piece * self.element.size
            scale = (1.0 / width ** np.arange(3))[:, None, None]
            result[:, :, first : first + self.element.size + 1, piece] = own * scale
        return result

    def combined(self, values: Array, t: Array) -> Array:
        """Return sums of the functions, those of each problem at its own parameters.

        Parameters
        ----------
        values : ndarray, shape (problems, 2, functions)
            The factors of the functions.
        t : ndarray, shape (problems, k)

        Returns
        -------
        ndarray, shape (problems, k, 2)
        """
        return np.stack([self.values(own) @ each.T for each, own in zip(values, t, strict=True)])

    def _places(self, t: Array) -> tuple[Ints, Array]:
        """The element of each parameter, and its place there, from 0 to 1."""
        last = len(self.edges) - 2
        number = np.clip(np.searchsorted(self.edges, t, side="right") - 1, 0, last)
        left, right = self.edges[number], self.edges[number + 1]
        return number, np.clip((t - left) / (right - left), 0.0, 1.0)


@dataclass(frozen=True, eq=False)
class ElementSpace(TrialSpace):
    """A trial space of elements."""

    functions: Any

    def leaves_patch(self, values: Array, margin: float) -> Bools:
        """Return which paths go further than a margin outside [0, 1], in u or v."""
        element = self.functions.element
        rows = np.arange(len(self.functions.edges) - 1)[:, None] * element.size
        parts = values[:, :, rows + np.arange(element.size + 1)]
        result: Bools = np.zeros(len(values), bool)
        for number, own in enumerate(parts):
            result[number] = element.leaves_patch(own.transpose(1, 0, 2), margin).any()
        return result


def element_space(edges: Array, degree: int) -> TrialSpace:
    """Return the space of continuous functions that are polynomials on each of some elements.

    Parameters
    ----------
    edges : ndarray, shape (elements + 1,)
        Increasing, from 0 to 1.
    degree : int
        The degree of the polynomials.
    """
    element = polynomial_space(degree)
    nodes = edges[:-1, None] + np.diff(edges)[:, None] * element.nodes[:-1]
    return ElementSpace(
        nodes=np.append(nodes.ravel(), 1.0),
        condition=element.condition,
        functions=ElementPolynomials(edges, element),
        description=f"{len(edges) - 1} elements of degree {degree}",
    )
