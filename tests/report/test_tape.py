import pytest
from hypothesis import given
from hypothesis import strategies as st

from bodymeasure.report.body import tailor_inches, tape_text
from bodymeasure.report.body.tape import small_text


def plain(text: str) -> str:
    return text.replace("\u00a0", " ")


@pytest.mark.parametrize(
    ("inches", "expected"),
    [
        (33.125, "33 1/8"),
        (33.0, "33"),
        (0.0, "0"),
        (0.0625, "1/16"),
        (0.5, "1/2"),
        (12.75, "12 3/4"),
        # The nearest sixteenth carries to the next inch.
        (32 + 31 / 32, "33"),
        (32 + 30.9 / 32, "32 15/16"),
        (0.99, "1"),
        # Never more than what is nearest.
        (10.03, "10"),
        (10.04, "10 1/16"),
        (-2.25, "\u22122 1/4"),
        (-0.001, "0"),
        (None, "\u2013"),
    ],
)
def test_inches_are_written_as_tailors_do(inches: float | None, expected: str) -> None:
    assert plain(tailor_inches(inches)) == expected


@pytest.mark.parametrize(
    ("error", "expected"),
    [(1e-9, "33 3/16"), (0.04, "33 1/4"), (0.1, "33 1/4"), (0.2, "33"), (5.0, "33")],
)
def test_fractions_are_no_finer_than_the_error(error: float, expected: str) -> None:
    assert plain(tailor_inches(33.19, error)) == expected


@given(st.floats(0.0, 500.0))
def test_fractions_are_the_nearest_and_in_lowest_terms(inches: float) -> None:
    whole, fraction = 0, "0/1"
    for word in plain(tailor_inches(inches)).split():
        whole, fraction = (whole, word) if "/" in word else (int(word), fraction)
    over, under = map(int, fraction.split("/"))
    assert abs(whole + over / under - inches) <= 1.0 / 32.0
    assert over == 0 or (over % 2 == 1 and over < under <= 16)


@pytest.mark.parametrize(
    ("value", "unit", "error", "expected"),
    [
        (0.91324, "m", None, "0.913"),
        (91.324, "cm", 1e-9, "91.3"),
        (913.24, "mm", 1e-9, "913"),
        (35.954, "inch", 1e-9, "35.95"),
        (23.578, "deg", 0.001, "23.6"),
        # The error leaves no certain digit after the point, or one digit less.
        (91.324, "cm", 0.4, "91"),
        (35.954, "inch", 0.01, "36.0"),
        (-0.01, "cm", None, "0.0"),
        (-1.25, "cm", None, "\u22121.2"),
        (None, "cm", None, "\u2013"),
    ],
)
def test_values_have_the_digits_of_a_tape(
    value: float | None, unit: str, error: float | None, expected: str
) -> None:
    assert tape_text(value, unit, error) == expected


@pytest.mark.parametrize(
    ("length", "unit", "expected"),
    [
        (0.0102, "m", "10.2 mm"),
        (1e-9, "cm", "< 0.0001 mm"),
        (0.4, "inch", "0.40 in"),
        (0.0123, "inch", "0.0123 in"),
        (1e-7, "inch", "< 0.0001 in"),
        (None, "inch", "\u2013"),
    ],
)
def test_small_lengths_keep_to_inches_or_millimeters(
    length: float | None, unit: str, expected: str
) -> None:
    assert plain(small_text(length, unit)) == expected
