"""What charts of scanned bodies say of the scan, on the page and in the files."""

import csv
import io
import json
from functools import cache

import pytest
from helpers.charts.scanned import scanned
from jsonschema import Draft202012Validator

from bodymeasure import load_sample, measure_chart
from bodymeasure.report.body import (
    ChartDocument,
    chart_document,
    chart_to_csv,
    render_chart,
    scan_sentences,
)
from bodymeasure.report.serial import json_schema, to_json

KEYS = ("bust_span", "knee_height_left", "shoulder_chord_left", "waist_depth")
SAMPLE = load_sample("female_average")


@cache
def document(unit: str = "mm", uncovered: tuple[int, ...] = ()) -> ChartDocument:
    return chart_document(measure_chart(scanned(SAMPLE, uncovered), only=KEYS), unit)


def test_each_value_has_the_uncertainty_of_the_scan_in_its_own_column() -> None:
    rows = list(csv.DictReader(io.StringIO(chart_to_csv(document()).decode())))
    span = next(row for row in rows if row["key"] == "bust_span")
    assert float(span["input_uncertainty"]) == pytest.approx(5.0, rel=0.02)
    assert float(span["error_estimate"]) < 1e-4
    content = json.loads(to_json(document()))
    Draft202012Validator(json_schema(ChartDocument)).validate(content)
    assert content["scan"]["distance"] == pytest.approx(0.6)
    knee = next(each for each in content["landmarks"] if each["name"] == "patella point left")
    assert (knee["origin"], knee["uncertainty"]) == ("carried", pytest.approx(5.0))


def test_the_page_adds_it_up_in_words() -> None:
    page = render_chart(document()).decode()
    assert '<th scope="col">From the scan</th>' in page
    assert "±\N{NO-BREAK SPACE}5.0\N{NO-BREAK SPACE}mm" in page
    assert "its surface lies 0.6" in page
    assert "The file&#39;s unit is mm." in page
    assert "It does not include the error of the scan" not in page
    _, second = scan_sentences(document())
    assert "uncertain by ±\N{NO-BREAK SPACE}" in second
    assert "about 19 of 20 cases" in second


def test_a_body_without_a_scan_says_nothing_of_one() -> None:
    plain = chart_document(measure_chart(SAMPLE, only=KEYS), "mm")
    assert scan_sentences(plain) == []
    assert b"input_uncertainty" not in to_json(plain) + chart_to_csv(plain)
    assert "From the scan" not in render_chart(plain).decode()
    Draft202012Validator(json_schema(ChartDocument)).validate(json.loads(to_json(plain)))


def test_what_the_scan_does_not_show_is_listed() -> None:
    knee = SAMPLE.landmarks["patella point left"].patch
    partly = document("cm", (knee,))
    assert json.loads(to_json(partly))["scan"]["uncovered"] == [SAMPLE.patch_names[knee]]
    assert "The scan has holes." in scan_sentences(partly)
    page = render_chart(partly).decode()
    assert "(not scanned)" in page
    assert partly.outcomes == {"measured": 3, "not scanned": 1}
