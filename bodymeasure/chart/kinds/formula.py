"""Measurements that follow from others by a formula."""

import math
from collections.abc import Mapping
from typing import ClassVar

from bodymeasure._typing import Array
from bodymeasure.chart.accuracy import AccuracyClass, length_class
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import FormulaText
from bodymeasure.chart.formula.parse import Formula, parse_formula
from bodymeasure.chart.formula.value import Estimate, evaluate_formula, formula_slopes
from bodymeasure.chart.kinds.base import Measured, MeasurementDefinition, Outcome
from bodymeasure.errors import InputError


class FormulaMeasure(MeasurementDefinition, frozen=True, kw_only=True, tag="formula"):
    """Arithmetic with other measurements.

    Parameters
    ----------
    formula : str
        Keys of other measurements, numbers, ``+ - * / ( )``, min and max.
    angle : bool
        Whether the result is in degrees and not a length; asin, acos and atan give angles.
    """

    may_be_negative: ClassVar[bool] = True
    example: ClassVar[str] = 'formula = "outer_leg_length_left - knee_height_left"'

    formula: FormulaText
    angle: bool = False

    @property
    def in_degrees(self) -> bool:
        return self.angle

    @property
    def accuracy_class(self) -> AccuracyClass | None:
        return None if self.angle else length_class(self.name)

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        formula = parse_formula(self.formula)
        operands = {name: others[name] for name in formula.names}
        used = [landmark for operand in operands.values() for landmark in operand.landmarks]
        landmarks = tuple(dict.fromkeys(used))
        failed = [name for name in formula.names if operands[name].outcome is not Outcome.MEASURED]
        if failed:
            # A formula is never evaluated without one of its operands.
            what = ", ".join(f"{name!r} ({operands[name].outcome})" for name in failed)
            return Measured(
                self,
                Outcome.MISSING_OPERAND,
                f"the formula {self.formula!r} lacks {what}: {operands[failed[0]].reason}",
                landmarks=landmarks,
            )
        estimates = {
            name: Estimate(operand.value, operand.error_estimate)
            for name, operand in operands.items()
        }
        costs = {
            name: Estimate(operand.value, operand.approximation_error)
            for name, operand in operands.items()
            if operand.approximation_error is not None
        }
        try:
            value, error = evaluate_formula(formula, estimates)
        except InputError as refusal:
            return Measured(self, Outcome.REFUSED, str(refusal), landmarks=landmarks)
        return Measured(
            self,
            Outcome.MEASURED,
            value=value,
            error_estimate=error,
            approximation_error=evaluate_formula(formula, costs).error if costs else None,
            mesh_difference=_on_mesh(formula, operands) - value if costs else None,
            surface_uncertainty=_surface(formula, operands),
            landmarks=landmarks,
            # Pictures show what the value is made of.
            tapes=tuple(tape for operand in operands.values() for tape in operand.tapes),
        )

    def slopes(
        self, body: Body, found: Measured, others: Mapping[str, Measured]
    ) -> Mapping[str, Array]:
        formula = parse_formula(self.formula)
        slopes: dict[str, Array] = {}
        for name, by in _partials(formula, others).items():
            for landmark, slope in others[name].slopes.items():
                slopes[landmark] = slopes.get(landmark, 0.0) + by * slope
        return slopes


def _partials(formula: Formula, others: Mapping[str, Measured]) -> Mapping[str, float]:
    return formula_slopes(
        formula, {name: Estimate(others[name].value, 0.0) for name in formula.names}
    )


def _surface(formula: Formula, operands: Mapping[str, Measured]) -> float:
    """Return the part of the uncertainty that comes from the surface below all operands."""
    partials = _partials(formula, operands)
    return math.hypot(*(by * operands[name].surface_uncertainty for name, by in partials.items()))


def _on_mesh(formula: Formula, operands: Mapping[str, Measured]) -> float:
    """Return the value on the mesh from which the patches were made, about; NaN if it has none."""
    estimates = {
        name: Estimate(operand.value + (operand.mesh_difference or 0.0), 0.0)
        for name, operand in operands.items()
    }
    try:
        return evaluate_formula(formula, estimates).value
    except InputError:
        return math.nan
