import csv
import io
import json
import math
from datetime import UTC, datetime

import jsonschema
import pytest
from helpers.charts.hand_made_chart import BUST, HOSTILE, MEASURED, hand_made_chart

from bodymeasure.report.body import ChartDocument, chart_document, chart_to_csv
from bodymeasure.report.serial import json_schema, to_json

METERS_TO = {"m": 1.0, "cm": 100.0, "mm": 1000.0, "inch": 1.0 / 0.0254}


@pytest.mark.parametrize("unit", METERS_TO)
def test_json_is_valid_and_in_the_unit(unit: str) -> None:
    document = chart_document(hand_made_chart(), unit)
    content = json.loads(to_json(document))
    schema = json_schema(ChartDocument)
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.Draft202012Validator(schema).validate(content)
    assert content["unit"] == unit
    bust = content["measurements"][0]
    scale = METERS_TO[unit]
    for key, meters in (("value", 0.9132), ("contact", 0.92345), ("gap", 0.01025)):
        assert math.isclose(bust[key], scale * meters, rel_tol=1e-12)
    assert math.isclose(bust["error_estimate"], scale * 1.5e-9, rel_tol=1e-12)
    assert math.isclose(sum(bust["length_by_region"].values()), bust["contact"], rel_tol=1e-12)
    assert {m["unit"] for m in content["measurements"]} == {unit, "deg"}


def test_angles_stay_in_degrees() -> None:
    slope = chart_document(hand_made_chart(), "mm").measurements[-1]
    assert (slope.unit, slope.value, slope.error_estimate) == ("deg", 23.578, 0.01)
    assert slope.accuracy_class is None


def test_records_say_all_that_is_known() -> None:
    document = chart_document(hand_made_chart(), "cm", created=datetime(2026, 1, 2, tzinfo=UTC))
    assert document.created == "2026-01-02T00:00:00+00:00"
    assert document.outcomes == {"measured": 5, "not converged": 1, "missing landmark": 1}
    bust, _, _, shoulder, height, *_ = document.measurements
    assert (bust.number, bust.key, bust.kind, bust.group) == (1, "bust_girth", "girth", "Girths")
    assert (bust.iso_name, bust.iso_clause) == ("bust girth", "5.3.4")
    assert (bust.seamly, bust.freesewing) == (["bust_circ"], "chest")
    assert (bust.status, bust.words) == ("converged", BUST.words)
    assert (shoulder.value, shoulder.gap, shoulder.status) == (None, None, "no_route")
    # The numbers are those of the pictures, which show the measurements with a value.
    assert [m.number for m in document.measurements] == [1, 2, 3, None, None, 4, 5]
    assert shoulder.iso_clause is None
    assert (height.outcome, height.status) == ("missing landmark", None)
    assert [(p.name, p.given) for p in document.landmarks] == [
        ("bust point left", True),
        ("navel", False),
    ]
    assert [p.name for p in document.missing_landmarks] == ["waist"]


def test_csv_holds_the_same_columns_flattened() -> None:
    document = chart_document(hand_made_chart(), "cm")
    text = chart_to_csv(document).decode()
    rows = list(csv.DictReader(io.StringIO(text, newline="")))
    assert len(rows) == len(MEASURED)
    for row, record in zip(rows, document.measurements, strict=True):
        # What an approximation or a scan costs has no column where there is none.
        costs = ("approximation_error", "mesh_difference", "input_uncertainty")
        assert list(row) == [name for name in record.__struct_fields__ if name not in costs]
        # Every float survives a round trip.
        assert (float(row["value"]) if row["value"] else None) == record.value
        assert row["landmarks"] == "; ".join(record.landmarks)
    assert rows[3]["name"] == HOSTILE
    regions = dict(pair.rsplit("=", 1) for pair in rows[0]["length_by_region"].split("; "))
    assert {k: float(v) for k, v in regions.items()} == document.measurements[0].length_by_region
