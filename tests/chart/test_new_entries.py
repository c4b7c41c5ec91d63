"""A kind of measurement and a rule that are made here work wherever the others do."""

import json
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import ClassVar

import jsonschema
import msgspec
import numpy as np
import pytest
from helpers.charts.entries import assert_complete, assert_names_what_it_asks_for

from bodymeasure import load_sample
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.chart import (
    AccuracyClass,
    Definitions,
    LandmarkRule,
    Measured,
    MeasurementDefinition,
    Outcome,
    definitions_schema,
    lacking,
    measure_chart,
)
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Fault, FormulaText, Landmark
from bodymeasure.chart.formula.parse import parse_formula
from bodymeasure.chart.formula.value import Estimate, evaluate_formula
from bodymeasure.chart.kinds import KINDS
from bodymeasure.chart.landmarks.rules import RULES
from bodymeasure.chart.landmarks.rules.base import Landmarks
from bodymeasure.chart.reading.read import definitions_from
from bodymeasure.errors import InputError
from bodymeasure.report.body import chart_document, chart_to_csv, render_chart
from bodymeasure.report.serial import to_json


class Polyline(MeasurementDefinition, frozen=True, kw_only=True, tag="polyline"):
    """The sum of the straight distances between landmarks.

    Parameters
    ----------
    corners : tuple of str
        The landmarks, in order.
    """

    example: ClassVar[str] = 'corners = ["side neck point left", "bust point left"]'

    corners: tuple[Landmark, ...]

    @property
    def accuracy_class(self) -> AccuracyClass:
        return AccuracyClass.SEGMENT_LENGTH

    def faults(self) -> Iterator[Fault]:
        if len(self.corners) < 2:
            yield Fault(self, "corners", "corners needs two landmarks or more")

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:  # noqa: ARG002
        corners = [body.position(name) for name in self.corners]
        length = sum(float(np.linalg.norm(b - a)) for a, b in pairwise(corners))
        return Measured(
            self, Outcome.MEASURED, value=length, error_estimate=0.0, landmarks=self.landmarks
        )


class Share(MeasurementDefinition, frozen=True, kw_only=True, tag="share"):
    """A percentage of what a formula gives.

    Parameters
    ----------
    of : str
        The formula.
    percent : float
        How much of it.
    """

    example: ClassVar[str] = 'of = "waist_girth + hip_girth"\npercent = 25.0'

    of: FormulaText
    percent: float

    @property
    def accuracy_class(self) -> AccuracyClass:
        return AccuracyClass.SEGMENT_LENGTH

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:  # noqa: ARG002
        operands = {
            name: Estimate(others[name].value, others[name].error_estimate)
            for name in self.operands
        }
        value, error = evaluate_formula(parse_formula(self.of), operands)
        part = self.percent / 100.0
        return Measured(self, Outcome.MEASURED, value=part * value, error_estimate=part * error)


class Middle(LandmarkRule, frozen=True, kw_only=True, tag="middle"):
    """The point of the body that is closest to the middle of a straight line.

    Parameters
    ----------
    start, end : str
        The landmarks between which the line runs.
    """

    example: ClassVar[str] = 'start = "bust point left"\nend = "bust point right"'

    start: Landmark
    end: Landmark

    @property
    def description(self) -> str:
        return f"closest to the middle between {self.start} and {self.end}"

    def point(self, atlas: Atlas, landmarks: Landmarks) -> AtlasPoint:
        start, end = (atlas.position(landmarks[name]) for name in (self.start, self.end))
        return closest_points(atlas, 0.5 * (start + end)[None])[0][0]


@pytest.fixture
def new_entries(monkeypatch: pytest.MonkeyPatch) -> None:
    """The registries with the new entries."""
    monkeypatch.setitem(KINDS, "polyline", Polyline)
    monkeypatch.setitem(KINDS, "share", Share)
    monkeypatch.setitem(RULES, "middle", Middle)


TEXT = """
format = "bodymeasure measurements"
version = 1
name = "New"

[[landmark]]
name = "middle bust point"
rule = "middle"
start = "bust point left"
end = "bust point right"

[[measurement]]
key = "quarter"
kind = "share"
name = "A quarter of the line"
of = "line_left"
percent = 25.0

[[measurement]]
key = "line_{side}"
kind = "polyline"
name = "Neck to middle, {side}"
corners = ["side neck point {side}", "bust point {side}", "middle bust point"]
"""


def read(text: str) -> Definitions:
    return definitions_from(text.encode(), "new.toml")


@pytest.mark.usefixtures("new_entries")
@pytest.mark.parametrize("kind", [Polyline, Share, Middle])
def test_new_entries_are_complete(kind: type[MeasurementDefinition]) -> None:
    assert_complete(kind)
    assert_names_what_it_asks_for(kind)


@pytest.mark.usefixtures("new_entries")
def test_new_entries_are_read_measured_and_written() -> None:
    definitions = read(TEXT)
    raw = msgspec.json.decode(msgspec.json.encode(definitions))
    jsonschema.validate(raw, definitions_schema())
    body = load_sample("female_average")
    chart = measure_chart(body, definitions)
    at = {name: body.position(point) for name, point in chart.landmarks.items()}
    legs = [at["bust point left"] - at["side neck point left"]]
    legs.append(at["middle bust point"] - at["bust point left"])
    length = sum(float(np.linalg.norm(leg)) for leg in legs)
    assert chart["line_left"].value == pytest.approx(length, rel=1e-14)
    assert chart["quarter"].value == 0.25 * chart["line_left"].value
    assert chart["line_right"].landmarks[0] == "side neck point right"
    document = chart_document(chart, "cm")
    record = json.loads(to_json(document))["measurements"][1]
    assert (record["kind"], record["accuracy_class"]) == ("polyline", "segment length")
    assert record["value"] == pytest.approx(100.0 * length)
    assert b",polyline," in chart_to_csv(document)
    assert b"Neck to middle, left" in render_chart(document)
    (lack,) = lacking(
        definitions.measurement[:1] + definitions.measurement[1:],
        set(at) - {"side neck point right"},
    )
    assert lack.landmarks == ("side neck point right",)


@pytest.mark.usefixtures("new_entries")
@pytest.mark.parametrize(
    ("before", "after", "message"),
    [
        ('"polyline"', '"polylin"', "has the unknown kind 'polylin'; did you mean 'polyline'"),
        ("corners", "corner", "has the unknown member 'corner'; did you mean 'corners'"),
        ("of = ", "off = ", "has the unknown member 'off'; did you mean 'of'"),
        ("percent = 25.0", "", "has no 'percent', which the kind 'share' needs; add it"),
        ('"line_left"', '"line_lft"', "names 'line_lft', which is no key here; did you mean"),
        ('"line_left"', '"quarter"', "the formulas go round in a circle: quarter -> quarter"),
        (', "bust point {side}", "middle bust point"', "", "corners needs two landmarks or more"),
        ('"bust point right"', "2", "line 10: landmark 'middle bust point': end: expected text"),
    ],
)
def test_new_entries_are_read_with_helpful_errors(before: str, after: str, message: str) -> None:
    assert before in TEXT
    with pytest.raises(InputError) as caught:
        read(TEXT.replace(before, after))
    assert message in str(caught.value)


def test_what_is_not_registered_is_noticed() -> None:
    with pytest.raises(AssertionError, match="Polyline is not registered"):
        assert_complete(Polyline)


class Forgetful(Polyline, frozen=True, kw_only=True, tag="polyline"):
    """A polyline that also needs a landmark which no typed member names."""

    example: ClassVar[str] = Polyline.example + '\nlast = "front waist point"'

    last: str

    def measure(self, body: Body, others: Mapping[str, Measured]) -> Measured:
        body.position(self.last)
        return super().measure(body, others)


class Idle(Polyline, frozen=True, kw_only=True, tag="polyline"):
    """A polyline that names a landmark which it does not need.

    Parameters
    ----------
    last : str
    """

    example: ClassVar[str] = Polyline.example + '\nlast = "front waist point"'

    last: Landmark


class Unclassed(MeasurementDefinition, frozen=True, kw_only=True, tag="polyline"):
    """A kind without an accuracy class.

    Parameters
    ----------
    at : str
        A landmark.
    """

    example: ClassVar[str] = 'at = "front waist point"'

    at: Landmark


class ForgetfulMiddle(Middle, frozen=True, kw_only=True, tag="middle"):
    """A rule that forgets to name one of its landmarks."""

    end: str


def test_what_is_forgotten_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as patched:
        patched.setitem(KINDS, "polyline", Forgetful)
        with pytest.raises(AssertionError, match=r"uses {'front waist point'}, whose members are"):
            assert_names_what_it_asks_for(Forgetful)
        with pytest.raises(AssertionError, match="Forgetful does not document"):
            assert_complete(Forgetful)
        patched.setitem(KINDS, "polyline", Idle)
        with pytest.raises(AssertionError, match=r"Idle never uses {'front waist point'}"):
            assert_names_what_it_asks_for(Idle)
        patched.setitem(KINDS, "polyline", Unclassed)
        with pytest.raises(NotImplementedError):
            assert_complete(Unclassed)
        patched.setitem(RULES, "middle", ForgetfulMiddle)
        with pytest.raises(
            AssertionError, match=r"uses {'bust point right'}, whose members are no"
        ):
            assert_names_what_it_asks_for(ForgetfulMiddle)
