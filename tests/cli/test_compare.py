import json
import re
from pathlib import Path

import pytest
from helpers.charts.hand_made_chart import hand_made_chart
from helpers.command_line import Run

from bodymeasure import load_sample, write_atlas
from bodymeasure.cli.measuring.compare import MINIMUM_SUBJECTS
from bodymeasure.compare import MINIMUM_SUBJECTS as STANDARD
from bodymeasure.report.body import chart_document, chart_to_csv
from bodymeasure.report.serial import to_json


@pytest.fixture
def chart(tmp_path: Path) -> Path:
    path = tmp_path / "chart.json"
    path.write_bytes(to_json(chart_document(hand_made_chart(), "inch")))
    return path


@pytest.fixture
def hand(tmp_path: Path) -> Path:
    path = tmp_path / "hand.csv"
    path.write_text("measurement,value,unit\nBust girth,91.0,cm\nwaist height,1,m\n", "utf-8")
    return path


def several(path: Path, shift: float) -> Path:
    lines = [
        f"person {number},bust_girth,{900.0 + shift + number % 2},mm"
        for number in range(MINIMUM_SUBJECTS)
    ]
    path.write_text("\n".join(["subject,measurement,value,unit", *lines]), "utf-8")
    return path


def test_a_chart_against_hand_measurements(run: Run, chart: Path, hand: Path) -> None:
    ran = run("compare", chart, hand, "--unit", "cm")
    assert ran.code == 0
    assert ran.out.startswith("A Anna <Muster>, B hand.csv, in cm\n")
    assert re.search(r"^Bust girth +91\.3 +91\.0 +\+0\.32 +\+0\.35\s% ", ran.out, re.M)
    assert "no value in Anna <Muster>: waist_height (lacks the landmark 'waist'" in ran.err
    assert "not in hand.csv: upper_arm_girth_left" in ran.err


def test_two_charts_of_one_body_go_by_their_files(run: Run, chart: Path, tmp_path: Path) -> None:
    other = tmp_path / "other.json"
    other.write_bytes(chart.read_bytes())
    ran = run("compare", chart, other)
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.startswith(f"A {chart}, B {other}, in inch\n")
    table = tmp_path / "chart.csv"
    table.write_bytes(chart_to_csv(chart_document(hand_made_chart(), "mm")))
    ran = run("compare", chart, table)
    assert (ran.code, ran.err) == (0, "")
    assert re.search(r"^Bust girth +35\.95 +35\.95 +0\.000 +0\.00\s% ", ran.out, re.M)


@pytest.mark.parametrize(("shift", "code", "verdict"), [(5.0, 0, "within"), (20.0, 1, "exceeds")])
def test_several_subjects_are_judged(
    run: Run, tmp_path: Path, shift: float, code: int, verdict: str
) -> None:
    a, b = several(tmp_path / "a.csv", shift), several(tmp_path / "b.csv", 0.0)
    ran = run("compare", a, b, "--unit", "mm")
    assert (ran.code, ran.err) == (code, "")
    assert re.search(rf"^Bust girth +40 +\+{shift} .* large girth +{verdict}$", ran.out, re.M)
    assert re.search(rf"^large girth +9\.0 +1 +\d +{verdict}$", ran.out, re.M)
    ran = run("compare", a, b, "--minimum-subjects", 41)
    assert ran.code == 0
    assert ran.err.startswith(
        "40 subjects are not enough for a verdict of ISO 20685-1, which takes"
    )


def test_the_minimum_is_that_of_the_comparison() -> None:
    assert MINIMUM_SUBJECTS == STANDARD == 40


@pytest.mark.parametrize("suffix", [".csv", ".json", ".html"])
def test_the_differences_are_written(
    run: Run, chart: Path, hand: Path, tmp_path: Path, suffix: str
) -> None:
    output = tmp_path / f"out{suffix}"
    ran = run("compare", chart, hand, "-o", output)
    assert ran.code == 0
    assert ran.out.endswith(f"{output}\n")
    content = output.read_text("utf-8")
    assert "bust_girth" in content if suffix != ".html" else "Bust girth" in content
    if suffix == ".json":
        assert len(json.loads(content)["differences"]) == 1


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("chart.json", "gone.csv"), "gone.csv: no such file"),
        (
            ("chart.json", "hand.csv", "-o", "out.xml"),
            "expected a name that ends in one of .csv, .json, .html",
        ),
        (("chart.json", "hand.csv", "-o", "no/out.csv"), "cannot be written"),
        (("chart.json", "wrong.csv"), "no measurement is named 'bust grith'; did you mean"),
        (("chart.json",), "Missing argument 'B'"),
        (("chart.json", "hand.csv", "--unit", "ft"), "'ft' is not one of"),
    ],
)
def test_bad_input_is_told_and_nothing_written(
    run: Run,
    chart: Path,
    hand: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: tuple[str, ...],
    message: str,
) -> None:
    monkeypatch.chdir(chart.parent)
    (chart.parent / "wrong.csv").write_text("measurement,value,unit\nbust grith,1,cm\n", "utf-8")
    before = set(chart.parent.iterdir())
    ran = run("compare", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err
    assert set(chart.parent.iterdir()) == before
    assert hand in before


@pytest.fixture
def one_height(tmp_path: Path) -> Path:
    """A set of definitions with one measurement."""
    path = tmp_path / "set.toml"
    path.write_text(
        'format = "bodymeasure measurements"\nversion = 1\nname = "One"\n[[measurement]]\n'
        'key = "back_neck_height"\nkind = "height"\nname = "Back neck height"\n'
        'at = "back neck point"\n',
        "utf-8",
    )
    return path


def test_an_atlas_is_measured(run: Run, one_height: Path) -> None:
    ran = run("compare", "female_average", "female_old", "--set", one_height, "--unit", "m")
    assert (ran.code, ran.err) == (0, "")
    assert re.search(r"^Back neck height +1\.\d{3} +1\.\d{3} +\+0\.\d{4} ", ran.out, re.M)


def test_the_unit_and_axes_of_an_atlas_whose_format_has_none(
    run: Run, tmp_path: Path, one_height: Path
) -> None:
    bare = tmp_path / "bare.bpt"
    write_atlas(load_sample("female_average"), bare)
    arguments = ("compare", "female_average", bare, "--set", one_height)
    ran = run(*arguments)
    assert (ran.code, ran.out) == (2, "")
    assert "says no unit" in ran.err
    # The file has lost its landmarks too, so that there is nothing to compare in the end.
    ran = run(*arguments, "--file-unit", "m", "--up", "+z", "--front", "-y")
    assert "have no value of the same measurement" in ran.err
    ran = run("compare", "female_average", "male_average", "--file-unit", "cm")
    assert (ran.code, ran.out) == (2, "")
    assert "is in m, but the unit cm was given" in ran.err


def test_a_folder_that_chart_has_written_is_compared(tmp_path: Path, run: Run) -> None:
    folder = tmp_path / "chart"
    written = run("chart", "--only", "bust_span", "-o", folder, "--no-pictures")
    assert written.code == 0
    ran = run("compare", folder, folder / "measurements.json")
    assert ran.code == 0
    assert re.search(r"^Bust .* 0\.0", ran.out, re.M)
    # The subject is called as in the chart of several bodies.
    assert json.loads((folder / "measurements.json").read_bytes())["subject"] == "female_average"
