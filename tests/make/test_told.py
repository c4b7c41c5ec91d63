"""Sets of measurements that are told to be impossible, rare or mistyped, and those that are not."""

import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from helpers.impossible import IMPOSSIBLE, WOMAN, Impossible

from bodymeasure.chart import load_definitions
from bodymeasure.make.body.measuring import Measuring, Readout
from bodymeasure.make.body.prior import prior_of
from bodymeasure.make.checks.contradictions import contradictions
from bodymeasure.make.checks.plausible import judged
from bodymeasure.make.checks.slips import slip_of
from bodymeasure.make.checks.told import Told, told
from bodymeasure.make.input.measurements import Value

# Bodies of normal coefficients of all 120 components, some of their measurements, and what a hand
# adds (3 mm), made once by tests/benchmarks/make/made_bodies.py.
POSSIBLE = Path(__file__).parents[1] / "data" / "make" / "possible_sets.json"


# German women's sizes from 32 to 54, in centimeters.
SIZES = (
    (76, 60, 86), (80, 64, 90), (84, 68, 94), (88, 72, 97), (92, 76, 100), (96, 80, 103),
    (100, 84, 106), (104, 88, 109), (110, 94.5, 114), (116, 101, 119), (122, 107.5, 124),
    (128, 114, 129),
)  # fmt: skip


@cache
def _mean() -> dict[str, tuple[float, np.ndarray]]:
    """The mean body's measurements and their derivatives, of all that the sets hold."""
    keys = tuple(dict.fromkeys([*WOMAN, *(key for one in _possible() for key in one)]))
    readout = Measuring(load_definitions(), keys).of(prior_of().mean)
    return dict(zip(keys, zip(readout.values.tolist(), readout.slopes, strict=True), strict=True))


@cache
def _possible() -> tuple[dict[str, float], ...]:
    return tuple(json.loads(POSSIBLE.read_text()))


def _told(values: dict[str, float]) -> Told:
    rows = [_mean()[key] for key in values]
    readout = Readout(
        np.array([value for value, _ in rows]),
        np.stack([slopes for _, slopes in rows]),
        ("",) * len(rows),
    )
    units = {key: "deg" if "slope" in key else "cm" for key in values}
    return told(readout, tuple(Value(key, value, units[key]) for key, value in values.items()))


@pytest.mark.slow
def test_the_womans_measurements_are_possible() -> None:
    found = _told(WOMAN)
    assert not found.refusal
    assert not found.warnings


@pytest.mark.parametrize("one", IMPOSSIBLE, ids=lambda one: one.reason)
def test_impossible_sets_are_told_with_the_culprit(one: Impossible) -> None:
    refusal = _told(WOMAN | one.changed).refusal
    assert refusal
    assert one.says in refusal
    assert not one.culprits or any(culprit in refusal for culprit in one.culprits)


def test_possible_sets_are_not_refused() -> None:
    assert len(_possible()) == 100
    assert sum(bool(_told(one).refusal) for one in _possible()) <= 2


@pytest.mark.parametrize(("bust", "waist", "hip"), SIZES)
def test_sizes_that_are_sold_are_not_refused(bust: float, waist: float, hip: float) -> None:
    sold = {"bust_girth": bust, "waist_girth": waist, "hip_girth": hip, "stature": 168.0}
    found = _told(sold)
    assert not found.refusal
    # The largest are rare in the space, and that is said.
    assert bool(found.warnings) == (bust > 110.0)


def test_a_value_on_the_border_warns_and_says_what_would_be_usual() -> None:
    found = _told(WOMAN | {"waist_girth": 58.0})
    assert not found.refusal
    (words,) = found.warnings
    assert words.startswith("waist_girth (58.0 cm) is unusual: beside the others, waist_girth is")


def test_the_chi_square_is_that_of_the_set_and_falls_by_the_gain() -> None:
    values = WOMAN | {"waist_girth": 50.0}
    whole = _told(values).judgment
    keys = list(values)
    row = keys.index("waist_girth")
    rest = _told({key: values[key] for key in keys if key != "waist_girth"}).judgment
    assert whole.worst == row
    assert whole.chi_square - whole.gain[row] == pytest.approx(rest.chi_square, rel=1e-9)
    low, high = whole.range_of(row)
    assert low < 0.01 * WOMAN["waist_girth"] < high


def test_what_the_others_say_of_a_value_is_the_conditional_mean() -> None:
    rng = np.random.default_rng(0)
    slopes = rng.normal(size=(3, 120))
    mean = Readout(np.array([1.0, 2.0, 3.0]), slopes, ("",) * 3)
    values = np.array([5.0, -4.0, 9.0])
    found = judged(mean, values, np.zeros(3, dtype=np.bool_))
    noise = 0.005 + 0.01 * mean.values
    covariance = slopes @ slopes.T + np.diag(noise**2)
    gain = covariance[0, 1:] @ np.linalg.inv(covariance[1:, 1:])
    assert found.from_others[0] == pytest.approx(1.0 + gain @ (values - mean.values)[1:])
    assert found.beside[0] ** 2 == pytest.approx(covariance[0, 0] - gain @ covariance[1:, 0])


@pytest.mark.parametrize(
    ("written", "unit", "meant", "words"),
    [
        (72.0, "cm", 0.72, None),
        (27.0, "cm", 0.72, "swapped digits: 72 written as 27"),
        (28.3, "cm", 0.72, "a value in inch"),
        (720.0, "cm", 0.72, "a decimal point one place to the right"),
        (7.2, "cm", 0.72, "a decimal point one place to the left"),
        (36.0, "cm", 0.72, "half of the tape, as of a tape laid double"),
        (82.0, "cm", 0.72, None),
    ],
)
def test_slips_are_recognized(written: float, unit: str, meant: float, words: str | None) -> None:
    found = slip_of(Value("waist_girth", written, unit), meant, 0.002)
    if words is None:
        assert found is None
    else:
        assert found is not None
        assert found.words == words


def test_contradictions_name_both_sides_only_where_both_are_given() -> None:
    assert not contradictions({"ankle_girth_left": 0.3, "calf_girth_right": 0.2})
    (one,) = contradictions({"ankle_girth_left": 0.3, "calf_girth_left": 0.2})
    assert one[:2] == ("ankle_girth_left", "calf_girth_left")
    # What two tapes in the hand may differ by is none.
    assert not contradictions({"ankle_girth_left": 0.205, "calf_girth_left": 0.2})
