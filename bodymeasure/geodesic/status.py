"""The outcome of a geodesic problem, and what happens on a failure."""

from enum import Enum
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Bools
from bodymeasure.errors import InputError
from bodymeasure.trust import is_known

OnFailure = Literal["raise", "status"]
"""What a function does if it finds no length that can be trusted: raise, or say so in a status."""


def check_on_failure(on_failure: str) -> None:
    """Raise an InputError unless a setting is one of `OnFailure`."""
    # Compared as text, since an array is not compared as a whole.
    if str(on_failure) not in ("raise", "status"):
        raise InputError(f"on_failure is {on_failure!r}; expected 'raise' or 'status'")


class Status(Enum):
    """The outcome of one geodesic problem; each value is a sentence that says what to do.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> bm.Status.LEAVES_PATCH.has_length
    False
    >>> print(bm.Status.CONVERGED.sentence)
    The path is a geodesic on the patch; its length holds to the stated error.
    """

    CONVERGED = "The path is a geodesic on the patch; its length holds to the stated error."
    ON_BOUNDARY = (
        "The shortest path that was found on the patch runs along its edge for a part; its length "
        "holds to the stated error. On a whole body, a shorter way may lead over the neighboring "
        "patch."
    )
    ENDS_AT_BOUNDARY = (
        "The geodesic reaches a boundary of the surface before it is as long as asked, and ends "
        "there; its length is that of the way up to it."
    )
    CUT_SHORT = (
        "The path is a geodesic and its length holds to the stated error, but the search used up "
        "its budget before all routes beside it were tried: a shorter way may lead over a "
        "neighboring patch; measure to a point in between."
    )
    LEAVES_PATCH = (
        "The geodesic between these points leaves the patch, so its length is not a length on the "
        "patch; measure across the neighboring patches, or take the mesh distance."
    )
    NOT_A_MINIMUM = (
        "The path is a geodesic, but not a shortest one: it passes a conjugate point (or ends so "
        "close to one that this is uncertain), and a shorter path lies beside it; choose end "
        "points that are closer together."
    )
    INACCURATE = (
        "A path was found, but the estimated error of its length is more than 1e-4 of it, so that "
        "the length, which `raw_length` holds, is not to be trusted; look near the path with "
        "`bodymeasure check` for folds and cusps, or measure to a point in between."
    )
    NOT_CONVERGED = (
        "No trial space met the tolerance; allow more functions, loosen the tolerance, or split "
        "the patch."
    )
    OUT_OF_BUDGET = (
        "The search used up its budget before any path met the tolerance; measure to a point in "
        "between, or fit the surface with fewer and smoother patches."
    )
    NO_ROUTE = (
        "No route over seams was found between the points: their parts meet in single points only; "
        "join the patches along whole edges, or measure to a point in between."
    )
    SINGULAR = (
        "The collocation equations became singular; the patch is probably degenerate or folded "
        "near the path, which `bodymeasure check` would show."
    )

    @property
    def has_length(self) -> bool:
        """Whether there is a length that can be trusted."""
        return self in (
            Status.CONVERGED,
            Status.ON_BOUNDARY,
            Status.ENDS_AT_BOUNDARY,
            Status.CUT_SHORT,
        )

    @property
    def sentence(self) -> str:
        """The status in words for the user."""
        return self.value


def checked_status(status: Status, length: float, error: float, size: float) -> Status:
    """Return a status, or ``INACCURATE`` in its place if it has a length that is not known."""
    return status if not status.has_length or is_known(length, error, size) else Status.INACCURATE


def have_length(statuses: NDArray[Any]) -> Bools:
    """Return `Status.has_length` for each of an array of statuses."""
    result: Bools = np.asarray(statuses == Status.CONVERGED)
    # Each comparison takes as long as a copy, and most batches need one.
    if not result.all():
        for status in Status:
            if status.has_length:
                result |= statuses == status
    return result
