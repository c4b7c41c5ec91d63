"""The geodesic between any two points of an atlas."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.components import connected_components
from bodymeasure.atlas.neighbors import Neighbors, Place
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.bezier import evaluate
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.geodesic.atlas_path import AtlasPath, PathPiece, SeamCrossing
from bodymeasure.geodesic.polynomial_space import polynomial_space
from bodymeasure.geodesic.route import Route
from bodymeasure.geodesic.route_reading import first_route
from bodymeasure.geodesic.route_search import Found, shortest_along
from bodymeasure.geodesic.status import Status


def geodesic_between(
    atlas: Atlas,
    start: AtlasPoint,
    end: AtlasPoint,
    via: Sequence[AtlasPoint] = (),
    *,
    on_failure: Literal["raise", "status"] = "raise",
) -> AtlasPath:
    """The geodesic between two points of an atlas, across as many seams as it takes.

    Parameters
    ----------
    atlas : Atlas
    start, end : AtlasPoint
    via : sequence of AtlasPoint
        Points that the path leads through, in order; each leg between two is a geodesic.
    on_failure : {"raise", "status"}
        What to do if there is no length that can be trusted: raise, or say so in the status, with
        NaN for a length.

    Returns
    -------
    AtlasPath

    Raises
    ------
    InputError
        If a point is not on the atlas, or two are on parts that no seam joins.
    ConvergenceError
        If there is no length that can be trusted and `on_failure` is "raise".
    MissingExtraError
        If pygeodesic is not installed.

    Notes
    -----
    The exact shortest path over a triangle mesh of the atlas tells which patches are crossed; the
    shortest smooth path along that route is found by Newton's method, its crossings among the
    unknowns. Where it presses against a corner or an edge, the routes on the other side are tried,
    and what is shorter is kept. That no other route is shorter still is not proven.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> nape, bust = (body.landmarks[name] for name in ("back neck point", "bust point left"))
    >>> path = geodesic_between(body, nape, bust)
    >>> print(f"{path.length:.4f} {body.unit}")
    0.3300 m
    """
    if on_failure not in ("raise", "status"):
        raise InputError(f"on_failure is {on_failure!r}; expected 'raise' or 'status'")
    topology = _topology(atlas)
    points = (start, *via, end)
    names = ("the start", *(f"via point {i}" for i in range(len(points) - 2)), "the end")
    places = [_checked(atlas, name, point) for name, point in zip(names, points, strict=True)]
    _check_parts(atlas, topology.part, list(zip(names, places, strict=True)))
    legs = [_leg(atlas, topology.neighbors, *ends) for ends in pairwise(places)]
    path = _joined(atlas, points, legs)
    if on_failure == "raise" and not path.converged:
        raise ConvergenceError(path.status.sentence)
    return path


# Points a piece that tell a path's length roughly, for scaling.
SAMPLES = 5
# What stands for a path that stays where it is.
STANDSTILL = polynomial_space(1)


class _Topology(NamedTuple):
    neighbors: Neighbors
    part: NDArray[np.int64]


@lru_cache(maxsize=4)
def _topology(atlas: Atlas) -> _Topology:
    neighbors = Neighbors(atlas)
    links = [
        (patch, crossing.to_patch)
        for (patch, _), crossings in neighbors.over.items()
        for crossing in crossings
    ]
    first, second = np.array(links, dtype=np.int64).reshape(-1, 2).T
    return _Topology(neighbors, connected_components(first, second, len(atlas)))


def _checked(atlas: Atlas, name: str, point: AtlasPoint) -> Place:
    if not isinstance(point, AtlasPoint):
        raise InputError(f"{name} is {point!r}; expected an AtlasPoint, such as a landmark")
    if not 0 <= point.patch < len(atlas):
        raise InputError(
            f"{name} is on patch {point.patch}, but the patches are numbered 0 to {len(atlas) - 1}"
        )
    # `not inside` rather than `outside`, so that NaN is refused too.
    if not (0.0 <= point.u <= 1.0 and 0.0 <= point.v <= 1.0):
        raise InputError(f"{name} has (u, v) = ({point.u}, {point.v}); expected both in [0, 1]")
    return Place(int(point.patch), float(point.u), float(point.v))


def _check_parts(atlas: Atlas, part: NDArray[np.int64], named: list[tuple[str, Place]]) -> None:
    for (name, place), (other, there) in pairwise(named):
        if part[place.patch] != part[there.patch]:
            raise InputError(
                f"{name} is on {atlas.patch_names[place.patch]!r} and {other} on "
                f"{atlas.patch_names[there.patch]!r}, which no seams join: the atlas has "
                f"{len(np.unique(part))} separate parts; choose points on one of them, or join "
                "the parts' control points (`bodymeasure check` tells where they nearly meet)"
            )


class _Leg(NamedTuple):
    status: Status
    found: Found | None
    at: Place


def _leg(atlas: Atlas, neighbors: Neighbors, start: Place, end: Place) -> _Leg:
    if end in neighbors.same(start):
        return _Leg(Status.CONVERGED, None, start)
    route = first_route(atlas, neighbors, (start, end))
    if route is None:
        return _Leg(Status.NO_ROUTE, None, start)
    size = _rough_length(atlas, route)
    if size == 0.0:
        return _Leg(Status.CONVERGED, None, start)
    found = shortest_along(atlas, neighbors, route, size)
    if not found.good:
        return _Leg(Status.NOT_CONVERGED, found, start)
    if found.contact:
        return _Leg(Status.ON_BOUNDARY, found, start)
    return _Leg(Status.CONVERGED if found.length.minimal else Status.NOT_A_MINIMUM, found, start)


def _rough_length(atlas: Atlas, route: Route) -> float:
    """The length of the path that is straight in (u, v) on each patch."""
    t = np.linspace(0.0, 1.0, SAMPLES)[:, None]
    lines = [
        (1.0 - t) * np.array(route.entry(piece)[1:]) + t * np.array(route.exit(piece)[1:])
        for piece in range(len(route.patches))
    ]
    points = evaluate(atlas.control_points[list(route.patches)], np.array(lines))
    return float(np.linalg.norm(np.diff(points, axis=1), axis=2).sum())


def _joined(atlas: Atlas, points: tuple[AtlasPoint, ...], legs: list[_Leg]) -> AtlasPath:
    """One path of all legs."""
    failed = [leg.status for leg in legs if not leg.status.has_length]
    other = [leg.status for leg in legs if leg.status is not Status.CONVERGED]
    status = (failed or other or [Status.CONVERGED])[0]
    lengths = [leg.found.length for leg in legs if leg.found is not None]
    corrected = sum(length.corrected for length in lengths)
    no_path = Status.NO_ROUTE in failed
    pieces = () if no_path else tuple(piece for leg in legs for piece in _pieces(leg))
    return AtlasPath(
        atlas=atlas,
        points=points,
        length=float(corrected) if status.has_length else np.nan,
        raw_length=np.nan if no_path else float(sum(length.raw for length in lengths)),
        error_estimate=np.inf if no_path else float(sum(length.error for length in lengths)),
        residual=max((length.residual for length in lengths), default=0.0),
        status=status,
        pieces=pieces,
        crossings=() if no_path else _crossings(legs, pieces),
    )


def _pieces(leg: _Leg) -> list[PathPiece]:
    if leg.found is None:
        stays = np.repeat(np.array(leg.at[1:])[:, None], 2, axis=1)
        return [PathPiece(leg.at.patch, STANDSTILL, stays, 0.0)]
    refined = leg.found.refined
    lengths = (refined.lengths * refined.problem.size).tolist()
    parts = zip(refined.route.patches, refined.values, lengths, strict=True)
    return [PathPiece(patch, refined.problem.space, *rest) for patch, *rest in parts]


def _crossings(legs: list[_Leg], pieces: tuple[PathPiece, ...]) -> tuple[SeamCrossing, ...]:
    ends = np.cumsum([piece.length for piece in pieces])
    result, passed = [], 0
    for leg in legs:
        if leg.found is None:
            passed += 1
            continue
        route = leg.found.refined.route
        for number in range(len(route.crossings)):
            before, after = route.exit(number), route.entry(number + 1)
            t = float(ends[passed + number] / ends[-1])
            result.append(SeamCrossing(AtlasPoint(*before), AtlasPoint(*after), t))
        passed += len(route.patches)
    return tuple(result)
