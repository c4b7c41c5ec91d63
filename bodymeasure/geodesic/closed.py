"""Closed geodesics: what a loop round a body contracts to."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.bezier import evaluate
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.geodesic.across.pieces.closed_error import LoopKind
from bodymeasure.geodesic.across.pieces.path import AtlasPath, PathPiece, SeamCrossing
from bodymeasure.geodesic.across.routes.through import route_through
from bodymeasure.geodesic.across.search.closed_search import FoundLoop, contracted
from bodymeasure.geodesic.across.search.ends import checked_places, topology
from bodymeasure.geodesic.status import Status

FEWEST = 3


@dataclass(frozen=True, eq=False)
class ClosedPath(AtlasPath):
    """A closed geodesic: an `AtlasPath` that returns to its start, where it has no kink.

    Its `points` are those of the loop that it was contracted from, and `path` starts where it
    crosses a seam.

    Parameters
    ----------
    kind : LoopKind
        What loops lie close to it.
    """

    # Of a loop, many.
    points: tuple[AtlasPoint, ...] = field(repr=False)
    kind: LoopKind

    @property
    def local_minimum(self) -> bool:
        """Whether it is proven that all loops close to it are longer."""
        return self.kind is LoopKind.MINIMUM and self.status is Status.CONVERGED


def contract(
    atlas: Atlas,
    loop: Sequence[AtlasPoint],
    *,
    on_failure: Literal["raise", "status"] = "raise",
) -> ClosedPath:
    """The closed geodesic that a loop contracts to, as a rubber band slides to a waist.

    Parameters
    ----------
    atlas : Atlas
    loop : sequence of AtlasPoint
        Along the loop, one on each seam that it crosses among them; the last one is joined to the
        first.
    on_failure : {"raise", "status"}
        What to do if there is no length that can be trusted: raise, or say so in the status, with
        NaN for a length.

    Returns
    -------
    ClosedPath
        One that slides to an open boundary of the atlas stays there, with that status.

    Raises
    ------
    InputError
        If a point is not on the atlas, two in a row are on patches that meet at neither, or the
        loop contracts to a point.
    ConvergenceError
        If there is no length that can be trusted and `on_failure` is "raise".

    Notes
    -----
    The shortest loop along its route is found by Newton's method, and where that presses against a
    corner or an edge, the routes on the other side are tried, as in `geodesic_between`. The length
    falls all the time, so that it ends at the first closed geodesic on the way down.
    """
    if on_failure not in ("raise", "status"):
        raise InputError(f"on_failure is {on_failure!r}; expected 'raise' or 'status'")
    points = tuple(loop)
    if len(points) < FEWEST:
        raise InputError(f"the loop has {len(points)} points; expected at least {FEWEST}")
    names = [f"point {number} of the loop" for number in range(len(points))]
    places = checked_places(atlas, points, names)
    neighbors = topology(atlas).neighbors
    route = route_through(neighbors, places)
    found = None
    if route.crossings:
        positions = evaluate(
            atlas.control_points[[place.patch for place in places]],
            np.array([place[1:] for place in places]),
        )
        size = float(np.linalg.norm(positions - np.roll(positions, 1, axis=0), axis=1).sum())
        found = contracted(atlas, neighbors, route, size)
    if found is None:
        raise InputError(
            "the loop contracts to a point: it goes round no part of the body; choose one round "
            "the trunk or a limb"
        )
    path = _path(atlas, points, found)
    if on_failure == "raise" and not path.converged:
        sentence = path.kind.value if path.status is Status.NOT_A_MINIMUM else path.status.sentence
        raise ConvergenceError(sentence)
    return path


def _path(atlas: Atlas, points: tuple[AtlasPoint, ...], found: FoundLoop) -> ClosedPath:
    refined, length = found.refined, found.length
    status = Status.CONVERGED
    if not found.good:
        status = Status.NOT_CONVERGED
    elif found.contact:
        status = Status.ON_BOUNDARY
    elif length.kind is LoopKind.SADDLE:
        status = Status.NOT_A_MINIMUM
    route, lengths = refined.route, refined.lengths * refined.problem.size
    starts = (np.cumsum(lengths) - lengths) / lengths.sum()
    return ClosedPath(
        atlas=atlas,
        points=points,
        length=length.corrected if status.has_length else np.nan,
        raw_length=length.raw,
        error_estimate=length.error,
        residual=length.residual,
        status=status,
        pieces=tuple(
            PathPiece(patch, refined.problem.space, values, float(piece))
            for patch, values, piece in zip(route.patches, refined.values, lengths, strict=True)
        ),
        crossings=tuple(
            SeamCrossing(route.exit(number - 1), route.entry(number), float(t))
            for number, t in enumerate(starts)
        ),
        kind=length.kind,
    )
