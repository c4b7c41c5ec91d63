"""A parametric surface of the user's own."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError
from bodymeasure.geodesic.surfaces.protocol import JET, JET_SIZE

# The number of points along each side of the grid from which the size of a surface is taken.
SAMPLES = 5


class CustomSurface:
    """One surface of the user's own, the same for all problems.

    Parameters
    ----------
    derivatives : callable
        A function from parameters of shape (..., 2) to derivatives of shape (..., 10, 3), in the
        order of `JET`.
    size : float
        The number by which the derivatives are divided.
    """

    def __init__(self, derivatives: Callable[[Array], ArrayLike], size: float = 1.0) -> None:
        self._derivatives = derivatives
        self._size = size

    def jet(self, parameters: Array, order: int) -> Array:
        """Return the derivatives in the order of `JET`, shape (derivatives, 3, problems, k)."""
        values = np.asarray(self._derivatives(parameters), dtype=np.float64)
        expected = (*parameters.shape[:-1], len(JET), 3)
        if values.shape != expected:
            raise InputError(
                f"the surface's derivatives have shape {values.shape} for parameters of shape "
                f"{parameters.shape}; expected {expected}"
            )
        values = values[:, :, : JET_SIZE[order]] / self._size
        return np.ascontiguousarray(values.transpose(2, 3, 0, 1))

    def positions(self, parameters: Array) -> Array:
        """Return points, shape (problems, k, 3)."""
        return np.asarray(self.jet(parameters, 0)[0].transpose(1, 2, 0))

    def magnitude(self, parameters: Array) -> Array:
        """Return the size of the terms of S_u and S_v, estimated by their values."""
        _, s_u, s_v, s_uu, s_uv, s_vv = np.linalg.norm(self.jet(parameters, 2), axis=1)
        u, v = np.abs(np.moveaxis(parameters, -1, 0))
        return np.stack([s_u + s_uu * u + s_uv * v, s_v + s_uv * u + s_vv * v])

    def take(self, problems: Ints) -> "CustomSurface":
        """Return the same surface, which serves all problems."""
        del problems
        return self

    def of_size_one(self) -> "tuple[CustomSurface, float]":
        """Return the surface scaled to a size of about 1, and the size that it had.

        The size is a power of 2, so that nothing is rounded; it is 1 for a surface that is not
        finite or all one point.
        """
        line = np.linspace(0.0, 1.0, SAMPLES)
        grid = np.stack(np.meshgrid(line, line), axis=-1).reshape(1, -1, 2)
        extent = np.ptp(self.jet(grid, 0)[0, :, 0], axis=1).max()
        if not (np.isfinite(extent) and extent > 0.0):
            return self, 1.0
        size = float(np.ldexp(1.0, int(np.frexp(extent)[1])))
        return CustomSurface(self._derivatives, size), size
