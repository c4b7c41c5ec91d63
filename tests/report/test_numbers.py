from itertools import pairwise

import pytest

from bodymeasure.report.numbers import (
    at_most,
    length_text,
    millimeters,
    percent,
    scientific,
    unbroken,
    with_code,
)
from bodymeasure.report.patches.histogram import histogram
from bodymeasure.wording import counted


def plain(text: str) -> str:
    return text.replace("\u00a0", " ").replace("\u2212", "-").replace("\u00d7", "x")


@pytest.mark.parametrize(
    ("unit", "expected"), [("m", "0.1235"), ("cm", "0.12"), ("mm", "0.1"), ("inch", "0.12")]
)
def test_lengths_are_rounded_to_what_a_tape_shows(unit: str, expected: str) -> None:
    assert length_text(0.123456, unit) == expected
    assert length_text(None, unit) == "\u2013"


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (3.14e-7, "3.1 x 10\u207b\u2077"),
        (-2.5e-12, "-2.5 x 10\u207b\u00b9\u00b2"),
        (9.99e-5, "1.0 x 10\u207b\u2074"),
        (0.0, "0"),
        (None, "\u2013"),
    ],
)
def test_errors_are_in_scientific_notation(value: float | None, expected: str) -> None:
    assert plain(scientific(value)) == expected


def test_signs_are_shown_where_asked() -> None:
    assert scientific(1e-3, signed=True).startswith("+")
    assert plain(percent(-0.0123)) == "-1.23 %"


@pytest.mark.parametrize(
    ("length", "unit", "expected"),
    [
        (1e-9, "m", "< 0.0001 mm"),
        (-0.00123, "cm", "0.012 mm"),
        (0.0012, "mm", "0.0012 mm"),
        (1.0, "inch", "25.4 mm"),
    ],
)
def test_small_lengths_are_in_millimeters(length: float, unit: str, expected: str) -> None:
    assert plain(millimeters(length, unit)) == expected


def test_bounds_are_in_words() -> None:
    assert plain(at_most(1e-9, "m")) == "less than 0.0001 mm"
    assert plain(at_most(0.5, "mm")) == "at most 0.500 mm"
    assert counted(1, "patch", "patches") == "1 patch"
    assert counted(1200, "diagonal") == "1,200 diagonals"


def test_code_is_marked_and_the_rest_escaped() -> None:
    assert with_code("run `a < b` & <i>") == "run <code>a &lt; b</code> &amp; &lt;i&gt;"


def test_numbers_in_names_stay_on_one_line() -> None:
    assert unbroken("arm <left> 3-2") == 'arm &lt;left&gt; <span class="whole">3-2</span>'


def test_a_histogram_counts_every_value_once_and_has_no_gaps() -> None:
    values = [0.0, 1e-30, 2e-9, -2e-9, 5e-9, 1e-3]
    bars = histogram(values, reference=[0.5])
    assert sum(bar.count for bar in bars) == len(values)
    assert sum(bar.reference for bar in bars) == 1
    for left, right in pairwise(bars):
        assert left.high == right.low
    for value in values[2:]:
        assert any(bar.low <= abs(value) < bar.high and bar.count for bar in bars)
    assert histogram([]) == []
