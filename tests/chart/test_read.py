"""Files of definitions."""

import re
from pathlib import Path

import jsonschema
import msgspec
import pytest
from helpers.charts.definition_files import HEAD, PATH, entry, read

from bodymeasure.chart import both_sides, definitions_schema, load_definitions
from bodymeasure.chart.kinds import (
    FormulaMeasure,
    GirthMeasure,
    HeightMeasure,
    PathMeasure,
)
from bodymeasure.errors import InputError


def test_what_a_file_says_is_read() -> None:
    set_ = read(
        HEAD
        + 'words = "All of it."  # a comment\n'
        + PATH
        + 'tape = "both"\niso = {name = "Back neck point to waist", clause = "5.4.5"}\n'
        + 'seamly = ["neck_back_to_waist_b"]\nfreesewing = "hpsToWaistBack"\n'
    )
    assert (set_.name, set_.words) == ("Mine", "All of it.")
    (one,) = set_.measurement
    assert isinstance(one, PathMeasure)
    assert one.through == ("back neck point", "back waist point")
    assert one.tape == "both"
    assert one.iso is not None
    assert one.iso.clause == "5.4.5"
    assert one.seamly == ("neck_back_to_waist_b",)


def test_a_file_on_disk_is_read_and_named(tmp_path: Path) -> None:
    path = tmp_path / "set.toml"
    path.write_bytes(b"\xef\xbb\xbf" + (HEAD + PATH).encode())
    assert load_definitions(path).measurement[0].key == "back"
    path.write_text(HEAD + "x = 1\n")
    with pytest.raises(InputError, match=re.escape(f"{path}, line 4: has the unknown member 'x'")):
        load_definitions(str(path))
    with pytest.raises(InputError, match="no such file; check the path"):
        load_definitions(tmp_path / "gone.toml")


def test_a_set_extends_the_default_one() -> None:
    default = load_definitions()
    own = read(
        HEAD
        + 'extends = "default"\ndrop = ["trunk_girth", "lower knee point {side}", '
        + '"lower_knee_girth_{side}", "calf_girth_{side}"]\n'
        + entry("girth", 'at = "back waist point"', "waist_girth")
        + entry("height", 'at = "my point"', "mine")
    )
    keys = [one.key for one in own.measurement]
    before = [one.key for one in default.measurement]
    gone = {"trunk_girth", "lower_knee_girth_{side}", "calf_girth_{side}"}
    assert keys == [key for key in before if key not in gone] + ["mine"]
    waist = own.measurement[keys.index("waist_girth")]
    assert isinstance(waist, GirthMeasure)
    assert waist.at == "back waist point"
    assert isinstance(own.measurement[-1], HeightMeasure)
    assert len(own.landmark) == len(default.landmark) - 1
    assert (own.extends, own.drop, own.name) == ("", (), "Mine")


def test_sides_are_put_in_everywhere() -> None:
    set_ = read(
        HEAD
        + entry("height", 'at = "hip {side}"\nwords = "The {side} one."', "h_{side}").replace(
            '"It"', '"It, {side}"'
        )
        + entry("formula", 'formula = "h_{side} / 2"', "half_{side}").replace('"It"', '"{side}"')
    )
    left, right, half, other = both_sides(set_.measurement)
    assert isinstance(left, HeightMeasure)
    assert (left.key, left.name, left.at, left.words) == (
        "h_left",
        "It, left",
        "hip left",
        "The left one.",
    )
    assert (right.key, half.key) == ("h_right", "half_left")
    assert isinstance(other, FormulaMeasure)
    assert other.formula == "h_right / 2"


def test_the_schema_holds_for_the_default_set() -> None:
    schema = definitions_schema()
    raw = msgspec.to_builtins(load_definitions())
    # JSON has lists only.
    jsonschema.validate(msgspec.json.decode(msgspec.json.encode(raw)), schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({"format": "x", "version": 1, "name": "y", "more": 1}, schema)
