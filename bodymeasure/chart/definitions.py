"""Sets of definitions, as they stand in files that users read, copy and change."""

from functools import reduce
from operator import or_
from types import GenericAlias
from typing import Any, Final, Literal

import msgspec

from bodymeasure.chart.kinds import KINDS
from bodymeasure.chart.kinds.base import MeasurementDefinition
from bodymeasure.chart.landmarks.rules import RULES
from bodymeasure.chart.landmarks.rules.base import LandmarkRule
from bodymeasure.wording import counted

FORMAT: Final = "bodymeasure measurements"
VERSION: Final = 1


class Definitions(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A set of definitions: what is measured, and which landmarks follow from others.

    Parameters
    ----------
    name : str
        The set's name, for titles.
    format : str
        ``bodymeasure measurements``; a file has to say so.
    version : int
        The version of the format, 1; a file has to say so.
    words : str
        A description of the set.
    extends : {"", "default"}
        With ``default``, the set is the default one with the changes that this file makes to it: an
        entry whose key (a rule: name) is there already takes the place of that one, and an entry
        with a new key follows at the end. Once read, the set stands for itself and this is empty.
    drop : tuple of str
        Keys of measurements and names of rules that are left out of what is extended.
    presets : dict of str to tuple of str
        Names for some of the measurements, each with their keys; a key without ``_{side}`` stands
        for both sides.
    landmark : tuple of LandmarkRule
        Rules for landmarks that the atlas does not have, in any order.
    measurement : tuple of MeasurementDefinition
        In the order of the chart.

    Examples
    --------
    >>> from bodymeasure.chart.kinds import HeightMeasure
    >>> knee = HeightMeasure(key="knee", name="Knee height", at="patella point left")
    >>> Definitions(name="Mine", measurement=(knee,))
    <Definitions 'Mine': 1 measurement, 0 rules for landmarks>
    """

    format: str = FORMAT
    version: int = VERSION
    name: str
    words: str = ""
    extends: Literal["", "default"] = ""
    drop: tuple[str, ...] = ()
    presets: dict[str, tuple[str, ...]] = {}
    landmark: tuple[LandmarkRule, ...] = ()
    measurement: tuple[MeasurementDefinition, ...] = ()

    def __repr__(self) -> str:
        measurements = counted(len(self.measurement), "measurement")
        rules = counted(len(self.landmark), "rule")
        return f"<Definitions {self.name!r}: {measurements}, {rules} for landmarks>"


def definitions_schema() -> dict[str, Any]:
    """Return the JSON schema of a file of definitions; TOML holds the same content as JSON."""
    rules, kinds = (reduce(or_, table.values()) for table in (RULES, KINDS))
    members: list[tuple[str, Any] | tuple[str, Any, Any]] = [
        ("format", Literal[FORMAT]),
        ("version", Literal[VERSION]),
        ("landmark", GenericAlias(tuple, (rules, ...)), ()),
        ("measurement", GenericAlias(tuple, (kinds, ...)), ()),
    ]
    written = msgspec.defstruct(
        "Definitions",
        members,
        bases=(Definitions,),
        namespace={"__doc__": Definitions.__doc__},
        frozen=True,
        kw_only=True,
        forbid_unknown_fields=True,
    )
    return msgspec.json.schema(written)
