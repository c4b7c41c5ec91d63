"""The tape tool: clicks, points on the way, snapping, the rubber band, ends that are dragged."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from helpers.charts.scanned import scanned
from helpers.viewer_page import Screen

import bodymeasure as bm

START, END = (15, 0.5, 0.5), (173, 0.5, 0.5)


@pytest.fixture(scope="module")
def atlas() -> bm.Atlas:
    return bm.load_sample("female_average")


def test_two_clicks_make_a_tape(screen: Screen) -> None:
    tape = screen.measure(START, END)
    assert [location[0] for location in tape["locations"]] == [START[0], END[0]]
    assert tape["result"]["words"] == screen.get("words").inner_text()
    assert screen.get("error").inner_text().startswith("±")
    assert screen.state()["selected"] == tape["id"]
    assert f"{tape['id']}/0" in screen.state()["lines"]
    # Measuring goes on: the next two clicks make the next one.
    assert screen.measure(screen.middle_of("front waist point"), END)["name"] == "Tape 2"


def test_points_on_the_way(screen: Screen, atlas: bm.Atlas) -> None:
    middle = screen.middle_of("front waist point")
    screen.click(START)
    screen.click(middle, "Shift")
    tape = screen.measure(END)
    assert len(tape["locations"]) == 3
    ends = [bm.AtlasPoint(*location) for location in tape["locations"]]
    path = bm.geodesic_between(atlas, ends[0], ends[2], [ends[1]], on_failure="status")
    assert tape["result"]["length"] == path.length

    # With the setting, clicks go on until Enter; Backspace takes the last one back.
    screen.get("tab-display").click()
    screen.get("via").check()
    for location in (START, middle, END):
        screen.click(location)
    assert screen.state()["pending"] == 3
    screen.page.keyboard.press("Backspace")
    assert screen.state()["pending"] == 2
    screen.page.keyboard.press("Enter")
    assert len(screen.settle()["tapes"]) == 2


def test_snapping_shows_before_the_click_and_alt_switches_it_off(screen: Screen) -> None:
    landmark = next(one for one in screen.state()["landmarks"] if one["name"] == "bust point left")
    place = screen.spot(landmark["location"])
    assert place is not None
    near = (place[0] + 6, place[1] + 4)
    screen.page.mouse.move(*near)
    screen.get("readout").get_by_text("bust point left").wait_for()
    screen.page.mouse.click(*near)
    tape = screen.measure(END)
    assert tape["locations"][0] == "bust point left"
    screen.page.keyboard.down("Alt")
    screen.page.mouse.click(*near)
    screen.page.keyboard.up("Alt")
    assert isinstance(screen.measure(END)["locations"][0], list)
    # A landmark on the far side is not near, however it looks.
    back = next(one for one in screen.state()["landmarks"] if one["name"] == "back neck point")
    hidden = screen.page.evaluate(
        "place => window.bodymeasure.project(...place, {hidden: true})", back["location"]
    )
    screen.page.mouse.move(*hidden)
    screen.page.wait_for_timeout(100)
    assert "back neck point" not in screen.get("readout").inner_text()


def test_the_rubber_band_has_a_running_number(screen: Screen) -> None:
    screen.click(START)
    screen.hover(END)
    label = screen.get("label-band")
    label.wait_for()
    assert "straight" in label.inner_text()
    assert "band" in screen.state()["lines"]
    # When the pointer rests, the length along the body is there before the second click.
    screen.until("state => state.lines.includes('preview')")
    preview = label.inner_text().split(" cm")[0]
    tape = screen.measure(END)
    assert preview == f"{100 * tape['result']['length']:.2f}"
    assert "band" not in screen.state()["lines"]


def test_two_clicks_on_one_spot_are_a_slip(screen: Screen) -> None:
    screen.click(START)
    screen.page.wait_for_timeout(700)
    screen.click(START)
    assert screen.state()["pending"] == 1
    assert not screen.state()["tapes"]
    screen.page.keyboard.press("Escape")
    assert screen.state()["pending"] == 0


def test_a_double_click_turns_about_that_point(screen: Screen) -> None:
    place = screen.spot(START)
    assert place is not None
    before = screen.state()["view"]["target"]
    screen.page.mouse.dblclick(*place)
    state = screen.state()
    assert state["pending"] == 0
    assert np.linalg.norm(np.subtract(state["view"]["target"], before)) > 0.1


def test_an_end_is_dragged_and_the_tape_follows(screen: Screen, atlas: bm.Atlas) -> None:
    tape = screen.measure(START, END)
    handle = screen.get(f"handle-{tape['id']}-1").bounding_box()
    assert handle is not None
    center = (handle["x"] + handle["width"] / 2, handle["y"] + handle["height"] / 2)
    target = screen.spot((300, 0.5, 0.5)) or screen.spot(screen.middle_of("front waist point"))
    assert target is not None
    screen.page.mouse.move(*center)
    screen.page.mouse.down()
    screen.page.mouse.move(*target, steps=12)
    screen.page.mouse.up()
    moved = screen.settle()["tapes"][0]
    assert moved["locations"][0] == tape["locations"][0]
    assert moved["locations"][1] != tape["locations"][1]
    ends = [
        atlas.landmarks[one] if isinstance(one, str) else bm.AtlasPoint(*one)
        for one in moved["locations"]
    ]
    path = bm.geodesic_between(atlas, ends[0], ends[1], on_failure="status")
    assert moved["result"]["length"] == path.length
    # The whole drag is one step.
    screen.page.keyboard.press("Control+z")
    assert screen.settle()["tapes"][0]["locations"] == tape["locations"]
    assert f"{100 * tape['result']['length']:.4f}"[:6] in screen.get("length").inner_text()


def test_undo_redo_delete_hide_and_names(screen: Screen) -> None:
    tape = screen.measure(START, END)
    name = screen.get("name")
    name.fill("Shoulder to thigh <b>")
    name.press("Enter")
    assert screen.get(f"row-{tape['id']}").get_by_text("Shoulder to thigh <b>").is_visible()
    assert "Shoulder to thigh <b>" in screen.get(f"label-{tape['id']}").inner_text()
    screen.get("undo").click()
    assert screen.state()["tapes"][0]["name"] == "Tape 1"
    screen.get("redo").click()
    assert screen.state()["tapes"][0]["name"] == "Shoulder to thigh <b>"

    screen.page.keyboard.press("h")
    assert not screen.state()["tapes"][0]["visible"]
    screen.page.keyboard.press("Escape")
    screen.until("state => state.lines.length === 0")
    screen.get(f"row-{tape['id']}").hover()
    screen.get(f"row-{tape['id']}").get_by_role("button", name="Show").click()
    assert screen.state()["tapes"][0]["visible"]

    screen.get(f"row-{tape['id']}").locator(".value").click()
    screen.get("delete").click()
    assert not screen.state()["tapes"]
    screen.page.keyboard.press("Control+z")
    assert len(screen.settle()["tapes"]) == 1


def test_contact_taut_and_straight(screen: Screen, atlas: bm.Atlas) -> None:
    tape = screen.measure((15, 0.5, 0.5), screen.middle_of("front waist point"))
    contact = tape["result"]["length"]
    screen.get("kind-taut").click()
    taut = screen.settle()["tapes"][0]
    assert taut["kind"] == "taut"
    start, end = (bm.AtlasPoint(*one) for one in taut["locations"])
    expected = bm.taut_tape(atlas, start, end)
    assert taut["result"]["length"] == pytest.approx(expected.length, abs=1e-12)
    straight = taut["result"]["straight"]
    assert straight < taut["result"]["length"] <= contact
    words = screen.get("details").inner_text()
    for length in (straight, contact, contact - taut["result"]["length"]):
        assert f"{100 * length:.2f} cm" in words


def test_tapes_come_back_after_a_reload(screen: Screen) -> None:
    tape = screen.measure(START, END)
    screen.page.reload()
    screen.page.wait_for_selector("#bodymeasure[data-ready]")
    after = screen.settle()["tapes"]
    assert [one["id"] for one in after] == [tape["id"]]
    assert after[0]["result"]["length"] == tape["result"]["length"]


def test_a_tape_between_landmarks_by_name(screen: Screen, atlas: bm.Atlas) -> None:
    screen.get("more").click()
    screen.get("menu-between").click()
    screen.get("between-from").select_option("back neck point")
    screen.get("between-to").select_option("elbow point left")
    screen.get("between-measure").click()
    screen.until("state => state.tapes.length === 1")
    tape = screen.settle()["tapes"][0]
    path = bm.geodesic_between(atlas, "back neck point", "elbow point left")
    assert tape["result"]["length"] == path.length
    assert tape["name"] == "back neck point to elbow point left"


def test_on_a_scan_its_distance_counts_as_the_error(
    screen: Screen, atlas: bm.Atlas, tmp_path: Path
) -> None:
    path = tmp_path / "scan.atlas"
    bm.write_atlas(replace(scanned(atlas), name="Scan"), path)
    screen.drop(path.name, path.read_bytes())
    screen.until("state => state.body === 'Scan'")
    tape = screen.measure((15, 0.5, 0.5), (173, 0.5, 0.5))
    told = f"± {1000 * tape['result']['uncertainty']:.2f} mm"
    assert screen.get("error").inner_text() == told
    assert screen.get(f"row-{tape['id']}").locator("td").last.inner_text() == told
    details = screen.get("details").inner_text()
    assert "Of the computation" in details
    assert "fitted to a scan" in details
