"""The value of a formula, and its error."""

import ast
import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

from bodymeasure.chart.formula.parse import ANGLE_FUNCTIONS, Formula, formula_fault


class Estimate(NamedTuple):
    """A value and its error."""

    value: float
    error: float


class _Dual(NamedTuple):
    """A value and its partial derivatives with respect to the operands."""

    value: float
    slopes: dict[str, float]


def evaluate_formula(formula: Formula, operands: Mapping[str, Estimate]) -> Estimate:
    """Return the value of a formula, and the error that follows from those of its operands.

    Parameters
    ----------
    formula : Formula
    operands : mapping of str to Estimate
        The value of each of `formula.names`; angles are in degrees.

    Returns
    -------
    Estimate
        The error is the sum of the operands' errors, each times the absolute value of the formula's
        partial derivative with respect to that operand.

    Raises
    ------
    InputError
        If it divides by zero, or has no finite value for these operands.
    """
    value, slopes = _visit(formula.tree, formula.text, operands)
    error = 0.0
    for name, slope in slopes.items():
        # An infinite slope does no harm if the operand is exact.
        error += abs(slope) * operands[name].error if operands[name].error else 0.0
    if not math.isfinite(value):
        raise formula_fault(formula.text, "has no finite value for these measurements")
    return Estimate(value, error)


def formula_slopes(formula: Formula, operands: Mapping[str, Estimate]) -> Mapping[str, float]:
    """Return the partial derivatives of a formula with respect to its operands.

    Those of an angle are in degrees for each unit of length.
    """
    return _visit(formula.tree, formula.text, operands).slopes


def _visit(node: ast.expr, text: str, operands: Mapping[str, Estimate]) -> _Dual:
    match node:
        case ast.Name(id=name):
            return _Dual(operands[name].value, {name: 1.0})
        case ast.UnaryOp(op=operator, operand=operand):
            inner = _visit(operand, text, operands)
            return (
                _scaled(inner, inner.value, 1.0)
                if isinstance(operator, ast.UAdd)
                else _scaled(inner, -inner.value, -1.0)
            )
        case ast.BinOp(left=left, op=operator, right=right):
            first, second = (_visit(side, text, operands) for side in (left, right))
            if isinstance(operator, ast.Div) and second.value == 0.0:
                raise formula_fault(text, f"divides by zero: {ast.unparse(right)!r} is 0 here")
            return _arithmetic(operator, first, second)
        case ast.Call(func=ast.Name(id=function), args=arguments):
            values = [_visit(argument, text, operands) for argument in arguments]
            if function in ANGLE_FUNCTIONS:
                return _angle(function, values[0], text)
            choose = min if function == "min" else max
            return choose(values, key=lambda dual: dual.value)
        case ast.Constant(value=int() | float() as number):
            return _Dual(float(number), {})
    raise AssertionError(ast.dump(node))


def _arithmetic(operator: ast.operator, first: _Dual, second: _Dual) -> _Dual:
    a, b = first.value, second.value
    match operator:
        case ast.Mult():
            value, by_first, by_second = a * b, b, a
        case ast.Div():
            value, by_first, by_second = a / b, 1.0 / b, -a / b / b
        case _:
            sign = 1.0 if isinstance(operator, ast.Add) else -1.0
            value, by_first, by_second = a + sign * b, 1.0, sign
    slopes = _scaled(first, value, by_first).slopes
    for name, slope in _scaled(second, value, by_second).slopes.items():
        slopes[name] = slopes.get(name, 0.0) + slope
    return _Dual(value, slopes)


def _scaled(dual: _Dual, value: float, by: float) -> _Dual:
    return _Dual(value, {name: by * slope for name, slope in dual.slopes.items()})


def _angle(function: str, argument: _Dual, text: str) -> _Dual:
    x = argument.value
    if function == "atan":
        radians, slope = math.atan(x), 1.0 / (1.0 + x * x)
    elif abs(x) > 1.0:
        raise formula_fault(text, f"takes the {function} of {x:.6g}; expected -1 to 1")
    else:
        inverse: Callable[[float], float] = math.asin if function == "asin" else math.acos
        steep = math.sqrt(1.0 - x * x)
        radians, slope = inverse(x), 1.0 / steep if steep else math.inf
        slope = slope if function == "asin" else -slope
    return _scaled(argument, math.degrees(radians), math.degrees(slope))
