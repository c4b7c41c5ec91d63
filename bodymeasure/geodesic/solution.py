"""What is known of the geodesics of a batch of problems."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, fields
from types import EllipsisType
from typing import Any, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.errors import InputError
from bodymeasure.geodesic.solving.protocol import PathBatch
from bodymeasure.geodesic.status import have_length
from bodymeasure.wording import result_line

# What takes some problems out of a batch, as numpy's arrays are indexed.
_Index = SupportsIndex | slice | EllipsisType | Sequence[int] | Ints | Bools


@dataclass(frozen=True, eq=False)
class GeodesicSolution:
    """Geodesics between pairs of points of a batch of surfaces.

    Every array has the shape of the batch; for a single problem the numbers are plain floats,
    ints, bools and a `Status`.

    Parameters
    ----------
    start, end : ndarray, shape (*batch, 2)
        End points (u, v).
    length : ndarray or float
        Length of the geodesic, in the unit of the control points: of the computed path, less its
        excess. NaN unless the status has a length (``CONVERGED`` or ``ON_BOUNDARY``), so that no
        wrong number can slip through.
    raw_length : ndarray or float
        Length of the computed path itself, whatever the status.
    error_estimate : ndarray or float
        Estimated error of `length`, in the same unit (see `bodymeasure.geodesic.lengths.measure`).
        Infinite where nothing is known.
    residual : ndarray or float
        Largest geodesic curvature between the collocation points, times the length; 0 for an exact
        geodesic.
    status : ndarray of Status, or Status
    index : ndarray of int, or int
        The Morse index: in how many independent ways the path can be changed, its ends fixed, so
        that it gets shorter, which is the number of points on it that are conjugate to its start. 0
        for a local minimum; -1 where it is not known, because no geodesic was found or because the
        path ends at a conjugate point, as near as can be told. Of a path along an edge, it is the
        sum over its free legs, the ends of which stay in place: 0 proves of each that it is a local
        minimum, and of the whole no more than that.
    functions : ndarray of int, or int
        How many functions the path was found with.
    iterations : ndarray of int, or int
        Newton iterations, all trial spaces together.
    batches : tuple of PathBatch
        The paths, by trial space; problems are numbered through the flattened batch. For `path`.
    """

    start: Array
    end: Array
    length: Any
    raw_length: Any
    error_estimate: Any
    residual: Any
    status: Any
    index: Any
    functions: Any
    iterations: Any
    batches: tuple[PathBatch, ...]

    def __repr__(self) -> str:
        if not self.shape:
            kind, error, status = "GeodesicSolution", self.error_estimate, self.status.name
            return result_line(kind, None, error, outcome=status, length=self.length)
        names = Counter(status.name for status in self.status.flat)
        statuses = ", ".join(f"{count:,} {name}" for name, count in names.most_common())
        known = self.length[self.converged]
        span = f"lengths from {known.min():.6g} to {known.max():.6g}, " if known.size else ""
        return f"<GeodesicSolution of shape {self.shape}: {span}{statuses}>"

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the batch; () for a single problem."""
        return self.start.shape[:-1]

    @property
    def converged(self) -> Any:
        """Whether the length can be trusted, of the batch's shape."""
        result = have_length(np.asarray(self.status, dtype=object))
        return result if self.shape else bool(result)

    @property
    def local_minimum(self) -> Any:
        """Whether the path is proven to be shorter than all paths close to it: its index is 0.

        That a path elsewhere on the patch is not shorter still is not proven.
        """
        result = np.asarray(self.index) == 0
        return result if self.shape else bool(result)

    @property
    def contacts(self) -> Any:
        """The edges of its patch that each path runs along: a tuple of `EdgeContact`, mostly empty.

        An array of tuples for a batch.
        """
        result = np.empty(int(np.prod(self.shape)), dtype=object)
        result[:] = [()] * len(result)
        for batch in self.batches:
            for problem in batch.problems:
                result[problem] = batch.contacts
        return result.reshape(self.shape) if self.shape else result[0]

    @property
    def condition(self) -> Any:
        """Condition number of the collocation system of each path's trial space."""
        result = np.ones(int(np.prod(self.shape)))
        for batch in self.batches:
            result[batch.problems] = batch.space.condition
        return result.reshape(self.shape) if self.shape else float(result[0])

    def path(self, t: ArrayLike) -> Array:
        """Points of the paths.

        Parameters
        ----------
        t : array_like, shape () or (k,)
            In [0, 1], from start to end: parts of the length, as far as the path is a geodesic.

        Returns
        -------
        ndarray, shape (*batch, *t.shape, 2)
            (u, v). With the status ``LEAVES_PATCH`` they go outside [0, 1]. On a collapsed edge,
            where all parameters along it are one place, an end may have others than were given.

        Raises
        ------
        InputError
            If a t is not a number in [0, 1].
        """
        try:
            times = np.asarray(t, dtype=np.float64)
        except (TypeError, ValueError):
            raise InputError(f"path parameters are {t!r}; expected numbers in [0, 1]") from None
        if not ((times >= 0.0) & (times <= 1.0)).all():
            raise InputError(f"path parameters must lie in [0, 1]; got {times}")
        points = np.empty((int(np.prod(self.shape)), times.size, 2))
        # Problems without a batch have their ends in one place, and a line that stays there.
        first, last = (ends.reshape(-1, 1, 2) for ends in (self.start, self.end))
        points[:] = first + (last - first) * times.reshape(1, -1, 1)
        points[:, times.ravel() == 1.0] = last
        for batch in self.batches:
            points[batch.problems] = batch.points(times.ravel())
        return points.reshape(*self.shape, *times.shape, 2)

    def __getitem__(self, key: "_Index | tuple[_Index, ...]") -> "GeodesicSolution":
        """Some of the problems, by indexing the batch as an array."""
        numbers = np.arange(int(np.prod(self.shape))).reshape(self.shape)[key]
        place = np.full(int(np.prod(self.shape)), -1)
        # Indices may repeat a problem; then each batch gives its rows as often.
        chosen = np.atleast_1d(np.asarray(numbers)).ravel()
        batches = []
        for batch in self.batches:
            place[:] = -1
            place[batch.problems] = np.arange(len(batch.problems))
            rows = place[chosen]
            inside = np.flatnonzero(rows >= 0)
            if len(inside):
                batches.append(batch.take(rows[inside]).renumbered(inside))
        start, end = (ends.reshape(-1, 2)[numbers] for ends in (self.start, self.end))
        return GeodesicSolution(
            start=start,
            end=end,
            **{item.name: self._chosen(item.name, numbers) for item in fields(self)[2:-1]},
            batches=tuple(batches),
        )

    def _chosen(self, name: str, numbers: NDArray[np.int64]) -> Any:
        """An array's values for some of the problems; plain numbers for a single one."""
        values = np.asarray(getattr(self, name)).reshape(-1)
        return values[numbers] if np.ndim(numbers) else values[[numbers]].tolist()[0]
