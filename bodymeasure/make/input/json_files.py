"""Measurements in JSON: of FreeSewing, of a chart, or as people write them."""

import json
import math
from collections.abc import Mapping
from pathlib import Path

from bodymeasure.arguments import repeated
from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError
from bodymeasure.make.input.measurements import Measurements, Value
from bodymeasure.make.input.names import Names
from bodymeasure.make.input.numbers import LARGEST, checked, parsed
from bodymeasure.report.body.codes import FREESEWING_KEYS
from bodymeasure.report.units import DEGREES
from bodymeasure.wording import hint

EXPECTED = (
    'expected {"unit": "cm", "measurements": {"waist_girth": 72}}, a measurement set of '
    "FreeSewing, or the measurements.json of a chart"
)
# The members of a file that says its unit.
MEMBERS = ("name", "unit", "sex", "measurements")


def measurements_of_json(content: bytes, path: Path, names: Names) -> Measurements:
    """Return the measurements of a JSON file that is not a chart's.

    With a member ``unit``, the measurements are by keys or names of the chart; without one, they
    are FreeSewing's, in millimeters.

    Raises
    ------
    InputError
        If the file is not as expected.
    """
    held = _decoded(content, path)
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


def _decoded(content: bytes, path: Path) -> object:
    def object_of(pairs: list[tuple[str, object]]) -> dict[str, object]:
        # JSON takes the last of two values of one name, which may be the wrong one.
        found = dict(pairs)
        if len(found) < len(pairs):
            twice = repeated(name for name, _ in pairs)
            raise InputError(f"{path}: {twice!r} is given a second time; keep one")
        return found

    try:
        # Notepad and Excel begin files with a byte order mark.
        return json.loads(content.decode("utf-8-sig"), object_pairs_hook=object_of)
    except InputError:  # which is a ValueError
        raise
    except UnicodeDecodeError:
        raise InputError(f"{path}: is not text in UTF-8; save the file in that encoding") from None
    except RecursionError:
        raise InputError(f"{path}: is nested too deeply; {EXPECTED}") from None
    except ValueError as error:
        raise InputError(f"{path}: is not JSON ({error}); {EXPECTED}") from None


def _own(
    held: Mapping[str, object], values: Mapping[str, object], path: Path, names: Names, title: str
) -> Measurements:
    unknown = [name for name in held if name not in MEMBERS]
    if unknown:
        raise InputError(
            f"{path}: has the member {unknown[0]!r}; expected no others than {', '.join(MEMBERS)} "
            "(an age is given with --age, or age=)"
        )
    unit = held["unit"]
    if not isinstance(unit, str) or unit not in [each.value for each in Unit]:
        raise InputError(f"{path}: the unit is {unit!r}; expected m, cm, mm or inch")
    sex = held.get("sex")
    if sex not in (None, "female", "male"):
        raise InputError(f"{path}: sex is {sex!r}; expected 'female' or 'male'")
    found: dict[str, Value] = {}
    for text, value in values.items():
        if value is None:
            continue
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
        # Whole numbers may be too large for a float.
        size = float(value) if abs(value) <= LARGEST else math.inf
        number = checked(size, own, f"{size:g}", place)
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
                f'{path}: without a member "unit", the measurements are those of FreeSewing, which '
                f"has no {code!r}; {hint(code, FREESEWING_KEYS)}"
            )
        key = names.freesewing.get(code)
        if key is None:
            left.append(code)
        elif value:
            found[key] = value_of(key, value, Unit.MM.value, f"{path}: {code}", names)
    if left:
        notes.append(f"{path.name}: the chart has no {', '.join(left)}; left out")
    return Measurements(title, tuple(found.values()), None, tuple(notes))
