"""Nothing that a kind of measurement or a rule needs is forgotten."""

from dataclasses import replace
from functools import cache

import pytest
from helpers.charts.entries import (
    assert_complete,
    assert_names_what_it_asks_for,
    example_of,
    unregistered,
)

from bodymeasure import load_sample
from bodymeasure.atlas import Atlas, GivenLength
from bodymeasure.chart import (
    Definitions,
    LandmarkRule,
    MeasurementDefinition,
    Outcome,
    derive_landmarks,
    load_definitions,
    measure_chart,
    names_in,
)
from bodymeasure.chart import kinds as kinds_package
from bodymeasure.chart.entry import Entry
from bodymeasure.chart.kinds import KINDS
from bodymeasure.chart.landmarks import rules as rules_package
from bodymeasure.chart.landmarks.rules import RULES

EVERY = [*KINDS.values(), *RULES.values()]
every = pytest.mark.parametrize("kind", EVERY, ids=lambda kind: kind.__name__)


def test_each_file_is_registered() -> None:
    assert unregistered(kinds_package, "MeasurementDefinition", KINDS) == set()
    assert unregistered(rules_package, "LandmarkRule", RULES) == set()
    assert unregistered(kinds_package, "MeasurementDefinition", {}) == {
        kind.__name__ for kind in KINDS.values()
    }


@every
def test_each_is_complete(kind: type[Entry]) -> None:
    assert_complete(kind)


@every
def test_each_names_the_landmarks_that_it_asks_for(kind: type[Entry]) -> None:
    assert_names_what_it_asks_for(kind)


@every
def test_examples_name_what_the_default_set_knows(kind: type[Entry]) -> None:
    example, default = example_of(kind), load_definitions()
    assert set(example.landmarks) <= names_in(default)


@cache
def landmarked_body() -> Atlas:
    """A body with the landmarks and the lengths that the examples ask for."""
    body = load_sample("female_average")
    derived = derive_landmarks(body, load_definitions().landmark)
    return replace(body, landmarks=derived.landmarks, given={"example": GivenLength(0.57)})


@pytest.mark.slow
@every
def test_examples_are_found_on_a_body(kind: type[Entry]) -> None:
    body, example = landmarked_body(), example_of(kind)
    if isinstance(example, LandmarkRule):
        assert derive_landmarks(body, [example]).missing == {}
    if isinstance(example, MeasurementDefinition):
        every = load_definitions().measurement if example.formulas else ()
        definitions = Definitions(name="Examples", measurement=(*every, example))
        chart = measure_chart(body, definitions, only=["example"])
        assert chart["example"].outcome is Outcome.MEASURED
