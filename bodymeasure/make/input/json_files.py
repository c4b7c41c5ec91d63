"""Measurements in JSON: of FreeSewing, of a chart, or as people write them."""

from collections.abc import Mapping
from pathlib import Path

import msgspec

from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError
from bodymeasure.make.input.measurements import Measurements, Value
from bodymeasure.make.input.names import Names
from bodymeasure.make.input.numbers import checked, parsed
from bodymeasure.report.body.codes import FREESEWING_KEYS
from bodymeasure.report.units import DEGREES
from bodymeasure.wording import hint

EXPECTED = (
    'expected {"unit": "cm", "measurements": {"waist_girth": 72}}, a measurement set of '
    "FreeSewing, or the measurements.json of a chart"
)


def measurements_of_json(content: bytes, path: Path, names: Names) -> Measurements:
    """Return the measurements of a JSON file that is not a chart's.

    With a member ``unit``, the measurements are by keys or names of the chart; without one, they
    are FreeSewing's, in millimeters.

    Raises
    ------
    InputError
        If the file is not as expected.
    """
    try:
        held = msgspec.json.decode(content)
    except msgspec.DecodeError as error:
        raise InputError(f"{path}: is not JSON ({error}); {EXPECTED}") from None
    if not isinstance(held, dict):
        raise InputError(f"{path}: is not an object; {EXPECTED}")
    values = held.get("measurements", held.get("measies"))
    if not isinstance(values, dict) or not values:
        raise InputError(f"{path}: has no measurements; {EXPECTED}")
    name = held.get("name")
    title = name if isinstance(name, str) and name else path.stem
    if "unit" in held:
        return _own(held, values, path, names, title)
    return _freesewing(values, path, names, title)


def _own(
    held: Mapping[str, object], values: Mapping[str, object], path: Path, names: Names, title: str
) -> Measurements:
    unit = held["unit"]
    if not isinstance(unit, str) or unit not in [each.value for each in Unit]:
        raise InputError(f"{path}: the unit is {unit!r}; expected m, cm, mm or inch")
    sex = held.get("sex")
    if sex not in (None, "female", "male"):
        raise InputError(f"{path}: sex is {sex!r}; expected 'female' or 'male'")
    found: dict[str, Value] = {}
    for text, value in values.items():
        key = names.find(text, str(path))
        if key in found:
            raise InputError(f"{path}: {key!r} is given a second time, as {text!r}; keep one")
        found[key] = value_of(key, value, unit, f"{path}: {text}", names)
    return Measurements(title, tuple(found.values()), sex)


def value_of(key: str, value: object, unit: str | None, place: str, names: Names) -> Value:
    """Return a value that was given as a number or as a text."""
    angle = names.by_key[key].in_degrees
    own = DEGREES if angle else unit
    if isinstance(value, str):
        number, own = parsed(value, own, place)
    elif isinstance(value, bool) or not isinstance(value, (int, float)):
        raise InputError(f"{place}: {value!r} is not a number; expected one such as 92.5")
    elif own is None:
        raise InputError(f"{place}: {value:g} has no unit, and none is guessed; give the unit")
    else:
        number = checked(float(value), own, f"{value:g}", place)
    if (own == DEGREES) != angle:
        expected = "an angle in deg" if angle else "a length in m, cm, mm or inch"
        raise InputError(f"{place}: is in {own}; expected {expected}")
    assert own is not None
    return Value(key, number, own, place)


def _freesewing(values: Mapping[str, object], path: Path, names: Names, title: str) -> Measurements:
    found: dict[str, Value] = {}
    notes, left = [], []
    for code, value in values.items():
        if code not in FREESEWING_KEYS:
            raise InputError(
                f"{path}: {code!r} is no measurement of FreeSewing; {hint(code, FREESEWING_KEYS)}. "
                'With a member "unit", the measurements are by keys of the chart'
            )
        key = names.freesewing.get(code)
        if key is None:
            left.append(code)
        elif value:
            found[key] = value_of(key, value, Unit.MM.value, f"{path}: {code}", names)
    if left:
        notes.append(f"{path.name}: the chart has no {', '.join(left)}; left out")
    return Measurements(title, tuple(found.values()), None, tuple(notes))
