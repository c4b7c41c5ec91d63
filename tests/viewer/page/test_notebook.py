import logging
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from bodymeasure.viewer.content.wire import unpacked
from helpers.viewer.cell import Cell

import bodymeasure as bm

FROM, TO = "bust point left", "front waist point"


@pytest.fixture(scope="module")
def body() -> bm.Atlas:
    return bm.load_sample("female_average")


@pytest.fixture
def cell(body: bm.Atlas) -> Iterator[Cell]:
    view = bm.show(body, height=500)
    yield Cell(view)
    view.close()


def test_a_cell_gets_the_body_and_lengths_with_all_digits(cell: Cell, body: bm.Atlas) -> None:
    assert cell.view.height == 500
    header, arrays = unpacked(cell.ask("body")["buffers"][0])
    assert header["name"] == body.name
    assert arrays["positions"].shape == (376, 17, 17, 3)
    answer = cell.ask("path", locations=[FROM, [30, 0.25, 0.75]])["answer"]
    expected = bm.geodesic_between(body, FROM, bm.AtlasPoint(30, 0.25, 0.75))
    assert answer["length"] == expected.length
    assert answer["error_estimate"] == expected.error_estimate


def test_what_goes_wrong_is_a_sentence(
    cell: Cell, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    assert "bust point lef" in cell.ask("path", locations=["bust point lef", TO])["error"]
    assert "not understood" in cell.ask("steal")["error"]
    assert "not understood" in cell.ask("path", locations=[[0, 2.0, 0.0], TO])["error"]
    assert "bm.show(path)" in cell.ask("open", name="a.atlas", content="")["error"]
    cell.view._received(cell.view, "nonsense", [])
    assert "not understood" in cell.sent.pop()["error"]

    def fail(*_args: object) -> None:
        raise RuntimeError("bug")

    monkeypatch.setattr("bodymeasure.viewer.page.widget.answer", fail)
    with caplog.at_level(logging.ERROR):
        answer = cell.ask("path", locations=[FROM, TO])
    assert answer["error"].startswith("The program that measures failed")
    assert answer["status"] == 500
    assert "RuntimeError: bug" in caplog.text


def test_a_chart_is_shown_as_it_was_measured(body: bm.Atlas) -> None:
    chart = bm.measure_chart(body, only=("waist_girth",))
    cell = Cell(bm.show(chart))
    key = cell.view.options["chart"]
    header, _ = unpacked(cell.ask("chart", set=key)["buffers"][0])
    (waist,) = header["measurements"]
    assert waist["value"] == chart["waist_girth"].value
    assert header["seconds"] == chart.seconds
    file = cell.ask("export", set=key, format="csv")
    assert file["name"].endswith(".csv")
    assert b"waist_girth" in file["buffers"][0]


def test_landmarks_are_saved_into_the_file_that_was_shown(tmp_path: Path, body: bm.Atlas) -> None:
    path = tmp_path / "body.atlas"
    bm.write_atlas(body, path)
    cell = Cell(bm.show(path))
    answer = cell.ask("landmarks", landmarks={"mole": [30, 0.5, 0.5]}, to="file")
    assert answer["answer"] == {"saved": str(path)}
    assert bm.read_atlas(path).landmarks["mole"] == bm.AtlasPoint(30, 0.5, 0.5)
    # What is asked next is asked of the body as it was saved.
    assert "length" in cell.ask("path", locations=["mole", FROM])["answer"]
    header, _ = unpacked(cell.ask("body")["buffers"][0])
    assert header["version"] == 2
    assert "mole" in [mark["name"] for mark in header["landmarks"]]
    # A body that comes from no file has none to be saved into.
    answer = Cell(bm.show(body)).ask("landmarks", landmarks={}, to="file")
    assert "save it as an atlas instead" in answer["error"]


@pytest.mark.parametrize("height", [0, 10**6, "tall"])
def test_no_cell_has_such_a_height(body: bm.Atlas, height: Any) -> None:
    with pytest.raises(bm.InputError, match="expected pixels from 200 to 4000"):
        bm.show(body, height=height)


def test_without_anywidget_the_extra_is_named(
    body: bm.Atlas, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delitem(sys.modules, "bodymeasure.viewer.page.widget", raising=False)
    monkeypatch.setitem(sys.modules, "anywidget", None)
    with pytest.raises(bm.MissingExtraError, match=r"bodymeasure\[notebook\]"):
        bm.show(body)
