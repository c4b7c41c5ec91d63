"""Measurements that cannot be taken, and the reasons given."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.charts.posts import chart_of, post
from helpers.surfaces.tubes import joined, tube

from bodymeasure.atlas import Atlas, AtlasPoint, GivenLength
from bodymeasure.chart import (
    AccuracyClass,
    MeasurementDefinition,
    Outcome,
    measure_chart,
)
from bodymeasure.chart.kinds import (
    BreadthMeasure,
    ChordMeasure,
    DepthMeasure,
    DropMeasure,
    ExtremeGirthMeasure,
    FormulaMeasure,
    GirthMeasure,
    GivenMeasure,
    HeightMeasure,
    LimbGirthMeasure,
    OverMeasure,
    PathMeasure,
    TiltedGirthMeasure,
)
from bodymeasure.chart.landmarks.rules import Between
from bodymeasure.errors import InputError


def refused(atlas: Atlas, measurement: MeasurementDefinition, outcome: Outcome) -> str:
    chart = chart_of(atlas, [measurement, HeightMeasure(key="other", name="other", at="front")])
    found = chart[measurement.key]
    assert found.outcome is outcome
    assert np.isnan(found.value)
    assert found.tapes == ()
    # The others are measured all the same.
    assert chart["other"].value == 1.5
    return found.reason


def test_heights_need_a_floor_under_the_body() -> None:
    atlas = post()
    sunk = replace(atlas, points=atlas.points - [0.0, 0.0, 2.0])
    straight = [
        HeightMeasure(key="height", name="height", at="front"),
        HeightMeasure(key="rise", name="rise", at="high front", above="low front"),
    ]
    height, rise = chart_of(sunk, straight).measured
    assert (height.outcome, rise.outcome) == (Outcome.REFUSED, Outcome.MEASURED)
    assert height.reason.startswith("the body reaches 2 cm below the floor, which is where the ")
    assert height.reason.endswith("move the body onto the floor, or check the atlas's axes")
    assert rise.value == 1.5
    # The soles of a scan are not quite flat.
    standing = replace(atlas, points=atlas.points - [0.0, 0.0, 0.05])
    assert chart_of(standing, straight)["height"].value == pytest.approx(1.45, rel=1e-12)


def test_a_missing_landmark_is_named() -> None:
    height = HeightMeasure(key="a", name="a", at="high frnt")
    reason = refused(post(), height, Outcome.MISSING_LANDMARK)
    assert reason == "the atlas has no landmark 'high frnt'; did you mean 'high front'?"
    for measurement in (
        PathMeasure(key="a", name="a", through=("front", "navel")),
        GirthMeasure(key="a", name="a", at="navel"),
        GirthMeasure(key="a", name="a", at="front", cut=("navel", "right")),
        LimbGirthMeasure(key="a", name="a", start="front", end="high front", at="navel"),
        ExtremeGirthMeasure(key="a", name="a", start="navel", end="front", extreme="largest"),
        TiltedGirthMeasure(key="a", name="a", through=("front", "navel")),
        OverMeasure(key="a", name="a", start="high front", level="front", over=("navel", "left")),
        DropMeasure(key="a", name="a", start="front", level="navel"),
        HeightMeasure(key="a", name="a", at="front", above="navel"),
        ChordMeasure(key="a", name="a", start="front", end="navel"),
        BreadthMeasure(key="a", name="a", at="navel"),
        DepthMeasure(key="a", name="a", at="navel"),
    ):
        reason = refused(post(), measurement, Outcome.MISSING_LANDMARK)
        assert reason.startswith("the atlas has no landmark 'navel'")


def test_a_landmark_that_a_rule_cannot_give_says_why() -> None:
    rule = Between(name="navel", start="front", end="wrist point left")
    chart = chart_of(post(), [HeightMeasure(key="a", name="a", at="navel")], [rule])
    assert chart["a"].outcome is Outcome.MISSING_LANDMARK
    assert chart["a"].reason.startswith(
        "the landmark 'navel' is missing: it needs 'wrist point left'"
    )
    assert chart["a"].reason.endswith("add it with `bodymeasure landmarks`")
    assert "navel" in chart.missing_landmarks


def test_rules_that_need_unknown_landmarks_leave_the_others() -> None:
    rules = [
        Between(name="navel", start="front", end="belly"),
        Between(name="near navel", start="navel", end="left"),
        Between(name="typed", start="frnt", end="left"),
        Between(name="fine", start="front", end="left"),
    ]
    chart = chart_of(post(), [HeightMeasure(key="a", name="a", at="fine")], rules)
    assert chart["a"].value == pytest.approx(1.5)
    belly = "it needs 'belly', which no landmark is called; pick it, or give it a rule"
    assert chart.missing_landmarks == {
        "navel": belly,
        "near navel": f"it needs 'navel', which is missing: {belly}",
        "typed": "it needs 'frnt', which no landmark is called; did you mean 'front'?",
    }


def test_rules_in_a_circle_are_an_error() -> None:
    rules = [
        Between(name="one", start="two", end="left"),
        Between(name="two", start="one", end="left"),
    ]
    with pytest.raises(InputError, match="need one another in a circle"):
        chart_of(post(), [HeightMeasure(key="a", name="a", at="one")], rules)


def test_refusals_keep_the_words_of_what_refuses() -> None:
    two = joined([tube((1.0,) * 4), tube((1.0,) * 4, (5.0, 0.0))], ["torso", "torso"])
    two = replace(two, landmarks={**post().landmarks, "far": AtlasPoint(4, 0.0, 0.5)})
    apart = PathMeasure(key="a", name="a", through=("front", "far"))
    assert "which no seams join: the atlas has 2 separate" in refused(two, apart, Outcome.REFUSED)
    flat = DropMeasure(key="a", name="a", start="front", level="left")
    assert "have one height, so there is nothing" in refused(post(), flat, Outcome.REFUSED)
    same = LimbGirthMeasure(key="a", name="a", start="front", end="front")
    assert "starts and ends at one place" in refused(post(), same, Outcome.REFUSED)


def test_a_formula_without_an_operand_is_never_evaluated() -> None:
    chart = chart_of(
        post(),
        [
            # Whatever the missing one is, the other is smaller.
            FormulaMeasure(key="a", name="a", formula="min(here, gone)"),
            HeightMeasure(key="here", name="here", at="front"),
            HeightMeasure(key="gone", name="gone", at="navel"),
            FormulaMeasure(key="b", name="b", formula="a + here"),
            FormulaMeasure(key="c", name="c", formula="here / (1 - 1)"),
            FormulaMeasure(key="d", name="d", formula="c + here"),
        ],
    )
    assert chart["a"].outcome is Outcome.MISSING_OPERAND
    assert np.isnan(chart["a"].value)
    assert chart["a"].reason.startswith(
        "the formula 'min(here, gone)' lacks 'gone' (missing landmark): the atlas has no landmark"
    )
    assert chart["b"].outcome is Outcome.MISSING_OPERAND
    assert "lacks 'a' (missing operand)" in chart["b"].reason
    assert chart["c"].outcome is Outcome.REFUSED
    assert "divides by zero: '1 - 1' is 0 here" in chart["c"].reason
    assert "lacks 'c' (refused)" in chart["d"].reason


def test_an_atlas_without_landmarks_has_reasons() -> None:
    chart = measure_chart(replace(post(), landmarks={}))
    outcomes = {one.outcome for one in chart.measured}
    assert outcomes == {Outcome.MISSING_LANDMARK, Outcome.MISSING_OPERAND}
    assert all(one.reason for one in chart.measured)


def test_definitions_made_in_python_may_be_wrong() -> None:
    chart = chart_of(
        post(),
        [
            FormulaMeasure(key="a", name="a", formula="b + b"),
            FormulaMeasure(key="b", name="b", formula="2 * a"),
            FormulaMeasure(key="c", name="c", formula="nothing + nothing"),
            PathMeasure(key="d", name="d", through=()),
        ],
    )
    assert {one.outcome for one in chart.measured} == {Outcome.MISSING_OPERAND, Outcome.REFUSED}
    assert "'a' is needed to compute itself" in chart["b"].reason
    assert "no measurement has the key 'nothing'" in chart["c"].reason
    assert chart["d"].reason == "through needs two landmarks or more"


def test_no_name_is_no_landmark() -> None:
    knee = GirthMeasure(key="a", name="a", at=None)  # type: ignore[arg-type]
    assert "the atlas has no landmark None; expected one of" in chart_of(post(), [knee])["a"].reason


def test_two_measurements_of_one_key_are_refused() -> None:
    both = [FormulaMeasure(key="a", name=name, formula="1 + 1") for name in ("one", "other")]
    with pytest.raises(InputError, match="two measurements have the key 'a'; rename or remove"):
        chart_of(post(), both)


def test_a_given_length_stands_in_for_missing_landmarks() -> None:
    top = HeightMeasure(key="top", name="Top", at="top of head", optional=True)
    head = GivenMeasure(key="head", name="Head girth", accuracy=AccuracyClass.SMALL_GIRTH)
    front = HeightMeasure(key="front", name="Front", at="front")
    above = FormulaMeasure(key="above", name="Above", formula="top - front", optional=True)
    measurements = [top, head, front, above]
    plain = chart_of(post(), measurements)
    # What is optional is left out, and so is what is computed from it.
    assert [one.definition.key for one in plain.measured] == ["head", "front"]
    assert plain["head"].outcome is Outcome.MISSING_LANDMARK
    assert plain["head"].reason.startswith("the body gives no 'head'; a fit of the whole body does")
    given = {
        "top": GivenLength(5.0, 0.01, 0.5, "By hand."),
        "head": GivenLength(56.0, 0.2),
        "front": GivenLength(9.0),
    }
    body = replace(post(), given=given)
    for atlas, scale in ((body, 1.0), (body.converted("mm"), 10.0)):
        chart = chart_of(atlas, measurements)
        assert {one.outcome for one in chart.measured} == {Outcome.MEASURED}
        assert chart["top"].value == pytest.approx(5.0 * scale, rel=1e-15)
        assert chart["top"].error_estimate == pytest.approx(0.01 * scale, rel=1e-15)
        assert chart["top"].input_uncertainty == pytest.approx(0.5 * scale, rel=1e-15)
        assert chart["head"].input_uncertainty is None
        assert chart["top"].reason == "By hand."
        # A body that has the landmark is measured.
        assert chart["front"].value == pytest.approx(1.5 * scale, rel=1e-12)
        assert chart["above"].value == pytest.approx(3.5 * scale, rel=1e-12)
        assert chart["above"].error_estimate >= 0.01 * scale


@pytest.mark.parametrize(
    ("numbers", "message"),
    [
        ((0.0, 0.0, 0.0), "a given length is 0.0; expected a positive number"),
        ((float("nan"), 0.0, 0.0), "a given length is nan; expected a positive number"),
        ((1.0, -1.0, 0.0), "the error_estimate of a given length is -1.0; expected 0 or more"),
        ((1.0, 0.0, float("inf")), "the uncertainty of a given length is inf; expected 0 or more"),
    ],
)
def test_given_lengths_are_lengths(numbers: tuple[float, float, float], message: str) -> None:
    with pytest.raises(InputError, match=message):
        GivenLength(*numbers)
