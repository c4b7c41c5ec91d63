"""Families of bodies: one that is varied, and the sizes of a table."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial

from bodymeasure.arguments import repeated, require_kind, require_progress, several, shown
from bodymeasure.atlas import Unit
from bodymeasure.chart import Definitions, load_definitions
from bodymeasure.errors import InputError
from bodymeasure.make.body.atlases import COUNT
from bodymeasure.make.input.measurements import Measurements, Value
from bodymeasure.make.input.names import Names
from bodymeasure.make.input.numbers import parsed
from bodymeasure.make.make import TOLERANCE, check_settings, make_body, measurements_from
from bodymeasure.make.result import MadeBody
from bodymeasure.report.units import DEGREES
from bodymeasure.threads import one_blas_thread


@one_blas_thread()
def make_sizes(
    sizes: Sequence[Measurements],
    *,
    sex: str | None = None,
    age: float | None = None,
    definitions: Definitions | None = None,
    tolerance: float = TOLERANCE,
    components: int = COUNT,
    despite_doubts: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> dict[str, MadeBody]:
    r"""Make a body for each size of a table, or each person of a list.

    Parameters
    ----------
    sizes : sequence of Measurements
        What `read_measurements` returns, each with a name of its own.
    sex, age, definitions, tolerance, components, despite_doubts
        As in `make_body`.
    progress : callable, optional
        Called with the number of bodies made so far, and the number of all.

    Returns
    -------
    dict of str to MadeBody
        By name, in the order of the sizes. `grade_pattern` takes their atlases.

    Raises
    ------
    InputError
        As `make_body`, with the name of the size; or if two have one name.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> table = "size;bust (cm);waist (cm);hip (cm)\n38;88;72;97\n42;96;80;105\n"
    >>> with TemporaryDirectory() as folder:
    ...     path = Path(folder) / "sizes.csv"
    ...     _ = path.write_text(table)
    ...     roll = bm.make_sizes(bm.read_measurements(path), sex="female")
    >>> [round(body.asked[0].found, 2) for body in roll.values()]
    [88.0, 96.0]
    """
    require_progress(progress)
    sizes = several(sizes, Measurements, "sizes", "what read_measurements returns")
    if (twice := repeated(size.name for size in sizes)) is not None:
        raise InputError(f"two sizes have the name {twice!r}; give each a name of its own")
    making = partial(
        make_body,
        sex=sex,
        age=age,
        definitions=definitions,
        tolerance=tolerance,
        components=components,
        despite_doubts=despite_doubts,
    )
    made: dict[str, MadeBody] = {}
    for size in sizes:
        made[size.name] = making(size)
        if progress is not None:
            progress(len(made), len(sizes))
    return made


@one_blas_thread()
def grade_body(
    values: Mapping[str, float | str] | Measurements,
    vary: Mapping[str, Sequence[str]],
    *,
    unit: Unit | str | None = None,
    sex: str | None = None,
    age: float | None = None,
    definitions: Definitions | None = None,
    tolerance: float = TOLERANCE,
    components: int = COUNT,
    despite_doubts: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> dict[str, MadeBody]:
    """Make a body and its variations: the same measurements but for some that are changed.

    Parameters
    ----------
    values : mapping of str to float or str, or Measurements
        Those of the first body, as in `make_body`.
    vary : mapping of str to sequence of str
        Changes of measurements by their keys, such as ``{"bust_girth": ["+4cm", "+8cm"]}``. A
        measurement that is not among the values is changed from what the first body has. Several
        measurements are changed together, the first change of each for the second body, and so on,
        and so they have the same number of changes.
    unit, sex, age, definitions, tolerance, components, despite_doubts
        As in `make_body`.
    progress : callable, optional
        Called with the number of bodies made so far, and the number of all.

    Returns
    -------
    dict of str to MadeBody
        The first one is named ``base``, the others by their changes.

    Raises
    ------
    InputError
        As `make_body`; or if a change is not a signed length, or the numbers of changes differ.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> values = {"bust_girth": 88, "waist_girth": 72, "hip_girth": 97}
    >>> family = bm.grade_body(values, {"bust_girth": ["+4cm", "+8cm"]}, unit="cm")
    >>> list(family)
    ['base', 'bust_girth+4cm', 'bust_girth+8cm']
    >>> [round(body.asked[0].found, 2) for body in family.values()]
    [88.0, 92.0, 96.0]
    """
    require_progress(progress)
    definitions = load_definitions() if definitions is None else definitions
    require_kind(definitions, Definitions, "definitions", "what load_definitions returns")
    wanted = measurements_from(values, definitions, unit)
    check_settings(tolerance, components)
    changes = changes_of(vary, definitions)
    count = 1 + len(next(iter(changes.values())))
    making = partial(
        make_body,
        sex=sex,
        age=age,
        definitions=definitions,
        tolerance=tolerance,
        components=components,
        despite_doubts=despite_doubts,
    )
    base = making(wanted, name=f"{wanted.name} base".strip())
    made = {"base": base}
    if progress is not None:
        progress(1, count)
    start = {value.key: value for value in wanted.values}
    absent = [key for key in changes if key not in start]
    for one in base.predicted(absent) if absent else ():
        start[one.key] = Value(one.key, one.value, DEGREES if one.unit == DEGREES else "m")
    for number in range(count - 1):
        change = {key: each[number] for key, each in changes.items()}
        name = ",".join(f"{key}{text}" for key, (text, _) in change.items())
        changed = replace(wanted, values=_changed(start, change), name=name)
        try:
            made[name] = making(changed, name=f"{wanted.name} {name}".strip())
        except InputError as error:
            raise InputError(f"{error}; the first body is possible, so change it by less") from None
        if progress is not None:
            progress(len(made), count)
    return made


def _changed(
    start: Mapping[str, Value], change: Mapping[str, tuple[str, float]]
) -> tuple[Value, ...]:
    """Return values of which some are changed, each by its key, in words and meters or degrees."""
    found = dict(start)
    for key, (text, by) in change.items():
        old = start[key]
        value = old.value + by * old.factor
        if value <= 0.0 and old.unit != DEGREES:
            raise InputError(
                f"vary: {key} is {old.written(old.base)}, of which {text} leaves nothing; change "
                "it by less"
            )
        found[key] = replace(old, value=value)
    return tuple(found.values())


def changes_of(
    vary: Mapping[str, Sequence[str]], definitions: Definitions
) -> dict[str, list[tuple[str, float]]]:
    """Return changes in words, and in meters or degrees, by the keys of measurements.

    Raises
    ------
    InputError
        If there are none, a measurement is unknown, a change has no sign or no unit, or the numbers
        of changes differ.
    """
    if not isinstance(vary, Mapping):
        raise InputError(f"vary is {shown(vary)}; expected a mapping of keys to lists of changes")
    names, found = Names(definitions), dict[str, list[tuple[str, float]]]()
    for text, changes in vary.items():
        require_kind(text, str, "vary: a measurement", "its key, a str")
        key = names.find(text, "vary")
        if key in found:
            raise InputError(f"vary: {key!r} is given a second time, as {text!r}; keep one")
        changes = several(changes, str, f"vary: {text}", "a change, such as '+4cm'")
        found[key] = [_change(change, f"vary: {text}", key, names) for change in changes]
    lengths = {len(each) for each in found.values()}
    if not found or 0 in lengths:
        raise InputError("vary holds no change; expected one such as bust_girth=+4cm,+8cm")
    if len(lengths) > 1:
        listed = ", ".join(f"{key} {len(each)}" for key, each in found.items())
        raise InputError(
            f"vary: the numbers of changes differ ({listed}); give each measurement as many"
        )
    together = list(zip(*found.values(), strict=True))
    for number, each_one in enumerate(together):
        if each_one in together[:number]:
            words = ", ".join(f"{key}{each[0]}" for key, each in zip(found, each_one, strict=True))
            raise InputError(f"vary: {words} comes a second time; keep one")
    return found


def _change(text: str, place: str, key: str, names: Names) -> tuple[str, float]:
    plain = "".join(text.split())
    if plain[:1] not in ("+", "-"):
        raise InputError(f"{place}: {text!r} has no sign; expected a change such as +4cm or -2cm")
    angle = names.by_key[key].in_degrees
    number, unit = parsed(plain[1:], DEGREES if angle else None, place)
    if (unit == DEGREES) != angle:
        raise InputError(
            f"{place}: {text!r} is in {unit}; expected {'deg' if angle else 'a length'}"
        )
    by = number if angle else number * Unit.parse(unit).meters
    return plain, by if plain[0] == "+" else -by
