"""Surveys in this process: records, failures, what is kept and what is refused."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest
from helpers.command_line import hide_here
from helpers.populations import knees, write_shapes
from helpers.speed import quick

import bodymeasure as bm
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.report.body import chart_document
from bodymeasure.surveys import run
from bodymeasure.surveys.bodies.again import BodiesAgain
from bodymeasure.surveys.folder.lock import locked
from bodymeasure.surveys.folder.parts import FOLDER
from bodymeasure.surveys.records import MEMBERS, SurveyTable

pytest.importorskip("pyarrow")


def renamed(definitions: bm.Definitions) -> bm.Definitions:
    return msgspec.structs.replace(definitions, name="Other")


def content(table: SurveyTable) -> bytes:
    return table.path.read_bytes()


@pytest.mark.parametrize("only", quick([["knee_height", "waist_girth"], []]))
def test_records_agree_with_the_chart_to_the_last_bit(only: list[str], tmp_path: Path) -> None:
    names = ["female_average", "male_average"]
    table = bm.survey(names, folder=tmp_path, only=only, unit="inch")
    for place, name in enumerate(names):
        chart = bm.measure_chart(bm.load_sample(name), only=only)
        records = {one.key: one for one in chart_document(chart, "inch").measurements}
        assert records
        for key in (column.key for column in table.measurements):
            for member in MEMBERS:
                found = float(table.member(key, member)[place])
                wanted = getattr(records[key], member, None) if key in records else None
                wanted = wanted if isinstance(wanted, float) else None
                assert (None if np.isnan(found) else found) == wanted


@pytest.mark.slow
def test_a_body_of_the_space_has_the_chart_of_its_atlas(tmp_path: Path) -> None:
    path = write_shapes(tmp_path / "many.npz", 2)
    only = ["stature", "waist_girth", "hip_girth"]
    table = bm.survey(path, folder=tmp_path / "out", only=only)
    atlas = BodiesAgain(table.path.parent, {}).atlas(table.subjects[1], table.sources[1])
    chart = chart_document(bm.measure_chart(atlas, only=only), "cm")
    assert table.sources[1] == "../many.npz#2"
    for record in chart.measurements:
        assert record.value is not None
        assert table[record.key][1] == record.value
        assert table.member(record.key, "error_estimate")[1] == record.error_estimate


@pytest.mark.slow
def test_head_and_hands_are_left_out_only_where_nothing_needs_them(tmp_path: Path) -> None:
    path = write_shapes(tmp_path / "many.npz", 1)
    without = bm.survey(path, folder=tmp_path / "a", only=["waist_girth"])
    within = bm.survey(path, folder=tmp_path / "b", only=["waist_girth", "stature"])
    assert np.isfinite(within["stature"]).all()
    assert without["waist_girth"] == within["waist_girth"]


class _EndedError(Exception):
    pass


def test_a_survey_that_was_ended_goes_on_and_gives_the_same_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write_shapes(tmp_path / "many.npz", 6)
    whole = bm.survey(path, knees(), folder=tmp_path / "whole")

    def end(done: int, total: int) -> None:
        assert total == 6
        if done == 4:
            raise _EndedError

    with pytest.raises(_EndedError):
        bm.survey(path, knees(), folder=tmp_path / "ended", progress=end)
    parts = sorted((tmp_path / "ended" / FOLDER).glob("*/*"))
    assert len(parts) == 4
    # A file that was cut short, as by a full disk, and one that was being written.
    parts[1].write_bytes(parts[1].read_bytes()[:-5])
    parts[0].with_name(".bodymeasure-x").write_bytes(b"half")
    counts: list[int] = []
    again = bm.survey(
        path, knees(), folder=tmp_path / "ended", progress=lambda done, _: counts.append(done)
    )
    assert counts == [3, 4, 5, 6]
    assert content(again) == content(whole)
    assert not (tmp_path / "ended" / FOLDER).exists()
    # What is done is not measured again.
    monkeypatch.setattr(run, "_measure", None)
    assert content(bm.survey(path, knees(), folder=tmp_path / "ended")) == content(whole)


def test_bodies_and_measurements_that_fail_are_rows_with_their_reasons(tmp_path: Path) -> None:
    (tmp_path / "broken.atlas").write_text("{", encoding="utf-8")
    (tmp_path / "scan.stl").write_text("solid nothing", encoding="utf-8")
    body = bm.load_sample("female_average")
    turned = replace(body, axes=bm.Axes(up="-z", front="-y"), name="upside down")
    bm.write_atlas(turned, tmp_path / "turned.atlas")
    bm.write_atlas(body, tmp_path / "whole.atlas")
    names = ["broken.atlas", "scan.stl", "turned.atlas", "whole.atlas"]
    table = bm.survey([tmp_path / name for name in names], knees(), folder=tmp_path / "out")
    reasons = {each.subject: each.reason for each in table.failures}
    assert set(reasons) == {"broken", "scan", "turned"}
    assert "broken.atlas" in reasons["broken"]
    assert "unit" in reasons["scan"]
    assert "landmarks" in reasons["turned"]
    assert np.isfinite(table["knee"]).tolist() == [False, False, False, True]
    ((subject, key, outcome, reason),) = table.lacking()
    assert (subject, key, outcome) == ("whole", "tail", "missing landmark")
    assert "has no landmark 'tail'" in reason
    assert np.isnan(table["tail"]).all()
    anyway = bm.survey(
        [tmp_path / name for name in names], knees(), folder=tmp_path / "b", despite_errors=True
    )
    assert {each.subject for each in anyway.failures} == {"broken", "scan"}


def test_an_unforeseen_error_of_one_body_leaves_the_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    measure = bm.measure_chart

    def fail(atlas: bm.Atlas, *rest: object, **more: object) -> object:
        if atlas.name == "bad":
            raise ZeroDivisionError("by\n zero")
        return measure(atlas, *rest, **more)  # type: ignore[arg-type]

    monkeypatch.setattr("bodymeasure.surveys.records.measured.measure_chart", fail)
    body = bm.load_sample("female_average")
    table = bm.survey([replace(body, name="bad"), body], knees(), folder=tmp_path)
    (failed,) = table.failures
    assert "ZeroDivisionError: by zero" in failed.reason
    assert np.isfinite(table["knee"]).tolist() == [False, True]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"only": ["knee"]}, "other measurements"),
        ({"unit": "mm"}, "another unit"),
        ({"despite_errors": True}, "another choice about bodies"),
        ({"file_unit": "m"}, "other bodies"),
        ({"definitions": renamed(knees())}, "other definitions of measurements"),
    ],
)
def test_a_folder_with_another_survey_is_refused(
    change: dict[str, Any], words: str, tmp_path: Path
) -> None:
    bm.survey(["female_average"], knees(), folder=tmp_path)
    before = sorted(tmp_path.iterdir())
    asked: dict[str, Any] = {"definitions": knees(), **change}
    with pytest.raises(InputError, match=f"holds a survey of {words}.*choose another folder"):
        bm.survey(["female_average"], folder=tmp_path, **asked)
    assert sorted(tmp_path.iterdir()) == before


def test_a_file_that_has_changed_is_another_body(tmp_path: Path) -> None:
    path = write_shapes(tmp_path / "many.npz", 2)
    bm.survey(path, knees(), folder=tmp_path / "out")
    write_shapes(path, 3)
    with pytest.raises(InputError, match="other bodies, or files that have changed since"):
        bm.survey(path, knees(), folder=tmp_path / "out")


def test_other_versions_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    bm.survey(["female_average"], knees(), folder=tmp_path)
    monkeypatch.setattr(run, "package_versions", lambda: {"numpy": "0.1"})
    with pytest.raises(InputError, match="other versions of bodymeasure"):
        bm.survey(["female_average"], knees(), folder=tmp_path)


def test_two_surveys_do_not_work_in_one_folder(tmp_path: Path) -> None:
    with locked(tmp_path), pytest.raises(InputError, match="another survey is at work in it"):
        bm.survey(["female_average"], knees(), folder=tmp_path)


def test_somebody_elses_file_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "survey.json").write_text("{}", encoding="utf-8")
    with pytest.raises(InputError, match=r"survey.json: is no file of `bodymeasure survey`"):
        bm.survey(["female_average"], knees(), folder=tmp_path)
    assert (tmp_path / "survey.json").read_text(encoding="utf-8") == "{}"


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda to: bm.survey([], folder=to), "there is no body to survey"),
        (lambda to: bm.survey(["nobody.atlas"], folder=to), "nobody.atlas: no such file"),
        (lambda to: bm.survey(3, folder=to), "bodies are 3; expected files or atlases"),  # type: ignore[arg-type]
        (lambda to: bm.survey(["female_average"] * 2, folder=to), "is given twice"),
        (lambda to: bm.survey(["female_average"], folder=to, processes=0), "processes is 0"),
        (lambda to: bm.survey(["female_average"], folder=to, only="core"), "only is 'core'"),
        (lambda to: bm.survey(["female_average"], folder=to, only=["x"]), "no preset 'x'"),
        (
            lambda to: bm.survey([bm.load_sample("paraboloid"), "female_average"], folder=to),
            "either the ones or the others",
        ),
        (lambda to: bm.read_survey(to), "no such file; expected what `bodymeasure survey` writes"),
        (lambda _: bm.read_survey(__file__), "is not the table of a survey"),
    ],
)
def test_bad_arguments_are_refused(
    call: Callable[[Path], object], words: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=words):
        call(tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_set_without_measurements_is_refused(tmp_path: Path) -> None:
    empty = bm.Definitions(name="Empty")
    with pytest.raises(InputError, match="defines no measurement"):
        bm.survey(["female_average"], empty, folder=tmp_path)


def test_a_missing_package_is_named_before_the_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    hide_here(monkeypatch, "pyarrow")
    with pytest.raises(MissingExtraError, match=r"pip install 'bodymeasure\[survey\]'"):
        bm.survey(["female_average"], knees(), folder=tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_full_disk_loses_no_measured_body(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(path: Path, *_: object) -> None:
        path.write_bytes(b"half")
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as changed:
        changed.setattr(run, "write_table", fail)
        with pytest.raises(InputError, match=r"No space left on device.*make room on the disk"):
            bm.survey(["female_average"], knees(), folder=tmp_path)
    assert not list(tmp_path.glob(".*unfinished"))
    counts: list[int] = []
    bm.survey(
        ["female_average"], knees(), folder=tmp_path, progress=lambda done, _: counts.append(done)
    )
    assert counts == [1]


@pytest.mark.slow
def test_a_body_is_fitted_to_a_scan(tmp_path: Path) -> None:
    pytest.importorskip("trimesh")
    scan = Path(__file__).parents[1] / "data" / "scans" / "coarse.ply"
    only = ["waist_girth", "knee_height"]
    table = bm.survey([scan], folder=tmp_path, only=only, file_unit="m", processes=2)
    fitted = bm.fit_body(scan, file_unit="m")
    chart = chart_document(bm.measure_chart(fitted.atlas, only=only), "cm")
    for record in chart.measurements:
        assert table[record.key][0] == record.value
        assert table.member(record.key, "input_uncertainty")[0] == record.input_uncertainty


def test_an_unknown_measurement_of_a_table_is_refused(tmp_path: Path) -> None:
    table = bm.survey([bm.load_sample("female_average")], knees(), folder=tmp_path)
    assert repr(table) == "<SurveyTable of 1 body, 3 measurements in cm>"
    assert len(bm.read_survey(tmp_path)) == 1
    with pytest.raises(KeyError, match="did you mean 'knee'"):
        table["knees"]
    with pytest.raises(KeyError, match="'taut'"):
        table.member("knee", "taught")
    with pytest.raises(InputError, match="did you mean 'knee'"):
        table.column("knees")
