"""The geodesic between any two points of an atlas."""

from collections.abc import Sequence
from itertools import pairwise

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.queries.locations import Location, listed
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.geodesic.across.pieces.path import AtlasPath
from bodymeasure.geodesic.across.poles.leg import leg_between
from bodymeasure.geodesic.across.routes.topology import topology
from bodymeasure.geodesic.across.search.ends import Ends, checked_points
from bodymeasure.geodesic.status import OnFailure, check_on_failure
from bodymeasure.threads import one_blas_thread


@one_blas_thread()
def geodesic_between(
    atlas: Atlas,
    start: Location,
    end: Location,
    via: Sequence[Location] = (),
    *,
    on_failure: OnFailure = "raise",
) -> AtlasPath:
    """Return the geodesic between two points of an atlas, across as many seams as it takes.

    Parameters
    ----------
    atlas : Atlas
    start, end : str, AtlasPoint or position of shape (3,)
        A landmark's name, a point of the atlas, or a position in the atlas's unit, for which the
        closest point of the surface is taken.
    via : sequence of the same
        The points that the path leads through, in order; each leg between two points is a geodesic.
    on_failure : {"raise", "status"}
        What to do if there is no length that can be trusted: raise, or say so in the status, with
        NaN for a length. By default it raises, so that no caller mistakes a NaN for a length.

    Returns
    -------
    AtlasPath

    Raises
    ------
    InputError
        If a location is not on the atlas, or two are on parts that no seam joins.
    ConvergenceError
        If there is no length that can be trusted and `on_failure` is "raise".

    Notes
    -----
    Rough ways through a graph of the surface, pulled straight on a triangle mesh, determine which
    patches may be crossed; the shortest smooth path along each of these routes is found by Newton's
    method, its crossings among the unknowns. Where it presses against a corner or an edge, the
    routes on the other side are tried, and the shortest of all is kept. That no other route is
    shorter still is not proven.

    A path that passes close by a collapsed side, a pole, is cut at lines about it, with more cuts
    the closer it passes; one that passes right beside it, or begins there, is calculated from the
    geodesics to the pole and from it, and drawn through the pole.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> path = bm.geodesic_between(body, "back neck point", "bust point left")
    >>> print(f"{path.length:.4f} {body.unit}")
    0.3300 m
    """
    check_on_failure(on_failure)
    via = listed(via, "via")
    names = ("the start", *(f"via point {number}" for number in range(len(via))), "the end")
    return _through(atlas, checked_points(atlas, (start, *via, end), names), on_failure)


@one_blas_thread()
def geodesics_between(
    atlas: Atlas,
    starts: Sequence[Location],
    ends: Sequence[Location],
    *,
    on_failure: OnFailure = "raise",
) -> tuple[AtlasPath, ...]:
    """Return the geodesics between many pairs of points of an atlas.

    They are found one after the other: each takes its own route, so that nothing is gained by more
    at once. The meshes of the atlas and its topology are made for the first one and serve for all.

    Parameters
    ----------
    atlas : Atlas
    starts, ends : sequence of str, AtlasPoint or position of shape (3,)
        Equal numbers of starts and ends; each is as for `geodesic_between`.
    on_failure : {"raise", "status"}
        As for `geodesic_between`. With "status", a pair without a length that can be trusted does
        not keep the others from being measured.

    Returns
    -------
    tuple of AtlasPath

    Raises
    ------
    InputError
        As for `geodesic_between`, before anything is measured; the message names the pair.
    ConvergenceError
        As for `geodesic_between`.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> shoulders = ["shoulder point left", "shoulder point right"]
    >>> elbows = ["elbow point left", "elbow point right"]
    >>> [f"{path.length:.4f}" for path in bm.geodesics_between(body, shoulders, elbows)]
    ['0.2572', '0.2572']
    """
    starts, ends = listed(starts, "starts"), listed(ends, "ends")
    if len(starts) != len(ends):
        raise InputError(f"there are {len(starts)} starts and {len(ends)} ends; expected as many")
    pairs = [
        checked_points(atlas, pair, [f"the {end} of pair {number}" for end in ("start", "end")])
        for number, pair in enumerate(zip(starts, ends, strict=True))
    ]
    return tuple(_through(atlas, pair, on_failure) for pair in pairs)


def _through(atlas: Atlas, ends: Ends, on_failure: OnFailure) -> AtlasPath:
    """Return the path through points, each leg of it a geodesic."""
    neighbors = topology(atlas).neighbors
    legs = [
        leg_between(atlas, neighbors, *points).with_ends_moved(*moves)
        for points, moves in zip(pairwise(ends.points), pairwise(ends.moves), strict=True)
    ]
    path = AtlasPath.concatenate(legs)
    if on_failure == "raise" and not path.converged:
        raise ConvergenceError(path.status.sentence)
    return path
