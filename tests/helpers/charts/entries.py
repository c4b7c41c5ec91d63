"""The checks that every kind of measurement and every rule for landmarks has to pass."""

import ast
import inspect
import tomllib
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import ModuleType

import msgspec
from helpers.surfaces.tubes import joined, tube

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart import AccuracyClass, LandmarkRule, MeasurementDefinition
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Entry, texts_in
from bodymeasure.chart.reading.convert import LANDMARKS, MEASUREMENTS, Table, entry_of
from bodymeasure.chart.reading.guide import default_set
from bodymeasure.errors import BodymeasureError


def table_of(kind: type[Entry]) -> Table:
    """The table of a file of definitions in which entries of that kind stand."""
    return MEASUREMENTS if issubclass(kind, MeasurementDefinition) else LANDMARKS


def example_of(kind: type[Entry]) -> Entry:
    """The example of a kind, as a file of definitions would give it."""
    table = table_of(kind)
    members = tomllib.loads(inspect.cleandoc(kind.example))
    return entry_of(
        table, {table.label: "example", "name": "Example", table.tag: kind.tag(), **members}
    )


def assert_complete(kind: type[Entry]) -> None:
    """A kind is registered, documented, and gives an example of each member that it needs."""
    table = table_of(kind)
    assert table.kinds.get(kind.tag()) is kind, f"{kind.__name__} is not registered"
    entry = example_of(kind)
    assert list(entry.faults()) == []
    guide = default_set().partition(f'"{kind.tag()}": ')[2].partition("\n#\n")[0]
    summary, *described = guide.split("\n#        ")
    assert len(summary) > 20, f"{kind.__name__} has no docstring"
    base = MeasurementDefinition if table is MEASUREMENTS else LandmarkRule
    own = [
        field for field in msgspec.structs.fields(kind) if field.name not in base.__struct_fields__
    ]
    assert own, f"{kind.__name__} has no members"
    documented = {name: line for line in described for name in line.partition(": ")[0].split(", ")}
    for field in own:
        words = documented.get(field.name, "").partition(": ")[2]
        assert words, f"{kind.__name__} does not document {field.name}"
    if isinstance(entry, MeasurementDefinition):
        assert entry.accuracy_class in {*AccuracyClass, None}
        assert kind.measure is not MeasurementDefinition.measure  # type: ignore[attr-defined]
    if isinstance(entry, LandmarkRule):
        assert entry.description
        assert kind.point is not LandmarkRule.point  # type: ignore[attr-defined]


def assert_names_what_it_asks_for(kind: type[Entry]) -> None:
    """The landmarks that a kind uses are those that its typed members name."""
    entry = example_of(kind)
    asked = _Asked({name: _place(name) for name in texts_in(entry)})
    try:
        if isinstance(entry, MeasurementDefinition):
            entry.measure(Body(_post(), asked), {})
        elif isinstance(entry, LandmarkRule):
            entry.point(_post(), asked)
    except (BodymeasureError, KeyError):
        # A tube has no armpits, and the example's formula no operands.
        pass
    used, named = asked.names, set(entry.landmarks)
    assert used <= named, f"{kind.__name__} uses {used - named}, whose members are no Landmark"
    assert named <= used, f"{kind.__name__} never uses {named - used}"


class _Asked(dict[str, AtlasPoint]):
    """Landmarks that note which of them are asked for."""

    def __init__(self, points: Mapping[str, AtlasPoint]) -> None:
        super().__init__(points)
        self.names: set[str] = set()

    def __getitem__(self, name: str) -> AtlasPoint:
        self.names.add(name)
        return super().__getitem__(name)


@cache
def _post() -> Atlas:
    return replace(joined([tube((1.5,) * 4)], ["torso"]), landmarks={})


def _place(name: str) -> AtlasPoint:
    """A point of the tube for a landmark: its side as the name says, its height by its letters."""
    sides = ("left", "back", "right", "front")
    patch = next((number for number, side in enumerate(sides) if side in name.split()), 0)
    return AtlasPoint(patch, 0.0, 0.1 + 0.8 * (sum(name.encode()) % 97) / 97)


def unregistered(package: ModuleType, base: str, registered: Mapping[str, type[Entry]]) -> set[str]:
    """The names of classes in a package's files that derive from a base but are not registered."""
    assert package.__file__ is not None
    found = set()
    for path in Path(package.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.ClassDef):
                bases = {getattr(each, "id", "") for each in node.bases}
                found |= {node.name} if base in bases else set()
    return found - {kind.__name__ for kind in registered.values()}
