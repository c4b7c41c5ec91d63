"""The faces of the file that an atlas was read from, and their own parameters."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.point import ON_EDGE, AtlasPoint, on_edges
from bodymeasure.errors import InputError
from bodymeasure.wording import hint


@dataclass(frozen=True, eq=False)
class FileFaces:
    """The faces of a file, each of one or more patches, and their parameters (s, t).

    On every patch, (s, t) are affine functions of (u, v).

    Parameters
    ----------
    names : sequence of str, one for each patch
        The face that each patch is a part of, as notes and errors on the file name it; empty where
        it is a part of none that has parameters.
    corners : array_like, shape (patches, 3, 2)
        The (s, t) of each patch at (u, v) = (0, 0), (1, 0) and (0, 1).
    without : mapping of str to str
        The names of faces without parameters, and why they have none.

    Raises
    ------
    InputError
        If the shapes do not fit, a number is not finite, or a patch covers no area of its face.
    """

    names: tuple[str, ...]
    corners: Array
    without: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        set_field = object.__setattr__
        set_field(self, "names", tuple(self.names))
        set_field(self, "corners", _checked(self.corners, self.names))
        set_field(self, "without", dict(self.without))

    def point(self, face: str, s: float, t: float) -> AtlasPoint:
        """Return the point of the atlas at the parameters of a face; see `Atlas.parameters`."""
        patches = np.flatnonzero([name == face for name in self.names])
        if not len(patches):
            raise InputError(self._reason(face))
        try:
            place = np.array([s, t], dtype=np.float64)
        except (TypeError, ValueError):
            raise InputError(f"(s, t) = ({s!r}, {t!r}); expected two numbers") from None
        if place.shape != (2,):
            raise InputError(f"(s, t) = ({s!r}, {t!r}); expected one number each")
        corners = self.corners[patches]
        start, sides = corners[:, 0], corners[:, 1:] - corners[:, :1]
        parameters = np.linalg.solve(sides.transpose(0, 2, 1), (place - start)[..., None])[..., 0]
        outside = np.abs(parameters - 0.5).max(axis=1) - 0.5
        # A place on a side that two patches share may be beside both, by rounding.
        ends = np.concatenate(
            [corners, corners[:, 1:].sum(axis=1, keepdims=True) - corners[:, :1]], 1
        )
        room = ON_EDGE * np.maximum(1.0, np.abs(ends).max() / np.ptp(ends, axis=1).min(axis=1))
        found = np.flatnonzero(outside <= room)
        if not len(found):
            low, high = ends.min(axis=(0, 1)), ends.max(axis=(0, 1))
            raise InputError(
                f"(s, t) = ({s:g}, {t:g}) is not on {face}, on which s runs from {low[0]:g} to "
                f"{high[0]:g} and t from {low[1]:g} to {high[1]:g}"
            )
        best = found[outside[found] <= 0.0][0] if (outside[found] <= 0.0).any() else found[0]
        u, v = on_edges(np.clip(parameters[best], 0.0, 1.0)).tolist()
        return AtlasPoint(int(patches[best]), u, v)

    def _reason(self, face: str) -> str:
        if face in self.without:
            return f"{face} has no parameters: {self.without[face]}"
        known = list(dict.fromkeys(name for name in self.names if name))
        return f"the file has no face {face!r}; {hint(str(face), known)}"

    def part(self, patches: Ints) -> Self:
        """Return the faces of some of the patches."""
        names = tuple(self.names[patch] for patch in patches.tolist())
        lost = dict.fromkeys(name for name in self.names if name and name not in set(names))
        reason = "it is not among the groups that were taken"
        return replace(
            self,
            names=names,
            corners=self.corners[patches],
            without={**self.without, **dict.fromkeys(lost, reason)},
        )

    def is_same(self, other: "FileFaces | None") -> bool:
        """Whether another has the same faces, with the same parameters."""
        return (
            other is not None
            and (self.names, self.without) == (other.names, other.without)
            and np.array_equal(self.corners, other.corners)
        )


def rectangles(along_s: Array, along_t: Array) -> Array:
    """Return the corners of all rectangles of a grid, those along t after each other.

    Parameters
    ----------
    along_s, along_t : ndarray, shapes (m, 2) and (n, 2)
        Where each begins and ends.

    Returns
    -------
    ndarray, shape (m n, 3, 2)
    """
    result = np.empty((len(along_s), len(along_t), 3, 2))
    result[..., 0] = along_s[:, None, [0, 1, 0]]
    result[..., 1] = along_t[None, :, [0, 0, 1]]
    return result.reshape(-1, 3, 2)


def _checked(corners: ArrayLike, names: Sequence[str]) -> Array:
    try:
        array = np.array(corners, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError("the parameters of faces are no numbers") from None
    if array.shape != (len(names), 3, 2):
        raise InputError(
            f"the parameters of faces have shape {array.shape}; expected {(len(names), 3, 2)}, "
            "three corners of each patch"
        )
    named = np.array([bool(name) for name in names], dtype=np.bool_)
    # Halves do not overflow, and quotients make ranges of any size comparable.
    with np.errstate(invalid="ignore", divide="ignore"):
        sides = array[:, 1:] / 2.0 - array[:, :1] / 2.0
        sides = sides / np.abs(sides).max(axis=1, keepdims=True)
        area = np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
    bad = np.flatnonzero(~np.isfinite(array).all(axis=(1, 2)) | (named & ~(area > 0.0)))
    if len(bad):
        raise InputError(
            f"patch {bad[0]} has the corners {array[bad[0]].tolist()} on its face; expected "
            "finite numbers that span an area"
        )
    array.flags.writeable = False
    return array
