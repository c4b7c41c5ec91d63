import json
import re
from dataclasses import replace

import msgspec
import pytest
from helpers.charts.hand_made_chart import BUST, SLOPE, hand_made_chart

from bodymeasure.chart import Definitions, MeasurementDefinition
from bodymeasure.errors import InputError
from bodymeasure.report.body import (
    FREESEWING_KEYS,
    asked_freesewing,
    chart_document,
    check_codes,
    missing_freesewing,
    to_freesewing,
)

# The list is that of FreeSewing's config/measurements.mjs.
KEYS = re.findall(
    r"\w+",
    """
ankle biceps bustFront bustPointToUnderbust bustSpan chest crossSeam crossSeamFront crotchDepth
head heel highBust highBustFront hips hpsToBust hpsToWaistBack hpsToWaistFront inseam knee neck
seat seatBack shoulderSlope shoulderToElbow shoulderToShoulder shoulderToWrist underbust upperLeg
waist waistBack waistToArmpit waistToFloor waistToHips waistToKnee waistToSeat waistToUnderbust
waistToUpperLeg wrist
""",
)


def test_the_keys_are_freesewings() -> None:
    assert list(FREESEWING_KEYS) == KEYS


@pytest.mark.parametrize("unit", ["cm", "inch", "m", "mm"])
def test_values_are_in_millimeters_and_degrees(unit: str) -> None:
    document = chart_document(hand_made_chart(), unit)
    content = json.loads(to_freesewing(document))
    assert set(content) == {"name", "units", "notes", "measurements"}
    assert content["units"] == "metric"
    # The value is that of the wearer's right arm; the height could not be measured.
    assert content["measurements"] == {"biceps": 302.0, "chest": 913.2, "shoulderSlope": 23.58}
    missing = missing_freesewing(document)
    assert sorted([*missing, *content["measurements"]]) == sorted(KEYS)
    assert f"Missing: {', '.join(missing)}." in content["notes"]


def test_only_keys_of_what_was_asked_for_can_be_missing() -> None:
    chart = replace(hand_made_chart(), only=("bust_girth",))
    document = chart_document(chart, "cm")
    asked = asked_freesewing(document)
    assert set(missing_freesewing(document)) < set(asked) < set(KEYS)
    notes = json.loads(to_freesewing(document))["notes"]
    assert "head" not in notes


def _set(*measurements: MeasurementDefinition) -> Definitions:
    return Definitions(
        format="bodymeasure measurements", version=1, name="a set", measurement=measurements
    )


@pytest.mark.parametrize(
    ("definition", "message"),
    [
        (msgspec.structs.replace(BUST, freesewing="chset"), "'chset'.*did you mean 'chest'"),
        (
            msgspec.structs.replace(BUST, freesewing="shoulderSlope"),
            "is an angle.*this is a length",
        ),
        (msgspec.structs.replace(SLOPE, freesewing="waist"), "is a length.*this is an angle"),
        (msgspec.structs.replace(BUST, seamly=("bust circ",)), "'bust circ' cannot be a name"),
    ],
)
def test_wrong_codes_are_refused(definition: MeasurementDefinition, message: str) -> None:
    with pytest.raises(InputError, match=message):
        check_codes(_set(definition))


def test_right_codes_are_taken() -> None:
    check_codes(_set(BUST, SLOPE))
