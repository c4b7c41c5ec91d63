"""The diagonals of an atlas's patches."""

from typing import Literal

import numpy as np

from bodymeasure.atlas import Atlas
from bodymeasure.errors import InputError
from bodymeasure.geodesic import GeodesicSolution, Method, Search, solve_geodesic
from bodymeasure.geodesic.surfaces.control_points import collapsed_patches

# Ends (u, v) of a patch's two diagonals; shape (2, 2).
DIAGONAL_STARTS = np.array([[0.0, 0.0], [1.0, 0.0]])
DIAGONAL_ENDS = np.array([[1.0, 1.0], [0.0, 1.0]])


def diagonals(
    atlas: Atlas,
    *,
    method: Method | None = None,
    search: Search | None = None,
    on_failure: Literal["raise", "status"] = "status",
) -> GeodesicSolution:
    """Both diagonal geodesics of every patch, in one batch.

    Parameters
    ----------
    atlas : Atlas
    method : Method, optional
        `RBFCollocation()` by default.
    search : {"quick", "thorough", "straight"}, optional
    on_failure : {"status", "raise"}
        See `solve_geodesic`. Among the hundreds of diagonals of a body one may fail, so here the
        statuses say so by default.

    Returns
    -------
    GeodesicSolution
        Of shape (patches, 2): ``[:, 0]`` runs from (0, 0) to (1, 1), ``[:, 1]`` from (1, 0) to
        (0, 1). Lengths are in the atlas's unit.

    Raises
    ------
    InputError
        If a patch is collapsed to a point. Whether patches are folded, and the like, is for
        `check_atlas` to say.
    """
    # As the solver would say, but by name.
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
