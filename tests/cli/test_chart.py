import csv
import io
import json
import math
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from helpers.charts.hand_made_chart import tape_pictures
from helpers.command_line import Run, hide_here, recorded_bars
from helpers.files.page import Page

import bodymeasure as bm

FILES = [
    "chart.html",
    "measurements.json",
    "measurements.csv",
    "measurements.schema.json",
    "female_average.smis",
    "freesewing.json",
    "garmentcode.yaml",
]
SET = """
format = "bodymeasure measurements"
version = 1
name = "Four"

[[measurement]]
key = "bust_girth"
kind = "girth"
name = "Bust girth"
group = "Girths"
at = "bust point left"
tape = "taut"
seamly = ["bust_circ"]
freesewing = "chest"

[[measurement]]
key = "waist_height_{side}"
kind = "height"
name = "Waist height, {side}"
group = "Heights"
at = "side waist point {side}"
freesewing = "waistToFloor"
"""
WRIST = """
[[measurement]]
key = "wrist_height"
kind = "height"
name = "Wrist height"
at = "no such point"
"""


@pytest.fixture
def definitions(tmp_path: Path) -> Path:
    path = tmp_path / "set.toml"
    path.write_text(SET, "utf-8")
    return path


def test_all_files_are_written(run: Run, definitions: Path, tmp_path: Path) -> None:
    folder = tmp_path / "new" / "chart"
    ran = run("chart", "--set", definitions, "-o", folder, "--no-pictures", "--unit", "inch")
    assert (ran.code, ran.err) == (0, "")
    assert sorted(path.name for path in folder.iterdir()) == sorted(FILES)
    content: dict[str, Any] = json.loads((folder / "measurements.json").read_bytes())
    schema = json.loads((folder / "measurements.schema.json").read_bytes())
    jsonschema.Draft202012Validator(schema).validate(content)
    assert content["unit"] == "inch"
    bust = content["measurements"][0]
    assert 0.6 / 0.0254 < bust["taut"] == bust["value"] < bust["contact"] < 1.1 / 0.0254
    assert (folder / "chart.html").read_text("utf-8").count("data:image/png") == 0
    millimeters = json.loads((folder / "freesewing.json").read_bytes())["measurements"]
    assert math.isclose(millimeters["chest"], 25.4 * bust["value"], abs_tol=0.006)
    smis = (folder / "female_average.smis").read_text("utf-8")
    assert f'<m name="bust_circ" value="{bust["value"]:.4f}" />' in smis
    assert "2 of 38 keys" in ran.out
    # The files stand at the end, one a line, to copy or to open.
    assert ran.out.splitlines()[-len(FILES) :] == [str(folder / name) for name in FILES]


def test_without_a_folder_the_chart_is_printed(run: Run, definitions: Path) -> None:
    table = run("chart", "female_average", "--set", definitions)
    assert (table.code, table.err) == (0, "")
    assert re.search(r"^Bust girth +\d\d\.\d +\d\d\.\d +\d\d\.\d .* measured$", table.out, re.M)
    ran = run("chart", "--set", definitions, "--format", "json", "--unit", "mm")
    records = json.loads(ran.out)["measurements"]
    assert [record["key"] for record in records] == [
        "bust_girth",
        "waist_height_left",
        "waist_height_right",
    ]
    ran = run("chart", "--set", definitions, "--format", "csv", "--unit", "m")
    rows = list(csv.DictReader(io.StringIO(ran.out, newline="")))
    for row, record in zip(rows, records, strict=True):
        assert math.isclose(1000.0 * float(row["value"]), record["value"], rel_tol=1e-12)
    inches = run("chart", "--set", definitions, "--unit", "inch").out
    assert re.search(r"^Bust girth +\d\d\.\d\d +\d\d\s\d+/\d+ ", inches, re.M)


def test_what_was_asked_for_and_is_missing_is_told(run: Run, definitions: Path) -> None:
    definitions.write_text(SET + WRIST, "utf-8")
    ran = run("chart", "--set", definitions)
    assert ran.code == 1
    assert re.search(r"^Wrist height .* missing landmark$", ran.out, re.M)
    assert "pick “no such point” to gain 1 measurement: Wrist height\n" in ran.out
    assert "    the atlas has no landmark 'no such point'; " in ran.out


def test_an_atlas_without_landmarks_is_no_success(run: Run) -> None:
    ran = run("chart", "paraboloid")
    assert ran.code == 1
    assert "measured" not in ran.out
    assert re.search(r"^Bust girth .* missing landmark$", ran.out, re.M)
    assert "pick “front waist point” to gain " in ran.out
    # Each cause and each place is said once.
    assert ran.out.count("the middle of the front at the waist") == 1
    assert "it has none at all" not in ran.out


def test_measurements_that_wait_for_one_point_are_told_together(run: Run, tmp_path: Path) -> None:
    body = bm.load_sample("female_average")
    lacking = {"bust point left", "crotch point"}
    landmarks = {name: at for name, at in body.landmarks.items() if name not in lacking}
    bm.write_atlas(replace(body, landmarks=landmarks), tmp_path / "body.atlas")
    options = ("--only", "bust_span,bust_girth,crotch_length,knee_height,trunk_girth")
    ran = run("chart", tmp_path / "body.atlas", *options)
    assert ran.code == 1
    told = ran.out.partition("\n\n")[2].splitlines()
    assert told == [
        "pick “bust point left” to gain 2 measurements: Bust girth; Bust span",
        "    the most forward point of the breast, on the wearer's left",
        "pick “crotch point” to gain 1 measurement: Total crotch length",
        "    the lowest point of the trunk, between the legs",
        "pick “bust point left” and “crotch point” to gain 1 measurement: Trunk girth",
        "`bodymeasure landmarks add` adds landmarks.",
    ]


def test_only_some_measurements_are_taken(run: Run, tmp_path: Path) -> None:
    ran = run("chart", "--only", "knee_height, hip_height_left", "--format", "json")
    measured = json.loads(ran.out)["measurements"]
    assert [one["key"] for one in measured] == [
        "hip_height_left",
        "knee_height_left",
        "knee_height_right",
    ]
    ran = run("chart", "--only", "knee_hight")
    assert ran.code == 2
    assert "has no measurement and no preset 'knee_hight'; did you mean 'knee_height'" in ran.err
    # A body without a head has a preset without its stature, but not if that is asked for by name.
    headless = tmp_path / "headless.atlas"
    bm.write_atlas(replace(bm.load_sample("female_average"), given={}), headless)
    assert run("chart", headless, "--only", "stature").code == 1
    nothing = run("chart", "--only", ",")
    assert nothing.code == 2
    assert "',' names nothing" in nothing.err


@pytest.mark.slow
def test_what_a_landmark_that_lies_elsewhere_changes(run: Run) -> None:
    options = ("--only", "back_neck_height,bust_span,shoulder_slope", "--sensitivity")
    measured = json.loads(run("chart", *options, "--format", "json").out)["measurements"]
    shifts = {one["key"]: one["shifts"] for one in measured}
    (height,) = shifts["back_neck_height"]
    # The skin leans forward there, so that 5 mm along it are less than 5 mm of height.
    assert 0.4 < height["up"] <= 0.5
    assert abs(height["across"]) < 0.01
    # A point that moves across a straight way changes it to second order.
    assert {one["landmark"] for one in shifts["bust_span"]} == {
        "bust point left",
        "bust point right",
    }
    assert all(abs(one["across"]) == pytest.approx(0.5, abs=0.05) for one in shifts["bust_span"])
    assert all(abs(one["up"]) < 0.1 for one in shifts["bust_span"])
    assert {one["landmark"] for one in shifts["shoulder_slope_left"]} == {
        "side neck point left",
        "shoulder point left",
    }
    table = run("chart", *options).out
    assert "5 mm off" in table
    assert re.search(r"^Back neck height .* 4\.\d\smm ", table, re.M)


def test_pictures_and_progress(
    run: Run, definitions: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    bars = recorded_bars(monkeypatch, "measuring.measured", "measuring.one_chart")
    near: list[bool] = []

    def draw(_chart: Any, *, few: bool, advance: Any) -> Any:
        near.append(not few)
        for name in range(5):
            advance(str(name))
        return tape_pictures()

    monkeypatch.setattr("bodymeasure.scene.tape_pictures", draw, raising=False)
    ran = run("chart", "--set", definitions, "-o", tmp_path / "out")
    assert (ran.code, ran.err) == (0, "Drawn without <OpenGL>.\n")
    page = Page((tmp_path / "out" / "chart.html").read_bytes())
    page.check_self_contained(scene=True)
    assert page.source.count("data:image/png") == 3
    assert b'id="bodymeasure-data"' in page.scene
    run("chart", "--set", definitions, "-o", tmp_path / "all", "--all-pictures")
    # What the scene shows is not drawn from near, unless it is asked for.
    assert near == [False, True]
    del bars[2:]
    assert [label for label, _, _ in bars] == ["measuring", "drawing"]
    assert bars[0][1:] == (3, [1, 2, 3])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--format", "csv", "-o", "out"), "--format is for printing; with -o, all formats"),
        (("--unit", "ft"), "'ft' is not one of 'm', 'cm', 'mm', 'inch'"),
        (("--set", "gone.toml"), "gone.toml: no such file"),
        (("--set", "set.toml", "gone.atlas"), "gone.atlas: no such file"),
        (("--set", "wrong.toml", "-o", "out"), "'chset' is no measurement of FreeSewing; did you"),
        (("--set", "empty.toml"), "'None' defines no measurement"),
    ],
)
def test_bad_input_is_told_and_nothing_written(
    run: Run,
    definitions: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: tuple[str, ...],
    message: str,
) -> None:
    folder = definitions.parent
    monkeypatch.chdir(folder)
    (folder / "wrong.toml").write_text(SET.replace('"chest"', '"chset"'), "utf-8")
    empty = SET.partition("[[")[0].replace('"Four"', '"None"')
    (folder / "empty.toml").write_text(empty, "utf-8")
    ran = run("chart", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err
    assert not (folder / "out").exists()


@pytest.mark.parametrize(
    ("package", "arguments"),
    [("jinja2", ("-o", "out", "--no-pictures")), ("matplotlib", ("-o", "out"))],
)
def test_missing_packages_are_told_first(
    run: Run,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    package: str,
    arguments: tuple[str, ...],
) -> None:
    monkeypatch.chdir(tmp_path)
    hide_here(monkeypatch, package)
    ran = run("chart", "gone.atlas", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.endswith("pip install 'bodymeasure[chart]'\n")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_a_whole_body_with_pictures(run: Run, tmp_path: Path) -> None:
    ran = run("chart", "--all-pictures", "-o", tmp_path)
    content = json.loads((tmp_path / "measurements.json").read_bytes())
    measured = [m for m in content["measurements"] if m["value"] is not None]
    assert len(measured) >= 45
    assert ran.code == (len(measured) < len(content["measurements"]))
    page = (tmp_path / "chart.html").read_text("utf-8")
    # Lengths of head, hands and feet are given, and have no tape to draw.
    drawn = [m for m in measured if m["key"] not in bm.load_sample("female_average").given]
    assert page.count('<img src="data:image/webp') > len(drawn)
    assert all(f'id="measurement-{m["key"]}">\n  <img' in page for m in drawn)
    # The scene, which the viewer's page draws, is in the page, too.
    assert 'id="scene-page"' in page
    assert len(page) < 6_000_000
    assert [m["number"] for m in measured] == list(range(1, len(measured) + 1))
    for number in (1, len(measured)):
        assert f"<strong>{number}. " in page


def test_the_default_set_is_printed_to_be_changed(run: Run, tmp_path: Path) -> None:
    from bodymeasure.chart import load_definitions

    ran = run("chart", "--print-set")
    assert (ran.code, ran.err) == (0, "")
    copy = tmp_path / "copy.toml"
    copy.write_text(ran.out, "utf-8")
    assert load_definitions(copy) == load_definitions()
