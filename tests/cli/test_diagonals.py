import csv
import io
import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers.command_line import Run
from helpers.surfaces.solids import CUBE, obj_text

from bodymeasure import (
    Atlas,
    GeodesicSolution,
    Status,
    diagonals,
    read_atlas,
    write_atlas,
)

FIELDS = {"name", "kind", "patch", "length", "unit", "error_estimate", "status"}
METERS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "inch": 0.0254}


def printed_json(run: Run, *arguments: object) -> dict[str, Any]:
    ran = run("diagonals", *arguments, "--format", "json")
    assert (ran.code, ran.err) == (0, "")
    content: dict[str, Any] = json.loads(ran.out)
    return content


def test_json_holds_the_records_of_all_diagonals(run: Run, part: Path) -> None:
    atlas = read_atlas(part)
    content = printed_json(run, part)
    assert content["unit"] == "cm"
    records = content["measurements"]
    assert all(record.keys() >= FIELDS for record in records)
    assert {(r["kind"], r["unit"]) for r in records} == {("diagonal", "cm")}
    assert [r["patch"] for r in records] == [n for name in atlas.patch_names for n in (name, name)]
    assert len({r["name"] for r in records}) == 2 * len(atlas)
    solution = diagonals(atlas)
    lengths = [math.nan if r["length"] is None else r["length"] for r in records]
    np.testing.assert_allclose(lengths, 100.0 * solution.length.ravel(), rtol=1e-14)
    errors = [r["error_estimate"] for r in records]
    np.testing.assert_allclose(errors, 100.0 * solution.error_estimate.ravel(), rtol=1e-14)
    assert [r["status"] for r in records] == [
        s.name.lower() for s in np.asarray(solution.status).ravel()
    ]


def test_csv_equals_json(run: Run, part: Path) -> None:
    ran = run("diagonals", part, "--format", "csv")
    assert (ran.code, ran.err) == (0, "")
    rows = list(csv.DictReader(io.StringIO(ran.out)))
    records = printed_json(run, part)["measurements"]
    assert len(rows) == len(records)
    for row, record in zip(rows, records, strict=True):
        for pair in ("start", "end"):
            record[f"{pair}_u"], record[f"{pair}_v"] = record.pop(pair)
        assert row.keys() == record.keys()
        for key, text in row.items():
            value = record[key]
            assert text == (
                "" if value is None else value if isinstance(value, str) else str(value)
            )


def test_the_table_has_a_row_for_each(run: Run, part: Path) -> None:
    ran = run("diagonals", part)
    assert (ran.code, ran.err) == (0, "")
    header, *rows = ran.out.partition("\n\n")[0].splitlines()
    assert header.split() == ["diagonal", "cm", "error", "shortest", "status"]
    records = printed_json(run, part)["measurements"]
    assert len(rows) == len(records)
    for row, record in zip(rows, records, strict=True):
        assert row.startswith(record["name"])
        rest = row.removeprefix(record["name"]).split()
        status = record["status"].split("_")
        status = ["proven", *status] if record["proven_shortest"] else status
        if record["length"] is None:
            assert rest == status
        else:
            numbers = [f"{record['length']:.4f}", f"{record['error_estimate']:.0e}"]
            assert rest == [*numbers, *status]


def test_the_table_explains_why_there_is_no_length(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    def left(atlas: Atlas) -> GeodesicSolution:
        """Diagonals, one of which has the status of a path that leaves its patch."""
        solution = diagonals(atlas)
        status, length = np.asarray(solution.status).copy(), solution.length.copy()
        status[0, 1], length[0, 1] = Status.LEAVES_PATCH, math.nan
        return replace(solution, status=status, length=length)

    monkeypatch.setattr(
        "bodymeasure.measure.patches.survey.diagonals", lambda atlas, **_: left(atlas)
    )
    ran = run("diagonals", "enneper")
    assert (ran.code, ran.err) == (0, "")
    table, *sentences = ran.out.split("\n\n")
    assert table.splitlines()[2].split() == ["enneper", "diagonal", "2", "leaves", "patch"]
    assert sentences[0].startswith("shortest: 1 of 1 measured diagonals are proven")
    assert sentences[1:] == [f"leaves patch: {Status.LEAVES_PATCH.value}\n"]
    records = printed_json(run, "enneper")["measurements"]
    assert (records[1]["length"], records[1]["status"]) == (None, "leaves_patch")


@pytest.mark.parametrize("unit", METERS)
def test_units_are_those_asked_for(run: Run, unit: str) -> None:
    content = printed_json(run, "enneper", "--unit", unit)
    assert content["unit"] == unit
    length = content["measurements"][0]["length"]
    assert math.isclose(length * METERS[unit], math.sqrt(2) * 5 / 3 * 0.01, rel_tol=1e-13)
    assert run("diagonals", "enneper", "--unit", unit).out.split()[1] == unit


def test_lengths_do_not_depend_on_the_unit_of_the_file(
    run: Run, part: Path, tmp_path: Path
) -> None:
    write_atlas(read_atlas(part).converted("cm"), tmp_path / "cm.atlas")
    meters = printed_json(run, part, "--unit", "mm")["measurements"]
    centimeters = printed_json(run, tmp_path / "cm.atlas", "--unit", "mm")["measurements"]
    assert [r["status"] for r in meters] == [r["status"] for r in centimeters]
    for one, other in zip(meters, centimeters, strict=True):
        if one["length"] is not None:
            assert math.isclose(one["length"], other["length"], rel_tol=1e-12)


def test_lengths_show_what_an_approximation_costs(run: Run, tmp_path: Path) -> None:
    mesh, file = tmp_path / "cube.obj", tmp_path / "cube.atlas"
    mesh.write_text(obj_text(CUBE))
    run("convert", mesh, "--file-unit", "cm", "--deviation", "inf", "-o", file)
    ran = run("diagonals", file)
    head, first = ran.out.splitlines()[:2]
    words = ["error", "approximation", "on", "the", "mesh", "shortest", "status"]
    assert head.split()[-7:] == words
    assert [word for word in first.split() if word != "proven"][-3:] == [
        "2e-02",
        "+0.5",
        "converged",
    ]
    assert "\nThe mesh itself lies within 0.43 cm of the patches" in ran.out
    document = json.loads(run("diagonals", file, "--format", "json").out)
    assert document["approximation"][0].startswith("The patches approximate")
    assert all(record["approximation_error"] > 0.0 for record in document["measurements"])
