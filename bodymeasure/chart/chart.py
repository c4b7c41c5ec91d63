"""A chart of measurements, measured. Reports and pictures show it and compute no geometry again."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart.kinds.definitions import Definitions, Measurement


class TapeKind(StrEnum):
    """How a tape lies."""

    CONTACT = "contact"
    TAUT = "taut"
    STRAIGHT = "straight"


class Outcome(StrEnum):
    """What came of a measurement; `Measured.reason` says it in words for this one."""

    MEASURED = "measured"
    MISSING_LANDMARK = "missing landmark"
    MISSING_OPERAND = "missing operand"
    REFUSED = "refused"
    NOT_CONVERGED = "not converged"


@dataclass(frozen=True, eq=False)
class Tape:
    """A tape, to be drawn.

    Parameters
    ----------
    kind : TapeKind
    points : ndarray, shape (k, 3)
        Along the tape, in the atlas's unit; a closed one ends at its first point.
    normals : ndarray, shape (k, 3)
        Unit vectors away from the body, to lift the drawn tape by; 0 where it stands free.
    """

    kind: TapeKind
    points: Array
    normals: Array


@dataclass(frozen=True, eq=False)
class Measured:
    """One measurement of a body.

    Parameters
    ----------
    definition : Measurement
        With left or right put in for ``{side}``.
    outcome : Outcome
    reason : str
        Empty if measured without remark; else what is the matter and what to do.
    status : str
        Name of the solver's status (`bodymeasure.Status`), where there is one; else empty.
    value : float
        The length asked for, in the atlas's unit (degrees if the definition says so); NaN if there
        is none.
    contact, taut : float
        Lengths along the skin and drawn taut; NaN where not asked for or not applicable.
    error_estimate : float
        Of `value`, in its unit; the larger one of contact and taut if there are both.
    landmarks : tuple of str
        Names of the landmarks used.
    tapes : tuple of Tape
    length_by_region : mapping of str to float
        Length of the contact tape inside each body region.
    """

    definition: Measurement
    outcome: Outcome
    reason: str = ""
    status: str = ""
    value: float = np.nan
    contact: float = np.nan
    taut: float = np.nan
    error_estimate: float = np.nan
    landmarks: tuple[str, ...] = ()
    tapes: tuple[Tape, ...] = field(default=(), repr=False)
    length_by_region: Mapping[str, float] = field(default_factory=dict)

    @property
    def gap(self) -> float:
        """By how much the taut tape is shorter than the one along the skin."""
        return self.contact - self.taut


@dataclass(frozen=True, eq=False)
class Chart:
    """All measurements of a body.

    Parameters
    ----------
    atlas : Atlas
    definitions : Definitions
    landmarks : mapping of str to AtlasPoint
        Those of the atlas, and those that rules gave.
    missing_landmarks : mapping of str to str
        Those that rules could not give, and why.
    measured : tuple of Measured
        In the order of the definitions.
    seconds : float
        What it took.
    versions : mapping of str to str
        Of the packages that can change a number.
    """

    atlas: Atlas
    definitions: Definitions = field(repr=False)
    landmarks: Mapping[str, AtlasPoint] = field(repr=False)
    missing_landmarks: Mapping[str, str] = field(repr=False)
    measured: tuple[Measured, ...] = field(repr=False)
    seconds: float = 0.0
    versions: Mapping[str, str] = field(default_factory=dict)

    def __getitem__(self, key: str) -> Measured:
        """The measurement of that key.

        Raises
        ------
        KeyError
            If there is none.
        """
        for item in self.measured:
            if item.definition.key == key:
                return item
        raise KeyError(key)
