"""The diagonals of an atlas's patches."""

import numpy as np

from bodymeasure.atlas import Atlas
from bodymeasure.atlas.atlas import require_atlas
from bodymeasure.errors import InputError
from bodymeasure.geodesic import GeodesicSolution, Method, Search, solve_geodesic
from bodymeasure.geodesic.status import OnFailure
from bodymeasure.geodesic.surfaces.control_points import collapsed_patches
from bodymeasure.threads import one_blas_thread

# Ends (u, v) of a patch's two diagonals; shape (2, 2).
DIAGONAL_STARTS = np.array([[0.0, 0.0], [1.0, 0.0]])
DIAGONAL_ENDS = np.array([[1.0, 1.0], [0.0, 1.0]])


@one_blas_thread()
def diagonals(
    atlas: Atlas,
    *,
    method: Method | None = None,
    search: Search | None = None,
    on_failure: OnFailure = "raise",
) -> GeodesicSolution:
    """Return both diagonal geodesics of every patch, in one batch.

    Parameters
    ----------
    atlas : Atlas
    method : Method, optional
        `RBFCollocation()` by default.
    search : {"quick", "thorough", "straight"}, optional
    on_failure : {"raise", "status"}
        What to do if there is no length that can be trusted: raise, so that no failure is
        overlooked, or say so in the status, with NaN for a length.

    Returns
    -------
    GeodesicSolution
        Its shape is (patches, 2): ``[:, 0]`` runs from (0, 0) to (1, 1), ``[:, 1]`` from (1, 0) to
        (0, 1). Lengths are in the atlas's unit.

    Raises
    ------
    InputError
        If a patch is collapsed to a point. `check_atlas` finds folded patches and other faults.
    ConvergenceError
        If a diagonal has no length that can be trusted and `on_failure` is "raise".

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> solutions = bm.diagonals(body)
    >>> solutions.shape
    (376, 2)
    >>> print(f"{solutions.length.max():.4f} {body.unit}")
    0.1345 m
    """
    require_atlas(atlas)
    # The solver would refuse it too, but without its name.
    collapsed = collapsed_patches(atlas.control_points)
    if len(collapsed):
        raise InputError(
            f"patch {atlas.patch_names[collapsed[0]]!r} is collapsed: all its control points are "
            f"equal ({len(collapsed)} such patch{'es' if len(collapsed) > 1 else ''}); remove it"
        )
    return solve_geodesic(
        atlas.control_points[:, None],
        DIAGONAL_STARTS,
        DIAGONAL_ENDS,
        method=method,
        search=search,
        on_failure=on_failure,
    )
