"""The derivative of each kind of measurement with respect to the control points."""

from collections.abc import Callable, Mapping
from typing import Any

from bodymeasure.chart.body import Body
from bodymeasure.chart.formula.parse import parse_formula
from bodymeasure.chart.formula.value import Estimate, formula_slopes
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition
from bodymeasure.chart.kinds.formula import FormulaMeasure
from bodymeasure.chart.kinds.girths.extreme_girth import ExtremeGirthMeasure
from bodymeasure.chart.kinds.girths.girth import GirthMeasure
from bodymeasure.chart.kinds.girths.girth_arc import GirthArcMeasure
from bodymeasure.chart.kinds.girths.limb_girth import LimbGirthMeasure
from bodymeasure.chart.kinds.girths.tilted_girth import TiltedGirthMeasure
from bodymeasure.chart.kinds.straight.breadth import BreadthMeasure
from bodymeasure.chart.kinds.straight.chord import ChordMeasure
from bodymeasure.chart.kinds.straight.depth import DepthMeasure
from bodymeasure.chart.kinds.straight.height import HeightMeasure
from bodymeasure.chart.kinds.surface.closed import ClosedMeasure
from bodymeasure.chart.kinds.surface.drop import DropMeasure
from bodymeasure.chart.kinds.surface.over import OverMeasure
from bodymeasure.chart.kinds.surface.path import PathMeasure
from bodymeasure.chart.landmarks.derive import Derived
from bodymeasure.make.gradient.arcs import pull_girth_arc
from bodymeasure.make.gradient.drops import pull_drop, pull_over
from bodymeasure.make.gradient.girths import (
    pull_extreme_girth,
    pull_girth,
    pull_limb_girth,
    pull_tilted_girth,
)
from bodymeasure.make.gradient.paths import pull_closed, pull_path
from bodymeasure.make.gradient.pull import Pull
from bodymeasure.make.gradient.rules import pull_rule
from bodymeasure.make.gradient.straight import pull_breadth, pull_depth, pull_slopes

KINDS: dict[type[MeasurementDefinition], Callable[[Pull, Body, Measured, Any], None]] = {
    BreadthMeasure: pull_breadth,
    ChordMeasure: pull_slopes,
    ClosedMeasure: pull_closed,
    DepthMeasure: pull_depth,
    DropMeasure: pull_drop,
    ExtremeGirthMeasure: pull_extreme_girth,
    GirthArcMeasure: pull_girth_arc,
    GirthMeasure: pull_girth,
    HeightMeasure: pull_slopes,
    LimbGirthMeasure: pull_limb_girth,
    OverMeasure: pull_over,
    PathMeasure: pull_path,
    TiltedGirthMeasure: pull_tilted_girth,
}
"""What adds the derivative of a measurement, by its kind; formulas are made of others."""


def has_gradient(definition: MeasurementDefinition) -> bool:
    """Return whether measurements of a kind have a derivative."""
    return isinstance(definition, (*KINDS, FormulaMeasure))


def gradient_of(key: str, taken: Mapping[str, Measured], body: Body, derived: Derived) -> Pull:
    """Return the derivative of a measurement with respect to the control points.

    Parameters
    ----------
    key : str
    taken : mapping of str to Measured
        The measurements of the body, those that formulas name among them.
    body : Body
    derived : Derived
        Its landmarks, with the rules of those that follow from others.

    Returns
    -------
    Pull
        Of control points, and of lengths that are given with the body.
    """
    pull = Pull.on(body.atlas)
    _pull(pull, key, taken, body)
    # Each rule comes after those whose landmarks it needs.
    for name in reversed(list(derived.rules)):
        if name in pull.landmarks:
            pull_rule(pull, body, derived.rules[name], pull.landmarks.pop(name))
    for name, vector in pull.landmarks.items():
        pull.point(body.point(name), vector)
    return pull


def _pull(pull: Pull, key: str, taken: Mapping[str, Measured], body: Body) -> None:
    found = taken[key]
    definition = found.definition
    if isinstance(definition, FormulaMeasure):
        formula = parse_formula(definition.formula)
        values = {name: Estimate(taken[name].value, 0.0) for name in formula.names}
        for name, slope in formula_slopes(formula, values).items():
            part = Pull.on(pull.atlas)
            _pull(part, name, taken, body)
            pull.add(part, slope)
        return
    if key in body.atlas.given and any(n not in body.landmarks for n in definition.landmarks):
        pull.given[key] = pull.given.get(key, 0.0) + 1.0
        return
    KINDS[type(definition)](pull, body, found, definition)
