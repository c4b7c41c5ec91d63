"""The measurement of a section, along which a tape follows the skin or is drawn taut."""

from collections.abc import Mapping
from typing import Protocol

from bodymeasure.chart.body import Body
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, Outcome, TapeWanted
from bodymeasure.chart.tapes import TapeKind
from bodymeasure.section import DrawnTape


class BothTapes(Protocol):
    """The lengths of a section along the skin and drawn taut, with both tapes."""

    @property
    def contact(self) -> float: ...
    @property
    def taut(self) -> float: ...
    @property
    def error_estimate(self) -> float: ...
    @property
    def contact_tape(self) -> DrawnTape: ...
    @property
    def taut_tape(self) -> DrawnTape: ...


def taped(
    body: Body,
    definition: MeasurementDefinition,
    wanted: TapeWanted,
    found: BothTapes,
    by_region: Mapping[str, float],
) -> Measured:
    """Return the measurement whose value is the length of the tape that is wanted."""
    tapes = [body.tape(TapeKind.CONTACT, found.contact_tape)]
    if wanted != "contact":
        tapes.append(body.tape(TapeKind.TAUT, found.taut_tape))
    return Measured(
        definition,
        Outcome.MEASURED,
        value=found.taut if wanted == "taut" else found.contact,
        contact=found.contact,
        taut=found.taut,
        error_estimate=found.error_estimate,
        landmarks=definition.landmarks,
        tapes=tuple(tapes),
        length_by_region=by_region,
    )


def sentence(remark: str) -> str:
    """Return a remark as a sentence."""
    return f"{remark[:1].upper()}{remark[1:]}." if remark else ""
