"""Formulas of measurements: arithmetic that is parsed, checked and evaluated, never executed."""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple

from bodymeasure.errors import InputError

# Far more than a formula for a body needs, and few enough for no nesting to be too deep.
LONGEST = 400
# What a formula consists of. Python's own grammar would take far more, and warn of some of it.
_TOKEN = re.compile(
    r"\s+|(?P<number>(?:\d+\.?\d*|\.\d+)(?!\w))|(?P<name>[A-Za-z_]\w*)|[-+*/(),]", re.A
)
ANGLE_FUNCTIONS = ("asin", "acos", "atan")
FUNCTIONS = ("min", "max", *ANGLE_FUNCTIONS)


class Quantity(StrEnum):
    """What a number measures."""

    NUMBER = "a pure number"
    LENGTH = "a length"
    ANGLE = "an angle"


@dataclass(frozen=True)
class Formula:
    """A formula that has been parsed.

    Parameters
    ----------
    text : str
    tree : ast.expr
        Of numbers, names, ``+ - * /`` and calls of known functions only.
    names : tuple of str
        Keys of the measurements that it takes, each once.
    """

    text: str
    tree: ast.expr
    names: tuple[str, ...]


class Estimate(NamedTuple):
    """A value and how far it may be off."""

    value: float
    error: float


def parse_formula(text: str) -> Formula:
    """A formula from its text.

    Raises
    ------
    InputError
        If it is not arithmetic of the kind that `bodymeasure.chart.FormulaMeasure` says.
    """
    if len(text) > LONGEST:
        raise _fault(text[:20] + "...", f"is longer than {LONGEST} signs; use several formulas")
    place = 0
    while place < len(text):
        token = _TOKEN.match(text, place)
        if token is None:
            raise _fault(text, f"has {text[place]!r} at sign {place + 1}; {_ALLOWED}")
        place = token.end()
    try:
        tree = ast.parse(text.strip(), mode="eval").body
    except SyntaxError as error:
        where = f" at sign {error.offset}" if error.offset else ""
        raise _fault(text, f"is no arithmetic: {error.msg}{where}; {_ALLOWED}") from None
    _check(tree, text)
    names = (node.id for node in ast.walk(tree) if isinstance(node, ast.Name))
    return Formula(text, tree, tuple(dict.fromkeys(n for n in names if n not in FUNCTIONS)))


_ALLOWED = (
    "expected keys of measurements, numbers, + - * / ( ), min, max, and for angles "
    + ", ".join(ANGLE_FUNCTIONS)
)


def _fault(text: str, what: str) -> InputError:
    return InputError(f"the formula {text!r} {what}")


def _check(node: ast.expr, text: str) -> None:
    """Refuse all that is not plain arithmetic."""
    match node:
        case ast.Constant(value=int() | float()) | ast.Name():
            if isinstance(node, ast.Name) and node.id in FUNCTIONS:
                raise _fault(text, f"has {node.id!r} without arguments; write {node.id}(...)")
        case ast.UnaryOp(op=ast.USub() | ast.UAdd(), operand=operand):
            _check(operand, text)
        case ast.BinOp(left=left, op=ast.Add() | ast.Sub() | ast.Mult() | ast.Div(), right=right):
            _check(left, text)
            _check(right, text)
        case ast.Call(func=ast.Name(id=function), args=arguments, keywords=[]):
            _check_call(function, arguments, text)
        case _:
            raise _fault(text, f"holds {ast.unparse(node)!r}, which is no arithmetic; {_ALLOWED}")


def _check_call(function: str, arguments: list[ast.expr], text: str) -> None:
    if function not in FUNCTIONS:
        raise _fault(text, f"calls {function!r}; expected one of {', '.join(FUNCTIONS)}")
    wanted = "one argument" if function in ANGLE_FUNCTIONS else "two arguments or more"
    if not arguments or (len(arguments) == 1) != (function in ANGLE_FUNCTIONS):
        raise _fault(text, f"gives {function} {len(arguments)} of them; expected {wanted}")
    for argument in arguments:
        _check(argument, text)


def quantity_of(formula: Formula, quantities: Mapping[str, Quantity]) -> Quantity:
    """What a formula gives, of operands that are lengths or angles.

    Parameters
    ----------
    formula : Formula
    quantities : mapping of str to Quantity
        For each of `formula.names`.

    Raises
    ------
    InputError
        If it adds or compares what cannot be added, or gives an area or the inverse of a length.
    """

    def mixed(node: ast.expr, *found: Quantity) -> InputError:
        met = " and ".join(dict.fromkeys(found))
        return _fault(
            formula.text,
            f"has mixed units: {ast.unparse(node)!r} puts together {met}; lengths may be added, "
            "compared and divided by one another, and multiplied or divided by numbers",
        )

    def visit(node: ast.expr) -> Quantity:
        match node:
            case ast.Name(id=name):
                return quantities[name]
            case ast.UnaryOp(operand=operand):
                return visit(operand)
            case ast.BinOp(left=left, op=operator, right=right):
                first, second = visit(left), visit(right)
                result = _combined(operator, first, second)
                if result is None:
                    raise mixed(node, first, second)
                return result
            case ast.Call(func=ast.Name(id=function), args=arguments):
                found = [visit(argument) for argument in arguments]
                if function in ANGLE_FUNCTIONS:
                    if found[0] is not Quantity.NUMBER:
                        raise mixed(node, found[0])
                    return Quantity.ANGLE
                if len(set(found)) > 1:
                    raise mixed(node, *found)
                return found[0]
        return Quantity.NUMBER

    return visit(formula.tree)


def _combined(operator: ast.operator, first: Quantity, second: Quantity) -> Quantity | None:
    match operator:
        case ast.Mult():
            if first is Quantity.NUMBER:
                return second
            return first if second is Quantity.NUMBER else None
        case ast.Div():
            if second is Quantity.NUMBER:
                return first
            return Quantity.NUMBER if first is second else None
    return first if first is second else None


class _Dual(NamedTuple):
    """A value and its partial derivatives by the operands."""

    value: float
    slopes: dict[str, float]


def evaluate_formula(formula: Formula, operands: Mapping[str, Estimate]) -> Estimate:
    """The value of a formula, and what the operands' errors make of it.

    Parameters
    ----------
    formula : Formula
    operands : mapping of str to Estimate
        For each of `formula.names`; angles in degrees.

    Returns
    -------
    Estimate
        Its error is the sum of the operands' errors, each times the size of the formula's partial
        derivative by it.

    Raises
    ------
    InputError
        If it divides by zero, or has no finite value for these operands.
    """
    value, slopes = _visit(formula.tree, formula.text, operands)
    error = 0.0
    for name, slope in slopes.items():
        # A slope without bound does no harm to an operand that is exact.
        error += abs(slope) * operands[name].error if operands[name].error else 0.0
    if not math.isfinite(value):
        raise _fault(formula.text, "has no finite value for these measurements")
    return Estimate(value, error)


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
                raise _fault(text, f"divides by zero: {ast.unparse(right)!r} is 0 here")
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
        raise _fault(text, f"takes the {function} of {x:.6g}; expected -1 to 1")
    else:
        inverse: Callable[[float], float] = math.asin if function == "asin" else math.acos
        steep = math.sqrt(1.0 - x * x)
        radians, slope = inverse(x), 1.0 / steep if steep else math.inf
        slope = slope if function == "asin" else -slope
    return _scaled(argument, math.degrees(radians), math.degrees(slope))
