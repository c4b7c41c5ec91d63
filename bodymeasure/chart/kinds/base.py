"""The definition of a measurement, which each kind extends, and its result."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import ClassVar, Literal, NamedTuple

import msgspec
import numpy as np

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Entry, Fault
from bodymeasure.chart.formula.parse import parse_formula
from bodymeasure.chart.tapes import Tape, TapeKind

TapeWanted = Literal["contact", "taut", "both"]
"""Along the skin; drawn taut; or along the skin, with the taut length beside it."""


class Iso(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The name and the clause of a measurement in ISO 8559-1."""

    name: str
    clause: str = ""


class MeasurementDefinition(Entry, frozen=True, kw_only=True, tag_field="kind"):
    """The definition of a measurement; each kind adds members of its own.

    Parameters
    ----------
    key : str
        The name that formulas, tables and files use: letters, digits and underscores. ``{side}`` in
        the key, name, words and landmarks stands for left and right in turn, which gives two
        measurements.
    name : str
    words : str
        A description of what is measured and how the tape lies.
    group : str
        Heading in tables, such as "Girths".
    iso : Iso, optional
    seamly : tuple of str
        Names in Seamly2D's list of measurements.
    freesewing : str, optional
        Key in FreeSewing's list of measurements.
    garmentcode : str, optional
        Key in GarmentCode's files of bodies.
    optional : bool
        Whether a body that lacks its landmarks has a chart without it, rather than with the reason.
    """

    label: ClassVar[str] = "key"
    may_be_negative: ClassVar[bool] = False
    """Whether the value may be zero or less, as a difference may."""

    key: str
    name: str
    words: str = ""
    group: str = ""
    iso: Iso | None = None
    seamly: tuple[str, ...] = ()
    freesewing: str | None = None
    garmentcode: str | None = None
    optional: bool = False

    @property
    def in_degrees(self) -> bool:
        """Whether the measurement is an angle, in degrees, and not a length."""
        return False

    @property
    def operands(self) -> tuple[str, ...]:
        """The keys of the measurements that the formulas of this one name, each once."""
        names = (name for text in self.formulas for name in parse_formula(text).names)
        return tuple(dict.fromkeys(names))

    @property
    def accuracy_class(self) -> AccuracyClass | None:
        """The measurement's class in ISO 20685-1; None for angles, for which it has none."""
        raise NotImplementedError

    def same_place(self, member: str, one: str, other: str | None) -> Iterator[Fault]:
        """Yield a fault if a measurement leads from a landmark to itself, and so is 0."""
        if one == other:
            words = f"leads from {one!r} to the same landmark, which is 0 on every body; name two"
            yield Fault(self, member, words)

    def measure(self, body: Body, others: Mapping[str, "Measured"]) -> "Measured":
        """Measure a body.

        Parameters
        ----------
        body : Body
        others : mapping of str to Measured
            The measurements that the formulas of this one name, by key.

        Raises
        ------
        InputError
            If the measurement cannot be taken on this body; in particular,
            `MissingLandmarkError` if a landmark is missing.
        ConvergenceError
            If a solver does not converge.
        """
        raise NotImplementedError

    def slopes(
        self, body: Body, found: "Measured", others: Mapping[str, "Measured"]
    ) -> Mapping[str, Array]:
        """Return the derivative of the value with respect to the place of each landmark.

        It tells what the uncertainty of landmarks on a scan does to a value, to first order.

        Parameters
        ----------
        body : Body
        found : Measured
            What `measure` has returned.
        others : mapping of str to Measured
            The measurements that the formulas of this one name, by key.

        Returns
        -------
        mapping of str to ndarray, shape (3,)
            Without the landmarks to which the value owes nothing, to first order.
        """
        raise NotImplementedError

    def skin(self, body: Body, found: "Measured") -> Array:
        """Return points of the skin on which the value depends besides its landmarks.

        Returns
        -------
        ndarray, shape (k, 3)
        """
        on_skin = [tape.points[tape.normals.any(axis=1)] for tape in found.tapes]
        return np.concatenate([*on_skin, np.empty((0, 3))])


class Outcome(StrEnum):
    """The outcome of a measurement; `Measured.reason` explains it in words."""

    MEASURED = "measured"
    MISSING_LANDMARK = "missing landmark"
    MISSING_OPERAND = "missing operand"
    REFUSED = "refused"
    NOT_CONVERGED = "not converged"
    NOT_SCANNED = "not scanned"


class Shift(NamedTuple):
    """The change of a value if a landmark lies elsewhere on the skin.

    Parameters
    ----------
    landmark : str
    up, across : float
        The change if it lies 5 mm higher, and 5 mm to the side; NaN if the measurement cannot be
        taken from there. In the unit of the value.
    """

    landmark: str
    up: float
    across: float


@dataclass(frozen=True, eq=False, repr=False)
class Measured:
    """The result of one measurement of a body.

    Parameters
    ----------
    definition : MeasurementDefinition
        With left or right in place of ``{side}``.
    outcome : Outcome
    reason : str
        The reason why there is no value, or a remark on it, and what to do; may be empty.
    status : str
        Name of the solver's status (`bodymeasure.Status`); empty where there is none.
    value : float
        The length that is asked for, in `unit`; NaN if there is none.
    contact, taut : float
        Lengths along the skin and drawn taut; NaN where not asked for or not applicable.
    error_estimate : float
        Estimated error of `value`, in its unit; where both contact and taut are computed, the
        larger one of their errors.
    approximation_error : float, optional
        A bound on the difference of `value` from that on the surface that the patches of the atlas
        approximate; None if they approximate nothing (`Atlas.approximation`).
    mesh_difference : float, optional
        By how much `value` is larger on the mesh from which the patches were made, about; None
        without one.
    input_uncertainty : float, optional
        The standard uncertainty of `value` that comes from the scan to which the atlas was fitted:
        from the distance of the surface and from the places of the landmarks; None if it was not
        fitted to one.
    surface_uncertainty : float
        The part of it that comes from the surface.
    slopes : mapping of str to ndarray, shape (3,)
        The derivative of `value` with respect to the place of each landmark, on an atlas that was
        fitted to a scan.
    landmarks : tuple of str
        Names of the landmarks used.
    tapes : tuple of Tape
    length_by_region : mapping of str to float
        Length of the contact tape inside each body region.
    unit : str
        The atlas's unit, or ``deg`` for an angle; empty if it is not known.
    shifts : tuple of Shift
        What the value owes to the places of its landmarks, where that was asked for.
    """

    definition: MeasurementDefinition
    outcome: Outcome
    reason: str = ""
    status: str = ""
    value: float = np.nan
    contact: float = np.nan
    taut: float = np.nan
    error_estimate: float = np.nan
    approximation_error: float | None = None
    mesh_difference: float | None = None
    input_uncertainty: float | None = None
    surface_uncertainty: float = 0.0
    slopes: Mapping[str, Array] = field(default_factory=dict)
    landmarks: tuple[str, ...] = ()
    tapes: tuple[Tape, ...] = ()
    length_by_region: Mapping[str, float] = field(default_factory=dict)
    unit: str = ""
    shifts: tuple[Shift, ...] = ()

    @property
    def tape(self) -> Tape:
        """The tape whose length is the value."""
        taut = [tape for tape in self.tapes if tape.kind is TapeKind.TAUT]
        return taut[0] if taut and self.value == self.taut else self.tapes[0]

    @property
    def gap(self) -> float:
        """The length by which the taut tape is shorter than the one along the skin."""
        return self.contact - self.taut

    def __repr__(self) -> str:
        value = f"{self.value:.6g} {self.unit}".rstrip()
        error = f"{self.error_estimate:.1g}"
        if self.approximation_error is not None:
            error += f", approximation {self.approximation_error:.1g}"
        if self.input_uncertainty is not None:
            error += f", scan {self.input_uncertainty:.1g}"
        found = f"{value} (error {error})" if np.isfinite(self.value) else "no value"
        return f"<Measured {self.definition.key}: {found}, {self.outcome}>"
