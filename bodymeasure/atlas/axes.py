"""The axes of a body: which way is up, and which way it faces."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError

DIRECTIONS = ("+x", "-x", "+y", "-y", "+z", "-z")


@dataclass(frozen=True)
class Axes:
    """Directions of a standing body, each one of ``+x -x +y -y +z -z``.

    Parameters
    ----------
    up : str
        The direction from the soles to the crown.
    front : str
        The direction in which the body looks.

    Raises
    ------
    InputError
        If a direction is unknown, or both lie along one axis.
    """

    up: str = "+z"
    front: str = "-y"

    def __post_init__(self) -> None:
        for name, value in (("up", self.up), ("front", self.front)):
            if value not in DIRECTIONS:
                raise InputError(
                    f"axes: {name} is {value!r}; expected one of {', '.join(DIRECTIONS)}"
                )
        if self.up[1] == self.front[1]:
            raise InputError(
                f"axes: up ({self.up}) and front ({self.front}) lie along the same axis; "
                "they must be perpendicular"
            )

    @property
    def up_vector(self) -> Array:
        """Unit vector upwards, shape (3,)."""
        return unit_vector(self.up)

    @property
    def front_vector(self) -> Array:
        """Unit vector to the front, shape (3,)."""
        return unit_vector(self.front)

    @property
    def left_vector(self) -> Array:
        """Unit vector to the wearer's left, shape (3,)."""
        return np.cross(self.up_vector, self.front_vector)


def unit_vector(direction: str) -> Array:
    """Return the unit vector of one of `DIRECTIONS`, shape (3,)."""
    vector = np.zeros(3)
    vector["xyz".index(direction[1])] = 1.0 if direction[0] == "+" else -1.0
    return vector
