"""Which landmarks measurements need."""

from collections.abc import Collection, Sequence
from typing import NamedTuple

from bodymeasure.chart.formula.parse import parse_formula
from bodymeasure.chart.kinds.definitions import Definitions, FormulaMeasure, Measurement
from bodymeasure.chart.landmarks.order import references
from bodymeasure.chart.reading.sides import both_sides

# Members of measurements that name landmarks.
MEMBERS = ("through", "start", "end", "at", "level", "above", "front", "back", "cut", "over")


class Lacking(NamedTuple):
    """A measurement that cannot be taken.

    Parameters
    ----------
    measurement : Measurement
    landmarks : tuple of str
        Those that it lacks; a formula lacks those of its operands.
    """

    measurement: Measurement
    landmarks: tuple[str, ...]


def names_in(definitions: Definitions) -> frozenset[str]:
    """Names of all landmarks that a set's measurements and rules refer to or give."""
    rules, measurements = both_sides(definitions.landmark), both_sides(definitions.measurement)
    given = [rule.name for rule in rules]
    needed = [name for rule in rules for name in references(rule)]
    return frozenset(
        [*given, *needed, *(name for one in measurements for name in landmarks_of(one))]
    )


def landmarks_of(measurement: Measurement) -> tuple[str, ...]:
    """Names of the landmarks that a measurement refers to, each once."""
    names: list[str] = []
    for member in MEMBERS:
        value = getattr(measurement, member, None)
        names += [value] if isinstance(value, str) else value if isinstance(value, tuple) else []
    return tuple(dict.fromkeys(names))


def lacking(measurements: Sequence[Measurement], there: Collection[str]) -> tuple[Lacking, ...]:
    """Measurements whose landmarks are not all there.

    Parameters
    ----------
    measurements : sequence of Measurement
        Those with ``{side}`` stand for a left and a right one.
    there : collection of str
        Names of the landmarks that a body has.
    """
    every = {measurement.key: measurement for measurement in both_sides(measurements)}
    needs: dict[str, tuple[str, ...]] = {}

    def needed(key: str) -> tuple[str, ...]:
        if key not in needs:
            needs[key] = ()
            own = landmarks_of(every[key])
            measurement = every[key]
            if isinstance(measurement, FormulaMeasure):
                operands = parse_formula(measurement.formula).names
                own = tuple(name for operand in operands for name in needed(operand))
            needs[key] = tuple(dict.fromkeys(own))
        return needs[key]

    result = []
    for key, measurement in every.items():
        names = tuple(name for name in needed(key) if name not in there)
        if names:
            result.append(Lacking(measurement, names))
    return tuple(result)
