"""Problems turned so that each runs from corner (0, 0) to corner (1, 1) of its own patch."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.bezier import restrict
from bodymeasure.geodesic.numerics.array_libraries import constant, is_on_cpu, namespace, to_numpy

# The number of problems in one array operation: enough to hide the cost of calls, and few enough
# for the cache.
CHUNK = 1024
# The number of problems that are solved at once elsewhere than on the CPU.
MANY = 16384
# The rounding errors of the control points of a part of a patch of size 1.
RESTRICTION = 2e-15


@dataclass(frozen=True)
class OffsetProblems:
    """A batch of problems on patches of one degree.

    Parameters
    ----------
    nets : array, shape (problems, m + 1, n + 1, 3)
        The control points of the patches: whole ones, where all points are corners, else each
        restricted to the rectangle between its two points.
    start, end : ndarray, shape (problems, 2)
        Those points, in the parameters of the whole patches.
    are_corners : bool
    """

    nets: Any
    start: Array
    end: Array
    are_corners: bool

    @classmethod
    def of_corners(cls, nets: Any, start: Array, end: Array) -> "OffsetProblems":
        """Return the problems of going from corners to the opposite ones."""
        return cls(nets, start, end, True)

    @classmethod
    def of(cls, nets: Any, start: Array, end: Array) -> "OffsetProblems":
        """Return the problems of going from start to end, no coordinate of which may be equal."""
        if are_corners(start, end):
            return cls.of_corners(nets, start, end)
        xp = namespace(nets)
        parts = constant(restrict(to_numpy(_centered(nets)), start, end), nets, xp)
        return cls(parts, start, end, False)

    @cached_property
    def columns(self) -> Any:
        """The control points, each patch turned, shape ((m + 1) * (n + 1), 3, problems)."""
        nets, xp = self.nets, self.xp
        if self.are_corners:
            nets = _centered(nets)
            for axis in (0, 1):
                turned = self.start[:, axis] == 1.0
                if turned.any():
                    turned = constant(turned, nets, xp)[:, None, None, None]
                    nets = xp.where(turned, xp.flip(nets, axis=axis + 1), nets)
        flat = xp.permute_dims(xp.reshape(nets, (nets.shape[0], -1, 3)), (1, 2, 0))
        # Joining two axes and splitting them again makes the array contiguous.
        return xp.reshape(xp.reshape(flat, (flat.shape[0], -1)), flat.shape)

    @property
    def chunk_size(self) -> int:
        """The number of problems in one array operation."""
        return CHUNK if is_on_cpu(self.nets) else MANY

    @cached_property
    def chunks(self) -> list[tuple[slice, "OffsetProblems"]]:
        """All of the problems in parts, each with its place."""
        if self.count <= self.chunk_size:
            return [(slice(None), self)]
        return [(rows, self.part(rows)) for rows in slices(self.count, self.chunk_size)]

    @property
    def degrees(self) -> tuple[int, int]:
        """The degrees m and n of the patches."""
        return self.nets.shape[1] - 1, self.nets.shape[2] - 1

    @property
    def count(self) -> int:
        """The number of problems."""
        return len(self.start)

    @property
    def xp(self) -> Any:
        """The namespace of the array library of the control points."""
        return namespace(self.nets)

    @property
    def rounding(self) -> float:
        """The error that rounding of the control points causes in any length."""
        return 0.0 if self.are_corners else RESTRICTION

    def take(self, rows: Ints) -> "OffsetProblems":
        """Return some of the problems."""
        nets = self.xp.take(self.nets, constant(rows, self.nets, self.xp), axis=0)
        return OffsetProblems(nets, self.start[rows], self.end[rows], self.are_corners)

    def part(self, rows: slice) -> "OffsetProblems":
        """Return some of the problems, which are in a row, without copying them."""
        nets = self.nets[rows, ...]
        return OffsetProblems(nets, self.start[rows], self.end[rows], self.are_corners)

    def parameters(self, times: Array, offset: Any) -> list[Any]:
        """Return u and v in the whole patches for offsets of shape (times, problems)."""
        t = constant(times[:, None], offset, self.xp)
        result = []
        for axis, sign in ((0, 1.0), (1, -1.0)):
            first, last = (constant(x[:, axis], offset, self.xp) for x in (self.start, self.end))
            result.append(first + (last - first) * (t + sign * offset))
        return result


def slices(count: int, size: int) -> Iterator[slice]:
    """Yield the range of a number of problems in nearly equal parts of at most a size."""
    if 0 < count <= size:
        yield slice(0, count)
        return
    edges = np.linspace(0, count, -(-count // size) + 1).astype(int)
    for first, last in pairwise(edges):
        yield slice(int(first), int(last))


def _centered(nets: Any) -> Any:
    """Patches near the origin, where rounding errors of their differences are smaller."""
    return nets - 0.5 * (nets[:, :1, :1, :] + nets[:, -1:, -1:, :])


def are_corners(start: Array, end: Array) -> bool:
    """Return whether all points are corners of their patches."""
    return bool((((start == 0.0) | (start == 1.0)) & (end == 1.0 - start)).all())
