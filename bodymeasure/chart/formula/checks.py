"""What has to hold for the formulas of a set of definitions."""

import graphlib
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import msgspec

from bodymeasure.chart.formula.parse import Formula, parse_formula
from bodymeasure.chart.formula.quantity import Quantity, quantity_of
from bodymeasure.chart.kinds.definitions import FormulaMeasure, Measurement
from bodymeasure.chart.reading.sides import both_sides
from bodymeasure.errors import InputError
from bodymeasure.wording import hint


class Fault(NamedTuple):
    """What is wrong with one definition.

    Parameters
    ----------
    definition : msgspec.Struct
        As it stands in the set: with ``{side}``.
    member : str
        The member at fault; empty for the whole.
    words : str
    """

    definition: msgspec.Struct
    member: str
    words: str


def formula_faults(measurements: Sequence[Measurement]) -> Iterator[Fault]:
    """The first thing that is wrong with the formulas of a set, if anything is.

    Parameters
    ----------
    measurements : sequence of Measurement
        As they stand in the set: with ``{side}``.
    """
    every = {one.key: one for one in both_sides(measurements)}
    written = {one.key: each for each in measurements for one in both_sides([each])}
    for key, words in _faults(every):
        yield Fault(written[key], "formula", words)
        return


def _faults(every: Mapping[str, Measurement]) -> Iterator[tuple[str, str]]:
    """Keys of measurements whose formula is at fault, and what is wrong with it."""
    measures = {key: one for key, one in every.items() if isinstance(one, FormulaMeasure)}
    formulas: dict[str, Formula] = {}
    for key, one in measures.items():
        try:
            formulas[key] = parse_formula(one.formula)
        except InputError as error:
            yield key, str(error)
            return
        for name in formulas[key].names:
            if name not in every:
                words = f"the formula {one.formula!r} names {name!r}, which is no key here"
                yield key, f"{words}; {_key_hint(name, every)}"
    try:
        order = evaluation_order(formulas)
    except graphlib.CycleError as error:
        circle = error.args[1]
        words = f"the formulas go round in a circle: {' -> '.join(reversed(circle))}"
        yield circle[0], f"{words}; define one of them by landmarks"
        return
    quantities = dict.fromkeys(every, Quantity.LENGTH)
    for key in order:
        wanted = Quantity.ANGLE if measures[key].angle else Quantity.LENGTH
        try:
            quantities[key] = quantity_of(formulas[key], quantities)
        except InputError as error:
            yield key, str(error)
            return
        if quantities[key] is not wanted:
            yield key, _wrong_quantity(measures[key], quantities[key], wanted)


def _key_hint(name: str, known: Mapping[str, Measurement]) -> str:
    near = hint(name, known)
    return near if near.startswith("did you mean") else "name measurements by their keys"


def _wrong_quantity(one: FormulaMeasure, found: Quantity, wanted: Quantity) -> str:
    remedy = "say `angle = true`" if found is Quantity.ANGLE else "change the formula"
    return f"the formula {one.formula!r} has mixed units: it gives {found}, not {wanted}; {remedy}"


def evaluation_order(formulas: Mapping[str, Formula]) -> tuple[str, ...]:
    """Keys of formulas, each after those that it needs.

    Raises
    ------
    graphlib.CycleError
        If they need one another in a circle.
    """
    needs = {
        key: [name for name in formula.names if name in formulas]
        for key, formula in formulas.items()
    }
    return tuple(graphlib.TopologicalSorter(needs).static_order())
