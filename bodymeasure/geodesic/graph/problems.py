"""Problems turned so that each runs from corner (0, 0) to corner (1, 1) of its own patch."""

from dataclasses import dataclass
from typing import Any

import array_api_compat

from bodymeasure._typing import Array, Ints
from bodymeasure.bezier import restrict
from bodymeasure.geodesic.numerics.array_libraries import constant, to_numpy
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces

# The rounding errors of the control points of a part of a patch of size 1.
RESTRICTION = 2e-15


@dataclass(frozen=True)
class OffsetProblems:
    """A batch of problems on patches of one degree.

    Parameters
    ----------
    columns : array, shape ((m + 1) * (n + 1), 3, problems)
        The control points of the patches, each restricted to the rectangle between its two points.
    start, end : ndarray, shape (problems, 2)
        Those points, in the parameters of the whole patches.
    degrees : tuple of int
        m and n.
    """

    columns: Any
    start: Array
    end: Array
    degrees: tuple[int, int]

    @classmethod
    def of(cls, surface: BezierSurfaces, start: Array, end: Array) -> "OffsetProblems":
        """Return the problems of going from start to end, no coordinate of which may be equal."""
        nets = surface.control_points
        xp = array_api_compat.array_namespace(nets)
        # Only differences matter, and they have smaller rounding errors near the origin.
        nets = nets - 0.5 * (nets[:, :1, :1, :] + nets[:, -1:, -1:, :])
        if _are_corners(start, end):
            for axis in (0, 1):
                turned = start[:, axis] == 1.0
                if turned.any():
                    turned = constant(turned, nets, xp)[:, None, None, None]
                    nets = xp.where(turned, xp.flip(nets, axis=axis + 1), nets)
        else:
            nets = constant(restrict(to_numpy(nets), start, end), nets, xp)
        flat = xp.permute_dims(xp.reshape(nets, (nets.shape[0], -1, 3)), (1, 2, 0))
        # Joining two axes and splitting them again makes the array contiguous.
        columns = xp.reshape(xp.reshape(flat, (flat.shape[0], -1)), flat.shape)
        return cls(columns, start, end, surface.degrees)

    @property
    def count(self) -> int:
        """The number of problems."""
        return len(self.start)

    @property
    def xp(self) -> Any:
        """The namespace of the array library of the control points."""
        return array_api_compat.array_namespace(self.columns)

    @property
    def rounding(self) -> float:
        """The error that rounding of the control points causes in any length."""
        return 0.0 if _are_corners(self.start, self.end) else RESTRICTION

    def take(self, rows: Ints) -> "OffsetProblems":
        """Return some of the problems."""
        columns = self.xp.take(self.columns, constant(rows, self.columns, self.xp), axis=2)
        return OffsetProblems(columns, self.start[rows], self.end[rows], self.degrees)

    def parameters(self, times: Array, offset: Any) -> list[Any]:
        """Return u and v in the whole patches for offsets of shape (times, problems)."""
        t = constant(times[:, None], offset, self.xp)
        result = []
        for axis, sign in ((0, 1.0), (1, -1.0)):
            first, last = (constant(x[:, axis], offset, self.xp) for x in (self.start, self.end))
            result.append(first + (last - first) * (t + sign * offset))
        return result


def _are_corners(start: Array, end: Array) -> bool:
    """Return whether all points are corners of their patches."""
    return bool(((start == 0.0) | (start == 1.0)).all() and (end == 1.0 - start).all())
