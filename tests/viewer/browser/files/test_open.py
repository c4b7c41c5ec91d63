"""Files that are dropped on the page or chosen: bodies, what is none, and what has no unit."""

import json
from pathlib import Path
from typing import Any

import pytest
from helpers.command_line import folded_part_of_a_body, part_of_a_body
from helpers.viewer_page import Screen

import bodymeasure as bm


@pytest.fixture
def complaints(screen: Screen) -> Screen:
    """A page whose browser complains of answers with a status of 422, as it should."""
    screen.expected = ("status of 422",)
    return screen


def test_a_dropped_body_is_shown_and_measured(screen: Screen, tmp_path: Path) -> None:
    atlas = bm.load_sample("male_average")
    path = tmp_path / "male.atlas"
    bm.write_atlas(atlas, path)
    screen.measure((15, 0.5, 0.5), (173, 0.5, 0.5))
    screen.drop("male.atlas", path.read_bytes())
    screen.until("state => state.body.includes('male body, 174')")
    state = screen.settle()
    assert not state["tapes"]
    places = screen.seen(apart=9)
    tape = screen.measure(places[2], places[4])
    ends = [
        atlas.landmarks[one] if isinstance(one, str) else bm.AtlasPoint(*one)
        for one in tape["locations"]
    ]
    path_between = bm.geodesic_between(atlas, ends[0], ends[1], on_failure="status")
    assert tape["result"]["length"] == path_between.length


def test_what_is_no_body_is_said_in_a_sentence(complaints: Screen) -> None:
    screen = complaints
    screen.drop("letter.docx", b"Dear Sir or Madam")
    assert ".docx" in screen.message() or "docx" in screen.message()
    screen.drop("broken.atlas", b"{")
    screen.get("messages").get_by_text("broken.atlas").first.wait_for()
    # The body that was open is still there, and is measured.
    assert screen.measure((15, 0.5, 0.5), (173, 0.5, 0.5))["result"]["length"] > 0.1


def test_who_drops_a_file_without_a_unit_is_asked_for_it(
    complaints: Screen, tmp_path: Path
) -> None:
    screen = complaints
    path = tmp_path / "part.bpt"
    bm.write_atlas(part_of_a_body(100, 106), path)
    screen.drop("part.bpt", path.read_bytes())
    dialog = screen.page.get_by_role("dialog")
    assert "part.bpt does not say it" in dialog.inner_text()
    # Who does not know it is told what is lacking, and has the body that was there.
    dialog.get_by_role("button", name="Close").click()
    assert "says no unit" in screen.message()
    assert screen.state()["patches"] == 376
    screen.drop("part.bpt", path.read_bytes())
    screen.get("unit-cm").click()
    screen.until("state => state.patches === 6")
    # In centimeters it is a hundredth as large as in meters.
    expected = 0.01 * bm.diagonals(part_of_a_body(100, 106)).length[0, 0]
    screen.get("tab-display").click()
    screen.get("layer-diagonals").click()
    screen.get("legend").wait_for()
    screen.hover((0, 0.5, 0.5))
    screen.get("readout").get_by_text(f"{100 * expected:.2f} cm").first.wait_for()


def test_what_is_wrong_with_a_dropped_file_is_said_and_the_file_is_listed_after_a_reload(
    screen: Screen, tmp_path: Path
) -> None:
    path = tmp_path / "folded.atlas"
    bm.write_atlas(folded_part_of_a_body(), path)
    screen.drop("folded.atlas", path.read_bytes())
    screen.get("messages").get_by_text("The check of the atlas finds").wait_for()
    screen.page.reload()
    screen.page.wait_for_selector("#bodymeasure[data-ready]")
    screen.get("more").click()
    screen.page.get_by_role("menuitem", name="Go to Part of a body").first.click()
    screen.until("state => state.patches === 6")


def test_a_triangle_mesh_is_sent_to_the_fit(complaints: Screen) -> None:
    scan = Path(__file__).parents[3] / "data" / "scans" / "coarse.ply"
    complaints.drop("coarse.ply", scan.read_bytes())
    assert "bodymeasure fit" in complaints.message()


def test_tapes_of_another_layout_are_refused(screen: Screen) -> None:
    content = (
        b'{"format": "bodymeasure tapes", "version": 1, "body": "Someone", "layout": "other",'
        b' "tapes": []}'
    )
    screen.drop("someone.tapes.json", content)
    assert "Someone" in screen.message()


GOOD = {
    "name": "Mine",
    "mode": "path",
    "kind": "contact",
    "locations": [[15, 0.5, 0.5], [173, 0, 1]],
}


@pytest.mark.parametrize(
    "change",
    [
        {"locations": None},
        {"locations": [[15, 0.5, 0.5]]},
        {"locations": [[15, 0.5, 0.5], [100000, 0.5, 0.5]]},
        {"locations": [[15, 0.5, 0.5], [1.5, 0.5, "0.5"]]},
        {"locations": [[15, 0.5, 0.5], {}]},
        {"mode": "fly"},
        {"kind": 7},
        {"name": {"toString": None}},
    ],
)
def test_tapes_that_are_none_are_refused(screen: Screen, change: dict[str, Any]) -> None:
    content = {"format": "bodymeasure tapes", "version": 1, "tapes": [GOOD, {**GOOD, **change}]}
    screen.drop("mine.tapes.json", json.dumps(content).encode())
    assert screen.message().startswith("mine.tapes.json: tape number 2 is none of this body")
    # Nothing of the file was opened, and the page goes on, also after it is loaded again.
    assert not screen.state()["tapes"]
    screen.drop("mine.tapes.json", json.dumps({**content, "tapes": [GOOD]}).encode())
    screen.until("state => state.tapes.length > 0")
    assert screen.settle()["tapes"][0]["result"]["length"] > 0.1


def test_what_was_kept_and_is_none_is_left_out(screen: Screen) -> None:
    screen.measure((15, 0.5, 0.5), (173, 0.5, 0.5))
    screen.page.evaluate(
        """() => {
          const keys = Object.keys(sessionStorage);
          const key = keys.find((one) => one.startsWith("bodymeasure-sheet"));
          const { tapes } = JSON.parse(sessionStorage.getItem(key));
          const bad = { ...tapes[0], id: "tape-2", locations: [[1e9, 0, 0], "x"] };
          const landmarks = { "crotch point": { location: 5, position: "here" } };
          const kept = { tapes: [null, ...tapes, bad], landmarks, last: "two" };
          sessionStorage.setItem(key, JSON.stringify(kept));
        }"""
    )
    screen.page.reload()
    screen.page.wait_for_selector("#bodymeasure[data-ready]")
    (tape,) = screen.settle()["tapes"]
    assert tape["result"]["length"] > 0.1
    assert not any(one.get("edited") for one in screen.state()["landmarks"])


def test_names_in_files_are_text(screen: Screen, tmp_path: Path) -> None:
    """A name may hold anything; nothing in it becomes an element of the page."""
    from dataclasses import replace

    atlas = bm.load_sample("paraboloid")
    name = "<img src=x onerror=alert(1)>"
    path = tmp_path / "named.atlas"
    bm.write_atlas(replace(atlas, name=name, landmarks={name: bm.AtlasPoint(0, 0.5, 0.5)}), path)
    screen.drop("named.atlas", path.read_bytes())
    screen.until("state => state.body.includes('<img')")
    screen.get("tab-display").click()
    screen.get("layer-names").click()
    screen.get("tab-landmarks").click()
    assert screen.get("landmarks").get_by_text(name).is_visible()
    assert screen.page.locator("h1").inner_text() == name
    assert screen.page.locator("#bodymeasure img").count() == 0
