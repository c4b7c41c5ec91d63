"""The choice of a few measurements of a set, by their keys or by the set's presets."""

from collections.abc import Iterable, Sequence

from msgspec.structs import replace

from bodymeasure.chart.definitions import Definitions
from bodymeasure.chart.kinds.base import MeasurementDefinition
from bodymeasure.chart.landmarks.rules.base import LandmarkRule
from bodymeasure.chart.sides import SIDE, both_sides
from bodymeasure.errors import InputError
from bodymeasure.wording import hint


def selected_keys(definitions: Definitions, names: Sequence[str]) -> tuple[str, ...]:
    """Return the keys of the measurements that names stand for, in the order of the set.

    Parameters
    ----------
    definitions : Definitions
    names : sequence of str
        Each is a key, a key without its ``_left`` or ``_right``, which stands for both, or the name
        of a preset of the set.

    Raises
    ------
    InputError
        If there is no such measurement or preset; the message suggests the nearest name.

    Examples
    --------
    >>> from bodymeasure.chart import load_definitions
    >>> selected_keys(load_definitions(), ["waist_girth", "knee_girth"])
    ('waist_girth', 'knee_girth_left', 'knee_girth_right')
    """
    meant = _meanings(definitions)
    wanted: set[str] = set()
    for name in names:
        found = meant.get(name.removesuffix(f"_{SIDE}"))
        if found is None:
            known = [*definitions.presets, *meant]
            raise InputError(
                f"{definitions.name!r} has no measurement and no preset {name!r}; "
                f"{hint(name, known)}"
            )
        wanted.update(found)
    return tuple(one.key for one in both_sides(definitions.measurement) if one.key in wanted)


def _meanings(definitions: Definitions) -> dict[str, tuple[str, ...]]:
    """Return the keys of measurements by all names that may stand for them."""
    keys = [one.key for one in both_sides(definitions.measurement)]
    meant: dict[str, tuple[str, ...]] = {}
    for key in keys:
        plain = key.removesuffix("_left").removesuffix("_right")
        meant[plain] = (*meant.get(plain, ()), key)
    meant |= {key: (key,) for key in keys}
    for name, members in definitions.presets.items():
        # What a set drops is no longer in the presets that it extends.
        every = (meant.get(member, ()) for member in members)
        meant[name] = tuple(key for keys in every for key in keys)
    return meant


def with_operands(
    every: Iterable[MeasurementDefinition], keys: Sequence[str]
) -> tuple[MeasurementDefinition, ...]:
    """Return the measurements of some keys, and those that their formulas need.

    Parameters
    ----------
    every : iterable of MeasurementDefinition
        With left or right in place of ``{side}``.
    keys : sequence of str
    """
    by_key = {one.key: one for one in every}
    needed: dict[str, None] = {}
    queue = list(keys)
    while queue:
        key = queue.pop()
        if key in by_key and key not in needed:
            needed[key] = None
            queue += by_key[key].operands
    return tuple(one for key, one in by_key.items() if key in needed)


def needed_rules(
    rules: Iterable[LandmarkRule], measurements: Iterable[MeasurementDefinition]
) -> tuple[LandmarkRule, ...]:
    """Return the rules for the landmarks of some measurements, and those that these rules need."""
    by_name = {rule.name: rule for rule in both_sides(rules)}
    needed: set[str] = set()
    queue = [name for one in measurements for name in one.landmarks]
    while queue:
        name = queue.pop()
        if name in by_name and name not in needed:
            needed.add(name)
            queue += by_name[name].landmarks
    return tuple(rule for name, rule in by_name.items() if name in needed)


def restricted(definitions: Definitions, names: Sequence[str]) -> tuple[Definitions, Definitions]:
    """Return the part of a set that names stand for, and the part that is needed to measure it.

    Parameters
    ----------
    definitions : Definitions
    names : sequence of str
        As for `selected_keys`; none of them stand for the whole set.
    """
    if not names:
        return definitions, definitions
    keys = selected_keys(definitions, names)
    every = with_operands(both_sides(definitions.measurement), keys)
    rules = needed_rules(definitions.landmark, every)
    needed = replace(definitions, landmark=rules, measurement=every)
    chosen = tuple(one for one in every if one.key in keys)
    return replace(needed, measurement=chosen), needed
