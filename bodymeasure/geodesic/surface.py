"""What the solver asks of a surface: its derivatives."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property, lru_cache
from typing import Any, Protocol

import array_api_compat
import numpy as np
from numpy.typing import ArrayLike, NDArray

from bodymeasure.bezier import bernstein_values, elevate
from bodymeasure.errors import InputError
from bodymeasure.geodesic.arrays import constant, to_numpy

# Order of the derivatives in a jet: (times by u, times by v).
JET = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3))
# Number of derivatives up to each order.
JET_SIZE = (1, 3, 6, 10)


class Surface(Protocol):
    """A batch of surfaces, one for each geodesic problem."""

    def jet(self, parameters: NDArray[np.float64], order: int) -> NDArray[np.float64]:
        """Derivatives up to an order of at most 3.

        Parameters
        ----------
        parameters : ndarray, shape (problems, k, 2)
        order : int

        Returns
        -------
        ndarray, shape (derivatives, 3, problems, k)
            In the order of `JET`.
        """

    def take(self, problems: NDArray[np.int64]) -> Surface:
        """The surfaces of some of the problems."""


class BezierSurfaces:
    """Bezier patches, each derivative held as control points of the patch's own degree.

    Then one product of the basis functions with one matrix gives all derivatives at once, and in
    a numerically stable way.

    Parameters
    ----------
    control_points : array, shape (problems, m + 1, n + 1, 3)
        Of any library that keeps to the Python array API standard; the jets are numpy's.
    """

    def __init__(self, control_points: Any) -> None:
        self.control_points = control_points
        self.degrees = (control_points.shape[1] - 1, control_points.shape[2] - 1)

    @cached_property
    def _nets(self) -> NDArray[np.float64]:
        """Control points of all derivatives, shape (problems, basis functions, 3 * derivatives).

        Made when first needed, since they take thirty times the place of the patches.
        """
        points = to_numpy(self.control_points)
        size = (self.degrees[0] + 1) * (self.degrees[1] + 1)
        # One large matrix product for all patches, then to (problems, basis functions, derivative
        # and component).
        columns = points.reshape(-1, size, 3).transpose(1, 0, 2).reshape(size, -1)
        nets = (_jet_map(*self.degrees) @ columns).reshape(len(JET), size, -1, 3)
        return np.ascontiguousarray(nets.transpose(2, 1, 0, 3)).reshape(-1, size, 3 * len(JET))

    def jet(self, parameters: NDArray[np.float64], order: int) -> NDArray[np.float64]:
        """Derivatives in the order of `JET`, shape (derivatives, 3, problems, k)."""
        problems, count = parameters.shape[:2]
        basis = np.empty((problems, count, self.degrees[0] + 1, self.degrees[1] + 1))
        in_v = bernstein_values(self.degrees[1], parameters[..., 1])
        for i, value in enumerate(bernstein_values(self.degrees[0], parameters[..., 0])):
            for j, other in enumerate(in_v):
                np.multiply(value, other, out=basis[:, :, i, j])
        size = JET_SIZE[order]
        values = basis.reshape(problems, count, self._nets.shape[1]) @ self._nets[:, :, : 3 * size]
        return np.ascontiguousarray(values.reshape(-1, 3 * size).T).reshape(
            size, 3, problems, count
        )

    def take(self, problems: NDArray[np.int64]) -> BezierSurfaces:
        """The patches of some of the problems."""
        points = self.control_points
        xp = array_api_compat.array_namespace(points)
        part = BezierSurfaces(xp.take(points, constant(problems, points, xp), axis=0))
        if "_nets" in self.__dict__:
            part._nets = self._nets[problems]
        return part


@lru_cache
def _jet_map(degree_u: int, degree_v: int) -> NDArray[np.float64]:
    """Matrix from a patch's control points to those of its derivatives, stacked."""
    along_u, along_v = _derivative_maps(degree_u), _derivative_maps(degree_v)
    return np.concatenate([np.kron(along_u[i], along_v[j]) for i, j in JET])


def _derivative_maps(degree: int) -> list[NDArray[np.float64]]:
    """Maps from Bezier points of a curve to those of its derivatives, in the same degree."""
    maps = []
    difference = np.eye(degree + 1)
    for order in range(4):
        lower = max(degree - order, 0)
        if order > degree:
            difference = np.zeros((1, degree + 1))
        # One column of control points a basis function: elevate them all as one curve's points.
        columns = difference.T[:, :, None, None].repeat(3, axis=-1)
        maps.append(elevate(columns, degree, 0)[:, :, 0, 0].T)
        difference = lower * np.diff(difference, axis=0)
    return maps


class CustomSurface:
    """One surface of the user's own, the same for all problems.

    Parameters
    ----------
    derivatives : callable
        From parameters of shape (..., 2) to derivatives of shape (..., 10, 3), in the order of
        `JET`.
    """

    def __init__(self, derivatives: Callable[[NDArray[np.float64]], ArrayLike]) -> None:
        self._derivatives = derivatives

    def jet(self, parameters: NDArray[np.float64], order: int) -> NDArray[np.float64]:
        """Derivatives in the order of `JET`, shape (derivatives, 3, problems, k)."""
        values = np.asarray(self._derivatives(parameters), dtype=np.float64)
        expected = (*parameters.shape[:-1], len(JET), 3)
        if values.shape != expected:
            raise InputError(
                f"the surface's derivatives have shape {values.shape} for parameters of shape "
                f"{parameters.shape}; expected {expected}"
            )
        return np.ascontiguousarray(values.transpose(2, 3, 0, 1)[: JET_SIZE[order]])

    def take(self, problems: NDArray[np.int64]) -> CustomSurface:
        """The same surface: it serves all problems."""
        del problems
        return self
