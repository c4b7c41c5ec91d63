import json
from pathlib import Path

import pytest
from helpers.command_line import Run

from bodymeasure.pattern import set_text

SMALL = """
format = "bodymeasure pattern"
version = 1
name = "Small"
extends = "skirt"
drop = ["skirt front"]
"""
FEW = ("--formats", "json")


def test_pieces_are_written_into_a_folder(run: Run, tmp_path: Path) -> None:
    (tmp_path / "small.toml").write_text(SMALL)
    out = tmp_path / "out"
    ran = run("pattern", "female_average", "--set", tmp_path / "small.toml", "-o", out)
    assert (ran.code, ran.err) == (0, "")
    assert "skirt back" in ran.out
    names = {"pattern.html", "pattern.svg", "pattern.pdf", "pattern.dxf", "garmentcode.json"}
    assert {path.name for path in out.iterdir()} == {*names, "strain.svg", "pattern.json"}
    page = (out / "pattern.html").read_text()
    assert 'href="pattern.pdf"' in page
    assert "seen from the back, with the panels of the pattern" in page
    content = json.loads((out / "pattern.json").read_bytes())
    assert content["allowance"] == 10.0
    assert content["set"] == "Small"


@pytest.mark.slow
def test_a_dart_that_is_left_out_is_said_and_no_fault(run: Run, tmp_path: Path) -> None:
    ran = run("pattern", "female_average", "--set", "skirt", *FEW, "-o", tmp_path / "out")
    assert ran.code == 0
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


def test_what_a_body_cannot_give_names_the_file_that_asks_for_it(run: Run, tmp_path: Path) -> None:
    path, out = tmp_path / "mine.toml", tmp_path / "out"
    path.write_text(set_text("skirt").replace("front hip point", "front hip pint"))
    ran = run("pattern", "female_average", "--set", path, "-o", out)
    assert ran.code == 2
    assert f"{path}: panel " in ran.err
    assert "needs the landmark 'front hip pint'" in ran.err
    assert "did you mean 'front hip point'" in ran.err
    # What is wrong with an option is no fault of the file.
    path.write_text(SMALL)
    ran = run("pattern", "female_average", "--set", path, "--ease", "hipp=1cm", "-o", out)
    assert ran.code == 2
    assert ran.err.startswith("Error: ease is asked for at 'hipp'")
    assert not out.exists()


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


@pytest.mark.slow
def test_several_bodies_are_sizes_of_one_garment(run: Run, tmp_path: Path) -> None:
    (tmp_path / "small.toml").write_text(SMALL)
    out = tmp_path / "out"
    bodies = ("female_average", "male_average")
    ran = run(
        *("pattern", *bodies, "--sizes", "F,M", "--formats", "json,dxf,svg"),
        *("--set", tmp_path / "small.toml", "-o", out),
    )
    assert ran.code == 0
    assert "M, skirt back: dart" in ran.err
    drawings = {"pattern.svg", "pattern.dxf"}
    assert {path.name for path in out.iterdir()} == {"F", "M", *drawings}
    assert {path.name for path in (out / "F").iterdir()} == {*drawings, "pattern.json"}
    nested = (out / "pattern.svg").read_text()
    assert 'id="F.skirt-back.cut"' in nested
    assert 'id="M.skirt-back.cut"' in nested
    assert json.loads((out / "M" / "pattern.json").read_bytes())["body"].startswith("Average male")


def test_sizes_that_name_no_folders_are_refused(run: Run, tmp_path: Path) -> None:
    bodies = ("female_average", "male_average")
    for sizes, words in (
        ("S", "names 1 size for 2 bodies"),
        ("S,S", "names 'S' twice"),
        ("../S,M", "cannot name a folder"),
    ):
        ran = run("pattern", *bodies, "--sizes", sizes, "-o", tmp_path / "out")
        assert ran.code == 2
        assert words in ran.err
        assert not (tmp_path / "out").exists()
    assert run("pattern", *bodies, "--patches", "-o", tmp_path / "out").code == 2


def test_patches_have_no_panels_to_which_options_apply(run: Run, tmp_path: Path) -> None:
    for option in (("--ease", "bust=4cm"), ("--no-bridge",), ("--formats", "svg")):
        ran = run("pattern", "female_average", "--patches", *option, "-o", tmp_path / "out")
        assert ran.code == 2
        asked = option[0].replace("no-", "")
        assert f"without panels; leave out {asked}." in " ".join(ran.err.split())
        assert not (tmp_path / "out").exists()


@pytest.mark.slow
def test_ease_is_given_with_units(run: Run, tmp_path: Path) -> None:
    (tmp_path / "small.toml").write_text(SMALL)
    lengths = {}
    for ease in ("hip=0cm", "hip=6cm,waist=0.5in"):
        out = tmp_path / "out"
        ran = run(
            *("pattern", "female_average", "--set", tmp_path / "small.toml"),
            *("--ease", ease, *FEW, "-o", out),
        )
        assert ran.code == 0
        (piece,) = json.loads((out / "pattern.json").read_bytes())["pieces"]
        lengths[ease] = {edge["name"]: edge["length_in_piece"] for edge in piece["edges"]}
    bare, wide = lengths.values()
    assert 12.0 < wide["hip"] - bare["hip"] < 18.0
    for wrong, words in (("hip=6", "is no ease"), ("hip=6cm,hip=1cm", "given twice")):
        ran = run("pattern", "female_average", "--ease", wrong, "-o", tmp_path / "none")
        assert ran.code == 2
        assert words in ran.err
        assert not (tmp_path / "none").exists()


def test_formats_and_papers_are_chosen(run: Run, tmp_path: Path) -> None:
    (tmp_path / "small.toml").write_text(SMALL)
    out = tmp_path / "out"
    few = ("--set", tmp_path / "small.toml", "--formats", "pdf", "--paper", "a0", "-o", out)
    assert run("pattern", "female_average", *few).code == 0
    assert [path.name for path in out.iterdir()] == ["pattern.pdf"]
    for wrong, words in (
        (("--formats", "dfx"), "no format is named 'dfx'; did you mean"),
        (("--paper", "a5"), "'a5' is not one of"),
        (("--allowance", "nan"), "'nan' is no number"),
    ):
        ran = run("pattern", "female_average", *wrong, "-o", tmp_path / "none")
        assert ran.code == 2
        assert words in " ".join(ran.err.split())
        assert not (tmp_path / "none").exists()
