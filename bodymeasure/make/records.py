"""The content of files about bodies that were made."""

from collections.abc import Mapping
from typing import Annotated, Final, Literal

from msgspec import Meta, Struct

from bodymeasure.make.result import MadeBody
from bodymeasure.report.serial import records_csv
from bodymeasure.report.units import ValueUnit

SCHEMA: Final = "bodymeasure made"


class ValueRecord(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One measurement of a body that was made."""

    subject: str
    measurement: Annotated[str, Meta(description="Its key.")]
    name: str
    value: Annotated[float | None, Meta(description="What the body has; null if it has none.")]
    unit: ValueUnit
    deviation: Annotated[
        float,
        Meta(
            description="Standard deviation of the value over all bodies of the space that have "
            "the measurements asked for."
        ),
    ]
    asked: Annotated[float | None, Meta(description="What was asked for; null if nothing was.")]
    miss: Annotated[float | None, Meta(description="value - asked")]


class BodyRecord(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A body that was made."""

    name: str
    rounds: int
    chi_square: Annotated[
        float,
        Meta(description="Squared distance of the measurements from those of the mean body."),
    ]
    probability: Annotated[float, Meta(description="Part of all bodies that are as far out.")]
    sex: str | None
    age: float | None
    coefficients: Annotated[
        list[float], Meta(description="In the space of bodies, in standard deviations.")
    ]
    warnings: list[str]
    notes: list[str]
    measurements: list[ValueRecord]


class MadeDocument(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Bodies that were made, with all their measurements."""

    schema: Literal["bodymeasure made"] = SCHEMA
    version: Literal[1] = 1
    bodies: list[BodyRecord]


def made_document(made: Mapping[str, MadeBody]) -> MadeDocument:
    """Return the document of some bodies, by their names; all of them are measured."""
    return MadeDocument(bodies=[_body(name, body) for name, body in made.items()])


def made_to_csv(document: MadeDocument) -> bytes:
    """Return the measurements of all bodies as CSV, with the fields of `ValueRecord`."""
    every = [record for body in document.bodies for record in body.measurements]
    return records_csv(ValueRecord, every)


def _body(name: str, body: MadeBody) -> BodyRecord:
    asked = {one.value.key: one for one in body.asked}
    records = []
    for one in body.predicted():
        # What was asked for stands in the unit in which it was asked.
        mine = asked.get(one.key)
        scale = mine.value.factor if mine else 1.0 if one.unit == "deg" else 100.0
        unit = mine.value.unit if mine else one.unit if one.unit == "deg" else "cm"
        known = one.value == one.value
        value = one.value * scale if known else None
        records.append(
            ValueRecord(
                subject=name,
                measurement=one.key,
                name=one.name,
                value=value,
                unit=unit,  # type: ignore[arg-type]
                deviation=one.deviation * scale,
                asked=mine.value.value if mine else None,
                miss=value - mine.value.value if mine and value is not None else None,
            )
        )
    return BodyRecord(
        name=name,
        rounds=body.rounds,
        chi_square=body.chi_square,
        probability=body.probability,
        sex=body.prior.sex,
        age=body.prior.age,
        coefficients=body.coefficients.tolist(),
        warnings=list(body.warnings),
        notes=list(body.notes),
        measurements=records,
    )
