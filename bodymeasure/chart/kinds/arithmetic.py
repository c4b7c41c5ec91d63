"""Measurements that follow from others by a formula."""

from collections.abc import Mapping

from bodymeasure.chart.chart import Measured, Outcome
from bodymeasure.chart.formula.parse import parse_formula
from bodymeasure.chart.formula.value import Estimate, evaluate_formula
from bodymeasure.chart.kinds.definitions import FormulaMeasure
from bodymeasure.errors import InputError


def measure_formula(definition: FormulaMeasure, measured: Mapping[str, Measured]) -> Measured:
    """A formula's value; missing if an operand is, never evaluated without it.

    Parameters
    ----------
    definition : FormulaMeasure
    measured : mapping of str to Measured
        Operands by key.
    """
    formula = parse_formula(definition.formula)
    operands = {name: measured[name] for name in formula.names}
    used = [landmark for operand in operands.values() for landmark in operand.landmarks]
    landmarks = tuple(dict.fromkeys(used))
    failed = [name for name in formula.names if operands[name].outcome is not Outcome.MEASURED]
    if failed:
        what = ", ".join(f"{name!r} ({operands[name].outcome})" for name in failed)
        one = operands[failed[0]]
        return Measured(
            definition,
            Outcome.MISSING_OPERAND,
            f"the formula {definition.formula!r} lacks {what}: {one.reason}",
            landmarks=landmarks,
        )
    estimates = {
        name: Estimate(operand.value, operand.error_estimate) for name, operand in operands.items()
    }
    try:
        value, error = evaluate_formula(formula, estimates)
    except InputError as refusal:
        return Measured(definition, Outcome.REFUSED, str(refusal), landmarks=landmarks)
    return Measured(
        definition, Outcome.MEASURED, value=value, error_estimate=error, landmarks=landmarks
    )
