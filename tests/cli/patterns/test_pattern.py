import json
from pathlib import Path

from helpers.command_line import Run

SMALL = """
format = "bodymeasure pattern"
version = 1
name = "Small"
extends = "skirt"
drop = ["skirt front"]
"""


def test_pieces_are_written_into_a_folder(run: Run, tmp_path: Path) -> None:
    (tmp_path / "small.toml").write_text(SMALL)
    out = tmp_path / "out"
    ran = run("pattern", "female_average", "--set", tmp_path / "small.toml", "-o", out)
    assert (ran.code, ran.err) == (0, "")
    assert "skirt back" in ran.out
    assert {path.name for path in out.iterdir()} == {"pattern.svg", "strain.svg", "pattern.json"}
    content = json.loads((out / "pattern.json").read_bytes())
    assert content["allowance"] == 10.0
    assert content["set"] == "Small"


def test_a_dart_that_is_left_out_is_something_to_look_at(run: Run, tmp_path: Path) -> None:
    ran = run("pattern", "female_average", "--set", "skirt", "-o", tmp_path / "out")
    assert ran.code == 1
    assert "skirt front: dart 'waist dart' is left out" in ran.err
    assert "both sides differ by at most" in ran.out


def test_a_set_is_printed_to_be_changed(run: Run) -> None:
    ran = run("pattern", "--print-set", "princess")
    assert (ran.code, ran.err) == (0, "")
    assert 'name = "Princess bodice"' in ran.out
    assert run("pattern", "--print-set", "prinzess").code == 2


def test_bad_sets_are_refused_before_the_work(run: Run, tmp_path: Path) -> None:
    for name, words in (("bodise", "did you mean 'bodice'"), ("missing.toml", "no such file")):
        ran = run("pattern", "female_average", "--set", name, "-o", tmp_path / "out")
        assert ran.code == 2
        assert words in ran.err
        assert not (tmp_path / "out").exists()


def test_patches_are_unfolded_into_a_folder(run: Run, part: Path, tmp_path: Path) -> None:
    ran = run("pattern", part, "--patches", "-o", tmp_path / "out")
    assert (ran.code, ran.err) == (0, "")
    assert "none turned over" in ran.out
    assert {path.name for path in (tmp_path / "out").iterdir()} == {"patches.svg", "patches.csv"}


def test_what_cannot_be_read_leaves_nothing(run: Run, tmp_path: Path) -> None:
    for more in ([], ["--patches"]):
        ran = run("pattern", tmp_path / "missing.atlas", *more, "-o", tmp_path / "out")
        assert ran.code == 2
        assert "missing.atlas" in ran.err
        assert not (tmp_path / "out").exists()


def test_a_body_without_landmarks_is_refused(run: Run, part: Path, tmp_path: Path) -> None:
    ran = run("pattern", part, "-o", tmp_path / "out")
    assert ran.code == 2
    assert "panel 'bodice front' needs the landmark" in ran.err
    assert not (tmp_path / "out").exists()
