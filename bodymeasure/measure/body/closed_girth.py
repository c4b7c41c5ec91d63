"""The natural waist, and other girths where a tape comes to rest by itself."""

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.queries.locations import Location, position_of
from bodymeasure.errors import InputError
from bodymeasure.geodesic import ClosedPath, contracted_loop
from bodymeasure.geodesic.status import OnFailure
from bodymeasure.measure.body.girths import section_loop
from bodymeasure.section import Plane
from bodymeasure.threads import one_blas_thread


@one_blas_thread()
def closed_geodesic(atlas: Atlas, at: Location, *, on_failure: OnFailure = "raise") -> ClosedPath:
    """Return the closed geodesic that the horizontal loop at a place contracts to.

    From hip, waist or underbust, that is the natural waist. It follows the skin, and need not be
    level: a girth at a landmark's height is `body_girth`.

    Parameters
    ----------
    atlas : Atlas
    at : str, AtlasPoint or ndarray of shape (3,)
    on_failure : {"raise", "status"}
        What to do if there is no length that can be trusted: raise, so that no failure is
        overlooked, or say so in the status, with NaN for a length.

    Returns
    -------
    ClosedPath

    Raises
    ------
    InputError
        As `body_girth`, or if the loop is open or contracts to a point.
    ConvergenceError
        If there is no length that can be trusted and `on_failure` is "raise".

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> waist = bm.closed_geodesic(body, "front waist point")
    >>> print(f"{waist.length:.4f} {body.unit}, {waist.kind.name}")
    0.6539 m, MINIMUM
    """
    plane = Plane(position_of(atlas, at), atlas.axes.up_vector)
    loop = section_loop(atlas, plane, at)
    if not loop.closed:
        raise InputError(
            "the section is open: it ends on the boundary of the atlas, so that it goes round "
            "nothing; choose a place where the body is closed all round"
        )
    points = [
        AtlasPoint(patch, *parameters)
        for patch, parameters in zip(loop.patch.tolist(), loop.parameters.tolist(), strict=True)
    ]
    return contracted_loop(atlas, points, on_failure=on_failure)
