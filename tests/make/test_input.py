"""Measurements from the files of programs and of people."""

import json
from pathlib import Path

import pytest

import bodymeasure as bm
from bodymeasure.atlas import Unit
from bodymeasure.errors import InputError
from bodymeasure.make.input.numbers import parsed
from bodymeasure.report.body import chart_document
from bodymeasure.report.body.freesewing import to_freesewing
from bodymeasure.report.body.smis import to_smis
from bodymeasure.report.serial import to_json

SMIS = """<?xml version="1.0" encoding="UTF-8"?>
<{root}>
    <version>0.3.4</version>
    <unit>{unit}</unit>
    <personal><gender>female</gender></personal>
    <body-measurements>{values}</body-measurements>
</{root}>
"""
# What comes before a measurement for it to be there twice.
TWICE = '<m name="waist_circ" value="71"/><m'


def _smis(values: dict[str, str], *, root: str = "smis", unit: str = "cm") -> str:
    lines = "".join(f'<m name="{name}" value="{value}"/>' for name, value in values.items())
    return SMIS.format(root=root, unit=unit, values=lines)


def _read(folder: Path, name: str, content: str, **settings: str) -> tuple[bm.Measurements, ...]:
    path = folder / name
    path.write_text(content, encoding="utf-8")
    return bm.read_measurements(path, **settings)  # type: ignore[arg-type]


@pytest.mark.parametrize(("root", "suffix"), [("smis", ".smis"), ("vit", ".vit")])
def test_files_of_seamly_and_valentina(tmp_path: Path, root: str, suffix: str) -> None:
    values = {
        "bust_circ": "88",
        "waist_circ": "72,5",
        "leg_knee_circ": "37",
        "hip_circ": "waist_circ + 25",
        "height": "0",
        "hand_length": "18",
        "@mine": "3",
        "neck_circ": "#increment * 2",
    }
    (found,) = _read(tmp_path, f"ann{suffix}", _smis(values, root=root))
    assert found.name == "ann"
    assert found.sex == "female"
    assert {one.key: one.value for one in found.values} == {
        "bust_girth": 88.0,
        "waist_girth": 72.5,
        "knee_girth_right": 37.0,
        "hip_girth": 97.5,
    }
    notes = " ".join(found.notes)
    assert "@mine" in notes
    assert "#increment * 2" in notes
    assert "hand_length_right" in notes


def test_a_chart_of_a_body_comes_back(tmp_path: Path) -> None:
    only = ["waist_girth", "knee_girth"]
    chart = bm.measure_chart(bm.load_sample("female_average"), only=only)
    document = chart_document(chart, Unit.CM)
    contents = {
        "a.smis": to_smis(document),
        "b.json": to_json(document),
        "c.json": to_freesewing(document),
    }
    for name, content in contents.items():
        (found,) = _read(tmp_path, name, content.decode())
        by_key = {one.key: one.base for one in found.values}
        for key in ("waist_girth", "knee_girth_right"):
            assert by_key[key] == pytest.approx(chart[key].value, abs=1e-5)


def test_own_json_and_that_of_freesewing(tmp_path: Path) -> None:
    own = {"name": "Ann", "unit": "inch", "sex": "male", "measurements": {"Waist girth": "28 1/2"}}
    (found,) = _read(tmp_path, "a.json", json.dumps(own))
    assert (found.name, found.sex) == ("Ann", "male")
    assert found.values[0].value == 28.5
    theirs = {"units": "metric", "measurements": {"waist": 720, "shoulderSlope": 21, "heel": 300}}
    (found,) = _read(tmp_path, "b.json", json.dumps(theirs))
    assert {one.key: (one.value, one.unit) for one in found.values} == {
        "waist_girth": (720.0, "mm"),
        "shoulder_slope_right": (21.0, "deg"),
    }
    assert "heel_girth_right" in found.notes[0]


@pytest.mark.parametrize(
    "content",
    [
        "measurement,value\nwaist,72 cm\nhip,38 1/2 in\n",
        "Name;Value;Unit\nwaist;72;CM\nhip;38,5;in\nbust;;\n",
        "sep=;\r\nmeasurement;value\r\nwaist;72\r\nhip;38 1/2 inches\r\n",
        "\nsize;waist (cm);hip (in);;\nann;72;38,5;;\n",
    ],
)
def test_tables_as_people_and_their_programs_write_them(tmp_path: Path, content: str) -> None:
    (found,) = _read(tmp_path, "ann.csv", content, unit="cm")
    assert [(one.key, one.value, one.unit) for one in found.values] == [
        ("waist_girth", 72.0, "cm"),
        ("hip_girth", 38.5, "inch"),
    ]


def test_json_as_people_and_their_programs_write_it(tmp_path: Path) -> None:
    content = '\ufeff{"unit": "cm", "measurements": {"waist": 72, "hip": null}}'
    (found,) = _read(tmp_path, "ann.json", content)
    assert [(one.key, one.value) for one in found.values] == [("waist_girth", 72.0)]


def test_entities_are_found_in_any_encoding(tmp_path: Path) -> None:
    path = tmp_path / "ann.smis"
    text = '<?xml version="1.0" encoding="UTF-16"?><!DOCTYPE x [<!ENTITY a "88">]><smis>&a;</smis>'
    path.write_bytes(text.encode("utf-16"))
    with pytest.raises(InputError, match="defines entities"):
        bm.read_measurements(path)


def test_a_file_may_hold_more_than_is_wanted(tmp_path: Path) -> None:
    values = {"waist_circ": "72", "leg_knee_circ": "37", "neck_circ": "40", "hip_circ": "98"}
    path = tmp_path / "ann.smis"
    path.write_text(_smis(values))
    (found,) = bm.read_measurements(path, only=["trousers"])
    assert {one.key for one in found.values} == {"waist_girth", "knee_girth_right", "hip_girth"}
    with pytest.raises(InputError, match="no measurement and no preset 'trouser'"):
        bm.read_measurements(path, only=["trouser"])
    with pytest.raises(InputError, match="has no value that a body can be made from"):
        bm.read_measurements(path, only=["calf_girth"])


def test_tables_of_sizes_and_lists_of_people(tmp_path: Path) -> None:
    table = "size;bust_girth (cm);Waist girth (in)\n36;84,5;26 1/2\n38;88;\n"
    one, other = _read(tmp_path, "roll.csv", table)
    assert (one.name, other.name) == ("36", "38")
    assert [value.value for value in one.values] == [84.5, 26.5]
    assert [value.unit for value in one.values] == ["cm", "inch"]
    assert len(other.values) == 1
    (single,) = _read(tmp_path, "plain.csv", "size,bust\n36,84\n", unit="cm")
    assert single.values[0].key == "bust_girth"
    people = "subject,measurement,value,unit\nann,waist_girth,72,cm\nbob,waist_girth,34,inch\n"
    ann, bob = _read(tmp_path, "people.csv", people)
    assert (ann.name, bob.name) == ("ann", "bob")


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("a.txt", "", "expected a name that ends in one of .smis, .vit, .json, .csv"),
        ("a.smis", "<smis", "is not XML"),
        ("a.smis", "<svg/>", "begins with <svg>; expected <smis>"),
        ("a.smis", "<smms/>", "is a multisize file"),
        ("a.smis", "<!DOCTYPE x><smis/>", "defines entities"),
        ("a.smis", _smis({"waist_circ": "72"}).replace("<m", TWICE), "a second time, '72'"),
        ("a.smis", _smis({"waist_circ": "72"}, unit="foot"), "the unit is 'foot'"),
        ("a.smis", _smis({"waist_circ": "-72"}), "expected a length above zero"),
        ("a.smis", _smis({"hand_length": "18"}), "has no value that a body can be made from"),
        ("a.json", "[", "is not JSON"),
        ("a.json", 100_000 * "[", "is nested too deeply"),
        (
            "a.json",
            '{"unit": "cm", "measurements": {"hip": 9, "hip": 8}}',
            "json: 'hip' is given",
        ),
        ("a.json", '{"unit": "cm", "age": 70, "measurements": {"hip": 9}}', "has the member 'age'"),
        ("a.json", "[]", "is not an object"),
        ("a.json", "{}", "has no measurements"),
        ("a.json", '{"measurements": {"waits": 3}}', "did you mean 'waist'?"),
        ("a.json", '{"unit": "ft", "measurements": {"waist": 3}}', "the unit is 'ft'"),
        ("a.json", '{"unit": "cm", "measurements": {"waist": true}}', "True is not a number"),
        (
            "a.json",
            '{"unit": "cm", "measurements": {"waist": 7, "waist_girth": 7}}',
            "given a second time",
        ),
        ("a.json", '{"unit": "cm", "sex": 1, "measurements": {"waist": 7}}', "sex is 1"),
        ("a.csv", "size,bust_girth\n36,84\n", "has no unit, and none is guessed"),
        ("a.csv", "measurement,value\nwaist,72\n", "no unit, and none is guessed"),
        ("a.csv", "measurement,value,unit\nwaist,72 cm,mm\n", "the value is in cm and the column"),
        ("a.csv", "size,bust_girth (cm)\n36,84,5\n", "separate the columns by semicolons"),
        ("a.csv", "size,bust_girth (cm)\n36,84\n36,85\n", "size '36' comes a second time"),
        ("a.csv", "size,bust_girth (cm),bust (cm)\n36,84,84\n", "has two columns"),
        ("a.csv", "size,bust_girth (cm)\n36,eighty\n", "'eighty' is not a value"),
        ("a.csv", "size,bust_girth (cm)\n", "holds no size"),
        ("a.csv", "size,bust_grith (cm)\n36,84\n", "did you mean 'bust_girth'?"),
        ("a.csv", "size,bust_girth (deg)\n36,84\n", "is in deg; expected a length"),
        ("a.csv", "measurement,value,unit\nwaist,72,cm\nwaist,73,cm\n", "given a second time"),
        ("a.csv", "measurement,value,unit\nwaist,72,ft\n", "unknown unit 'ft'"),
    ],
)
def test_bad_files_are_refused(tmp_path: Path, name: str, content: str, message: str) -> None:
    with pytest.raises(InputError) as caught:
        _read(tmp_path, name, content)
    assert message in str(caught.value)


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("92.5", "cm", (92.5, "cm")),
        ("92,5 cm", None, (92.5, "cm")),
        ("36 1/4 in", None, (36.25, "inch")),
        ('36 1/4"', "cm", (36.25, "inch")),
        ("1/2", "inch", (0.5, "inch")),
        ("21\N{DEGREE SIGN}", "cm", (21.0, "deg")),
    ],
)
def test_values_as_people_write_them(text: str, unit: str | None, value: tuple[float, str]) -> None:
    assert parsed(text, unit, "here") == value
