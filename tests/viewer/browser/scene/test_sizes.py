"""Usable at 1024 x 700, on a tablet and by touch; and the picture that README shows."""

import os
from collections.abc import Callable
from pathlib import Path

import pytest
from helpers.viewer_page import Screen

import bodymeasure as bm

CONTROLS = ("tool-tape", "undo", "unit", "more", "help", "view-front", "frame-all", "tab-display")


@pytest.mark.parametrize("size", [(1400, 900), (1024, 700), (820, 1180), (768, 1024)])
def test_nothing_is_cut_off(open_page: Callable[..., Screen], size: tuple[int, int]) -> None:
    screen = open_page(size=size)
    overflow = screen.page.evaluate(
        "() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]"
    )
    assert overflow[0] <= size[0]
    assert overflow[1] <= size[1]
    for name in CONTROLS:
        box = screen.get(name).bounding_box()
        assert box is not None, name
        assert box["x"] >= 0, name
        assert box["x"] + box["width"] <= size[0], name
        assert box["y"] + box["height"] <= size[1], name
    canvas = screen.page.locator("canvas").bounding_box()
    assert canvas is not None
    # The hint lies over no head, however low the scene is.
    view = screen.state()["view"]
    body = bm.load_sample("female_average")
    head = float((body.points @ body.axes.up_vector).max())
    middle = canvas["y"] + canvas["height"] / 2
    above = (head - view["target"][1]) / view["height"] * canvas["height"]
    for tool in ("girth", "loop", "look", "tape"):
        screen.get(f"tool-{tool}").click()
        hint = screen.get("hint").bounding_box()
        assert hint is not None
        assert hint["y"] + hint["height"] <= middle - above, tool
    assert canvas["width"] * canvas["height"] > 0.3 * size[0] * size[1]
    places = screen.seen(apart=5)
    assert len(places) > 8
    assert screen.measure(places[1], places[-2])["result"]["words"]
    # The value can be read without scrolling.
    box = screen.get("length").bounding_box()
    assert box is not None
    assert box["y"] + box["height"] <= size[1]


def test_fingers(open_page: Callable[..., Screen]) -> None:
    screen = open_page(size=(820, 1180), touch=True)
    places = screen.seen(apart=5)
    for place in (places[1], places[-2]):
        spot = screen.spot(place)
        assert spot is not None
        screen.page.touchscreen.tap(*spot)
    screen.until("state => state.tapes.length === 1")
    assert screen.settle()["tapes"][0]["result"]["words"]
    # A finger needs more room than a pointer.
    box = screen.get("undo").bounding_box()
    assert box is not None
    assert box["width"] >= 40


def test_the_picture_of_readme(open_page: Callable[..., Screen], tmp_path: Path) -> None:
    """Taken anew into viewer/page.png with BODYMEASURE_PICTURE=viewer/page.png."""
    screen = open_page(size=(1400, 900))
    screen.take_chart("default")
    screen.get("tab-display").click()
    screen.get("layer-tapes").click()
    screen.get("tab-list").click()
    tape = screen.measure((15, 0.5, 0.5), screen.middle_of("side hip point left"))
    screen.page.mouse.move(60, 500)
    screen.until("state => state.lit === null")
    path = Path(os.environ.get("BODYMEASURE_PICTURE", tmp_path / "page.png"))
    screen.page.screenshot(path=path)
    assert path.stat().st_size > 50_000
    assert tape["result"]["length"] > 0.1
