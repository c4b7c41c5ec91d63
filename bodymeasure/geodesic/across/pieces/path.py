"""A geodesic over an atlas: what is known of it, and where it runs."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.bezier import evaluate
from bodymeasure.errors import InputError
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.status import Status


@dataclass(frozen=True, eq=False)
class PathPiece:
    """The part of a path that runs over one patch.

    Parameters
    ----------
    patch : int
    space : TrialSpace
    values : ndarray, shape (2, n + 1)
        u and v at the space's nodes.
    length : float
        In the atlas's unit.
    """

    patch: int
    space: TrialSpace
    values: Array
    length: float


@dataclass(frozen=True)
class SeamCrossing:
    """Where a path crosses a seam.

    Parameters
    ----------
    before, after : AtlasPoint
        The one point, on the patch that is left and on the patch that is entered.
    t : float
        The path's parameter there.
    """

    before: AtlasPoint
    after: AtlasPoint
    t: float


@dataclass(frozen=True, eq=False)
class AtlasPath:
    """The geodesic between two points of an atlas, or through several.

    Parameters
    ----------
    atlas : Atlas
    points : tuple of AtlasPoint
        The start, the points that it leads through, and the end, as they were given.
    length : float
        In the atlas's unit: of the computed path, less its excess. NaN unless the status has a
        length.
    raw_length : float
        Length of the computed path itself, whatever the status.
    error_estimate : float
        Estimated error of `length`, in the same unit, as a length of the shortest path along this
        route (see `bodymeasure.geodesic.across.pieces.route_error`); infinite where nothing is
        known.
    residual : float
        0 for an exact geodesic: see `bodymeasure.geodesic.across.pieces.route_error.RouteLength`.
    status : Status
        Of several legs, the first that is not ``CONVERGED``, those without a length before others.
    pieces : tuple of PathPiece
        In order.
    crossings : tuple of SeamCrossing
        In order; several at one place where the path runs through a corner.
    """

    atlas: Atlas = field(repr=False)
    points: tuple[AtlasPoint, ...]
    length: float
    raw_length: float
    error_estimate: float
    residual: float
    status: Status
    pieces: tuple[PathPiece, ...] = field(repr=False)
    crossings: tuple[SeamCrossing, ...] = field(repr=False)

    @property
    def converged(self) -> bool:
        """Whether the length can be trusted."""
        return self.status.has_length

    @property
    def patches(self) -> tuple[int, ...]:
        """The patch of each piece."""
        return tuple(piece.patch for piece in self.pieces)

    def path(self, t: ArrayLike) -> tuple[NDArray[np.int64], Array]:
        """Points of the path.

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
        times = _checked_times(t)
        if not self.pieces:
            raise InputError(f"there is no path: {self.status.sentence}")
        lengths = np.array([piece.length for piece in self.pieces])
        bounds = np.concatenate([[0.0], np.cumsum(lengths)])
        way = times.ravel() * bounds[-1]
        number = np.clip(np.searchsorted(bounds, way, side="right") - 1, 0, len(lengths) - 1)
        # The end itself, even if the last pieces have no length.
        number[times.ravel() == 1.0] = len(lengths) - 1
        parameters = np.empty((len(way), 2))
        for piece in np.unique(number):
            here, length = number == piece, lengths[piece]
            local = (way[here] - bounds[piece]) / length if length > 0.0 else 0.0 * way[here]
            local[times.ravel()[here] == 1.0] = 1.0
            matrix = self.pieces[piece].space.functions.values(np.clip(local, 0.0, 1.0))
            parameters[here] = matrix @ self.pieces[piece].values.T
        patch = np.array(self.patches, dtype=np.int64)[number]
        # Between the nodes, a polynomial along an edge may be outside by its own error.
        parameters = np.clip(parameters, 0.0, 1.0)
        return patch.reshape(times.shape), parameters.reshape(*times.shape, 2)

    def position(self, t: ArrayLike) -> Array:
        """Positions of the path in the atlas's unit, shape (*t.shape, 3); t as for `path`."""
        patch, parameters = self.path(t)
        return evaluate(self.atlas.control_points[patch], parameters)


def _checked_times(t: ArrayLike) -> Array:
    try:
        times = np.asarray(t, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"path parameters are {t!r}; expected numbers in [0, 1]") from None
    if not ((times >= 0.0) & (times <= 1.0)).all():
        raise InputError(f"path parameters must lie in [0, 1]; got {times}")
    return times
