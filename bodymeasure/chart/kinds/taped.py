"""The measurement of a section, along which a tape follows the skin or is drawn taut."""

from collections.abc import Mapping
from dataclasses import replace

from bodymeasure.chart.body import Body
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, Outcome, TapeWanted
from bodymeasure.chart.tapes import TapeKind
from bodymeasure.measure import Drop, Girth, GirthArc


def taped(
    body: Body,
    definition: MeasurementDefinition,
    wanted: TapeWanted,
    found: Drop | Girth | GirthArc,
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


def taped_girth(
    body: Body,
    definition: MeasurementDefinition,
    wanted: TapeWanted,
    girth: Girth,
    remark: str = "",
) -> Measured:
    """Return the measurement of a girth, with the remarks on it."""
    found = taped(body, definition, wanted, girth, girth.tape.length_by_region)
    return replace(found, reason=" ".join(filter(None, (remark, sentence(girth.remark)))))


def sentence(remark: str) -> str:
    """Return a remark as a sentence."""
    return f"{remark[:1].upper()}{remark[1:]}." if remark else ""
