"""The landmarks that a set of definitions needs."""

from collections.abc import Collection, Sequence
from typing import NamedTuple

from bodymeasure.chart.definitions import Definitions
from bodymeasure.chart.kinds.base import MeasurementDefinition
from bodymeasure.chart.sides import both_sides


class Lacking(NamedTuple):
    """A measurement that cannot be taken.

    Parameters
    ----------
    measurement : MeasurementDefinition
    landmarks : tuple of str
        The landmarks that it lacks; a formula lacks those of its operands.
    """

    measurement: MeasurementDefinition
    landmarks: tuple[str, ...]


def names_in(definitions: Definitions) -> frozenset[str]:
    """Return the names of all landmarks that a set's measurements and rules name or give."""
    rules, measurements = both_sides(definitions.landmark), both_sides(definitions.measurement)
    needed = [name for entry in (*rules, *measurements) for name in entry.landmarks]
    return frozenset([*(rule.name for rule in rules), *needed])


def lacking(
    measurements: Sequence[MeasurementDefinition], there: Collection[str]
) -> tuple[Lacking, ...]:
    """Return the measurements whose landmarks are not all there.

    Parameters
    ----------
    measurements : sequence of MeasurementDefinition
        Definitions with ``{side}`` stand for a left and a right one.
    there : collection of str
        Names of the landmarks that a body has.
    """
    every = {measurement.key: measurement for measurement in both_sides(measurements)}
    needs: dict[str, tuple[str, ...]] = {}

    def needed(key: str) -> tuple[str, ...]:
        if key not in needs:
            needs[key] = ()
            one = every[key]
            names = [*one.landmarks, *(name for other in one.operands for name in needed(other))]
            needs[key] = tuple(dict.fromkeys(names))
        return needs[key]

    result = []
    for key, measurement in every.items():
        names = tuple(name for name in needed(key) if name not in there)
        if names:
            result.append(Lacking(measurement, names))
    return tuple(result)
