"""Several bodies in one chart, and in one comparison."""

import csv
import io
import json
from dataclasses import replace
from pathlib import Path

import jsonschema
import pytest
from helpers.command_line import Run
from helpers.files.page import Page

import bodymeasure as bm

# Quick to measure, and one that follows from others.
ONLY = ("--only", "knee_height,waist_depth,shoulder_slope_left")
KEYS = ["knee_height_left", "knee_height_right", "waist_depth", "shoulder_slope_left"]


def body(factor: float = 1.0, name: str = "") -> bm.Atlas:
    average = bm.load_sample("female_average")
    return replace(average, points=factor * average.points, name=name or average.name)


@pytest.fixture
def bodies(tmp_path: Path) -> Path:
    folder = tmp_path / "bodies"
    folder.mkdir()
    bm.write_atlas(body(), folder / "anna.atlas")
    bm.write_atlas(body(1.1), folder / "berta.atlas")
    return folder


def test_several_files_are_a_row_each(run: Run, bodies: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    ran = run("chart", bodies / "anna.atlas", bodies / "berta.atlas", *ONLY, "-o", out)
    assert (ran.code, ran.err) == (0, "")
    assert {file.name for file in out.iterdir()} == {
        "population.html",
        "wide.csv",
        "summary.csv",
        "measurements.csv",
        "measurements.json",
        "measurements.schema.json",
    }
    header, anna, berta = csv.reader(io.StringIO((out / "wide.csv").read_text("utf-8")))
    units = ["cm", "cm", "cm", "deg"]
    assert header == ["subject", *(f"{k} ({u})" for k, u in zip(KEYS, units, strict=True))]
    assert (anna[0], berta[0]) == ("anna", "berta")
    for mine, theirs in zip(anna[1:4], berta[1:4], strict=True):
        assert float(theirs) == pytest.approx(1.1 * float(mine))
    summary = list(csv.DictReader(io.StringIO((out / "summary.csv").read_text("utf-8"))))
    assert float(summary[0]["mean"]) == pytest.approx(1.05 * float(anna[1]))
    assert float(summary[0]["maximum"]) == float(berta[1])
    content = json.loads((out / "measurements.json").read_bytes())
    jsonschema.validate(content, json.loads((out / "measurements.schema.json").read_bytes()))
    page = Page((out / "population.html").read_bytes())
    page.check_links()
    page.check_self_contained()
    assert "2 subjects, 4 measurements each" in page.text

    # What was written is read again, from either file.
    for other in ("measurements.csv", "measurements.json"):
        ran = run("compare", out / "measurements.json", out / other)
        assert ran.code == 0
        assert "2 subjects compared: 3 with too few subjects to tell, 1 without a class." in ran.out


def test_a_folder_and_a_file_of_many_are_several_bodies(
    run: Run, bodies: Path, tmp_path: Path
) -> None:
    file = tmp_path / "both.npz"
    bm.write_population([body(name="anna"), body(1.1, "berta")], file)
    by_file, by_folder = (
        json.loads(run("chart", source, *ONLY, "--format", "json").out) for source in (file, bodies)
    )
    assert by_file["subjects"] == by_folder["subjects"] == ["anna", "berta"]
    values = [
        [[one["value"] for one in chart["measurements"]] for chart in found["charts"]]
        for found in (by_file, by_folder)
    ]
    assert values[0] == values[1]
    table = run("chart", bodies, *ONLY).out
    assert "mean, cm" in table
    long = run("chart", bodies, *ONLY, "--format", "csv").out
    assert len(list(csv.DictReader(io.StringIO(long)))) == 2 * len(KEYS)


def test_a_subject_that_lacks_a_value_is_told(run: Run, bodies: Path, tmp_path: Path) -> None:
    few = body()
    kept = {name: at for name, at in few.landmarks.items() if name != "patella point left"}
    bm.write_atlas(replace(few, landmarks=kept), bodies / "clara.atlas")
    ran = run("chart", bodies, *ONLY, "-o", tmp_path / "out")
    assert ran.code == 1
    assert "without a value on some: Knee height, left (1)" in ran.out
    page = Page((tmp_path / "out" / "population.html").read_bytes())
    assert "Knee height, left (clara)" in page.text
    assert "2 of 3" in page.text


def test_a_folder_without_an_atlas_is_refused(run: Run, tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    ran = run("chart", tmp_path / "empty")
    assert ran.code == 2
    assert "is a folder without an atlas" in ran.err


def test_bodies_with_errors_are_refused_by_number(run: Run, tmp_path: Path) -> None:
    wrong = body(100.0, "giant")
    bm.write_population([body(name="anna"), wrong], tmp_path / "both.npz")
    ran = run("chart", tmp_path / "both.npz", *ONLY, "-o", tmp_path / "out")
    assert ran.code == 2
    assert "both.npz, body 2: the atlas has 1 error" in ran.err
    assert not (tmp_path / "out").exists()


def test_every_subject_has_a_name_of_its_own(run: Run, bodies: Path, tmp_path: Path) -> None:
    other = tmp_path / "other"
    other.mkdir()
    for target in (other / "anna.atlas", other / "anna 1.atlas"):
        bm.write_atlas(body(1.2), target)
    files = (bodies / "anna.atlas", other / "anna.atlas", other / "anna 1.atlas")
    ran = run("chart", *files, *ONLY, "--format", "json")
    assert ran.code == 0
    assert json.loads(ran.out)["subjects"] == ["anna 2", "anna 3", "anna 1"]


def test_a_subject_given_twice_does_not_count_twice(run: Run, bodies: Path) -> None:
    for names in ([bodies, bodies / "anna.atlas"], ["female_average", "female_average"]):
        ran = run("chart", *names, *ONLY)
        assert (ran.code, ran.out) == (2, "")
        assert f"{names[1]}: is given twice; give every subject once" in ran.err
