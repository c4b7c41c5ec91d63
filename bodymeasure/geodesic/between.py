"""The geodesic between any two points of an atlas."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Literal

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.geodesic.across.pieces.path import AtlasPath
from bodymeasure.geodesic.across.search.ends import checked_places, topology
from bodymeasure.geodesic.across.search.leg import join_legs, shortest_leg


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
    neighbors = topology(atlas).neighbors
    points = (start, *via, end)
    names = ("the start", *(f"via point {i}" for i in range(len(via))), "the end")
    places = checked_places(atlas, points, names)
    legs = [shortest_leg(atlas, neighbors, *ends) for ends in pairwise(places)]
    path = join_legs(atlas, points, legs)
    if on_failure == "raise" and not path.converged:
        raise ConvergenceError(path.status.sentence)
    return path


def geodesics_between(
    atlas: Atlas,
    starts: Sequence[AtlasPoint],
    ends: Sequence[AtlasPoint],
    *,
    on_failure: Literal["raise", "status"] = "status",
) -> tuple[AtlasPath, ...]:
    """The geodesics between many pairs of points of an atlas.

    One after the other: each takes its own route, so that nothing is gained by more at once. What
    is made of the atlas for the first one, its meshes and what its seams join, serves for all.

    Parameters
    ----------
    atlas : Atlas
    starts, ends : sequence of AtlasPoint
        As many of the one as of the other.
    on_failure : {"raise", "status"}
        As for `geodesic_between`; by default the others are measured all the same.

    Returns
    -------
    tuple of AtlasPath

    Raises
    ------
    InputError
        As for `geodesic_between`, before anything is measured; the message names the pair.
    ConvergenceError, MissingExtraError
        As for `geodesic_between`.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> shoulders, elbows = (
    ...     [body.landmarks[f"{name} point {side}"] for side in ("left", "right")]
    ...     for name in ("shoulder", "elbow")
    ... )
    >>> [f"{path.length:.4f}" for path in geodesics_between(body, shoulders, elbows)]
    ['0.2572', '0.2572']
    """
    if len(starts) != len(ends):
        raise InputError(f"there are {len(starts)} starts and {len(ends)} ends; expected as many")
    for number, pair in enumerate(zip(starts, ends, strict=True)):
        checked_places(atlas, pair, [f"the {end} of pair {number}" for end in ("start", "end")])
    return tuple(
        geodesic_between(atlas, start, end, on_failure=on_failure)
        for start, end in zip(starts, ends, strict=True)
    )
