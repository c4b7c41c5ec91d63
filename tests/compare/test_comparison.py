import csv
import io
import json
import math
from dataclasses import replace

import jsonschema
import numpy as np
import pytest
from helpers.charts.hand_made_chart import hand_made_chart
from helpers.files.page import Page
from scipy.stats import t as student

from bodymeasure.compare import (
    MINIMUM_SUBJECTS,
    VERDICTS,
    Comparison,
    Known,
    Reading,
    Readings,
    compare,
    comparison_to_csv,
    readings_of,
    render_comparison,
)
from bodymeasure.compare.iso20685 import confidence_interval
from bodymeasure.compare.shown import OUTCOMES, summary
from bodymeasure.errors import InputError
from bodymeasure.report.body import chart_document
from bodymeasure.report.serial import json_schema, to_json

KNOWN = (
    Known("bust_girth", "Bust girth", "large girth"),
    Known("neck_girth", "Neck girth", "small girth"),
    Known("waist_height", "Waist height", "height"),
    Known("back_length", "Back <length>", "segment length"),
    Known("slope", "Shoulder slope", None, angle=True),
)


def readings(name: str, *values: Reading) -> Readings:
    return Readings(name, values)


def reading(
    measurement: str, value: float | None, unit: str = "cm", subject: str = "", **more: float
) -> Reading:
    return Reading(subject, measurement, value, unit, place=f"{measurement} of {subject}", **more)  # type: ignore[arg-type]


def many(name: str, differences: np.ndarray, measurement: str = "bust_girth") -> Readings:
    """One reading of each subject."""
    return Readings(
        name,
        tuple(
            reading(measurement, 90.0 + difference, subject=f"subject {number}")
            for number, difference in enumerate(differences)
        ),
    )


def of_subjects(
    differences: np.ndarray, measurement: str = "bust_girth", **more: int
) -> Comparison:
    return compare(
        many("A", differences, measurement),
        many("B", np.zeros(len(differences)), measurement),
        known=KNOWN,
        **more,  # type: ignore[arg-type]
    )


def test_differences_are_a_minus_b_in_one_unit() -> None:
    a = readings("A", reading("Bust girth", 0.915, "m", error=0.001), reading("slope", 23.0, "deg"))
    b = readings(
        "B", reading("bust_girth", 36.0, "inch", error=0.0625), reading("SLOPE", 22.0, "deg")
    )
    comparison = compare(a, b, known=KNOWN, unit="mm")
    bust, slope = comparison.differences
    assert (bust.key, bust.unit, slope.unit) == ("bust_girth", "mm", "deg")
    assert math.isclose(bust.difference, 915.0 - 914.4, rel_tol=1e-9)
    assert bust.relative is not None
    assert math.isclose(bust.relative, 0.6 / 914.4, rel_tol=1e-9)
    assert bust.combined_error is not None
    assert math.isclose(bust.combined_error, 1.0 + 1.5875, rel_tol=1e-12)
    assert (slope.difference, slope.combined_error, slope.accuracy_class) == (1.0, None, None)


def test_swapping_the_sources_turns_the_signs() -> None:
    a = readings("A", reading("bust_girth", 91.0), reading("neck_girth", 35.0))
    b = readings("B", reading("neck_girth", 34.0), reading("bust_girth", 93.0))
    there, back = (compare(*pair, known=KNOWN).differences for pair in ((a, b), (b, a)))
    assert [(d.key, d.difference) for d in there] == [(d.key, -d.difference) for d in back]


def test_the_unit_is_that_of_the_first_chart_that_has_one() -> None:
    chart = readings_of(chart_document(hand_made_chart(), "inch"))
    hand = readings("hand", reading("bust_girth", 91.0))
    assert compare(chart, hand).unit == "inch"
    assert compare(hand, chart).unit == "inch"
    assert compare(hand, hand, known=KNOWN).unit == "cm"
    assert compare(chart, hand, unit="mm").unit == "mm"


def test_two_single_subjects_are_compared_whatever_their_names() -> None:
    chart = readings_of(chart_document(hand_made_chart(), "cm"))
    hand = readings("hand", reading("bust_girth", 91.0, subject="somebody"))
    comparison = compare(chart, hand)
    assert comparison.subjects == ["Anna <Muster>"]
    assert math.isclose(comparison.differences[0].difference, 0.32, rel_tol=1e-9)


def test_what_only_one_source_has_is_told() -> None:
    a = readings("A", reading("bust_girth", 91.0), reading("neck_girth", None))
    a = replace(a, values=(a.values[0], replace(a.values[1], reason="it was <cold>")))
    b = readings("B", *(reading(k.key, 30.0) for k in KNOWN if not k.angle))
    comparison = compare(a, b, known=KNOWN)
    assert [d.key for d in comparison.differences] == ["bust_girth"]
    assert comparison.notes == [
        "not in A: waist_height, back_length",
        "no value in A: neck_girth (it was <cold>)",
    ]


def test_subjects_are_paired_by_name() -> None:
    a = readings("A", *(reading("bust_girth", 90.0, subject=name) for name in "xyz"))
    b = readings("B", *(reading("bust_girth", 91.0, subject=name) for name in "zwx"))
    comparison = compare(a, b, known=KNOWN)
    assert comparison.subjects == ["x", "z"]
    assert comparison.notes == ["not in B: y", "not in A: w"]


@pytest.mark.parametrize(
    ("a", "b", "message"),
    [
        (
            reading("bust_grith", 1.0),
            None,
            r"no measurement is named 'bust_grith'; did you mean "
            r"'bust_girth' \(Bust girth\)",
        ),
        (reading("xyzzy", 1.0), None, "no measurement is named 'xyzzy'; give a key"),
        (reading("slope", 1.0, "cm"), None, "'slope' is given in cm; expected an angle in deg"),
        (reading("bust_girth", 1.0, "deg"), None, "given in deg; expected a length in m, cm"),
        (None, reading("neck_girth", 1.0), "have no value of the same measurement"),
    ],
)
def test_what_cannot_be_compared_is_refused(
    a: Reading | None, b: Reading | None, message: str
) -> None:
    bust = reading("bust_girth", 91.0)
    with pytest.raises(InputError, match=message):
        compare(readings("A", a or bust), readings("B", b or bust), known=KNOWN)


def test_a_value_given_twice_is_refused() -> None:
    twice = readings("A", reading("bust_girth", 91.0), reading("Bust Girth", 92.0))
    with pytest.raises(InputError, match="'bust_girth' is given a second time; keep one"):
        compare(twice, readings("B", reading("bust_girth", 91.0)), known=KNOWN)


def test_subjects_that_do_not_meet_are_refused() -> None:
    a = readings("A", *(reading("bust_girth", 90.0, subject=name) for name in "xy"))
    b = readings("B", reading("bust_girth", 91.0))
    with pytest.raises(InputError, match="have no subject in common"):
        compare(a, b, known=KNOWN)


def test_a_name_of_several_measurements_is_refused() -> None:
    known = (Known("one", "Girth", None), Known("two", "Girth", None))
    a = readings("A", reading("girth", 1.0))
    with pytest.raises(InputError, match="give the key of one: one, two"):
        compare(a, a, known=known)
    by_key = readings("A", reading("two", 1.0))
    assert compare(by_key, by_key, known=known).differences[0].key == "two"


def test_the_interval_is_students(rng: np.random.Generator) -> None:
    for count in (2, 3, 10, 40):
        sample = rng.normal(1.0, 2.0, count)
        expected = student.interval(
            0.95, count - 1, loc=sample.mean(), scale=sample.std(ddof=1) / math.sqrt(count)
        )
        assert confidence_interval(sample.tolist()) == pytest.approx(expected, rel=1e-12)
    assert confidence_interval([1.0]) is None


@pytest.mark.parametrize(
    ("measurement", "allowed"),
    [("bust_girth", 0.9), ("neck_girth", 0.4), ("waist_height", 0.4), ("back_length", 0.5)],
)
def test_the_interval_has_to_lie_within_what_the_class_allows(
    measurement: str, allowed: float
) -> None:
    # The values are spread so that the half width of the interval is known.
    spread = np.tile([-1.0, 1.0], MINIMUM_SUBJECTS // 2)
    low, high = confidence_interval(spread.tolist()) or (0.0, 0.0)
    half = (high - low) / 2.0
    for shift, verdict in (
        (0.99, "within"),
        (-0.99, "within"),
        (1.01, "exceeds"),
        (-1.01, "exceeds"),
    ):
        mean = math.copysign(abs(shift) * allowed - 0.1 * half, shift)
        comparison = of_subjects(mean + 0.1 * spread, measurement)
        (agreement,), (of_class,) = comparison.agreements, comparison.classes
        assert agreement.verdict == of_class.verdict == verdict
        assert agreement.maximum_error == pytest.approx(allowed, rel=1e-12)
        assert agreement.mean == pytest.approx(mean, abs=1e-12)
        assert agreement.subjects == MINIMUM_SUBJECTS


def test_too_few_subjects_have_no_verdict() -> None:
    few = np.linspace(-0.1, 0.1, MINIMUM_SUBJECTS - 1)
    (agreement,) = of_subjects(few).agreements
    assert agreement.verdict == "too few subjects"
    assert agreement.low is not None
    assert of_subjects(few, minimum_subjects=10).agreements[0].verdict == "within"
    assert of_subjects(few[:1]).agreements[0].low is None
    assert of_subjects(few + 5.0).classes[0].verdict == "too few subjects"


def test_few_subjects_tell_only_what_their_interval_does() -> None:
    # The interval of two subjects is wide: it reaches beyond the limit on either side.
    straddling = of_subjects(np.array([0.3, 0.6]), minimum_subjects=2)
    assert straddling.agreements[0].verdict == "too few subjects"
    assert straddling.classes[0].verdict == "too few subjects"
    beyond = of_subjects(np.array([4.0, 4.01]), minimum_subjects=2)
    assert beyond.agreements[0].verdict == "exceeds"
    inside = of_subjects(np.array([0.3, 0.31]), minimum_subjects=2)
    assert inside.agreements[0].verdict == "within"


def test_what_several_subjects_lack_is_told_once() -> None:
    names = [f"subject {number}" for number in range(12)]
    both = [reading("bust_girth", 90.0, subject=name) for name in names]
    more = [reading("neck_girth", 35.0, subject=name) for name in names]
    some = [reading("waist_height", 100.0, subject=name) for name in names[:2]]
    empty = [reading("back_length", None, subject=name) for name in names]
    full = [reading("back_length", 40.0, subject=name) for name in names]
    a, b = readings("A", *both, *more, *some, *full), readings("B", *both, *empty)
    assert compare(a, b, known=KNOWN).notes == [
        "not in B: neck_girth; all 12 subjects",
        "not in B: waist_height; subject 0, subject 1",
        "no value in B: back_length (); all 12 subjects",
    ]


def test_each_verdict_is_counted_in_words() -> None:
    assert set(OUTCOMES) == set(VERDICTS)


def test_a_comparison_is_summed_up() -> None:
    single = compare(
        readings("A", reading("bust_girth", 91.0), reading("neck_girth", 35.0)),
        readings("B", reading("bust_girth", 93.0), reading("neck_girth", 35.1)),
        known=KNOWN,
    )
    assert summary(single) == [
        "2 measurements of one subject compared.",
        "The largest difference of a length is \u22122.00 cm (Bust girth); half of them are at "
        "most 1.05 cm.",
        "1 of 2 differences are larger than ISO 20685-1 allows for the mean of many subjects; "
        "those of a single one may be larger.",
    ]
    several = of_subjects(np.full(MINIMUM_SUBJECTS, 0.2))
    assert summary(several)[0] == "1 measurement of 40 subjects compared: 1 within what is allowed."


def test_a_class_is_within_if_all_its_measurements_are() -> None:
    count = MINIMUM_SUBJECTS
    names = (*KNOWN, Known("hip_girth", "Hip girth", "large girth"))

    def sources(shift: float) -> tuple[Readings, Readings]:
        a = (
            many("A", np.full(count, 0.1)).values
            + many("A", np.full(count, shift), "hip_girth").values
        )
        b = many("B", np.zeros(count)).values + many("B", np.zeros(count), "hip_girth").values
        return Readings("A", a), Readings("B", b)

    (good,) = compare(*sources(0.2), known=names).classes
    assert (good.verdict, good.within, good.measurements) == ("within", 2, 2)
    (bad,) = compare(*sources(2.0), known=names).classes
    assert (bad.verdict, bad.within, bad.measurements) == ("exceeds", 1, 2)


def test_angles_have_no_class() -> None:
    a = Readings("A", tuple(reading("slope", 20.0, "deg", f"{n}") for n in range(50)))
    comparison = compare(a, a, known=KNOWN)
    assert comparison.agreements[0].verdict == "no class"
    assert comparison.classes == []


def test_json_is_valid_and_csv_has_the_same_rows(rng: np.random.Generator) -> None:
    comparison = of_subjects(rng.normal(0.0, 0.3, 5))
    content = json.loads(to_json(comparison))
    schema = json_schema(Comparison)
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.Draft202012Validator(schema).validate(content)
    rows = list(csv.DictReader(io.StringIO(comparison_to_csv(comparison).decode(), newline="")))
    assert [float(row["difference"]) for row in rows] == [
        d["difference"] for d in content["differences"]
    ]


def test_the_page_of_one_subject_and_that_of_many(rng: np.random.Generator) -> None:
    a = readings("A <b>", reading("back_length", 40.0, error=0.1), reading("slope", 20.0, "deg"))
    b = readings("B", reading("back_length", 41.25), reading("slope", 21.0, "deg"))
    b = replace(b, values=(*b.values, reading("bust_girth", 91.0)))
    single = Page(render_comparison(compare(a, b, known=KNOWN)))
    several = Page(render_comparison(of_subjects(rng.normal(0.0, 0.1, MINIMUM_SUBJECTS))))
    for page in (single, several):
        page.check_links()
        page.check_self_contained()
    for shown in (
        "A <b>",
        "Back <length>",
        "40.0",
        "\u22121.25",
        "\u22123.03 %",
        "1.0 mm",
        "20.0°",
    ):
        assert shown in single.text
    assert "not in A <b>: bust_girth" in single.text
    assert "Verdict of ISO 20685-1" in several.text
    assert "within" in several.text
    assert "\u00b10.90" in several.text


@pytest.mark.parametrize(
    ("value", "unit", "words"),
    [
        (
            705.0,
            "cm",
            "is 705 cm, far from the other source's; in mm it would agree: is the unit mm",
        ),
        (70.5, "inch", "in cm it would agree"),
        (28.0, "cm", "in inch it would agree"),
        (0.71, "cm", "in m it would agree"),
        (71.0, "mm", "in cm it would agree"),
        (7116.0, "cm", "is 7116 cm, longer than any measurement of a body; expected at most 3 m"),
    ],
)
def test_a_length_in_the_wrong_unit_is_doubted(value: float, unit: str, words: str) -> None:
    measured = readings("chart", reading("bust_girth", 71.2, error=1e-7))
    by_hand = readings("hand.csv", reading("bust_girth", value, unit))
    for pair in ((measured, by_hand), (by_hand, measured)):
        (note,) = compare(*pair, known=KNOWN).notes
        assert note.startswith(f"hand.csv: bust_girth is {value:g} {unit}")
        assert words in note


@pytest.mark.parametrize("value", [50.0, 68.0, 71.0, 100.0])
def test_lengths_that_differ_as_bodies_do_are_not_doubted(value: float) -> None:
    measured = readings("chart", reading("bust_girth", 71.2, error=1e-7))
    by_hand = readings("hand.csv", reading("bust_girth", value))
    assert compare(measured, by_hand, known=KNOWN).notes == []


def test_many_doubts_are_one_note() -> None:
    body = [reading("bust_girth", 91.0), reading("neck_girth", 36.0)]
    typed = [reading("bust_girth", 910.0), reading("neck_girth", 355.0)]
    measured = readings("chart", *(replace(each, error=1e-7) for each in body))
    (note,) = compare(measured, readings("hand.csv", *typed), known=KNOWN).notes
    assert "(1 more like it)" in note
