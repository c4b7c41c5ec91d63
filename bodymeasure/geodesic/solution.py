"""The solution: the geodesics of a batch of problems, and how good they are."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from types import EllipsisType
from typing import Any, SupportsIndex, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.closer_bounds import closer_bounds
from bodymeasure.geodesic.lengths.arc_length_times import checked_times
from bodymeasure.geodesic.proofs.bounds import Bounds
from bodymeasure.geodesic.proofs.curvature import CurvatureBounds
from bodymeasure.geodesic.proofs.patches import PatchesOfPaths
from bodymeasure.geodesic.solving.protocol import PathBatch
from bodymeasure.geodesic.status import Status, have_length
from bodymeasure.threads import one_blas_thread
from bodymeasure.wording import result_line

_T = TypeVar("_T", bound=np.generic)
# The indices that take some problems out of a batch, as those of an array.
_Index = SupportsIndex | slice | EllipsisType | Sequence[int] | Ints | Bools


@dataclass(frozen=True, eq=False)
class GeodesicSolution:
    """Geodesics between pairs of points of a batch of surfaces.

    Every array has the shape of the batch. The annotations speak of arrays; for a single problem,
    the same attributes are plain floats, ints, bools and a `Status`.

    Parameters
    ----------
    start, end : ndarray, shape (*batch, 2)
        The end points (u, v).
    length : ndarray or float
        The length of the geodesic, in the unit of the control points: that of the computed path,
        less its excess. It is NaN unless the status has a length (``CONVERGED`` or
        ``ON_BOUNDARY``), so that no wrong number can slip through.
    raw_length : ndarray or float
        The length of the computed path itself, whatever the status.
    error_estimate : ndarray or float
        The estimated error of `length`, in the same unit (see
        `bodymeasure.geodesic.lengths.measure`); infinite where nothing is known.
    residual : ndarray or float
        The largest geodesic curvature between the collocation points, times the length; 0 for an
        exact geodesic.
    status : ndarray of Status, or Status
    index : ndarray of int, or int
        The Morse index: the number of independent ways in which the path can be changed, its ends
        fixed, so that it gets shorter, which is the number of points on it that are conjugate to
        its start. It is 0 for a local minimum, and -1 where it is not known: because no geodesic
        was found, or because the path ends too close to a conjugate point. For a path along an
        edge, it is the sum over its free legs with their ends in place: 0 proves that each leg is a
        local minimum, but not that the whole is one.
    functions : ndarray of int, or int
        The number of functions that the path was found with.
    iterations : ndarray of int, or int
        The number of Newton iterations, all trial spaces together.
    batches : tuple of PathBatch
        The paths, by trial space, from which `path` takes its points; problems are numbered through
        the flattened batch.
    patches : PatchesOfPaths, optional
        The patches of the paths, from which `proven_shortest` is found when it is asked for; None
        on surfaces that are no polynomial patches.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> net = bm.load_sample("paraboloid").control_points[0]
    >>> solution = bm.solve_geodesic(net, (0.0, 0.0), [(1.0, 0.5), (1.0, 1.0)])
    >>> solution
    <GeodesicSolution of shape (2,): lengths from 1.75543 to 2.56201, 2 CONVERGED>
    >>> round(solution[1].length, 5)
    2.56201
    >>> solution.path(0.5).round(3)
    array([[0.621, 0.311],
           [0.642, 0.642]])
    """

    start: Array
    end: Array
    length: Array
    raw_length: Array
    error_estimate: Array
    residual: Array
    status: NDArray[np.object_] | Status
    index: Ints
    functions: Ints
    iterations: Ints
    batches: tuple[PathBatch, ...]
    patches: PatchesOfPaths | None = None

    def __repr__(self) -> str:
        statuses = np.asarray(self.status, dtype=object).ravel().tolist()
        if not self.shape:
            length, error = float(self.length), float(self.error_estimate)
            name = statuses[0].name
            return result_line("GeodesicSolution", None, error, outcome=name, length=length)
        counts = Counter(status.name for status in statuses).most_common()
        listed = ", ".join(f"{count:,} {name}" for name, count in counts)
        known = self.length[self.converged]
        span = f"lengths from {known.min():.6g} to {known.max():.6g}, " if known.size else ""
        return f"<GeodesicSolution of shape {self.shape}: {span}{listed}>"

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of the batch; () for a single problem."""
        return self.start.shape[:-1]

    @property
    def converged(self) -> Bools:
        """Whether the length can be trusted."""
        return self._shaped(have_length(np.asarray(self.status, dtype=object)))

    @property
    def local_minimum(self) -> Bools:
        """Whether the path is proven to be shorter than all paths close to it: its index is 0.

        Of paths elsewhere on the patch, `proven_shortest` speaks.
        """
        return self._shaped(np.asarray(np.asarray(self.index) == 0))

    @cached_property
    def proven_shortest(self) -> Bools:
        """Whether the geodesic is proven to be the only shortest path on its patch.

        False means that it is not proven, not that a shorter path exists. The proof bounds the
        patch's Gaussian curvature everywhere (see the page "proofs" of the documentation); it is
        made when this is first asked for, in some 0.05 milliseconds a path. It is about the
        geodesic that the computed path stands for, and about paths on this patch: over neighboring
        patches, a shorter one may lead. On rational patches and surfaces of your own nothing is
        proven.
        """
        if self.patches is None:
            return self._shaped(np.zeros(int(np.prod(self.shape)), bool))
        return self._shaped(self.patches.prove_shortest(self._curvature, self._upper))

    @cached_property
    def bounds(self) -> Bounds:
        """Bounds of the length of the shortest path on the patch, lower and upper.

        They hold by theorem, whatever the computed path is like, but for one thing: its geodesic
        curvature is sampled, at more points than it was found from, and 20 % are added for what
        lies between (see the page "proofs" of the documentation; `enclose` samples nothing). Where
        the computed path gives wide bounds, finer paths are found for them, when this is first
        asked for. Where the theorem says nothing, as of paths along an edge, the distance in space
        is the lower bound; where every computed path is found to leave the patch, if only by
        rounding, the upper bound is infinite. NaN where there is no length, and on surfaces that
        are no polynomial patches.
        """
        count = int(np.prod(self.shape))
        lower, upper = np.full((2, count), np.nan)
        if self.patches is not None:
            with one_blas_thread():
                status = np.asarray(self.status, dtype=object).ravel()
                lower, upper = closer_bounds(
                    self.patches,
                    self.batches,
                    (self.start.reshape(-1, 2), self.end.reshape(-1, 2)),
                    self._curvature,
                    np.array([each is Status.CONVERGED for each in status], bool),
                )
            # Between points in one place there is no path that was solved for.
            still = np.isnan(upper)
            lower, upper = np.where(still, 0.0, lower), np.where(still, self._upper, upper)
        none = np.isnan(self._upper)
        return Bounds(*(self._shaped(np.where(none, np.nan, each)) for each in (lower, upper)))

    @cached_property
    def _upper(self) -> Array:
        """Upper bounds of the geodesics' lengths; NaN where there is none. Shape (problems,)."""
        known = have_length(np.asarray(self.status, dtype=object)).ravel()
        upper = np.maximum(np.add(self.length, self.error_estimate), self.raw_length).ravel()
        return np.where(known, upper, np.nan)

    @cached_property
    def _curvature(self) -> CurvatureBounds:
        with one_blas_thread():
            return cast("PatchesOfPaths", self.patches).curvature(self._upper)

    @property
    def contacts(self) -> NDArray[np.object_]:
        """The edges of its patch that each path runs along: a tuple of `EdgeContact`, mostly empty.

        For a batch, this is an array of such tuples.
        """
        result = np.empty(int(np.prod(self.shape)), dtype=object)
        result[:] = [()] * len(result)
        for batch in self.batches:
            for problem in batch.problems:
                result[problem] = batch.contacts
        return self._shaped(result)

    @property
    def condition(self) -> Array:
        """The condition number of the collocation system of each path's trial space."""
        result = np.ones(int(np.prod(self.shape)))
        for batch in self.batches:
            result[batch.problems] = batch.space.condition
        return self._shaped(result)

    def _shaped(self, values: NDArray[_T]) -> NDArray[_T]:
        """Values in the shape of the batch; for a single problem, its plain value."""
        result = values.reshape(self.shape) if self.shape else values.reshape(-1).tolist()[0]
        return cast("NDArray[_T]", result)

    def path(self, t: ArrayLike) -> Array:
        """Return points of the paths.

        Parameters
        ----------
        t : array_like, shape () or (k,)
            Parameters in [0, 1] from start to end, which are parts of the length as far as the path
            is a geodesic.

        Returns
        -------
        ndarray, shape (*batch, *t.shape, 2)
            (u, v). With the status ``LEAVES_PATCH`` they go outside [0, 1]. All parameters along a
            collapsed edge are one place, so that an end on it may have others than were given.

        Raises
        ------
        InputError
            If a t is not a number in [0, 1].
        """
        times = checked_times(t)
        points = np.empty((int(np.prod(self.shape)), times.size, 2))
        # Problems without a path have their ends in one place, and a line that stays there.
        first, last = (ends.reshape(-1, 1, 2) for ends in (self.start, self.end))
        points[:] = first + (last - first) * times.reshape(1, -1, 1)
        points[:, times.ravel() == 1.0] = last
        for batch in self.batches:
            points[batch.problems] = batch.points(times.ravel())
        return points.reshape(*self.shape, *times.shape, 2)

    def __getitem__(self, key: "_Index | tuple[_Index, ...]") -> "GeodesicSolution":
        """Return some of the problems, by indexing the batch as an array."""
        count = int(np.prod(self.shape))
        numbers = np.arange(count).reshape(self.shape)[key]
        place = np.full(count, -1)
        # Indices may repeat a problem; then the batches of paths repeat its rows, too.
        chosen = np.atleast_1d(np.asarray(numbers)).ravel()
        batches = []
        for batch in self.batches:
            place[:] = -1
            place[batch.problems] = np.arange(len(batch.problems))
            rows = place[chosen]
            inside = np.flatnonzero(rows >= 0)
            if len(inside):
                batches.append(batch.take(rows[inside]).renumbered(inside).alone())
        start, end = (ends.reshape(-1, 2)[numbers] for ends in (self.start, self.end))
        patches = None if self.patches is None else self.patches.take(chosen)
        part = replace(self, start=start, end=end, batches=tuple(batches), patches=patches)
        values: dict[str, Any] = {
            item.name: part._shaped(np.asarray(getattr(self, item.name)).reshape(-1)[chosen])
            for item in fields(self)[2:-2]
        }
        return replace(part, **values)
