"""A path over a triangle mesh, its length and the error of that."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Unit
from bodymeasure.trust import is_known
from bodymeasure.wording import result_line


@dataclass(frozen=True, eq=False)
class MeshPath:
    """The shortest path over a triangle mesh.

    Parameters
    ----------
    length : float
        Exact length over the mesh itself, in `unit`.
    error_estimate : float
        How far the length may be from that over the smooth surface which the mesh stands for; in
        the same unit. Infinite where it could not be estimated.
    points : ndarray, shape (k, 3)
        The path, straight in each triangle.
    unit : Unit or None
        None if it was not given: meshes come without a unit.
    """

    length: float
    error_estimate: float
    points: Array
    unit: Unit | None

    def __repr__(self) -> str:
        return result_line("MeshPath", self.unit, self.error_estimate, length=self.length)

    @property
    def converged(self) -> bool:
        """Whether the mesh is fine enough that the length is that over its smooth surface, too."""
        return bool(is_known(self.length, self.error_estimate, np.ptp(self.points, axis=0).max()))

    @property
    def sentence(self) -> str:
        """The quality of the length in a sentence."""
        unit = "" if self.unit is None else f" {self.unit}"
        return (
            f"Measured on the mesh itself, not on a smooth surface: {self.length:.6g}{unit}, from "
            f"which the surface that the mesh stands for may differ by {self.error_estimate:.1g}"
            f"{unit}."
        )
