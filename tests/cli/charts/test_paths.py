"""The option --paths of the commands that measure."""

import json
from pathlib import Path

import numpy as np
import pytest
from helpers.command_line import Run, part_of_a_body

import bodymeasure as bm


def test_diagonals_are_written_as_curves(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "paths.json"
    assert run("diagonals", "paraboloid", "--paths", file).code == 0
    first, second = json.loads(file.read_bytes())["paths"]
    assert (first["name"], second["name"]) == ("paraboloid diagonal 1", "paraboloid diagonal 2")
    points = np.array(first["points"])
    assert np.linalg.norm(np.diff(points, axis=0), axis=1).sum() == pytest.approx(
        first["length"], rel=1e-4
    )
    assert points[-1] == pytest.approx(
        bm.load_sample("paraboloid").position(bm.AtlasPoint(0, 1, 1))
    )


def test_tapes_are_written_as_curves(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "tapes.step"
    assert run("chart", "--only", "bust_span,knee_height_left", "--paths", file).code == 0
    text = file.read_text("ascii")
    for name in ("bust_span contact", "bust_span taut", "knee_height_left"):
        assert f"B_SPLINE_CURVE_WITH_KNOTS('{name}'" in text


def test_a_file_that_cannot_be_written_is_refused_first(run: Run, tmp_path: Path) -> None:
    ran = run("chart", "--paths", tmp_path / "tapes.dwg")
    assert ran.code == 2
    assert "expected a name that ends in one of .3dm" in ran.err
    ran = run("diagonals", "paraboloid", "--paths", tmp_path / "no" / "paths.obj")
    assert (ran.code, ran.out) == (2, "")


def test_lengths_are_shown_in_the_unit_of_the_file(run: Run, tmp_path: Path) -> None:
    bm.write_atlas(bm.load_sample("female_average").converted("inch"), tmp_path / "body.atlas")
    bm.write_atlas(part_of_a_body(100, 102).converted("inch"), tmp_path / "part.atlas")
    by_file = run("diagonals", tmp_path / "part.atlas", "--unit", "file", "--format", "json")
    by_name = run("diagonals", tmp_path / "part.atlas", "--unit", "inch", "--format", "json")
    found, expected = json.loads(by_file.out), json.loads(by_name.out)
    assert found["unit"] == "inch"
    assert found["measurements"] == expected["measurements"]
    for command in (
        ("chart", tmp_path / "body.atlas", "--only", "knee_height"),
        ("landmarks", tmp_path / "part.atlas"),
    ):
        ran = run(*command, "--unit", "file", "--format", "json")
        assert json.loads(ran.out)["unit"] == "inch"
