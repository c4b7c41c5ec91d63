"""The surface that the patches of an atlas approximate, and how well they do."""

from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError


class ApproximationKind(StrEnum):
    """The way in which patches approximate a mesh."""

    SMOOTHED = "smoothed mesh"
    """They approximate the Catmull-Clark surface of the mesh, which lies inside where it bulges."""

    INTERPOLATED = "interpolated mesh"
    """They approximate a Catmull-Clark surface through the vertices of the mesh."""


@dataclass(frozen=True, eq=False)
class Approximation:
    """The deviation of an atlas from the surface and from the mesh that it approximates.

    It holds no lengths, so that it stays true when the atlas is moved, scaled or converted to
    another unit: distances are parts of the atlas's `extent`.

    Parameters
    ----------
    kind : ApproximationKind
    distance : array_like, shape (patches,)
        The largest distance of each patch from the surface.
    stretch : array_like, shape (patches,)
        A bound on the relative difference of lengths on each patch from those on the surface.
    mesh_distance, mesh_rms : float
        The largest distance between the mesh that was read and the patches, and the root mean
        square of all.
    mesh_lengths : float
        The relative difference of lengths, positive if the mesh's are longer: the mean over all
        places and directions.

    Raises
    ------
    InputError
        If a number is negative or not finite, or the arrays differ in their shapes.
    """

    kind: ApproximationKind
    distance: Array
    stretch: Array
    mesh_distance: float
    mesh_rms: float
    mesh_lengths: float

    def __post_init__(self) -> None:
        set_field = object.__setattr__
        for name in ("distance", "stretch"):
            set_field(self, name, _checked(getattr(self, name), name))
        if self.distance.shape != self.stretch.shape:
            raise InputError(
                f"the approximation has {len(self.distance)} distances and {len(self.stretch)} "
                "stretches; expected one of each for each patch"
            )
        _checked([self.mesh_distance, self.mesh_rms, self.mesh_lengths + 1.0], "deviation")

    def part(self, patches: Ints, size: float) -> Self:
        """Return that of some of the patches, if the whole is `size` times as large as they are.

        The numbers on the mesh stay those of the whole.
        """
        return replace(
            self,
            distance=size * self.distance[patches],
            stretch=self.stretch[patches],
            mesh_distance=size * self.mesh_distance,
            mesh_rms=size * self.mesh_rms,
        )

    def is_same(self, other: "Approximation | None") -> bool:
        """Whether another has the same numbers."""
        return other is not None and all(
            np.array_equal(getattr(self, name), getattr(other, name))
            for name in self.__dataclass_fields__
        )


def extent(points: Array) -> float:
    """Return the root mean square distance of points (n, 3) from their center."""
    return float(np.sqrt(((points - points.mean(axis=0)) ** 2).sum(axis=1).mean()))


def _checked(values: ArrayLike, name: str) -> Array:
    try:
        array = np.array(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"the {name} of the approximation is no list of numbers") from None
    if array.ndim != 1 or not ((array >= 0.0) & (array < np.inf)).all():
        raise InputError(
            f"the approximation has a {name} that is negative or not finite, or no number for each "
            "patch; expected numbers of at least 0"
        )
    array.flags.writeable = False
    return array
