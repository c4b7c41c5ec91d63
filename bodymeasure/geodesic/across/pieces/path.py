"""A geodesic over an atlas: its course, its length and what is known of that."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.bezier import evaluate
from bodymeasure.errors import InputError
from bodymeasure.geodesic.across.pieces.part import PathPart, PathPiece
from bodymeasure.geodesic.across.routes.topology import extent
from bodymeasure.geodesic.lengths.arc_length_times import checked_times
from bodymeasure.geodesic.status import Status, checked_status
from bodymeasure.wording import result_line


@dataclass(frozen=True)
class SeamCrossing:
    """Where a path crosses a seam.

    Parameters
    ----------
    before, after : AtlasPoint
        The point on the patch that is left, and the same point on the patch that is entered.
    t : float
        The path's parameter there.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> path = bm.geodesic_between(body, "back neck point", "bust point left")
    >>> crossing = path.crossings[0]
    >>> crossing.before.patch == path.patches[0], crossing.after.patch == path.patches[1]
    (True, True)
    >>> bool(abs(path.position(crossing.t) - body.position(crossing.after)).max() < 1e-12)
    True
    """

    before: AtlasPoint
    after: AtlasPoint
    t: float


@dataclass(frozen=True, eq=False, repr=False)
class AtlasPath:
    """The geodesic between two points of an atlas, or through several.

    Parameters
    ----------
    atlas : Atlas
    points : tuple of AtlasPoint
        The start, the points that it leads through, and the end.
    length : float
        The length of the geodesic in the atlas's unit: that of the computed path, less its excess.
        NaN unless the status has a length.
    raw_length : float
        Length of the computed path itself, whatever the status.
    error_estimate : float
        Estimated error of `length`, in the same unit, as a length of the shortest path along this
        route (see `bodymeasure.geodesic.across.pieces.error`); infinite where nothing is known.
    residual : float
        The largest geodesic curvature times the piece's length, and the largest difference of the
        unit tangents' components along a seam where it is crossed: 0 for an exact geodesic.
    status : Status
        The status; that of several legs is the first that is not ``CONVERGED``, where those without
        a length come before others.
    pieces : tuple of PathPiece
        In order.
    crossings : tuple of SeamCrossing
        In order; several at one place where the path runs through a corner.
    leg_ends : tuple of float
        The path's parameter at each of its points, from 0 to 1; none if there is no path.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> path = bm.geodesic_between(body, "back neck point", "bust point left")
    >>> path  # doctest: +ELLIPSIS
    <AtlasPath of length 0.330... m, error ...e-1... m, CONVERGED>
    >>> patch, (u, v) = path.path(0.5)
    >>> path.position([0.0, 0.5, 1.0]).shape
    (3, 3)
    """

    atlas: Atlas
    points: tuple[AtlasPoint, ...]
    length: float
    raw_length: float
    error_estimate: float
    residual: float
    status: Status
    pieces: tuple[PathPiece, ...]
    crossings: tuple[SeamCrossing, ...]
    leg_ends: tuple[float, ...]

    @staticmethod
    def of(
        atlas: Atlas, points: tuple[AtlasPoint, ...], part: PathPart, status: Status
    ) -> "AtlasPath":
        """Return a path of one leg."""
        length = part.length
        corrected, error = float(length.corrected), float(length.error)
        status = checked_status(status, corrected, error, extent(atlas))
        bounds = np.cumsum([0.0, *(piece.length for piece in part.pieces)])
        return AtlasPath(
            atlas=atlas,
            points=points,
            length=float(length.corrected) if status.has_length else np.nan,
            raw_length=float(length.raw),
            error_estimate=float(length.error),
            residual=float(length.residual),
            status=status,
            pieces=part.pieces,
            crossings=tuple(
                SeamCrossing(before, after, float(bounds[number + 1] / bounds[-1]))
                for number, before, after in part.crossings
            ),
            leg_ends=(0.0, 1.0) if part.pieces else (),
        )

    @staticmethod
    def concatenate(paths: "Sequence[AtlasPath]") -> "AtlasPath":
        """Return one path of several, each of which begins where the one before it ends.

        Parameters
        ----------
        paths : sequence of AtlasPath
            At least one.
        """
        if len(paths) == 1:
            return paths[0]
        found = all(path.pieces for path in paths)
        sizes = [sum(piece.length for piece in path.pieces) for path in paths]
        whole = sum(sizes) or 1.0
        crossings: list[SeamCrossing] = []
        leg_ends = [0.0]
        before = 0.0
        for path, size in zip(paths, sizes, strict=True) if found else ():
            crossings += (
                replace(crossing, t=(before + crossing.t * size) / whole)
                for crossing in path.crossings
            )
            leg_ends += ((before + t * size) / whole for t in path.leg_ends[1:])
            before += size
        statuses = [path.status for path in paths]
        failed = [status for status in statuses if not status.has_length]
        other = [status for status in statuses if status is not Status.CONVERGED]
        return AtlasPath(
            atlas=paths[0].atlas,
            points=(*paths[0].points, *(point for path in paths[1:] for point in path.points[1:])),
            length=sum(path.length for path in paths),
            raw_length=sum(path.raw_length for path in paths),
            error_estimate=sum(path.error_estimate for path in paths),
            residual=max(path.residual for path in paths),
            status=(failed or other or [Status.CONVERGED])[0],
            pieces=tuple(piece for path in paths for piece in path.pieces) if found else (),
            crossings=tuple(crossings),
            leg_ends=(*leg_ends[:-1], 1.0) if found else (),
        )

    def with_ends_moved(self, *moves: float) -> Self:
        """Return the path as that between ends from which its own were moved so far."""
        return replace(self, error_estimate=self.error_estimate + sum(moves))

    def __repr__(self) -> str:
        kind, unit, status = type(self).__name__, self.atlas.unit, self.status.name
        return result_line(kind, unit, self.error_estimate, outcome=status, length=self.length)

    @property
    def approximation_error(self) -> float:
        """A bound on the difference from the length on the surface that the patches approximate.

        It is 0 on an atlas that approximates nothing; see `bodymeasure.approximation_error`.
        """
        approximation = self.atlas.approximation
        if approximation is None:
            return 0.0
        return float(sum(approximation.stretch[each.patch] * each.length for each in self.pieces))

    @property
    def converged(self) -> bool:
        """Whether the length can be trusted."""
        return self.status.has_length

    @property
    def patches(self) -> tuple[int, ...]:
        """The patch of each piece."""
        return tuple(piece.patch for piece in self.pieces)

    def path(self, t: ArrayLike) -> tuple[Ints, Array]:
        """Return points of the path.

        Parameters
        ----------
        t : array_like, shape () or (k,)
            In [0, 1], from start to end: parts of the length.

        Returns
        -------
        patch : ndarray of int, shape (*t.shape)
        parameters : ndarray, shape (*t.shape, 2)
            (u, v) on that patch, in [0, 1].

        Raises
        ------
        InputError
            If a t is not a number in [0, 1], or no path was found.
        """
        times = checked_times(t)
        if not self.pieces:
            raise InputError(f"there is no path: {self.status.sentence}")
        lengths = np.array([piece.length for piece in self.pieces])
        bounds = np.concatenate([[0.0], np.cumsum(lengths)])
        way = times.ravel() * bounds[-1]
        number = np.clip(np.searchsorted(bounds, way, side="right") - 1, 0, len(lengths) - 1)
        # The end itself, even if the last pieces have no length.
        number[times.ravel() == 1.0] = len(lengths) - 1
        length = lengths[number]
        local = np.divide(way - bounds[number], length, out=0.0 * way, where=length > 0.0)
        local = np.clip(np.where(times.ravel() == 1.0, 1.0, local), 0.0, 1.0)
        parameters = np.empty((len(way), 2))
        # Pieces mostly share a few spaces.
        spaces = {id(self.pieces[piece].space): piece for piece in np.unique(number).tolist()}
        space = np.array([id(piece.space) for piece in self.pieces])[number]
        for each, piece in spaces.items():
            row = np.flatnonzero(space == each)
            matrix = self.pieces[piece].space.functions.values(local[row])
            values = np.stack([self.pieces[i].values for i in number[row].tolist()])
            places = np.einsum("kf,kcf->kc", matrix, values)
            # The ends are exactly where they are, without rounding.
            first, last = local[row] == 0.0, local[row] == 1.0
            places[first], places[last] = values[first, :, 0], values[last, :, -1]
            parameters[row] = places
        patch = np.array(self.patches, dtype=np.int64)[number]
        # Between the nodes, a polynomial along an edge may be outside by its own error.
        parameters = np.clip(parameters, 0.0, 1.0)
        return patch.reshape(times.shape), parameters.reshape(*times.shape, 2)

    def position(self, t: ArrayLike) -> Array:
        """Return positions of the path in the atlas's unit, shape (*t.shape, 3); t as in `path`."""
        patch, parameters = self.path(t)
        return evaluate(self.atlas.control_points[patch], parameters)
