"""The content of the ``measurements.json`` of several bodies."""

from typing import Annotated, Final, Literal

from msgspec import Meta, Struct

from bodymeasure.report.body.records import ChartDocument
from bodymeasure.report.units import LengthUnit, ValueUnit

SCHEMA: Final = "bodymeasure population"


class MeasurementSummary(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One measurement over all subjects that have a value of it; null without any."""

    key: str
    name: str
    group: str
    unit: ValueUnit
    subjects: Annotated[int, Meta(description="Number of subjects with a value.")]
    missing: Annotated[int, Meta(description="Number of subjects without one.")]
    mean: float | None
    deviation: Annotated[float | None, Meta(description="Sample standard deviation.")]
    minimum: float | None
    median: float | None
    maximum: float | None


class Failure(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A body that could not be charted."""

    subject: str
    reason: str


class PopulationDocument(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The charts of several bodies by one set of definitions."""

    schema: Annotated[Literal["bodymeasure population"], Meta(description="Kind of file.")] = SCHEMA
    version: Annotated[Literal[1], Meta(description="The version of this layout.")] = 1
    created: Annotated[str, Meta(description="The time at which it was made, in ISO 8601.")]
    unit: Annotated[LengthUnit, Meta(description="Unit of every length.")]
    definitions: Annotated[str, Meta(description="Name of the set of definitions.")]
    subjects: Annotated[list[str], Meta(description="Their names, in the order of the charts.")]
    failures: Annotated[
        list[Failure],
        Meta(description="The bodies that could not be charted, which are no subjects here."),
    ] = []
    summaries: list[MeasurementSummary]
    charts: list[ChartDocument]
