"""Planes that cut an atlas."""

from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.errors import InputError


@dataclass(frozen=True, eq=False)
class Plane:
    """A plane through a point.

    Parameters
    ----------
    point : array_like, shape (3,)
    normal : array_like, shape (3,)
        It may have any length but zero, and is kept with length 1.

    Raises
    ------
    InputError
        If either is not three finite numbers, or the normal is zero.
    """

    point: Array
    normal: Array

    def __post_init__(self) -> None:
        point = _vector("point", self.point)
        normal = _vector("normal", self.normal)
        largest = np.abs(normal).max()
        if largest == 0.0:
            raise InputError("the plane's normal is zero; expected a direction")
        # Scaled first, so that no square overflows.
        normal = normal / largest
        object.__setattr__(self, "point", point)
        object.__setattr__(self, "normal", normal / np.linalg.norm(normal))

    @classmethod
    def horizontal(cls, atlas: Atlas, height: float) -> Self:
        """Return the plane at a height along the atlas's way up, in the atlas's unit."""
        up = atlas.axes.up_vector
        return cls(height * up, up)

    def moved(self, distance: float) -> Self:
        """Return the parallel plane so far along the normal."""
        return replace(self, point=self.point + distance * self.normal)

    def distances(self, positions: ArrayLike) -> Array:
        """Return the signed distances of positions (..., 3) from the plane, shape (...).

        Homogeneous coordinates (..., 4) give the distances times their weights.
        """
        given = np.asarray(positions, dtype=np.float64)
        if given.shape[-1] == 4:
            return np.asarray((given[..., :3] - given[..., 3:] * self.point) @ self.normal)
        return np.asarray((given - self.point) @ self.normal)

    def frame(self) -> Array:
        """Return two unit vectors in the plane, perpendicular to each other, shape (2, 3)."""
        least = np.eye(3)[np.argmin(np.abs(self.normal))]
        first = np.cross(self.normal, least)
        first /= np.linalg.norm(first)
        return np.stack([first, np.cross(self.normal, first)])

    def __str__(self) -> str:
        point, normal = (", ".join(f"{x:.6g}" for x in v) for v in (self.point, self.normal))
        return f"the plane through ({point}) with normal ({normal})"


def _vector(what: str, value: ArrayLike) -> Array:
    try:
        vector = np.array(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"the plane's {what} is {value!r}; expected three numbers") from None
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise InputError(f"the plane's {what} is {value!r}; expected three finite numbers")
    return vector
