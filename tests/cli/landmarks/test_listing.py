"""`bodymeasure landmarks list`, and what all of its commands share."""

import csv
import io
import json
from pathlib import Path

import pytest
from helpers.command_line import Run

from bodymeasure import read_atlas


def words(text: str) -> str:
    return " ".join(text.split())


def test_the_list_tells_what_is_there_what_is_not_and_why(run: Run, bare: Path, mine: Path) -> None:
    ran = run("landmarks", bare, "--set", mine, "--unit", "mm")
    assert (ran.code, ran.err) == (0, "")
    lines = ran.out.splitlines()
    assert lines[0].split() == ["landmark", "patch", "u", "v", "x/mm", "y/mm", "z/mm", "origin"]
    assert lines[1].split()[-6:] == ["0.0494", "1.0000", "0.0", "-150.5", "975.7", "picked"]
    assert lines[2].startswith("waist point left ")
    assert lines[2].endswith("outermost to the left at the height of front waist point")
    assert (
        "chin point: it needs 'top of head', which the atlas lacks and no rule gives; pick it"
        in ran.out
    )
    assert "Lacking for measurements of “Mine”:\n  Face: chin point, top of head\n" in ran.out
    assert run("landmarks", "list", bare, "--set", mine, "--unit", "mm") == ran


def test_the_list_as_json_and_csv(run: Run, bare: Path, mine: Path) -> None:
    ran = run("landmarks", bare, "--set", mine, "--format", "json", "--unit", "m")
    assert (ran.code, ran.err) == (0, "")
    document = json.loads(ran.out)
    assert (document["unit"], document["definitions"]) == ("m", "Mine")
    picked, left, right = document["landmarks"]
    atlas = read_atlas(bare)
    position = atlas.position(atlas.landmarks["front waist point"])
    assert [picked["x"], picked["y"], picked["z"]] == position.tolist()
    assert (picked["origin"], left["origin"]) == ("picked", "rule")
    assert left["x"] == pytest.approx(-right["x"], abs=1e-14)
    assert document["missing"][0]["name"] == "chin point"
    assert document["lacking"] == [
        {"key": "face", "name": "Face", "landmarks": ["chin point", "top of head"]}
    ]
    ran = run("landmarks", bare, "--set", mine, "--format", "csv", "--unit", "m")
    rows = list(csv.DictReader(io.StringIO(ran.out)))
    assert [row["name"] for row in rows] == [
        "front waist point", "waist point left", "waist point right", "chin point",
    ]  # fmt: skip
    assert float(rows[1]["x"]) == left["x"]
    assert rows[3]["patch"] == ""
    assert rows[3]["missing"].startswith("it needs 'top of head'")


def test_an_atlas_without_landmarks_is_listed_too(run: Run, mine: Path) -> None:
    ran = run("landmarks", "enneper", "--set", mine)
    assert (ran.code, ran.err) == (0, "")
    assert "The atlas has no landmark; `bodymeasure landmarks add` adds one." in ran.out
    assert "waist point left: it needs 'front waist point', which the atlas lacks" in ran.out


@pytest.mark.parametrize("command", ["list", "add", "remove", "check"])
def test_each_subcommand_has_help(run: Run, command: str) -> None:
    ran = run("landmarks", command, "--help")
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.startswith(f"Usage: bodymeasure landmarks {command} [OPTIONS] ATLAS")
    assert "Exit codes: 0 done; 1 done, but" in words(ran.out)


def test_no_atlas_is_a_usage_error(run: Run) -> None:
    ran = run("landmarks")
    assert (ran.code, ran.out) == (2, "")
    assert "Missing argument 'ATLAS'" in ran.err
    ran = run("landmarks", "gone.atlas")
    assert (ran.code, ran.out) == (2, "")
    assert "gone.atlas: no such file" in ran.err
    ran = run("landmarks", "--help")
    assert ran.code == 0
    assert ran.out.startswith("Usage: bodymeasure landmarks [OPTIONS] [COMMAND] ATLAS [ARGS]...")
