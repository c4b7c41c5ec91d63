"""The record of a length: what was computed, what it is corrected by, and how far it is known."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Bools, Ints

# The correction is the leading order of an expansion: past this part of the length it is not to be
# trusted.
TRUSTED_CORRECTION = 1e-4
# Neither is it where a path turns, within the surface, by more than this angle on a distance as
# long as itself. Of 7000 paths with good lengths on bodies and on mild and wild patches, one in a
# thousand does, and is found with more functions; on folded patches and near cusps some do whose
# formulas all agree on a wrong length.
TRUSTED_RESIDUAL = 1.0
# The index of a path whose index is not known.
UNKNOWN = -1


@dataclass(frozen=True)
class Length:
    """Lengths of computed paths, or of closed ones, with what is known of their errors.

    Every array has the shape of the batch: (problems,) for many paths, () for a single one. Lengths
    and errors are in one unit, that of the surface or of the atlas.

    Parameters
    ----------
    raw : ndarray
        The length of the path as computed.
    correction : ndarray
        The amount by which the path is longer than the geodesic, to leading order; 0 where nothing
        is known.
    error : ndarray
        The estimated error of ``raw - correction``; infinite where nothing is known.
    residual : ndarray
        The largest geodesic curvature at the quadrature points, which lie between the nodes, times
        the length: 0 for a geodesic. For a path over several patches it is the largest among its
        pieces and the differences of the unit tangents' components along the seams it crosses.
    index : ndarray of int
        The Morse index of the geodesic that the path stands for: 0 for a strict local minimum, and
        `UNKNOWN` where it could not be determined.
    trusted : ndarray of bool
        Whether corrections and residuals are so small that the leading order says enough
        (`is_leading_order`). Of a path made of parts, it is so of every part.
    """

    raw: Array
    correction: Array
    error: Array
    residual: Array
    index: Ints
    trusted: Bools

    @property
    def corrected(self) -> Array:
        """The length of the geodesic: that of the path, less its excess."""
        return self.raw - self.correction

    @property
    def minimal(self) -> Bools:
        """Which paths are proven to be shorter than all paths close to them."""
        result: Bools = self.index == 0
        return result

    def is_known_to(self, tolerance: float) -> Bools:
        """Return which lengths are trusted and known to a relative tolerance."""
        result: Bools = self.trusted & (self.error <= tolerance * self.raw)
        return result

    def mapped(self, function: Callable[[Any], Any]) -> "Length":
        """Return the record with a function applied to each of its arrays."""
        return Length(
            function(self.raw),
            function(self.correction),
            function(self.error),
            function(self.residual),
            function(self.index),
            function(self.trusted),
        )

    def take(self, rows: Ints) -> "Length":
        """Return the lengths of some of the problems."""
        return self.mapped(lambda array: array[rows])

    def scaled(self, factor: Array | float) -> "Length":
        """Return the lengths in another unit, or on surfaces that are larger by a factor."""
        return Length(
            self.raw * factor,
            self.correction * factor,
            self.error * factor,
            self.residual,
            self.index,
            self.trusted,
        )

    @classmethod
    def concatenated(cls, batches: "Sequence[Length]") -> "Length":
        """Return the lengths of several batches as one batch."""
        return cls(
            np.concatenate([each.raw for each in batches]),
            np.concatenate([each.correction for each in batches]),
            np.concatenate([each.error for each in batches]),
            np.concatenate([each.residual for each in batches]),
            np.concatenate([each.index for each in batches]),
            np.concatenate([each.trusted for each in batches]),
        )

    @classmethod
    def of_parts(cls, parts: "Sequence[Length]") -> "Length":
        """Return the lengths of paths that are made of parts whose joints stay in place.

        The index is then the sum of the parts' indices.
        """
        indices = [part.index for part in parts]
        known = np.all([index != UNKNOWN for index in indices], axis=0)
        return cls(
            raw=np.sum([part.raw for part in parts], axis=0),
            correction=np.sum([part.correction for part in parts], axis=0),
            error=np.sum([part.error for part in parts], axis=0),
            residual=np.max([part.residual for part in parts], axis=0),
            index=np.where(known, np.sum(indices, axis=0), UNKNOWN),
            trusted=np.all([part.trusted for part in parts], axis=0),
        )


def is_leading_order(correction: Any, residual: Any, length: Any) -> Any:
    """Return whether corrections are small parts of the length, and residuals small angles.

    Parameters
    ----------
    correction, residual, length : array
        Arrays of shapes that broadcast with one another; the length is that of the whole path.

    Returns
    -------
    array of bool
    """
    return (abs(correction) <= TRUSTED_CORRECTION * length) & (residual <= TRUSTED_RESIDUAL)
