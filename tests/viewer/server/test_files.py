"""The viewer opens what the product reads: finished reports and charts, many bodies, scans."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bodymeasure.viewer.content.wire import unpacked
from helpers.command_line import folded_part_of_a_body, part_of_a_body, run_here
from helpers.viewer_server import Viewer, viewer
from msgspec import json

import bodymeasure as bm

DATA = Path(__file__).parents[2] / "data"


def header_of(server: Viewer, body: str = "0") -> dict[str, Any]:
    header, _ = unpacked(server.get(f"/api/body?body={body}").content)
    return header


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report of a part of a body, and the atlas beside it."""
    folder = tmp_path_factory.mktemp("report")
    atlas = part_of_a_body(100, 106)
    bm.write_report(bm.measure_atlas(atlas), folder, pictures=False)
    bm.write_atlas(atlas, folder / "part.atlas")
    return folder


@pytest.mark.slow
def test_a_report_brings_its_body_and_its_differences(report: Path) -> None:
    with viewer("--report", report) as server:
        header = header_of(server)
        assert header["name"] == "Part of a body"
        assert header["start"]["layers"] == ["diagonals"]
        layer = server.get("/api/layer?name=diagonals&compare=true")
        items = unpacked(layer.content)[0]["items"]
        # They are those of the file: nothing is compared again, so that no second worker is there.
        assert len(server.workers()) == 2
    document = json.decode((report / "measurements.json").read_bytes())
    told = {
        (record["patch_number"], record["start"][0]): record["relative_difference"]
        for record in document["measurements"]
        if record["kind"] == "diagonal"
    }
    expected = [told[patch, start] for patch in range(6) for start in (0.0, 1.0)]
    assert [item["difference"] for item in items] == expected
    assert all(expected)


@pytest.mark.slow
def test_a_chart_of_a_few_is_shown_as_it_was_asked_for(tmp_path: Path) -> None:
    atlas = bm.load_sample("female_average")
    asked = ["hip_girth", "knee_girth"]
    chart = bm.measure_chart(atlas, only=asked)
    bm.write_chart(chart, tmp_path, pictures=False)
    with viewer("--report", tmp_path) as server:
        header = header_of(server)
        # Nobody has said which body it is: the sample of that digest.
        assert header["name"] == atlas.name
        key = header["start"]["chart"]
        assert key in [one["key"] for one in header["sets"]]
        found, _ = unpacked(server.post("/api/chart", json={"set": key}).content)
    values = {one["key"]: one["value"] for one in found["measurements"]}
    assert values == {item.definition.key: item.value for item in chart.measured}
    assert list(values) == ["hip_girth", "knee_girth_left", "knee_girth_right"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("female_average", "--report", "REPORT"), "is about Part of a body, not about female"),
        (("--report", "gone"), "gone: no such file"),
        (("--report", DATA), "measurements.json: no such file"),
        (("--report", DATA / "three_teapot.json"), "measurements.json"),
        (("--report", "REPORT", "--export", "page.html"), "give it by itself"),
    ],
)
def test_a_folder_that_is_no_report_of_the_body_is_told(
    report: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    arguments: tuple[object, ...],
    words: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    named = [report if each == "REPORT" else each for each in arguments]
    ran = run_here(capsys, "view", "--no-browser", *named)
    assert (ran.code, ran.out) == (2, "")
    assert words in ran.err
    assert "Traceback" not in ran.err


def test_a_report_without_its_body_asks_for_it(
    report: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    alone = tmp_path / "alone"
    alone.mkdir()
    (alone / "measurements.json").write_bytes((report / "measurements.json").read_bytes())
    ran = run_here(capsys, "view", "--no-browser", "--report", alone)
    assert (ran.code, ran.out) == (2, "")
    assert "name the atlas that was measured (Part of a body) before --report" in ran.err


@pytest.mark.slow
def test_all_bodies_of_a_file_are_open(tmp_path: Path) -> None:
    first = part_of_a_body(100, 106)
    larger = bm.Atlas(1.1 * first.points, first.index, first.unit, name="A larger one")
    path = tmp_path / "bodies.npz"
    bm.write_population(
        [bm.Atlas(first.points, first.index, first.unit, name="Anna"), larger], path
    )
    with viewer(path) as server:
        header = header_of(server)
        assert header["bodies"] == [
            {"id": "0", "name": "Anna"},
            {"id": "1", "name": "A larger one"},
        ]
        assert header["warnings"][0] == "bodies.npz holds 2 bodies; this is number 1."
        assert header_of(server, "1")["name"] == "A larger one"
        found = server.get("/api/quantity?key=distance&other=1").content
        assert np.nanmax(unpacked(found)[1]["values"]) > 0.0


@pytest.mark.slow
def test_what_a_check_finds_is_told_on_the_page(tmp_path: Path) -> None:
    path = tmp_path / "gaping.atlas"
    bm.write_atlas(folded_part_of_a_body(), path)
    with viewer(path) as server:
        (warning,) = header_of(server)["warnings"]
        assert warning.startswith("The check of the atlas finds ")
        assert server.post("/api/path", json={"locations": [[0, 0.2, 0.2], [0, 0.8, 0.8]]}).json()[
            "length"
        ]


@pytest.mark.slow
def test_a_scan_is_fitted_first() -> None:
    with viewer(DATA / "scans" / "coarse.ply", "--file-unit", "m") as server:
        header = header_of(server)
        assert header["patches"] == 376
        assert header["warnings"][0].startswith("Fitted a body to the scan: ")
        assert {mark["origin"] for mark in header["landmarks"]} <= {"carried", "rule", "picked"}
        found = server.post(
            "/api/path", json={"locations": ["back neck point", "front neck point"]}
        ).json()
        assert 0.1 < found["length"] < 0.4


def test_a_scan_of_no_unit_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    ran = run_here(capsys, "view", "--no-browser", DATA / "scans" / "coarse.ply")
    assert (ran.code, ran.out) == (2, "")
    assert "--file-unit" in ran.err
