"""Landmarks by clicking: added, named, moved, mirrored, removed, and saved."""

import csv
import io
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from helpers.viewer_page import Screen, Served, saved, serve

import bodymeasure as bm


@pytest.fixture(scope="module")
def bare(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Path, Served]]:
    """A body without landmarks in a file of its own."""
    path = tmp_path_factory.mktemp("bare") / "bare body.atlas"
    body = bm.load_sample("female_average")
    kept = {name: body.landmarks[name] for name in ("back neck point", "crotch point")}
    bm.write_atlas(replace(body, landmarks=kept), path)
    served = serve(str(path))
    yield path, served
    served.stop()


@pytest.fixture
def blank(bare: tuple[Path, Served], open_page: Callable[..., Screen]) -> Screen:
    screen = open_page(bare[1].link)
    screen.get("tab-landmarks").click()
    return screen


def names(screen: Screen) -> list[str]:
    return [one["name"] for one in screen.state()["landmarks"]]


def test_lacking_ones_are_placed_one_after_the_other(blank: Screen) -> None:
    lacking = blank.get("lacking").locator("button").all_inner_texts()
    assert len(lacking) > 15
    assert "bust point left" in lacking
    blank.get("place-bust point left").click()
    assert "bust point left" in blank.get("hint").inner_text()
    places = blank.seen(apart=7)[2:4]
    blank.click(places[0])
    blank.until("state => state.landmarks.length === 3")
    assert "bust point left" in names(blank)
    # The next one follows by itself.
    following = lacking[lacking.index("bust point left") + 1]
    assert following in blank.get("hint").inner_text()
    blank.click(places[1])
    blank.until("state => state.landmarks.length === 4")
    assert following in names(blank)
    placed = next(one for one in blank.state()["landmarks"] if one["name"] == "bust point left")
    # It stands where the smooth surface is, in the page's axes.
    atlas = bm.load_sample("female_average")
    axes = np.stack([atlas.axes.left_vector, atlas.axes.up_vector, atlas.axes.front_vector])
    exact = axes @ atlas.position(bm.AtlasPoint(*placed["location"]))
    np.testing.assert_allclose(placed["position"], exact, atol=1e-9)
    blank.page.keyboard.press("Control+z")
    blank.page.keyboard.press("Control+z")
    assert len(names(blank)) == 2


def test_a_new_one_is_named_and_mirrored_and_removed(blank: Screen) -> None:
    blank.get("add-landmark").click()
    blank.click(blank.seen(apart=7)[3])
    name = blank.get("landmark-name")
    name.wait_for()
    assert name.input_value() == "landmark 1"
    name.fill("bust point left")
    name.press("Enter")
    assert "bust point left" in names(blank)
    blank.get("mirror").click()
    blank.until("state => state.landmarks.some((one) => one.name === 'bust point right')")
    by_name = {one["name"]: one["position"] for one in blank.state()["landmarks"]}
    left, right = by_name["bust point left"], by_name["bust point right"]
    np.testing.assert_allclose(left[1:], right[1:], atol=0.02)
    assert left[0] == pytest.approx(-right[0], abs=0.02)
    blank.get("remove-landmark").click()
    assert "bust point right" not in names(blank)
    assert "bust point left" in names(blank)


def test_one_is_moved_by_its_handle(blank: Screen) -> None:
    before = next(one for one in blank.state()["landmarks"] if one["name"] == "crotch point")
    blank.get("landmarks").get_by_text("crotch point").click()
    handle = blank.get("handle-landmark")
    box = handle.bounding_box()
    assert box is not None
    blank.page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    blank.page.mouse.down()
    blank.page.mouse.move(box["x"] + 50, box["y"] - 60, steps=6)
    blank.page.mouse.up()
    blank.until(
        "(state, place) => state.landmarks.some((one) => one.name === 'crotch point'"
        " && JSON.stringify(one.location) !== JSON.stringify(place))",
        before["location"],
    )
    blank.page.keyboard.press("Control+z")
    after = next(one for one in blank.state()["landmarks"] if one["name"] == "crotch point")
    assert after["location"] == before["location"]


def test_tapes_follow_a_landmark_that_is_moved(blank: Screen) -> None:
    blank.get("more").click()
    blank.get("menu-between").click()
    blank.get("between-measure").click()
    blank.until("state => state.tapes.length === 1")
    before = blank.settle()["tapes"][0]["result"]["length"]
    blank.get("landmarks").get_by_text("crotch point").click()
    handle = blank.get("handle-landmark")
    handle.focus()
    for _ in range(4):
        blank.page.keyboard.press("ArrowUp")
    after = blank.settle()["tapes"][0]["result"]["length"]
    assert abs(after - before) > 1e-3


def test_a_tape_stays_where_its_landmark_was_when_that_is_renamed_or_removed(
    blank: Screen,
) -> None:
    blank.get("more").click()
    blank.get("menu-between").click()
    blank.get("between-measure").click()
    blank.until("state => state.tapes.length === 1")
    before = blank.settle()["tapes"][0]
    assert before["locations"] == ["back neck point", "crotch point"]
    blank.get("landmarks").get_by_text("crotch point").click()
    name = blank.get("landmark-name")
    name.fill("lowest point")
    name.press("Enter")
    renamed = blank.settle()["tapes"][0]
    assert renamed["locations"] == ["back neck point", "lowest point"]
    assert renamed["name"] == "back neck point to lowest point"
    assert renamed["result"]["length"] == before["result"]["length"]
    # All of it is one step.
    blank.page.keyboard.press("Control+z")
    assert blank.settle()["tapes"][0]["locations"] == before["locations"]
    blank.page.keyboard.press("Control+Shift+z")
    blank.get("landmarks").get_by_text("lowest point").click()
    blank.get("remove-landmark").click()
    removed = blank.settle()["tapes"][0]
    assert "lowest point" not in names(blank)
    assert removed["locations"][1] == list(
        bm.load_sample("female_average").landmarks["crotch point"]
    )
    assert removed["result"]["length"] == before["result"]["length"]


def test_saved_as_picks_and_in_a_copy(blank: Screen, tmp_path: Path) -> None:
    blank.get("add-landmark").click()
    blank.click(blank.seen(apart=7)[3])
    blank.get("landmark-name").fill("bust point left")
    blank.get("landmark-name").press("Enter")
    placed = next(one for one in blank.state()["landmarks"] if one["name"] == "bust point left")

    blank.get("save-landmarks").click()
    name, content = saved(blank, lambda: blank.get("save-picks").click())
    assert name.endswith(".csv")
    rows = list(csv.reader(io.StringIO(content.decode())))
    assert {"back neck point", "crotch point", "bust point left"} <= {row[0] for row in rows}

    blank.get("save-landmarks").click()
    name, content = saved(blank, lambda: blank.get("save-atlas").click())
    copy = tmp_path / name
    copy.write_bytes(content)
    point = bm.read_atlas(copy).landmarks["bust point left"]
    assert [point.patch, point.u, point.v] == pytest.approx(placed["location"], abs=1e-12)


def test_saved_into_the_file_itself(bare: tuple[Path, Served], blank: Screen) -> None:
    blank.get("add-landmark").click()
    blank.click(blank.seen(apart=7)[4])
    blank.get("landmark-name").fill("bust point right")
    blank.get("landmark-name").press("Enter")
    blank.get("save-landmarks").click()
    blank.get("save-file").click()
    blank.page.get_by_text("Saved the landmarks in").wait_for()
    assert "bust point right" in bm.read_atlas(bare[0]).landmarks
    blank.until(
        "state => state.landmarks.some((one) => one.name === 'bust point right' && !one.edited)"
    )
