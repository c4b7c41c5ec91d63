import re
from dataclasses import replace

import msgspec
import pytest
from helpers.charts.hand_made_chart import BUST, MEASURED, SLOPE, hand_made_chart

from bodymeasure.chart import Chart, Definitions, MeasurementDefinition
from bodymeasure.errors import InputError
from bodymeasure.report.body import (
    GARMENTCODE_KEYS,
    chart_document,
    check_codes,
    missing_garmentcode,
    to_garmentcode,
)

CODES = {
    "bust_girth": "bust",
    "upper_arm_girth_left": "wrist",
    "upper_arm_girth_right": "wrist",
    "waist_height": "waist",
    "shoulder_slope": "shoulder_incl",
}
# A body of GarmentCode's own, for the names and the layout (its assets/bodies).
THEIRS = """body:
  arm_length: 53.9697
  arm_pose_angle: 0.0
  armscye_depth: 12.8679
  back_width: 47.6761
  bum_points: 18.2342
  bust: 99.8407
  bust_line: 25.6947
  bust_points: 16.9463
  crotch_hip_diff: 8.81363
  head_l: 26.3262
  height: 171.99
  hip_back_width: 54.8237
  hip_inclination: 9.86489
  hips: 103.478
  hips_line: 23.4837
  leg_circ: 60.2039
  neck_w: 18.9328
  shoulder_incl: 21.6777
  shoulder_w: 36.4568
  underbust: 86.2455
  vert_bust_line: 21.1388
  waist: 84.3338
  waist_back_width: 39.1358
  waist_line: 36.8913
  waist_over_bust_line: 40.5603
  wrist: 16.5945
"""


def _read(text: str) -> dict[str, float]:
    """The numbers below ``body:``, which is as much YAML as such files hold."""
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    assert lines[0] == "body:"
    found = [re.fullmatch(r"  (\w+): (-?\d+(?:\.\d+)?)", line) for line in lines[1:]]
    return {match[1]: float(match[2]) for match in found if match}


def _coded(name: str = "Anna") -> Chart:
    chart = hand_made_chart()
    measured = tuple(
        replace(
            one,
            definition=msgspec.structs.replace(
                one.definition, garmentcode=CODES.get(one.definition.key)
            ),
        )
        for one in MEASURED
    )
    return replace(chart, measured=measured, atlas=replace(chart.atlas, name=name))


def test_the_keys_are_garmentcodes() -> None:
    assert list(_read(THEIRS)) == list(GARMENTCODE_KEYS)


@pytest.mark.parametrize("unit", ["cm", "inch", "m", "mm"])
def test_values_are_in_centimeters_and_degrees(unit: str) -> None:
    document = chart_document(_coded(), unit)
    text = to_garmentcode(document).decode()
    # The value is that of the wearer's right arm; the height could not be measured.
    assert _read(text) == {"bust": 91.32, "shoulder_incl": 23.578, "wrist": 30.2}
    missing = missing_garmentcode(document)
    assert sorted([*missing, *_read(text)]) == list(GARMENTCODE_KEYS)
    assert f"# Missing: {', '.join(missing)}.\n" in text


def test_a_name_does_not_end_the_comment() -> None:
    text = to_garmentcode(chart_document(_coded("Anna\nbody: 1"), "cm")).decode()
    assert text.startswith("# Anna body: 1, measured by bodymeasure")


def test_a_chart_without_any_is_a_body_without_any() -> None:
    text = to_garmentcode(chart_document(hand_made_chart(), "cm")).decode()
    assert text.splitlines()[-1] == "body: {}"


def _set(measurement: MeasurementDefinition) -> Definitions:
    return Definitions(name="a set", measurement=(measurement,))


@pytest.mark.parametrize(
    ("definition", "message"),
    [
        (msgspec.structs.replace(BUST, garmentcode="bsut"), "'bsut' is no measurement of Garment"),
        (
            msgspec.structs.replace(BUST, garmentcode="shoulder_incl"),
            "GarmentCode's 'shoulder_incl' is an angle, and this is a length",
        ),
        (
            msgspec.structs.replace(SLOPE, garmentcode="waist"),
            "GarmentCode's 'waist' is a length, and this is an angle",
        ),
    ],
)
def test_wrong_keys_are_refused(definition: MeasurementDefinition, message: str) -> None:
    with pytest.raises(InputError, match=message):
        check_codes(_set(definition))
