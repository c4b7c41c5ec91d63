"""Closed geodesics, to which loops round a body contract."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.queries.locations import Location, listed
from bodymeasure.bezier import evaluate
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.geodesic.across.pieces.error import LoopKind
from bodymeasure.geodesic.across.pieces.path import AtlasPath
from bodymeasure.geodesic.across.routes.through import route_through
from bodymeasure.geodesic.across.routes.topology import topology
from bodymeasure.geodesic.across.search.ends import checked_points
from bodymeasure.geodesic.across.search.search import shortest_along
from bodymeasure.geodesic.status import OnFailure, Status, check_on_failure
from bodymeasure.threads import one_blas_thread
from bodymeasure.wording import counted

# The points that a loop has at least.
FEWEST = 3


@dataclass(frozen=True, eq=False, repr=False)
class ClosedPath(AtlasPath):
    """A closed geodesic: an `AtlasPath` that returns to its start, where it has no kink.

    Its `points` are those of the loop that it was contracted from, and `path` starts where it
    crosses a seam.

    Parameters
    ----------
    kind : LoopKind
        The kind of the loops that lie close to it.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> waist = bm.closed_geodesic(body, "side waist point left")
    >>> waist  # doctest: +ELLIPSIS
    <ClosedPath of length 0.65387 m, error ...e-1... m, CONVERGED>
    >>> waist.local_minimum
    True
    """

    kind: LoopKind

    @property
    def local_minimum(self) -> bool:
        """Whether it is proven that all loops close to it are longer."""
        return self.kind is LoopKind.MINIMUM and self.status is Status.CONVERGED


@one_blas_thread()
def contracted_loop(
    atlas: Atlas, loop: Sequence[Location], *, on_failure: OnFailure = "raise"
) -> ClosedPath:
    """Return the closed geodesic that a loop contracts to, as a rubber band slides to a waist.

    Parameters
    ----------
    atlas : Atlas
    loop : sequence of str, AtlasPoint or position of shape (3,)
        Points along the loop, one on each seam that it crosses among them; the last one is joined
        to the first. Each is given as for `geodesic_between`.
    on_failure : {"raise", "status"}
        What to do if there is no length that can be trusted: raise, or say so in the status, with
        NaN for a length. By default it raises, so that no caller mistakes a NaN for a length.

    Returns
    -------
    ClosedPath
        One that slides to an open boundary of the atlas stays there, with that status.

    Raises
    ------
    InputError
        If a location is not on the atlas, two in a row are on patches that meet at neither, or the
        loop contracts to a point.
    ConvergenceError
        If there is no length that can be trusted and `on_failure` is "raise".

    Notes
    -----
    The shortest loop along its route is found by Newton's method, and where that presses against a
    corner or an edge, the routes on the other side are tried, as in `geodesic_between`. The length
    falls all the time, so that it ends at the first closed geodesic on the way down.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> from bodymeasure.section import Plane, plane_section
    >>> body = bm.load_sample("female_average")
    >>> waist = body.position(body.landmarks["side waist point left"])
    >>> level = plane_section(body, Plane(waist, body.axes.up_vector)).nearest(waist)
    >>> places = zip(level.patch.tolist(), level.parameters.tolist(), strict=True)
    >>> loop = [bm.AtlasPoint(patch, *parameters) for patch, parameters in places]
    >>> path = bm.contracted_loop(body, loop)
    >>> print(f"{path.length:.4f} {body.unit}, {path.kind.name}")
    0.6539 m, MINIMUM
    """
    check_on_failure(on_failure)
    loop = listed(loop, "the loop")
    if len(loop) < FEWEST:
        raise InputError(f"the loop has {counted(len(loop), 'point')}; expected at least {FEWEST}")
    names = [f"point {number} of the loop" for number in range(len(loop))]
    points, _ = checked_points(atlas, loop, names)
    neighbors = topology(atlas).neighbors
    patches = [point.patch for point in points]
    places = np.array([point[1:] for point in points])
    positions = evaluate(atlas.control_points[patches], places[:, None])[:, 0]
    size = float(np.linalg.norm(positions - np.roll(positions, 1, axis=0), axis=1).sum())
    found = shortest_along(atlas, neighbors, [route_through(neighbors, points)], size)
    assert found.kind is not None
    path = AtlasPath.of(atlas, points, found.part, found.status)
    path = ClosedPath(**vars(path), kind=found.kind)
    if on_failure == "raise" and not path.converged:
        saddle = path.status is Status.NOT_A_MINIMUM
        raise ConvergenceError(path.kind.value if saddle else path.status.sentence)
    return path
