"""The measurements of a survey, and the numbers that it keeps of each."""

from collections.abc import Sequence

import msgspec

from bodymeasure.atlas import Unit
from bodymeasure.chart import Definitions, both_sides, restricted
from bodymeasure.report.units import DEGREES, ValueUnit

# The fields of a chart's record that a survey keeps. The column of the value has the key as its
# name; the others have the key, a point and the field.
MEMBERS = (
    "value",
    "error_estimate",
    "approximation_error",
    "mesh_difference",
    "input_uncertainty",
    "contact",
    "taut",
)


class Column(msgspec.Struct, frozen=True, kw_only=True):
    """A measurement of a survey.

    Parameters
    ----------
    key, name, group, kind : str
    unit : str
    accuracy_class, iso_name : str, optional
        In ISO 20685-1, and in ISO 8559-1.
    """

    key: str
    name: str
    group: str
    kind: str
    unit: ValueUnit
    accuracy_class: str | None
    iso_name: str | None


def columns_of(definitions: Definitions, only: Sequence[str], unit: Unit) -> tuple[Column, ...]:
    """Return the measurements that a set, or a part of it, asks for, in its order."""
    return tuple(
        Column(
            key=one.key,
            name=one.name,
            group=one.group,
            kind=one.tag(),
            unit=DEGREES if one.in_degrees else unit.value,
            accuracy_class=None if (kind := one.accuracy_class) is None else kind.value,
            iso_name=one.iso.name if one.iso else None,
        )
        for one in both_sides(restricted(definitions, only)[0].measurement)
    )


def column_name(key: str, member: str) -> str:
    """Return the name of a column of the table."""
    return key if member == MEMBERS[0] else f"{key}.{member}"
