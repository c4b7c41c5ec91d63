"""Tables of sizes: where they lie, whom they fit, and their mannequins."""

import csv
from collections.abc import Callable
from pathlib import Path

import msgspec
import numpy as np
import pytest
from helpers.command_line import hide_here, run_here
from helpers.populations import knees, write_shapes

import bodymeasure as bm
from bodymeasure.cli.surveys.made import made_bodies
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.report.numbers import NONE
from bodymeasure.surveys import MedoidSizes, SizeTable, StepSizes, SurveyTable, size_table
from bodymeasure.surveys.records import MEMBERS, Column, Row, read_survey, write_table
from bodymeasure.surveys.records.table import Head

pytest.importorskip("pyarrow")
PLAIN = {"group": "", "kind": "", "accuracy_class": None, "iso_name": None}


def table_of(path: Path, values: np.ndarray) -> SurveyTable:
    """A survey of bodies with these values, of a length a, a length b and an angle."""
    units = ("cm", "cm", "deg")
    columns = [
        msgspec.convert({"key": key, "name": key.upper(), "unit": unit, **PLAIN}, Column)
        for key, unit in zip("abc", units, strict=True)
    ]
    head = Head(
        unit="cm", definitions="", only=[], bodies=len(values), versions={}, measurements=columns
    )
    rows = []
    for place, given in enumerate(values):
        numbers = np.full((3, len(MEMBERS)), np.nan, "<f8")
        numbers[: len(given), 0] = given
        rows.append(Row(f"body {place}", "", "", numbers.tobytes()))
    write_table(path, head, [rows])
    return read_survey(path)


@pytest.fixture
def normal(tmp_path: Path, rng: np.random.Generator) -> SurveyTable:
    values = rng.normal([170.0, 92.0, 20.0], [7.0, 6.0, 2.0], (3000, 3))
    values[5, 0] = np.nan
    return table_of(tmp_path / "normal.parquet", values)


def test_sizes_at_steps_fit_those_who_are_within_half_a_step(normal: SurveyTable) -> None:
    table = size_table(normal, StepSizes({"a": 8.0, "b": 4.0}, least=0.02))
    values = np.column_stack([normal["a"], normal["b"]])
    whole = values[np.isfinite(values).all(axis=1)]
    assert table.bodies == len(whole) == 2999
    covered = 0
    for size in table.sizes:
        a, b = size.center.values()
        assert (a % 8.0, b % 4.0) == (0.0, 0.0)
        assert size.name == f"{a:.0f}/{b:.0f}"
        inside = (np.floor(whole / [8.0, 4.0] + 0.5) == [a / 8.0, b / 4.0]).all(axis=1)
        assert size.bodies == inside.sum() >= 0.02 * len(whole)
        assert size.controls[1].mean == pytest.approx(whole[inside, 1].mean(), rel=1e-12)
        assert size.controls[1].deviation == pytest.approx(whole[inside, 1].std(ddof=1), rel=1e-9)
        apart = np.sqrt(np.mean(((values - [a, b]) / [8.0, 4.0]) ** 2, axis=1))
        assert size.mannequin == np.nanargmin(apart)
        assert size.distance == pytest.approx(np.nanmin(apart), rel=1e-12)
        covered += size.bodies
    assert table.coverage == pytest.approx(covered / len(whole), rel=1e-14)
    largest = max(table.sizes, key=lambda size: size.bodies)
    assert largest.together == largest.part
    assert max(size.together for size in table.sizes) == pytest.approx(table.coverage, rel=1e-14)


def test_the_most_sizes_are_those_of_the_most_bodies(normal: SurveyTable) -> None:
    every = size_table(normal, StepSizes({"a": 8.0}, least=0.0))
    assert every.coverage == 1.0
    few = size_table(normal, StepSizes({"a": 8.0}, most=3))
    assert [size.center["a"] for size in few.sizes] == [160.0, 168.0, 176.0]
    largest = sum(sorted(size.bodies for size in every.sizes)[-3:])
    assert few.coverage == largest / 2999


@pytest.mark.slow
def test_sizes_by_medoids_are_bodies_and_nearer_than_others(
    normal: SurveyTable, rng: np.random.Generator
) -> None:
    pytest.importorskip("kmedoids")
    steps = {"a": 8.0, "b": 4.0}
    table = size_table(normal, MedoidSizes(steps, 8))
    values = np.column_stack([normal["a"], normal["b"]]) / list(steps.values())
    values = values[np.isfinite(values).all(axis=1)]
    centers = np.array([list(size.center.values()) for size in table.sizes]) / [8.0, 4.0]
    assert len(centers) == 8
    assert all((values == center).all(axis=1).any() for center in centers)

    def loss(some: np.ndarray) -> float:
        return float(np.linalg.norm(values[:, None] - some, axis=2).min(axis=1).mean())

    best = loss(centers)
    # No medoid can be exchanged for another body to advantage.
    for other in values[rng.choice(len(values), 30, replace=False)]:
        for place in range(8):
            changed = centers.copy()
            changed[place] = other
            assert loss(changed) >= best * (1.0 - 1e-12)
    again = size_table(normal, MedoidSizes(steps, 8))
    assert [size.center for size in again.sizes] == [size.center for size in table.sizes]


def test_few_different_bodies_are_each_a_size(tmp_path: Path) -> None:
    pytest.importorskip("kmedoids")
    values = np.array([[170.0], [170.0], [180.0]])
    table = size_table(table_of(tmp_path / "few.parquet", values), MedoidSizes({"a": 8.0}, 5))
    assert [(size.name, size.bodies, size.mannequin) for size in table.sizes] == [
        ("170", 2, 0),
        ("180", 1, 2),
    ]
    assert repr(table) == "<SizeTable of 2 sizes by a: 100.0% covered>"


def test_near_sizes_have_names_that_differ(tmp_path: Path) -> None:
    values = np.array([[170.01], [170.04], [180.0]])
    table = size_table(table_of(tmp_path / "near.parquet", values), StepSizes({"a": 0.03}))
    assert [size.name for size in table.sizes] == ["170.01", "170.04", "180.00"]


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: StepSizes({}), "the steps are {}; expected key measurements"),
        (lambda: StepSizes({"a": 0.0}), "the step of a is 0.0; expected a number above zero"),
        (lambda: StepSizes({"a": "8"}), "the step of a is '8'"),  # type: ignore[dict-item]
        (lambda: StepSizes({"a": 8.0}, least=2.0), "least is 2.0; expected a part"),
        (lambda: StepSizes({"a": 8.0}, most=0), "most is 0"),
        (lambda: MedoidSizes({"a": 8.0}, 0), "count is 0"),
    ],
)
def test_wrong_schemes_are_refused(make: Callable[[], object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        make()


def test_what_is_no_key_measurement_is_refused(normal: SurveyTable, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="has no measurement 'x'"):
        size_table(normal, StepSizes({"x": 8.0}))
    with pytest.raises(InputError, match="c is an angle; expected lengths"):
        size_table(normal, StepSizes({"c": 8.0}))
    with pytest.raises(InputError, match="no size fits enough bodies; take larger steps"):
        size_table(normal, StepSizes({"a": 0.01}, least=0.5))
    empty = table_of(tmp_path / "empty.parquet", np.array([[170.0]]))
    with pytest.raises(InputError, match=r"no body of .* has all of a, b"):
        size_table(empty, StepSizes({"a": 8.0, "b": 4.0}))


@pytest.mark.slow
def test_the_page_has_the_sizes_and_their_mannequins(tmp_path: Path) -> None:
    path = write_shapes(tmp_path / "many.npz", 6, names=np.array(["<i>"] * 6))
    survey = bm.survey(path, knees(), folder=tmp_path / "out")
    table: SizeTable = size_table(survey, StepSizes({"waist": 5.0}))
    files = bm.write_sizes(table, tmp_path / "sizes")
    assert len(files) == 3 + len(table.sizes)
    page = files[0].read_text(encoding="utf-8")
    assert "&lt;i&gt;" in page
    assert "<i>" not in page
    # Of one body there is no standard deviation.
    assert f"± {NONE}" not in page
    with files[1].open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    for size, row in zip(table.sizes, rows, strict=True):
        body = bm.read_atlas(tmp_path / "sizes" / "mannequins" / f"{size.name}.atlas")
        value = bm.measure_chart(body, knees())["waist"].value
        assert 100.0 * value == pytest.approx(survey["waist"][size.mannequin], rel=1e-14)
        assert f'href="mannequins/{size.name}.atlas"' in page
        assert float(row["waist_from"]) == size.center["waist"] - 2.5
        assert row["bodies"] == str(size.bodies)
    # Without the file of the bodies there are no mannequins, but all else.
    path.unlink()
    assert len(bm.write_sizes(table, tmp_path / "again")) == 3


@pytest.mark.slow
def test_a_body_is_made_for_each_size(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = write_shapes(tmp_path / "many.npz", 4)
    only = ["stature", "waist_girth", "hip_girth", "bust_girth"]
    survey = bm.survey(path, folder=tmp_path / "out", only=only)
    steps = "waist_girth=20,stature=30"
    ran = run_here(capsys, "sizes", tmp_path / "out", "--by", steps, "-o", tmp_path / "s", "--make")
    assert ran.code == 0
    table = size_table(survey, StepSizes({"waist_girth": 20.0, "stature": 30.0}))
    for size in table.sizes:
        name = size.name.replace("/", "-")
        body = bm.read_atlas(tmp_path / "s" / "mannequins" / f"{name}-made.atlas")
        waist = 100.0 * bm.measure_chart(body, only=["waist_girth"])["waist_girth"].value
        assert waist == pytest.approx(size.center["waist_girth"], abs=0.01)
    with (tmp_path / "s" / "sizes.csv").open(encoding="utf-8", newline="") as file:
        assert all(row["not_made"] == "" for row in csv.DictReader(file))


def test_why_no_body_was_made_is_said(tmp_path: Path) -> None:
    survey = bm.survey(["female_average"], folder=tmp_path / "out", only=["waist_girth"])
    table = size_table(survey, StepSizes({"waist_girth": 4.0}))
    made = made_bodies(table, lambda _done, _all: None)
    files = bm.write_sizes(table, tmp_path / "sizes", made=made)
    assert not [file for file in files if file.stem.endswith("-made")]
    with files[1].open(encoding="utf-8", newline="") as file:
        (row,) = csv.DictReader(file)
    assert "has 1 measurement; expected 3 to" in row["not_made"]
    assert "expected 3 to" in files[0].read_text(encoding="utf-8")


def test_the_command_prints_the_sizes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    table = table_of(tmp_path / "survey.parquet", np.array([[170.0, 90.0]] * 3 + [[180.0, 95.0]]))
    asked = ("sizes", tmp_path, "--by", "a=8,b=4")
    ran = run_here(capsys, *asked, "-o", tmp_path / "out")
    assert ran.code == 0
    assert "168/92" in ran.out
    assert "They fit 100.0% of 4 bodies." in ran.out
    assert "2 of 2 mannequins are not written" in ran.err
    few = run_here(capsys, *asked, "--most", "1")
    assert "They fit 75.0% of 4 bodies." in few.out
    both = run_here(capsys, *asked, "--medoids", "2", "--least", "0.1")
    assert (both.code, "--least and --most are for" in both.err) == (2, True)
    nowhere = run_here(capsys, *asked, "--make")
    assert (nowhere.code, "give a folder for them with -o" in nowhere.err) == (2, True)
    wrong = run_here(capsys, "sizes", tmp_path / "no.parquet", "--by", "a=8")
    assert (wrong.code, "no such file" in wrong.err) == (2, True)
    hide_here(monkeypatch, "kmedoids")
    lacking = run_here(capsys, *asked, "--medoids", "2")
    assert (lacking.code, "bodymeasure[survey]" in lacking.err) == (2, True)
    with pytest.raises(MissingExtraError, match="kmedoids"):
        size_table(table, MedoidSizes({"a": 8.0}, 1))
