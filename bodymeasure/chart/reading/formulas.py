"""Checks of the formulas of a set of definitions."""

import graphlib
from collections.abc import Iterator, Mapping, Sequence

from bodymeasure.chart.entry import Fault, texts
from bodymeasure.chart.formula.parse import parse_formula
from bodymeasure.chart.formula.quantity import Quantity, quantity_of
from bodymeasure.chart.kinds.base import MeasurementDefinition
from bodymeasure.chart.sides import both_sides
from bodymeasure.errors import InputError
from bodymeasure.wording import hint


def formula_fault(measurements: Sequence[MeasurementDefinition]) -> Fault | None:
    """Return the first fault of the formulas of a set; None if they have none.

    Parameters
    ----------
    measurements : sequence of MeasurementDefinition
        As they stand in the set, with ``{side}``.
    """
    every = {one.key: one for one in both_sides(measurements)}
    written = {one.key: each for each in measurements for one in both_sides([each])}
    for key, text, words in _faults(every):
        member = next(name for name, other in texts(every[key]) if other == text)
        return Fault(written[key], member, words)
    return None


def _faults(
    every: Mapping[str, MeasurementDefinition],
) -> Iterator[tuple[str, str, str]]:
    """Yield the keys of measurements whose formula is at fault, the formula and its fault."""
    for key, one in every.items():
        for text in one.formulas:
            try:
                names = parse_formula(text).names
            except InputError as error:
                yield key, text, str(error)
                return
            for name in names:
                if name not in every:
                    words = f"the formula {text!r} names {name!r}, which is no key here"
                    yield key, text, f"{words}; {_key_hint(name, every)}"
    try:
        order = _evaluation_order(every)
    except graphlib.CycleError as error:
        circle = error.args[1]
        words = f"the formulas go round in a circle: {' -> '.join(reversed(circle))}"
        text = every[circle[0]].formulas[0]
        yield circle[0], text, f"{words}; define one of them by landmarks"
        return
    quantities: dict[str, Quantity] = {}
    for key in order:
        one = every[key]
        quantities[key] = Quantity.ANGLE if one.in_degrees else Quantity.LENGTH
        for text in one.formulas:
            try:
                found = quantity_of(parse_formula(text), quantities)
            except InputError as error:
                yield key, text, str(error)
                return
            if found is not quantities[key]:
                yield key, text, _wrong_quantity(text, found, quantities[key])


def _evaluation_order(every: Mapping[str, MeasurementDefinition]) -> tuple[str, ...]:
    """Return the keys of measurements, each after those that its formulas need.

    Raises
    ------
    graphlib.CycleError
        If formulas need one another in a circle.
    """
    needs = {key: one.operands for key, one in every.items()}
    return tuple(graphlib.TopologicalSorter(needs).static_order())


def _key_hint(name: str, known: Mapping[str, MeasurementDefinition]) -> str:
    near = hint(name, known)
    return near if near.startswith("did you mean") else "name measurements by their keys"


def _wrong_quantity(text: str, found: Quantity, wanted: Quantity) -> str:
    remedy = "say `angle = true`" if found is Quantity.ANGLE else "change the formula"
    return f"the formula {text!r} has mixed units: it gives {found}, not {wanted}; {remedy}"
