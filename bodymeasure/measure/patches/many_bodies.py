"""The diagonals of many bodies at once, as arrays alone."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bodymeasure._typing import Array
from bodymeasure.arguments import numbers
from bodymeasure.errors import InputError
from bodymeasure.geodesic import Method, Search, solve_geodesic
from bodymeasure.measure.patches.diagonals import DIAGONAL_ENDS, DIAGONAL_STARTS
from bodymeasure.threads import one_blas_thread

# Problems that are solved together: enough to fill the kernels, and few enough that their paths,
# which are dropped again, take some hundred megabytes.
TOGETHER = 20_000


@dataclass(frozen=True, eq=False, repr=False)
class DiagonalArrays:
    """Lengths of both diagonals of every patch of many bodies; all have shape (bodies, patches, 2).

    Parameters
    ----------
    length : ndarray
        NaN where there is none that can be trusted.
    error_estimate : ndarray
    status : ndarray of Status
    """

    length: Array
    error_estimate: Array
    status: NDArray[np.object_]

    def __repr__(self) -> str:
        bodies, patches, _ = self.length.shape
        measured = int(np.isfinite(self.length).sum())
        return (
            f"<DiagonalArrays of {bodies:,} bodies with {patches} patches: {measured:,} of "
            f"{self.length.size:,} measured>"
        )


@one_blas_thread()
def diagonals_of_bodies(
    control_points: ArrayLike, *, method: Method | None = None, search: Search | None = "straight"
) -> DiagonalArrays:
    """Return the lengths of both diagonals of every patch of many bodies, without their paths.

    Parameters
    ----------
    control_points : array_like, shape (bodies, patches, 4, 4, 3)
    method : Method, optional
        `RBFCollocation()` by default.
    search : {"quick", "thorough", "straight"}, optional
        As for `diagonals`, but straight by default: a diagonal that runs along an edge of its
        patch, of which a body has about a dozen, has no length then. The others search for it,
        which takes many times as long as all the rest.

    Returns
    -------
    DiagonalArrays
        What `diagonals` gives for each body with the same search, to rounding.

    Raises
    ------
    InputError
        If the control points have another shape, are not finite, or a patch is collapsed.

    Examples
    --------
    >>> import numpy as np
    >>> import bodymeasure as bm
    >>> names = ["female_average", "male_average"]
    >>> nets = np.stack([bm.load_sample(name).control_points for name in names])
    >>> found = bm.diagonals_of_bodies(nets)
    >>> found.length.shape, found.length[:, 0, 0].round(4)
    ((2, 376, 2), array([0.0813, 0.0837]))
    """
    nets = numbers(control_points, "the control points", "an array of numbers")
    if nets.ndim != 5 or nets.shape[2:] != (4, 4, 3) or not nets.size:
        raise InputError(
            f"the control points have shape {nets.shape}; expected (bodies, patches, 4, 4, 3)"
        )
    shape = (*nets.shape[:2], 2)
    length, error = np.empty(shape), np.empty(shape)
    status = np.empty(shape, dtype=object)
    step = max(TOGETHER // (2 * shape[1]), 1)
    for start in range(0, len(nets), step):
        some = slice(start, start + step)
        found = solve_geodesic(
            nets[some, :, None],
            DIAGONAL_STARTS,
            DIAGONAL_ENDS,
            method=method,
            search=search,
            on_failure="status",
        )
        length[some], error[some], status[some] = found.length, found.error_estimate, found.status
    return DiagonalArrays(length, error, status)
