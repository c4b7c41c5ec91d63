"""`bodymeasure make`."""

import csv
import json
from pathlib import Path

import pytest
from helpers.command_line import Run

from bodymeasure import load_definitions, read_atlas

GOOD = ("bust_girth=88cm", "waist_girth=28 1/4in", "hip_girth=970mm")


@pytest.mark.slow
def test_values_become_an_atlas_and_a_chart_with_deviations(run: Run, tmp_path: Path) -> None:
    atlas, values = tmp_path / "ann.atlas", tmp_path / "ann.csv"
    ran = run("make", *GOOD, "-o", atlas, "--sex", "female", "--values", values)
    assert (ran.code, ran.err) == (0, "")
    assert "Waist girth" in ran.out
    assert "28.25 inch" in ran.out
    assert "rounds; the largest miss of a length is" in ran.out
    body = read_atlas(atlas)
    assert "sex female" in body.provenance["source"]
    rows = {row["measurement"]: row for row in csv.DictReader(values.read_text().splitlines())}
    assert float(rows["waist_girth"]["value"]) == pytest.approx(28.25, abs=1e-3)
    assert float(rows["waist_girth"]["deviation"]) < 0.01
    assert rows["knee_girth_left"]["asked"] == ""
    assert 0.5 < float(rows["knee_girth_left"]["deviation"]) < 5.0
    assert len(rows) > 100
    assert len(load_definitions().measurement) > 90


@pytest.mark.slow
def test_a_table_of_sizes_becomes_a_folder(run: Run, tmp_path: Path) -> None:
    table = tmp_path / "roll.csv"
    table.write_text("size,bust (cm),waist (cm),hip (cm)\n36,84,68,93\n38/40,90,74,99\n")
    ran = run("make", table, "-o", tmp_path / "roll", "--values", tmp_path / "roll.json")
    assert (ran.code, ran.err) == (0, "")
    assert sorted(path.name for path in (tmp_path / "roll").iterdir()) == [
        "36.atlas",
        "38_40.atlas",
    ]
    held = json.loads((tmp_path / "roll.json").read_text())
    assert [body["name"] for body in held["bodies"]] == ["36", "38/40"]
    assert len(held["bodies"][0]["coefficients"]) == 120


@pytest.mark.slow
def test_a_body_is_varied(run: Run, tmp_path: Path) -> None:
    ran = run("make", *GOOD, "--vary", "bust=+4cm,+8cm", "-o", tmp_path / "family")
    assert (ran.code, ran.err) == (0, "")
    names = sorted(path.name for path in (tmp_path / "family").iterdir())
    assert names == ["base.atlas", "bust_girth+4cm.atlas", "bust_girth+8cm.atlas"]


def test_doubts_stop_it_and_nothing_is_written(run: Run, tmp_path: Path) -> None:
    atlas = tmp_path / "new" / "ann.atlas"
    ran = run("make", "bust_girth=88cm", "waist_girth=27cm", "hip_girth=97cm", "-o", atlas)
    assert ran.code == 2
    assert "swapped digits: 72 written as 27" in ran.err
    assert not atlas.parent.exists()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("bust_girth=88", *GOOD[1:]), "has no unit, and none is guessed"),
        (GOOD[:2], "has 2 measurements; expected 3 to 40"),
        ((*GOOD, "bust=88cm"), "'bust_girth' is given a second time"),
        ((*GOOD, "nothing.csv"), "'nothing.csv' is not KEY=VALUE"),
        (("nothing.csv",), "no such file"),
        (("one.csv", "two.csv"), "MEASUREMENTS is one file"),
        ((*GOOD, "--vary", "bust"), "is no change"),
        ((*GOOD, "--vary", "bust=+1cm", "--vary", "bust=+2cm"), "is given twice"),
        ((*GOOD, "--vary", "bust=4cm"), "has no sign"),
        ((*GOOD, "--vary", "bust=+4cm", "-o", "made.atlas"), "expected a folder"),
        ((*GOOD, "-o", "made.obj"), "expected a name that ends in .atlas"),
        ((*GOOD, "--values", "made.txt"), "ends in one of .csv, .json"),
        ((*GOOD, "--set", "nothing.toml"), "no such file"),
        ((*GOOD, "--age", "12"), "18.0<=x<=90.0"),
    ],
)
def test_bad_input_is_refused(
    run: Run,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: tuple[str, ...],
    message: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = run("make", *arguments)
    assert ran.code == 2
    assert message in " ".join(ran.err.split())
    assert not list(tmp_path.iterdir())
