"""Formulas: their operands, their values, and how errors propagate through them."""

import math
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bodymeasure.chart.formula.parse import FUNCTIONS, LONGEST, parse_formula
from bodymeasure.chart.formula.quantity import Quantity, quantity_of
from bodymeasure.chart.formula.value import Estimate, evaluate_formula
from bodymeasure.errors import InputError

A, B = Estimate(7.5, 1e-3), Estimate(-2.0, 3e-3)


def value(text: str, **operands: Estimate) -> Estimate:
    return evaluate_formula(parse_formula(text), operands)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a + b", 5.5),
        ("a - b", 9.5),
        ("-a - -b", -9.5),
        ("+a * 2", 15.0),
        ("2 * (a + b) / 4", 2.75),
        ("a / b * b", 7.5),
        ("a - b - b", 11.5),
        ("min(a, b, 3 * b)", -6.0),
        ("max(a,\n  b)", 7.5),
        (".5 * a + 1. * b", 1.75),
        ("atan(a / a)", 45.0),
        ("asin(b / 4)", -30.0),
        ("acos(b / 4)", 120.0),
    ],
)
def test_arithmetic(text: str, expected: float) -> None:
    assert value(text, a=A, b=B).value == pytest.approx(expected, rel=1e-15)


@pytest.mark.parametrize(
    "text",
    ["a + 2 * b", "a * 3 - b / 7", "a / b", "(a - b) / (a + b)", "max(a, b) - b", "atan(b / a)"],
)
def test_errors_are_those_of_the_partial_derivatives(text: str) -> None:
    step = 1e-6
    slopes = [
        (
            value(text, a=Estimate(A.value + da, 0.0), b=Estimate(B.value + db, 0.0)).value
            - value(text, a=Estimate(A.value - da, 0.0), b=Estimate(B.value - db, 0.0)).value
        )
        / (2.0 * step)
        for da, db in ((step, 0.0), (0.0, step))
    ]
    expected = abs(slopes[0]) * A.error + abs(slopes[1]) * B.error
    assert value(text, a=A, b=B).error == pytest.approx(expected, rel=1e-7)


def test_what_cancels_has_no_error() -> None:
    assert value("a - a", a=A) == (0.0, 0.0)
    # At the end of its range the slope has no bound, but an exact operand no error.
    assert value("asin(a / b)", a=Estimate(2.0, 0.0), b=Estimate(2.0, 0.0)) == (90.0, 0.0)
    assert math.isinf(value("asin(a / b)", a=Estimate(2.0, 0.1), b=Estimate(2.0, 0.0)).error)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "is no arithmetic"),
        ("a +", "is no arithmetic: invalid syntax"),
        ("a b", "is no arithmetic: invalid syntax"),
        ("(a", "is no arithmetic: '(' was never closed"),
        ("a ** 2", "holds 'a ** 2', which is no arithmetic; expected keys of measurements"),
        ("a // 2", "holds 'a // 2'"),
        ("a, b", "holds '(a, b)'"),
        ("*a", "is no arithmetic"),
        ("a.b", "has '.' at character 2; expected keys"),
        ("a[0]", "has '[' at character 2"),
        ("2a", "has '2' at character 1"),
        ("1e3", "has '1' at character 1"),
        ("0x1", "has '0' at character 1"),
        ("1_0", "has '1' at character 1"),
        ("1or 2", "has '1' at character 1"),
        ("01", "is no arithmetic"),
        ("a if b", "is no arithmetic"),
        ("not a", "holds 'not a'"),
        ("lambda a", "is no arithmetic"),
        ("'a'", 'has "\'" at character 1'),
        ("a ÷ b", "has '÷' at character 3"),
        ("a\x00", "has '\\x00' at character 2"),
        ("sqrt(a)", "calls 'sqrt'; expected one of min, max, asin, acos, atan"),
        ("min(a)", "gives min 1 argument; expected two arguments or more"),
        ("min()", "gives min 0 arguments"),
        ("atan(a, b)", "gives atan 2 arguments; expected one argument"),
        ("min + 1", "has 'min' without arguments; write min(...)"),
        ("a(b)", "calls 'a'"),
        ("(min)(a, b)(a)", "is no arithmetic"),
        ("None", "holds 'None'"),
        ("True", "holds 'True'"),
        ("(" * 300 + "a" + ")" * 99, "is no arithmetic"),
        ("a + " * LONGEST, "is longer than 400 characters; use several formulas"),
    ],
)
def test_what_is_no_arithmetic_is_refused(text: str, message: str) -> None:
    with pytest.raises(InputError, match=re.escape(message)) as caught:
        parse_formula(text)
    assert str(caught.value).startswith("the formula ")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a + b", Quantity.LENGTH),
        ("2 * a / 3", Quantity.LENGTH),
        ("a / b", Quantity.NUMBER),
        ("a / b * a", Quantity.LENGTH),
        ("-min(a, b)", Quantity.LENGTH),
        ("3 / 4", Quantity.NUMBER),
        ("asin(a / b) + c / 2", Quantity.ANGLE),
        ("c / c", Quantity.NUMBER),
    ],
)
def test_quantities(text: str, expected: Quantity) -> None:
    known = {"a": Quantity.LENGTH, "b": Quantity.LENGTH, "c": Quantity.ANGLE}
    assert quantity_of(parse_formula(text), known) is expected


@pytest.mark.parametrize(
    ("text", "part"),
    [
        ("a * b", "'a * b' puts together a length"),
        ("2 * (a + 1)", "'a + 1' puts together a length and a pure number"),
        ("1 / a", "'1 / a' puts together a pure number and a length"),
        ("min(a, 2)", "'min(a, 2)' puts together a length and a pure number"),
        ("a + c", "'a + c' puts together a length and an angle"),
        ("atan(a)", "'atan(a)' puts together a length"),
        ("a / c", "'a / c' puts together a length and an angle"),
    ],
)
def test_mixed_units_are_refused(text: str, part: str) -> None:
    known = {"a": Quantity.LENGTH, "b": Quantity.LENGTH, "c": Quantity.ANGLE}
    with pytest.raises(InputError, match=r"has mixed units: .*lengths may be added") as caught:
        quantity_of(parse_formula(text), known)
    assert part in str(caught.value)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a / (b - b)", "divides by zero: 'b - b' is 0 here"),
        ("asin(a)", "takes the asin of 7.5; expected -1 to 1"),
        ("a * " + "9" * 200 + " * " + "9" * 180, "has no finite value for these measurements"),
    ],
)
def test_values_that_there_are_not(text: str, message: str) -> None:
    with pytest.raises(InputError, match=re.escape(message)):
        value(text, a=A, b=B)


NUMBERS = st.floats(-1e3, 1e3).filter(lambda x: abs(x) > 1e-3)
TREES = st.recursive(
    st.sampled_from(["a", "b", "2", "0.5", "3.25"]),
    lambda inner: st.one_of(
        st.builds("({} {} {})".format, inner, st.sampled_from("+-*/"), inner),
        st.builds("-{}".format, inner),
        st.builds("{}({}, {})".format, st.sampled_from(["min", "max"]), inner, inner),
    ),
    max_leaves=12,
)


@given(text=TREES, a=NUMBERS, b=NUMBERS)
def test_formulas_are_what_python_makes_of_them(text: str, a: float, b: float) -> None:
    if len(text) > LONGEST:
        return
    formula = parse_formula(text)
    assert set(formula.names) <= {"a", "b"}
    try:
        known = eval(text, {"min": min, "max": max}, {"a": a, "b": b})
        found = evaluate_formula(formula, {"a": Estimate(a, 1e-6), "b": Estimate(b, 1e-6)})
    except (ZeroDivisionError, InputError):
        with pytest.raises(InputError, match=r"divides by zero|no finite value"):
            evaluate_formula(formula, {"a": Estimate(a, 0.0), "b": Estimate(b, 0.0)})
        return
    assert found.value == pytest.approx(known, rel=1e-12, abs=1e-300)
    assert found.error >= 0.0


@given(st.text(alphabet="ab1.+-*/(), \nminax", max_size=40))
def test_any_text_is_a_formula_or_refused(text: str) -> None:
    try:
        formula = parse_formula(text)
    except InputError:
        return
    assert not set(formula.names) & set(FUNCTIONS)
