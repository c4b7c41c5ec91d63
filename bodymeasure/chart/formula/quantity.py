"""The quantity that a formula gives: a length, an angle or a pure number."""

import ast
from collections.abc import Mapping
from enum import StrEnum

from bodymeasure.chart.formula.parse import ANGLE_FUNCTIONS, Formula, formula_fault
from bodymeasure.errors import InputError


class Quantity(StrEnum):
    """The quantity that a number measures."""

    NUMBER = "a pure number"
    LENGTH = "a length"
    ANGLE = "an angle"


def quantity_of(formula: Formula, quantities: Mapping[str, Quantity]) -> Quantity:
    """Return what a formula gives if its operands are lengths or angles.

    Parameters
    ----------
    formula : Formula
    quantities : mapping of str to Quantity
        The quantity of each of `formula.names`.

    Raises
    ------
    InputError
        If it adds or compares what cannot be added, or gives an area or the inverse of a length.
    """

    def mixed(node: ast.expr, *found: Quantity) -> InputError:
        met = " and ".join(dict.fromkeys(found))
        return formula_fault(
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
