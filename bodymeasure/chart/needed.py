"""The landmarks that a set of definitions needs."""

from collections.abc import Collection, Sequence
from typing import NamedTuple

from bodymeasure.chart.definitions import Definitions
from bodymeasure.chart.kinds.base import MeasurementDefinition
from bodymeasure.chart.sides import both_sides


class Pick(NamedTuple):
    """Landmarks that are to be picked together, and what that gains.

    Parameters
    ----------
    landmarks : tuple of str
    measurements : tuple of MeasurementDefinition
        Those that lack these landmarks and no others.
    """

    landmarks: tuple[str, ...]
    measurements: tuple[MeasurementDefinition, ...]


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
    every = {one.key: one for one in both_sides(measurements)}
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
        # A body without a head is no worse for it.
        if names and not measurement.optional:
            result.append(Lacking(measurement, names))
    return tuple(result)


def worth_picking(
    definitions: Definitions, there: Collection[str], keys: Collection[str] | None = None
) -> tuple[Pick, ...]:
    """Return the landmarks that a body lacks, with the measurements that picking them gains.

    A rule that needs a landmark which is not there waits for that one, so that many measurements
    may wait for a single point.

    Parameters
    ----------
    definitions : Definitions
    there : collection of str
        Names of the landmarks that a body has, by rule or as picked.
    keys : collection of str, optional
        The keys of the measurements that are wanted; all if not given.

    Returns
    -------
    tuple of Pick
        The most worthwhile come first.
    """
    rules = {rule.name: rule for rule in both_sides(definitions.landmark)}
    causes: dict[str, tuple[str, ...]] = {}

    def cause(name: str) -> tuple[str, ...]:
        if name not in causes:
            causes[name] = (name,)
            needs = rules[name].landmarks if name in rules else ()
            missing = [other for other in needs if other not in there]
            if missing:
                every = [one for other in missing for one in cause(other)]
                causes[name] = tuple(dict.fromkeys(every))
        return causes[name]

    gained: dict[frozenset[str], list[MeasurementDefinition]] = {}
    order: dict[frozenset[str], tuple[str, ...]] = {}
    for measurement, landmarks in lacking(definitions.measurement, there):
        if keys is not None and measurement.key not in keys:
            continue
        names = tuple(dict.fromkeys(one for name in landmarks for one in cause(name)))
        order.setdefault(frozenset(names), names)
        gained.setdefault(frozenset(names), []).append(measurement)
    picks = [Pick(order[names], tuple(found)) for names, found in gained.items()]
    return tuple(sorted(picks, key=lambda pick: (len(pick.landmarks), -len(pick.measurements))))
