"""Fits and charts of scans on the command line: one, many, some of them bad, and again."""

import csv
import json
from dataclasses import replace
from pathlib import Path
from shutil import copyfile
from typing import Any

import numpy as np
import pytest
from helpers.command_line import Run

import bodymeasure as bm
import bodymeasure.fit
from bodymeasure import Atlas, FitError, read_atlas, write_atlas

SCAN = Path(__file__).parents[2] / "data" / "scans" / "coarse.ply"
KEYS = "bust_span,knee_height_left,shoulder_chord_left"


@pytest.fixture(scope="module")
def fitted() -> bm.FittedBody:
    """The fit of a scan, which takes some ten seconds."""
    return bm.fit_body(SCAN, file_unit="m")


@pytest.fixture
def fits(fitted: bm.FittedBody, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The names of the scans that are fitted, by a fit that is made once; those named bad fail."""
    made: list[str] = []

    def fit(path: Path, **_: Any) -> bm.FittedBody:
        made.append(path.stem)
        if "bad" in path.stem:
            raise FitError(f"{path}: no body was found in the mesh; check the unit")
        return replace(fitted, atlas=replace(fitted.atlas, name=path.stem))

    monkeypatch.setattr(bodymeasure.fit, "fit_body", fit)
    return made


def scans(folder: Path, *names: str) -> list[Path]:
    folder.mkdir()
    for name in names:
        copyfile(SCAN, folder / f"{name}.ply")
    return [folder / f"{name}.ply" for name in names]


def rows_of(file: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(file.read_text("utf-8").splitlines()))


def files(folder: Path) -> set[str]:
    return {file.name for file in folder.iterdir()}


@pytest.mark.slow
def test_a_scan_goes_in_and_an_atlas_comes_out(run: Run, tmp_path: Path) -> None:
    ran = run("fit", SCAN, "--file-unit", "m", "-o", tmp_path / "anna.atlas", "--no-pictures")
    assert ran.code == 0
    assert "distance from the scan" in ran.out
    assert files(tmp_path) == {"anna.atlas", "anna.fit.html"}
    atlas = read_atlas(tmp_path / "anna.atlas")
    assert atlas.scan is not None
    assert len(atlas.scan.landmarks) == len(atlas.landmarks) == 21
    assert atlas.provenance["scan"] == "coarse.ply"
    assert len(atlas.provenance["scan, SHA-256"]) == 64
    # Other commands take it as they take a sample.
    assert run("check", tmp_path / "anna.atlas").code == 0
    assert run("diagonals", tmp_path / "anna.atlas", "--format", "csv").code == 0
    chart = run("chart", tmp_path / "anna.atlas", "--only", KEYS, "--format", "json")
    spans = {each["key"]: each for each in json.loads(chart.out)["measurements"]}
    assert spans["bust_span"]["error_estimate"] < 1e-4 < 0.1
    assert 0.1 < spans["bust_span"]["input_uncertainty"] < 1.0


@pytest.mark.slow
def test_a_chart_of_a_scan_fits_first_and_says_so(
    run: Run, tmp_path: Path, fits: list[str]
) -> None:
    ran = run("chart", SCAN, "--file-unit", "m", "--only", KEYS, "--no-pictures", "-o", tmp_path)
    assert (ran.code, fits) == (0, ["coarse"])
    assert "Fitted a body to the scan: " in ran.err
    assert {"chart.html", "measurements.json", "coarse.atlas", "coarse.fit.html"} < files(tmp_path)
    content = json.loads((tmp_path / "measurements.json").read_bytes())
    assert content["subject"] == "coarse"
    assert content["scan"]["done"]
    assert content["provenance"]["scan"] == "coarse.ply"
    printed = run("chart", SCAN, "--file-unit", "m", "--only", KEYS)
    assert "from the scan" in printed.out
    assert "The body was fitted to a scan" in printed.out


@pytest.mark.slow
def test_many_scans_are_done_but_for_the_bad_ones_and_once(
    run: Run, tmp_path: Path, fits: list[str]
) -> None:
    given = scans(tmp_path / "scans", "anna", "bad", "ben")
    options = ("--file-unit", "m", "--no-pictures", "-o", tmp_path / "out")
    ran = run("fit", *given, *options)
    assert ran.code == 1
    assert "1 of 3 failed:\n  bad: " in ran.err
    rows = rows_of(tmp_path / "out" / "fits.csv")
    assert [(row["subject"], row["result"]) for row in rows] == [
        ("anna", "fitted"), ("ben", "fitted"), ("bad", "failed")
    ]  # fmt: skip
    assert "no body was found" in rows[2]["reason"]
    chart = (*given, *options, "--only", KEYS)
    assert run("chart", *chart).code == 1
    # The charts take the fits that are there; what failed is tried again.
    assert fits == ["anna", "bad", "ben", "bad"]
    table = (tmp_path / "out" / "wide.csv").read_text("utf-8").splitlines()
    assert [line.split(",")[0] for line in table] == ["subject", "anna", "ben"]
    long = rows_of(tmp_path / "out" / "measurements.csv")
    assert len(long) == 2 * 3
    assert all(float(row["input_uncertainty"]) > 0.0 for row in long)
    content = json.loads((tmp_path / "out" / "measurements.json").read_bytes())
    assert [each["subject"] for each in content["failures"]] == ["bad"]
    assert "Not charted" in (tmp_path / "out" / "population.html").read_text("utf-8")
    # Another set of measurements is charted anew, on the same fits; another unit is fitted anew.
    assert run("chart", *given, *options, "--only", "bust_span").code == 1
    assert fits[4:] == ["bad"]
    assert "2 of 3 were done before" in run("chart", *chart, "--only", "bust_span").err
    run("fit", given[0], given[2], "--up", "+z", *options)
    assert fits[-2:] == ["anna", "ben"]


@pytest.mark.slow
def test_a_run_that_was_killed_goes_on(
    run: Run, tmp_path: Path, fits: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    given = scans(tmp_path / "scans", "anna", "ben", "carl")
    made = bodymeasure.fit.fit_body

    def killed(path: Path, **settings: Any) -> bm.FittedBody:
        if path.stem == "carl":
            raise KeyboardInterrupt
        return made(path, **settings)

    monkeypatch.setattr(bodymeasure.fit, "fit_body", killed)
    options = ("--file-unit", "m", "--no-pictures", "-o", tmp_path / "out")
    assert run("fit", *given, *options).code == 130
    monkeypatch.setattr(bodymeasure.fit, "fit_body", made)
    assert run("fit", *given, *options).code == 0
    assert fits == ["anna", "ben", "carl"]
    # An atlas that was half-written or taken away is made again.
    (tmp_path / "out" / "ben.atlas").unlink()
    assert run("fit", *given, *options).code == 0
    assert fits[3:] == ["ben"]


@pytest.mark.slow
def test_bad_scans_are_refused_and_nothing_written(
    run: Run, tmp_path: Path, fits: list[str]
) -> None:
    (bad,) = scans(tmp_path / "scans", "bad")
    for command in ("fit", "chart"):
        ran = run(command, bad, "--file-unit", "m", "-o", tmp_path / "out")
        assert ran.code == 2
        assert "no body was found" in ran.err
        twice = run(command, bad, SCAN, SCAN, "--file-unit", "m", "-o", tmp_path / "out")
        assert "is given twice" in twice.err
    assert fits == ["bad", "bad"]
    assert not (tmp_path / "out").exists()


def test_what_is_missing_is_said(run: Run, tmp_path: Path) -> None:
    ran = run("fit", SCAN, "-o", tmp_path / "body.atlas")
    assert ran.code == 2
    assert "--file-unit" in ran.err
    ran = run("chart", "female_average", "--landmarks", "picks.csv")
    assert ran.code == 2
    assert "picks of one scan" in ran.err
    ran = run("fit", SCAN, "--file-unit", "m", "-o", tmp_path / "body.ply")
    assert ran.code == 2
    assert "ends in .atlas" in ran.err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_atlases_among_scans_are_charted_as_they_are(
    run: Run, tmp_path: Path, fits: list[str]
) -> None:
    body: Atlas = bm.load_sample("female_average")
    write_atlas(body, tmp_path / "mannequin.atlas")
    ran = run(
        "chart", SCAN, tmp_path / "mannequin.atlas", "--file-unit", "m", "--no-pictures",
        "--only", "bust_span", "-o", tmp_path / "out",
    )  # fmt: skip
    assert (ran.code, fits) == (0, ["coarse"])
    rows = rows_of(tmp_path / "out" / "measurements.csv")
    assert [row["input_uncertainty"] != "" for row in rows] == [True, False]
    assert np.isfinite([float(row["value"]) for row in rows]).all()
