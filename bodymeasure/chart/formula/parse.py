"""Formulas of measurements: arithmetic that is parsed, checked and evaluated, never executed."""

import ast
import re
from dataclasses import dataclass
from functools import lru_cache

from bodymeasure.errors import InputError
from bodymeasure.wording import counted

# Far more than a formula for a body needs, and so few that no nesting is too deep.
LONGEST = 400
# These are the parts of a formula. Python's own grammar takes far more, and warns of some of it.
_TOKEN = re.compile(
    r"\s+|(?P<number>(?:\d+\.?\d*|\.\d+)(?!\w))|(?P<name>[A-Za-z_]\w*)|[-+*/(),]", re.A
)
ANGLE_FUNCTIONS = ("asin", "acos", "atan")
FUNCTIONS = ("min", "max", *ANGLE_FUNCTIONS)


@dataclass(frozen=True)
class Formula:
    """A formula that has been parsed.

    Parameters
    ----------
    text : str
    tree : ast.expr
        It consists of numbers, names, ``+ - * /`` and calls of known functions only.
    names : tuple of str
        Keys of the measurements that it needs, each once.
    """

    text: str
    tree: ast.expr
    names: tuple[str, ...]


# As many formulas as several sets of measurements hold.
@lru_cache(maxsize=1024)
def parse_formula(text: str) -> Formula:
    """Return the formula that a text holds; each text is parsed once.

    Raises
    ------
    InputError
        If it is not arithmetic of the kind that `bodymeasure.chart.kinds.FormulaMeasure` says.
    """
    if len(text) > LONGEST:
        raise formula_fault(
            text[:20] + "...", f"is longer than {LONGEST} characters; use several formulas"
        )
    place = 0
    while place < len(text):
        token = _TOKEN.match(text, place)
        if token is None:
            raise formula_fault(text, f"has {text[place]!r} at character {place + 1}; {_ALLOWED}")
        place = token.end()
    try:
        # The parser takes one line; a file may give several.
        tree = ast.parse(" ".join(text.split()), mode="eval").body
    except SyntaxError as error:
        where = f" at character {error.offset}" if error.offset else ""
        raise formula_fault(text, f"is no arithmetic: {error.msg}{where}; {_ALLOWED}") from None
    _check(tree, text)
    names = (node.id for node in ast.walk(tree) if isinstance(node, ast.Name))
    return Formula(text, tree, tuple(dict.fromkeys(n for n in names if n not in FUNCTIONS)))


_ALLOWED = (
    "expected keys of measurements, numbers, + - * / ( ), min, max, and for angles "
    + ", ".join(ANGLE_FUNCTIONS)
)


def formula_fault(text: str, what: str) -> InputError:
    """Return the error that names a formula and its fault."""
    return InputError(f"the formula {text!r} {what}")


def _check(node: ast.expr, text: str) -> None:
    """Refuse everything that is not plain arithmetic."""
    match node:
        case ast.Constant(value=int() | float() as number) if not isinstance(number, bool):
            return
        case ast.Name(id=name):
            if name in FUNCTIONS:
                raise formula_fault(text, f"has {name!r} without arguments; write {name}(...)")
        case ast.UnaryOp(op=ast.USub() | ast.UAdd(), operand=operand):
            _check(operand, text)
        case ast.BinOp(left=left, op=ast.Add() | ast.Sub() | ast.Mult() | ast.Div(), right=right):
            _check(left, text)
            _check(right, text)
        case ast.Call(func=ast.Name(id=function), args=arguments, keywords=[]):
            _check_call(function, arguments, text)
        case _:
            raise formula_fault(
                text, f"holds {ast.unparse(node)!r}, which is no arithmetic; {_ALLOWED}"
            )


def _check_call(function: str, arguments: list[ast.expr], text: str) -> None:
    if function not in FUNCTIONS:
        raise formula_fault(text, f"calls {function!r}; expected one of {', '.join(FUNCTIONS)}")
    wanted = "one argument" if function in ANGLE_FUNCTIONS else "two arguments or more"
    if not arguments or (len(arguments) == 1) != (function in ANGLE_FUNCTIONS):
        raise formula_fault(
            text, f"gives {function} {counted(len(arguments), 'argument')}; expected {wanted}"
        )
    for argument in arguments:
        _check(argument, text)
