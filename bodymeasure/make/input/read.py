"""Reading the measurements that bodies are to have."""

from collections.abc import Sequence
from dataclasses import replace
from os import PathLike
from pathlib import Path

import msgspec

from bodymeasure.arguments import file_path, require_kind, several
from bodymeasure.chart import Definitions, load_definitions, selected_keys
from bodymeasure.compare import Reading, read_readings
from bodymeasure.errors import InputError
from bodymeasure.files import read_bytes
from bodymeasure.make.body.measuring import can_be_asked
from bodymeasure.make.input.json_files import measurements_of_json, value_of
from bodymeasure.make.input.measurements import Measurements, Value
from bodymeasure.make.input.names import Names
from bodymeasure.make.input.seamly import measurements_of_seamly
from bodymeasure.make.input.table import is_size_table, measurements_of_table
from bodymeasure.report.body.records import SCHEMA as CHART
from bodymeasure.report.population.records import SCHEMA as CHARTS

SUFFIXES = (".smis", ".vit", ".json", ".csv")


def read_measurements(
    path: str | PathLike[str],
    *,
    definitions: Definitions | None = None,
    unit: str | None = None,
    only: Sequence[str] = (),
) -> tuple[Measurements, ...]:
    r"""Read the measurements that one body, or several, are to have.

    Parameters
    ----------
    path : path-like
        By its extension: ``.smis`` of SeamlyMe or ``.vit`` of Valentina; ``.json`` of FreeSewing,
        of a chart, or ``{"unit": "cm", "measurements": {"waist_girth": 72}}``; ``.csv`` with the
        columns measurement, value and unit, and subject if there are several, or a table of sizes
        with one row for each and the measurements as columns.
    definitions : Definitions, optional
        The set that the measurements belong to; the default set if not given.
    unit : {"m", "cm", "mm", "inch"}, optional
        Unit of the lengths of a CSV file that say none.
    only : sequence of str
        The measurements to take, all if none are given: keys, keys without ``_left`` or
        ``_right``, which stand for both, and names of the set's presets, such as ``core``.

    Returns
    -------
    tuple of Measurements
        One for each body.

    Raises
    ------
    InputError
        If the file is not as expected; the message gives the place and what to do.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     path = Path(folder) / "ann.csv"
    ...     _ = path.write_text("measurement,value,unit\nwaist_girth,72,cm\n")
    ...     (ann,) = bm.read_measurements(path)
    >>> ann, ann.values[0].key
    (<Measurements of 'ann': 1 value>, 'waist_girth')
    """
    path = file_path(path)
    chosen = load_definitions() if definitions is None else definitions
    require_kind(chosen, Definitions, "definitions", "what load_definitions returns")
    names = Names(chosen)
    keys = selected_keys(chosen, several(only, str, "only", "the key of a measurement"))
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise InputError(f"{path}: expected a name that ends in one of {', '.join(SUFFIXES)}")
    content = read_bytes(path)
    written_by_hand = False
    found: tuple[Measurements, ...]
    if suffix in (".smis", ".vit"):
        found = (measurements_of_seamly(content, path, names),)
    elif suffix == ".json" and not _is_chart(content):
        found = (measurements_of_json(content, path, names),)
    elif suffix == ".csv" and is_size_table(content):
        found = measurements_of_table(content, path, names, unit)
        written_by_hand = True
    else:
        found = _of_readings(path, names, unit)
        written_by_hand = suffix == ".csv"
    if not written_by_hand:
        # The files of programs hold what bodies cannot be asked for; a person's list should not.
        found = tuple(_without_others(one, chosen) for one in found)
    if keys:
        found = tuple(
            replace(one, values=tuple(value for value in one.values if value.key in keys))
            for one in found
        )
    for one in found:
        if not one.values:
            raise InputError(f"{path}: {one.name!r} has no value that a body can be made from")
    return found


class _Head(msgspec.Struct):
    schema: str = ""


def _is_chart(content: bytes) -> bool:
    try:
        return msgspec.json.decode(content, type=_Head).schema in (CHART, CHARTS)
    except msgspec.DecodeError:
        return False


def _of_readings(path: Path, names: Names, unit: str | None) -> tuple[Measurements, ...]:
    readings = read_readings(path, unit)
    by_subject: dict[str, dict[str, Value]] = {name: {} for name in readings.subjects}
    for reading in readings.values:
        if reading.value is None:
            continue
        value = _value(reading, names)
        mine = by_subject[reading.subject]
        if value.key in mine:
            raise InputError(
                f"{reading.place}: {value.key!r} is given a second time; keep one of the two, or "
                "name the subjects in a column subject"
            )
        mine[value.key] = value
    return tuple(
        Measurements(subject or path.stem, tuple(values.values()))
        for subject, values in by_subject.items()
    )


def _value(reading: Reading, names: Names) -> Value:
    key = names.find(reading.measurement, reading.place)
    return value_of(key, reading.value, reading.unit, reading.place, names)


def _without_others(found: Measurements, definitions: Definitions) -> Measurements:
    """Return measurements without those that bodies cannot be asked for, with a note on them."""
    kept = tuple(one for one in found.values if can_be_asked(definitions, one.key))
    others = [one.key for one in found.values if one not in kept]
    if not others:
        return found
    note = f"left out, since bodies cannot be asked for it: {', '.join(others)}"
    return replace(found, values=kept, notes=(*found.notes, note))
