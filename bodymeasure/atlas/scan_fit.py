"""The scan that an atlas was fitted to, and how well it follows it."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError

# A patch of which the scan shows less than this part takes its shape from the body model.
LEAST_COVERAGE = 0.5


class LandmarkOrigin(StrEnum):
    """The way in which a landmark came onto an atlas that was fitted to a scan."""

    CARRIED = "carried"
    """It lies at its place on the body model, which the fit has moved onto the scan."""

    PICKED = "picked"
    """The user has picked it on the scan."""

    RULE = "rule"
    """A rule has found it by the shape of the fitted body."""


class LandmarkFound(NamedTuple):
    """How a landmark was found on a scan, and how far it may be from its place.

    Parameters
    ----------
    origin : LandmarkOrigin
    uncertainty : float
        Root mean square distance along the skin from the place where it belongs, in meters.
    """

    origin: LandmarkOrigin
    uncertainty: float


@dataclass(frozen=True, eq=False)
class ScanFit:
    """The scan that an atlas was fitted to, and how well the atlas follows it.

    Distances are in meters, whatever the atlas's unit.

    Parameters
    ----------
    coverage : array_like, shape (patches,)
        The part of each patch that has scan near it, from 0 to 1.
    distance : array_like, shape (patches,)
        Root mean square distance of each patch from the scan, where it has scan; NaN where it has
        none.
    landmarks : mapping of str to LandmarkFound
        How each landmark was found. One that is not here is taken as it is.
    done : tuple of str
        What was done with the scan, in sentences.
    warnings : tuple of str
        What a user should know before relying on a number, in sentences.

    Raises
    ------
    InputError
        If a number is not what is said above, or the arrays differ in their shapes.
    """

    coverage: Array
    distance: Array
    landmarks: Mapping[str, LandmarkFound] = field(default_factory=dict)
    done: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        coverage = _checked(self.coverage, "coverage")
        distance = _checked(self.distance, "distance")
        if coverage.shape != distance.shape:
            raise InputError(
                f"the scan has {len(coverage)} numbers of coverage and {len(distance)} distances; "
                "expected one of each for each patch"
            )
        # `not within`, so that NaN is refused too.
        if not ((coverage >= 0.0) & (coverage <= 1.0)).all():
            raise InputError("the scan's coverage of a patch is not within 0 to 1")
        if (distance < 0.0).any() or np.isinf(distance).any():
            raise InputError("a patch's distance from the scan is negative or infinite")
        for name, found in self.landmarks.items():
            if not 0.0 <= found.uncertainty < np.inf:
                raise InputError(
                    f"the uncertainty of landmark {name!r} is {found.uncertainty}; expected a "
                    "distance in meters"
                )
        set_field = object.__setattr__
        set_field(self, "coverage", coverage)
        set_field(self, "distance", distance)
        set_field(self, "landmarks", dict(self.landmarks))
        set_field(self, "done", tuple(self.done))
        set_field(self, "warnings", tuple(self.warnings))

    @property
    def uncovered(self) -> Ints:
        """The numbers of the patches that the scan does not show, whose shape is a guess."""
        return np.flatnonzero(self.coverage < LEAST_COVERAGE)

    @property
    def rms(self) -> float:
        """Root mean square of the distances of all patches that have scan; NaN without any."""
        known = self.distance[np.isfinite(self.distance)]
        return float(np.sqrt((known**2).mean())) if len(known) else float("nan")

    def part(self, patches: Ints) -> Self:
        """Return that of some of the patches."""
        return replace(self, coverage=self.coverage[patches], distance=self.distance[patches])

    def is_same(self, other: "ScanFit | None") -> bool:
        """Whether another has the same content."""
        return (
            other is not None
            and np.array_equal(self.coverage, other.coverage)
            and np.array_equal(self.distance, other.distance, equal_nan=True)
            and (self.landmarks, self.done, self.warnings)
            == (other.landmarks, other.done, other.warnings)
        )


def _checked(values: ArrayLike, name: str) -> Array:
    try:
        array = np.array(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"the scan's {name} is no list of numbers") from None
    if array.ndim != 1:
        raise InputError(
            f"the scan's {name} has shape {array.shape}; expected one number for each patch"
        )
    array.flags.writeable = False
    return array
