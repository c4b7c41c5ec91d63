from pathlib import Path

import pytest
from helpers.charts.hand_made_chart import hand_made_chart

from bodymeasure.compare import read_readings
from bodymeasure.errors import InputError
from bodymeasure.report.body import chart_document, chart_to_csv
from bodymeasure.report.serial import to_json


def written(tmp_path: Path, text: str | bytes, name: str = "hand.csv") -> Path:
    path = tmp_path / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


@pytest.mark.parametrize(
    "text",
    [
        "measurement,value,unit\nBust girth,91.5,cm\n",
        "\ufeffKey , VALUE,Unit\r\nBust girth, 91.5 ,cm\r\n,,\r\n",
        "measurement;unit;value\nBust girth;cm;91,5",
        "name\tvalue\tunit\nBust girth\t91,5\tcm\n",
        'measurement,value,unit\n"Bust girth",9.15e1,cm\n',
        "measurement,value\nBust girth,91.5 cm\n",
        "sep=;\nmeasurement;value;unit\nBust girth;91,5;CM\n",
    ],
)
def test_tables_come_in_several_forms(tmp_path: Path, text: str) -> None:
    (reading,) = read_readings(written(tmp_path, text)).values
    assert (reading.measurement, reading.value, reading.unit) == ("Bust girth", 91.5, "cm")
    assert (reading.subject, reading.error) == ("", None)


@pytest.mark.parametrize(
    ("value", "expected"),
    [("33 1/8", 33.125), ("1/2", 0.5), ("33", 33.0), ("33 15/16", 33.9375)],
)
def test_inches_may_have_fractions(tmp_path: Path, value: str, expected: float) -> None:
    path = written(tmp_path, f"measurement,value,unit,error\nwaist,{value},inch,1/16\n")
    (reading,) = read_readings(path).values
    assert (reading.value, reading.error) == (expected, 0.0625)


def test_subjects_errors_and_gaps_are_read(tmp_path: Path) -> None:
    text = "subject,measurement,value,unit,error\nAnna,bust,91,cm,0.2\nBeth,bust,,cm,\n"
    readings = read_readings(written(tmp_path, text))
    anna, beth = readings.values
    assert readings.subjects == ("Anna", "Beth")
    assert (anna.value, anna.error) == (91.0, 0.2)
    assert (beth.value, beth.reason) == (None, "no value is given")
    assert readings.name == "hand.csv"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "line 1: has no column 'measurement' and no column 'value'; expected"),
        ("measurement,length,unit\na,1,cm\n", "has no column 'value'; expected a header with"),
        ("measurement,value,unit\n", "holds no measurement"),
        ("measurement,value,unit\na,1,ft\n", "line 2: unknown unit 'ft'; expected one of m, cm"),
        ("measurement,value,unit\na,1,\n", "line 2: no unit, and none is guessed"),
        ("measurement,value,unit\na,1\n", "line 2: no unit"),
        ("measurement,value\na,1\n", "line 2: no unit, and none is guessed"),
        ("sep=;\nmeasurement;value\na;1\n", "line 3: no unit, and none is guessed"),
        ("measurement,value,unit\na,1 cm,mm\n", "line 2: the value is in cm and the column"),
        ("measurement,value,unit\na,much,cm\n", "line 2: 'much' is not a number"),
        ("measurement,value,unit\na,nan,cm\n", "'nan' is not a number"),
        ("measurement,value,unit\na,1e999,cm\n", "'1e999' is not a number"),
        ("measurement,value,unit\na,1_0,cm\n", "'1_0' is not a number"),
        # A fraction of a centimeter is a slip in the unit, and this is a slip of the pen.
        ("measurement,value,unit\na,33 1/8,cm\n", "'33 1/8' is not a number"),
        ("measurement,value,unit\na,33 1/0,inch\n", "'33 1/0' is not a number"),
        ("measurement;value;unit\na;1.234,5;cm\n", r"'1\.234,5' is not a number"),
        # Here the comma separates columns.
        ("measurement,value,unit\na,91,5,cm\n", "line 2: has 'cm' beyond the last column"),
        (
            "measurement,unit,value\na,cm,91,5\n",
            "line 2: has '5' beyond the last column .* separate the columns by semicolons",
        ),
        ("measurement,value,unit\na,-91.5,cm\n", "line 2: '-91.5' is no length; expected one abo"),
        ("measurement,value,unit\na,0,inch\n", "line 2: '0' is no length"),
        ("measurement,value,unit,error\na,1,cm,-1\n", "line 2: '-1' is no error"),
        (b"measurement,value,unit\n\xff,1,cm\n", "is not text in UTF-8"),
        ('measurement,value,unit\n"a\x00,1,cm\n', "line 2"),
        ('measurement,value\n"a,1 cm\nb,2 cm\n', "is not CSV .unexpected end of data"),
    ],
)
def test_bad_tables_are_refused(tmp_path: Path, text: str | bytes, message: str) -> None:
    with pytest.raises(InputError, match=message):
        read_readings(written(tmp_path, text))


def test_angles_and_differences_may_be_below_zero(tmp_path: Path) -> None:
    text = "key,kind,value,unit\nslope,chord,-3,deg\ngap,formula,-0.5,cm\n"
    slope, gap = read_readings(written(tmp_path, text)).values
    assert (slope.value, gap.value) == (-3.0, -0.5)


def test_a_charts_json_and_csv_read_alike(tmp_path: Path) -> None:
    document = chart_document(hand_made_chart(), "inch")
    from_json = read_readings(written(tmp_path, to_json(document), "m.json"))
    from_csv = read_readings(written(tmp_path, chart_to_csv(document), "m.csv"))
    assert from_json.name == "Anna <Muster>"
    assert from_json.unit == "inch"
    for one, other in zip(from_json.values, from_csv.values, strict=True):
        assert (one.measurement, one.value, one.unit, one.error) == (
            other.measurement,
            other.value,
            other.unit,
            other.error,
        )
        if one.value is None:
            assert one.reason == other.reason


def test_other_json_is_refused(tmp_path: Path) -> None:
    for text in ('{"schema": "bodymeasure measurements"}', "[]", "{"):
        with pytest.raises(InputError, match=r"is not the measurements\.json of a chart"):
            read_readings(written(tmp_path, text, "m.json"))


def test_a_missing_file_is_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such file"):
        read_readings(tmp_path / "gone.csv")
