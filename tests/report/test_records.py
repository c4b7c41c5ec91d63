import csv
import io
import json
import math
from collections.abc import Callable
from datetime import UTC, datetime
from typing import Any

import jsonschema
import numpy as np
import pytest

from bodymeasure.errors import InputError
from bodymeasure.geodesic.status import Status
from bodymeasure.report import (
    Document,
    json_schema,
    measurement_records,
    survey_document,
    to_csv,
    to_json,
)


def refuse(constant: str) -> float:
    raise AssertionError(f"{constant} is not JSON")


def decoded(survey: Any, unit: str = "cm") -> Any:
    return json.loads(to_json(survey_document(survey, unit)), parse_constant=refuse)


@pytest.mark.parametrize("check", [True, False])
def test_json_is_as_its_schema_says(survey_of: Callable[..., Any], check: bool) -> None:
    jsonschema.Draft202012Validator.check_schema(json_schema(Document))
    jsonschema.Draft202012Validator(json_schema(Document)).validate(decoded(survey_of(check=check)))


def test_the_schema_documents_every_field_of_a_measurement_and_refuses_others(survey: Any) -> None:
    fields = json_schema(Document)["$defs"]["PatchRecord"]["properties"]
    content = decoded(survey)
    # What an approximation costs is absent where there is none.
    costs = ("approximation_error", "mesh_difference")
    there = [name for name in fields if name not in costs]
    assert list(content["measurements"][0]) == there
    assert len(there) == len(fields) - len(costs)
    undocumented = [
        name
        for name, field in fields.items()
        if "description" not in field and "description" not in str(field)
    ]
    assert undocumented == []
    content["measurements"][0]["girth"] = 1.0
    with pytest.raises(jsonschema.ValidationError, match="girth"):
        jsonschema.validate(content, json_schema(Document))


def test_lengths_survive_at_full_precision_in_the_atlas_unit(survey: Any) -> None:
    records = [m for m in decoded(survey, "m")["measurements"] if m["kind"] == "diagonal"]
    lengths = [math.nan if m["length"] is None else m["length"] for m in records]
    np.testing.assert_array_equal(lengths, survey.diagonals.length.ravel())
    sides = [m["length"] for m in decoded(survey, "m")["measurements"] if m["kind"] == "boundary"]
    assert sides == survey.boundary.length.ravel().tolist()


def test_every_length_is_in_the_unit_asked_for(survey: Any) -> None:
    in_meters, in_inches = decoded(survey, "m"), decoded(survey, "inch")
    assert in_inches["unit"] == "inch"
    converted = (
        "length raw_length error_estimate exact exact_uncertainty heat difference".split()  # noqa: SIM905
    )
    kept = ("relative_difference", "residual", "functions", "iterations", "start", "end")
    for a, b in zip(in_meters["measurements"], in_inches["measurements"], strict=True):
        assert b["unit"] == "inch"
        for key in converted:
            assert (a[key] is None) == (b[key] is None)
            if a[key] is not None:
                assert b[key] * 0.0254 == pytest.approx(a[key], rel=1e-15, abs=0.0)
        assert [a[key] for key in kept] == [b[key] for key in kept]
    assert in_inches["summary"]["length"]["median"] * 0.0254 == pytest.approx(
        in_meters["summary"]["length"]["median"], rel=1e-15
    )


def test_an_unknown_unit_is_refused(survey: Any) -> None:
    with pytest.raises(InputError, match="unknown unit 'ell'"):
        survey_document(survey, "ell")


def test_what_is_not_measured_is_null_and_says_why(survey: Any) -> None:
    content = decoded(survey)
    missing = [m for m in content["measurements"] if m["length"] is None]
    assert {m["status"] for m in missing} == {"leaves_patch", "not_converged"}
    for record in missing:
        assert record["error_estimate"] is None
        assert record["difference"] is None
        assert record["raw_length"] > 0.0
    assert content["statuses"] == {
        status.name.lower(): status.value
        for status in (Status.CONVERGED, Status.LEAVES_PATCH, Status.NOT_CONVERGED)
    }
    assert content["summary"]["by_status"] == {
        "converged": 6,
        "leaves_patch": 1,
        "not_converged": 1,
    }


def test_without_a_cross_check_its_fields_are_null(survey_of: Callable[..., Any]) -> None:
    content = decoded(survey_of(check=False))
    for key in ("exact", "exact_uncertainty", "difference", "heat", "verdict"):
        assert {m[key] for m in content["measurements"]} == {None}
    assert content["verdicts"] == {}
    assert content["summary"]["difference"]["count"] == 0
    assert content["summary"]["worst"] is None


def test_the_summary_agrees_with_the_survey(survey: Any) -> None:
    summary = decoded(survey, "m")["summary"]
    differences = np.abs(survey.cross_check.difference)
    assert summary["difference"]["maximum"] == np.nanmax(differences)
    assert summary["difference"]["median"] == np.nanmedian(differences)
    assert summary["measured"] == np.isfinite(survey.diagonals.length).sum()
    assert summary["worst"] == "torso front left 1-1 diagonal 2"


def test_records_say_what_is_proven(survey: Any) -> None:
    content = decoded(survey)
    proven = [m["proven_shortest"] for m in content["measurements"] if m["kind"] == "diagonal"]
    assert proven == survey.diagonals.proven_shortest.ravel().tolist()
    assert content["summary"]["proven_shortest"] == sum(proven)
    sides = {m["proven_shortest"] for m in content["measurements"] if m["kind"] == "boundary"}
    assert sides == {None}


def test_names_are_unique_and_patches_stay_together(survey: Any) -> None:
    records = measurement_records(survey, "cm")
    assert len({record.name for record in records}) == len(records) == 4 * 6
    assert [record.patch_number for record in records] == np.repeat(range(4), 6).tolist()


def test_diagonals_alone_need_no_boundary(survey: Any) -> None:
    del survey.boundary
    records = measurement_records(survey, "cm", kinds=("diagonal",))
    assert {record.kind for record in records} == {"diagonal"}
    assert len(records) == 8


def test_sides_run_between_the_corners_that_their_names_say(survey: Any) -> None:
    sides = [r for r in measurement_records(survey, "cm") if r.kind == "boundary"][:4]
    assert [(side.start, side.end) for side in sides] == [
        ((0.0, 0.0), (0.0, 1.0)),
        ((1.0, 0.0), (1.0, 1.0)),
        ((0.0, 0.0), (1.0, 0.0)),
        ((0.0, 1.0), (1.0, 1.0)),
    ]


def test_csv_reads_back_to_the_same_values(survey: Any) -> None:
    records = measurement_records(survey, "cm")
    content = to_csv(records)
    assert content.count(b"\r\n") == content.count(b"\n") == len(records) + 1
    rows = list(csv.DictReader(io.StringIO(content.decode(), newline="")))
    for row, record in zip(rows, records, strict=True):
        for field in ("name", "kind", "patch", "region", "unit", "status"):
            assert row[field] == getattr(record, field)
        for field in ("length", "error_estimate", "residual", "difference", "heat"):
            value = getattr(record, field)
            assert row[field] == "" if value is None else float(row[field]) == value
        assert (float(row["start_u"]), float(row["start_v"])) == record.start
        assert (float(row["end_u"]), float(row["end_v"])) == record.end


def test_the_same_survey_gives_the_same_bytes(survey: Any) -> None:
    created = datetime(2024, 2, 29, 12, 30, tzinfo=UTC)
    documents = [survey_document(survey, "cm", created=created) for _ in range(2)]
    assert to_json(documents[0]) == to_json(documents[1])
    assert json.loads(to_json(documents[0]))["created"] == "2024-02-29T12:30:00+00:00"


def test_contacts_with_edges_are_told_in_words(survey: Any) -> None:
    records = measurement_records(survey, "cm", kinds=("diagonal",))
    told = [record.contacts for record in records]
    assert told[0] == "u = 0 from 0.25 to 0.5; v = 1 from 1 to 0.75"
    assert told[1:] == [None] * 7
