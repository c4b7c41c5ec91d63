"""The page of a survey, the tables beside it, and the command that makes them."""

import csv
from pathlib import Path

import numpy as np
import pytest
from helpers.command_line import hide_here, run_here
from helpers.populations import coefficients, knees, write_shapes

import bodymeasure as bm
from bodymeasure.chart import both_sides
from bodymeasure.cli.surveys.progress import Left, duration
from bodymeasure.errors import InputError
from bodymeasure.report.numbers import MINUS, NONE
from bodymeasure.report.ticks import ticks
from bodymeasure.surveys import SurveyTable
from bodymeasure.surveys.page.drawing import drawing
from bodymeasure.surveys.page.page import correlation
from bodymeasure.surveys.statistics import MAIN

pytest.importorskip("pyarrow")
pytest.importorskip("jinja2")


@pytest.fixture(scope="module")
def surveyed(tmp_path_factory: pytest.TempPathFactory) -> SurveyTable:
    """A survey of 20 bodies, of which one is far larger than the others, and one is none."""
    folder = tmp_path_factory.mktemp("survey")
    rows = coefficients(20)
    rows[:, 0] *= 0.4
    rows[5, 0] = -4.0 if rows[5, 0] < 0 else 4.0
    rows[8, 1] = np.inf
    names = np.array([f"<b>{place}</b>" for place in range(20)])
    np.savez(folder / "many.npz", coefficients=rows, names=names)
    return bm.survey(folder / "many.npz", knees(), folder=folder / "out")


def rows_of(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@pytest.mark.slow
def test_the_page_says_what_there_is(surveyed: SurveyTable, tmp_path: Path) -> None:
    files = bm.write_survey(surveyed, tmp_path, sizes=[{"knee": 45.0}])
    text = files[0].read_text(encoding="utf-8")
    assert "20 bodies, 3 measurements each, by the set “Knees”" in text
    assert "1 body could not be measured, and nothing here counts it." in text
    # Names come from files.
    assert "<b>" not in text
    assert "Knee &lt;height&gt;" in text
    assert "src=" not in text
    assert "http" not in text.replace("http://www.w3.org", "")
    summary = {row["key"]: row for row in rows_of(tmp_path / "summary.csv")}
    values = surveyed["knee"]
    assert summary["knee"]["bodies"] == "19"
    assert float(summary["knee"]["p50"]) == np.nanquantile(values, 0.5)
    assert summary["tail"]["mean"] == ""
    (failure,) = rows_of(tmp_path / "failures.csv")
    assert failure["subject"] == "<b>8</b>"
    correlations = rows_of(tmp_path / "correlations.csv")
    there = np.isfinite(values)
    wanted = np.corrcoef(values[there], surveyed["waist"][there])[0, 1]
    assert float(correlations[0]["waist"]) == pytest.approx(wanted, abs=1e-12)


@pytest.mark.slow
def test_outliers_have_links_to_their_bodies(surveyed: SurveyTable, tmp_path: Path) -> None:
    bm.write_survey(surveyed, tmp_path, sizes=[{"knee": 45.0}])
    outliers = rows_of(tmp_path / "outliers.csv")
    assert outliers[0]["subject"] == "<b>5</b>"
    page = (tmp_path / "survey.html").read_text(encoding="utf-8")
    assert 'href="bodies/body-0000006.atlas"' in page
    body = bm.read_atlas(tmp_path / "bodies" / "body-0000006.atlas")
    chart = bm.measure_chart(body, knees(), despite_errors=True)
    assert chart["knee"].value == pytest.approx(surveyed["knee"][5] / 100.0, rel=1e-14)


def test_links_lead_to_files_of_bodies(tmp_path: Path) -> None:
    (tmp_path / "a b").mkdir()
    bm.write_atlas(bm.load_sample("male_average"), tmp_path / "a b" / "one #1.atlas")
    table = bm.survey([tmp_path / "a b"], knees(), folder=tmp_path / "out")
    bm.write_survey(table)
    page = (tmp_path / "out" / "survey.html").read_text(encoding="utf-8")
    assert 'href="../a%20b/one%20%231.atlas"' in page
    # A body that was moved away since has no link, and one in memory never had one.
    (tmp_path / "a b" / "one #1.atlas").unlink()
    bm.write_survey(table)
    assert 'href="..' not in (tmp_path / "out" / "survey.html").read_text(encoding="utf-8")
    held = bm.survey([bm.load_sample("male_average")], knees(), folder=tmp_path / "held")
    assert bm.write_survey(held)[0].is_file()


def test_a_size_of_an_unknown_measurement_is_refused(surveyed: SurveyTable, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="has no measurement 'knees'; did you mean 'knee'"):
        bm.write_survey(surveyed, tmp_path, sizes=[{"knees": 45.0}])
    for value in ("45", float("nan")):
        with pytest.raises(InputError, match=r"the knee of a size is .*; expected a n"):
            bm.write_survey(surveyed, tmp_path, sizes=[{"knee": value}])  # type: ignore[dict-item]
    with pytest.raises(InputError, match="sizes, item 0, is 'knee'; expected a size"):
        bm.write_survey(surveyed, tmp_path, sizes={"knee": 45.0})  # type: ignore[arg-type]
    assert not list(tmp_path.iterdir())


def test_bars_count_every_value(rng: np.random.Generator) -> None:
    values = np.append(rng.normal(90.0, 5.0, 400), np.nan)
    drawn = drawing(values)
    assert drawn is not None
    assert sum(bar.count for bar in drawn.bars) == 400
    tallest = max(drawn.bars, key=lambda bar: bar.count)
    assert tallest.height == max(bar.height for bar in drawn.bars)
    assert drawing(np.array([3.0, 3.0])) is None
    assert drawing(np.array([np.nan])) is None
    assert ticks(61.0, 92.0) == [70.0, 80.0, 90.0]
    assert ticks(-1.0, 1.0) == [-1.0, -0.5, 0.0, 0.5, 1.0]


def test_the_time_left_follows_the_pace_of_this_run() -> None:
    left = Left()
    assert left.words(400, 1000, 10.0) == ""
    assert left.words(500, 1000, 70.0) == "about 5 minutes left"
    assert left.words(1000, 1000, 80.0) == ""
    assert [duration(seconds) for seconds in (0.2, 90.0, 7200.0, 3e5)] == [
        *("1 second", "90 seconds", "2 hours", "3 days")
    ]


def test_the_command_says_what_it_did_and_what_failed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "broken.atlas").write_text("{", encoding="utf-8")
    asked = ["--only", "knee_height", "--processes", "1", "-o", tmp_path / "out"]
    given = ["survey", tmp_path / "broken.atlas", "female_average"]
    ran = run_here(capsys, *given, *asked, "--size", "knee_height_left=46")
    assert ran.code == 1
    assert "measured      1" in ran.out
    assert "survey.html" in ran.out
    assert "1 of 2 bodies could not be measured:\n  broken: " in ran.err
    assert "knee_height_left" in (tmp_path / "out" / "summary.csv").read_text(encoding="utf-8")
    again = run_here(capsys, *given, *asked, "--no-page")
    assert again.code == 1
    assert "survey.html" not in again.out
    other = run_here(capsys, *given, "--only", "waist_girth", "-o", tmp_path / "out")
    assert (other.code, "other measurements" in other.err) == (2, True)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--size", "stature"], "is no measurement with a number above zero"),
        (["--size", "stature=170,stature=171"], "expected keys with numbers, each once"),
        (["--size", "stature=-1"], "is no measurement with a number above zero"),
        (["--size", "statue=170"], "--size names statue, which the survey does not measure"),
        (["--only", "statue"], "did you mean 'stature'?"),
        (["--unit", "ell"], "'ell' is not one of"),
    ],
)
def test_wrong_options_are_refused(
    arguments: list[str], words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    ran = run_here(capsys, "survey", "female_average", "-o", tmp_path / "out", *arguments)
    assert ran.code == 2
    assert words in " ".join(ran.err.split())
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("package", "arguments", "extra"),
    [
        ("pyarrow", [], "survey"),
        ("jinja2", [], "survey"),
        ("distributed", ["--scheduler", "tcp://x:1"], "cluster"),
    ],
)
def test_a_missing_extra_is_named(
    package: str,
    arguments: list[str],
    extra: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    hide_here(monkeypatch, package)
    path = write_shapes(tmp_path / "many.npz", 1)
    ran = run_here(capsys, "survey", path, "-o", tmp_path / "out", *arguments)
    assert ran.code == 2
    assert f"pip install 'bodymeasure[{extra}]'" in " ".join(ran.err.split())
    assert not (tmp_path / "out").exists()


def test_the_page_of_the_main_measurements_is_about_what_there_is() -> None:
    keys = {one.key for one in both_sides(bm.load_definitions().measurement)}
    assert set(MAIN) <= keys
    assert [correlation(value) for value in (-0.001, -0.42, np.nan)] == [
        *("0.00", f"{MINUS}0.42", NONE)
    ]
