import csv
import json
import math
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from helpers.command_line import Run, hide_here, recorded_bars
from helpers.files.page import Page

from bodymeasure import read_atlas
from bodymeasure.oracle import MeshDistances, mesh_distances
from bodymeasure.scene.drawing.opengl_check import opengl_trouble

FILES = ["report.html", "measurements.json", "measurements.csv", "measurements.schema.json"]


def checked_content(folder: Path) -> dict[str, Any]:
    """The content of a report's JSON, after a check against its schema and its CSV."""
    assert sorted(path.name for path in folder.iterdir()) == sorted(FILES)
    content: dict[str, Any] = json.loads((folder / "measurements.json").read_bytes())
    schema = json.loads((folder / "measurements.schema.json").read_bytes())
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.Draft202012Validator(schema).validate(content)
    with (folder / "measurements.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["name"] for row in rows] == [m["name"] for m in content["measurements"]]
    return content


@pytest.mark.slow
def test_a_part_of_a_body(run: Run, part: Path, tmp_path: Path) -> None:
    folder = tmp_path / "new" / "report"
    ran = run("report", part, "-o", folder, "--no-pictures", "--processes", 2)
    assert (ran.code, ran.err) == (0, "")
    content = checked_content(folder)
    kinds = [m["kind"] for m in content["measurements"]]
    assert (kinds.count("diagonal"), kinds.count("boundary")) == (12, 24)
    assert content["summary"]["patches"] == 6
    assert sum(content["summary"]["by_verdict"].values()) == 12
    assert content["atlas_digest"] == read_atlas(part).digest
    compared = [m for m in content["measurements"] if m["relative_difference"] is not None]
    assert compared
    for record in compared:
        assert record["verdict"] == "agrees"
        assert abs(record["relative_difference"]) < 1e-4
    assert ran.out.startswith("Part of a body\n")
    # The files stand at the end, one a line, to copy or to open.
    assert ran.out.splitlines()[-4:] == [str(folder / name) for name in FILES]


def test_a_single_patch_with_pictures_and_progress(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    bars = recorded_bars(monkeypatch, "measuring.report")
    # Drawing is faster without pyvista, and there is a note to report.
    hide_here(monkeypatch, "pyvista")
    opengl_trouble.cache_clear()
    ran = run("report", "enneper", "-o", tmp_path, "--unit", "mm", "--processes", 1)
    opengl_trouble.cache_clear()
    assert ran.code == 0
    assert ran.err == ""
    content = checked_content(tmp_path)
    assert content["unit"] == "mm"
    length = content["measurements"][0]["length"]
    assert math.isclose(length, 50.0 * math.sqrt(2.0) / 3.0, rel_tol=1e-13)
    page = Page((tmp_path / "report.html").read_bytes())
    # The scene takes the place of pictures.
    assert page.source.count("data:image/png") == 0
    assert b'id="bodymeasure-data"' in page.scene
    assert [label for label, _, _ in bars] == ["comparing with meshes"]
    for _, total, done in bars:
        assert done == sorted(done)
        assert done[-1] == total


@pytest.mark.slow
def test_all_pictures_are_drawn_on_request(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    hide_here(monkeypatch, "pyvista")
    opengl_trouble.cache_clear()
    options = ("--no-cross-check", "--processes", 1, "-o", tmp_path)
    ran = run("report", "enneper", "--all-pictures", *options)
    opengl_trouble.cache_clear()
    assert ran.code == 0
    page = Page((tmp_path / "report.html").read_bytes())
    assert page.source.count("data:image/png") > 4
    assert b'id="bodymeasure-data"' in page.scene
    ran = run("report", "enneper", "--all-pictures", "--no-pictures", *options)
    assert ran.code == 2
    assert "--no-pictures and --all-pictures contradict each other." in ran.err


def test_a_second_report_replaces_the_first(run: Run, tmp_path: Path) -> None:
    for unit in ("m", "inch"):
        ran = run(
            "report", "enneper", "-o", tmp_path, "--unit", unit, "--no-cross-check", "--no-pictures"
        )
        assert (ran.code, ran.err) == (0, "")
        assert checked_content(tmp_path)["unit"] == unit


def test_lengths_that_disagree_are_told(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The mesh's distances are scaled, which is as if the lengths were wrong.
    def wrong(*arguments: Any, **options: Any) -> MeshDistances:
        true = mesh_distances(*arguments, **options)
        return replace(true, exact=0.9 * true.exact)

    monkeypatch.setattr("bodymeasure.measure.patches.cross_check.mesh_distances", wrong)
    ran = run("report", "enneper", "-o", tmp_path, "--no-pictures", "--processes", 1)
    assert ran.code == 1
    assert "2 longer than the mesh distance" in ran.out
    assert ran.err == "2 lengths disagree with the mesh; see report.html.\n"
    assert checked_content(tmp_path)["summary"]["by_verdict"] == {"longer": 2}


@pytest.mark.slow
def test_libigl_measures_everything_on_request(run: Run, tmp_path: Path) -> None:
    options = ("--no-pictures", "--processes", 1, "-o", tmp_path)
    for check, words in (("flips", "edge flips"), ("libigl", "libigl exact on 5, 10, 15, 20")):
        assert run("report", "female_average", "--check", check, *options).code == 0
        content = checked_content(tmp_path)
        assert content["settings"]["cross-check"].startswith(words)
        diagonals = [each for each in content["measurements"] if each["kind"] == "diagonal"]
        by = Counter(each["exact_by"] for each in diagonals)
        if check == "libigl":
            assert by == {"libigl": 752}
        else:
            assert by["libigl"] + by["edge flips"] == 752
            assert 2 * 376 // 20 <= by["libigl"] < 200
            page = (tmp_path / "report.html").read_text("utf-8")
            assert "edge flips (potpourri3d)" in page


@pytest.mark.slow
def test_a_whole_body(run: Run, tmp_path: Path) -> None:
    ran = run("report", "--all-pictures", "-o", tmp_path)
    assert ran.code == 0
    content = checked_content(tmp_path)
    records = content["measurements"]
    assert len(records) == 376 * 6
    assert content["summary"]["diagonals"] == 752
    unmeasured = [r for r in records if r["length"] is None]
    assert all(r["status"] != "converged" for r in unmeasured)
    assert len(unmeasured) < 20
    assert set(content["summary"]["by_verdict"]) <= {"agrees", "not_compared"}
    page = (tmp_path / "report.html").read_text("utf-8")
    assert page.count("data:image/png") > 4
    assert 'id="scene-page"' in page


@pytest.mark.slow
def test_a_picture_of_a_whole_body(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "body.png"
    ran = run("view", "female_average", "--no-cross-check", "--screenshot", path)
    assert (ran.code, ran.out) == (0, f"{path}\n")
    assert path.read_bytes().startswith(b"\x89PNG")
