"""What goes wrong is said in a sentence, and the page lives on."""

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import psutil
import pytest
from helpers.viewer_page import Screen, Served, serve
from playwright.sync_api import Browser

import bodymeasure as bm

START, END = (15, 0.5, 0.5), (173, 0.5, 0.5)


@pytest.fixture
def own() -> Iterator[Served]:
    """A server that a test may kill."""
    served = serve("female_average")
    yield served
    served.stop()


def test_a_point_off_the_body(screen: Screen) -> None:
    screen.page.mouse.click(60, 500)
    assert "off the body" in screen.message()
    assert screen.state()["pending"] == 0


def test_the_server_is_gone(own: Served, open_page: Callable[..., Screen]) -> None:
    screen = open_page(own.link)
    screen.expected = ("ERR_",)
    tape = screen.measure(START, END)
    own.process.kill()
    own.process.wait()
    banner = screen.get("banner")
    banner.wait_for()
    assert "connects again by itself" in banner.inner_text()
    # The list stays, the body turns, and what is under the pointer is named.
    assert screen.get(f"row-{tape['id']}").is_visible()
    before = screen.state()["view"]["theta"]
    screen.page.keyboard.press("2")
    assert screen.state()["view"]["theta"] != before
    screen.page.keyboard.press("1")
    screen.page.mouse.move(60, 500)
    screen.hover(END)
    screen.get("readout").wait_for()
    # A tape that is asked for now waits, and is not lost.
    screen.click(START)
    screen.click(screen.middle_of("front waist point"))
    screen.until("state => state.tapes.length === 2")


def test_connected_again(open_page: Callable[..., Screen]) -> None:
    """A server that is started again at its port has its pages back, without a click."""
    token = "a-token-of-more-than-twenty-letters"
    served = serve("female_average", token=token)
    screen = open_page(served.link)
    screen.expected = ("ERR_",)
    served.process.kill()
    served.stop()
    banner = screen.get("banner")
    banner.wait_for()
    screen.click(START)
    screen.click(END)
    assert "Your tapes are kept" in banner.inner_text()
    port = served.address.rstrip("/").rpartition(":")[2]
    again = serve("female_average", "--port", port, token=token)
    try:
        banner.wait_for(state="hidden")
        # What was asked while nobody answered is asked again.
        assert screen.settle()["tapes"][0]["result"]["length"] > 0.1
    finally:
        again.stop()


def test_another_body_at_the_same_place(open_page: Callable[..., Screen]) -> None:
    """A server that is started again with another body does not measure that one in silence."""
    token = "a-token-of-more-than-twenty-letters"
    served = serve("female_average", token=token)
    screen = open_page(served.link)
    screen.expected = ("ERR_",)
    screen.measure(START, END)
    served.process.kill()
    served.stop()
    screen.get("banner").wait_for()
    port = served.address.rstrip("/").rpartition(":")[2]
    again = serve("male_average", "--port", port, token=token)
    try:
        screen.until("state => state.body.includes('male body, 174')")
        screen.page.get_by_text("in another form now").wait_for()
        # The tapes of the body before are not those of this one, and come back with it.
        assert not screen.settle()["tapes"]
        kept = screen.page.evaluate("() => Object.keys(sessionStorage)")
        assert sum(key.startswith("bodymeasure-sheet") for key in kept) == 2
    finally:
        again.stop()


def test_a_server_that_falls_silent(server: Served, screen: Screen) -> None:
    """One that is stopped, or out of reach, closes no connection; its ticks are missed."""
    screen.expected = ("ERR_",)
    process = psutil.Process(server.process.pid)
    process.suspend()
    try:
        screen.get("banner").wait_for(timeout=60_000)
        screen.click(START)
        screen.click(END)
    finally:
        process.resume()
    screen.get("banner").wait_for(state="hidden", timeout=60_000)
    assert screen.settle()["tapes"][0]["result"]["length"] > 0.1


def test_a_chart_is_stopped(screen: Screen) -> None:
    screen.expected = ("409",)
    screen.get("set").select_option("default")
    screen.get("take-chart").click()
    # At once, while it slides in: the chart may be done before it has come to rest.
    screen.get("stop").dispatch_event("click")
    assert screen.message() == "this was stopped before it was finished"
    screen.get("progress").wait_for(state="hidden")
    assert screen.state()["chart"] == 0
    screen.take_chart()


def test_the_new_link_in_the_old_tab(own: Served, open_page: Callable[..., Screen]) -> None:
    """Without a token that both know, the page needs the new link, and has its tapes by it."""
    screen = open_page(own.link)
    screen.expected = ("ERR_", "403")
    tape = screen.measure(START, END)
    own.process.kill()
    own.process.wait()
    banner = screen.get("banner")
    banner.wait_for()
    assert "BODYMEASURE_VIEW_TOKEN" in banner.inner_text()
    port = own.address.rstrip("/").rpartition(":")[2]
    again = serve("female_average", "--port", port)
    try:
        banner.get_by_text("earlier viewer").wait_for()
        # Only the fragment of the address changes, so that no browser loads the page by itself.
        with screen.page.expect_event("load"):
            screen.page.goto(again.link)
        screen.page.wait_for_selector("#bodymeasure[data-ready]")
        (kept,) = screen.settle()["tapes"]
        assert kept["id"] == tape["id"]
        assert kept["result"]["length"] == tape["result"]["length"]
        assert again.token not in screen.page.url
    finally:
        again.stop()


def test_the_worker_dies(own: Served, open_page: Callable[..., Screen]) -> None:
    screen = open_page(own.link)
    screen.measure(START, END)
    for child in psutil.Process(own.process.pid).children(recursive=True):
        if "spawn_main" in " ".join(child.cmdline()):
            child.kill()
    # The message goes by itself after a while, which a slow machine may need for the tape.
    screen.page.get_by_text("had to be started anew").wait_for()
    tape = screen.measure(screen.middle_of("front waist point"), END)
    assert tape["result"]["length"] > 0.1


def test_no_length_is_an_answer(screen: Screen, tmp_path: Path) -> None:
    """Two pieces of the body are not joined: the page says what the library says."""
    screen.expected = ("422",)
    body = bm.load_sample("female_average")
    pieces = [15, 173]
    used, index = np.unique(body.index[pieces], return_inverse=True)
    apart = bm.Atlas(body.points[used], index.reshape(-1, 4, 4), body.unit, axes=body.axes)
    bm.write_atlas(apart, tmp_path / "apart.atlas")
    screen.drop("apart.atlas", (tmp_path / "apart.atlas").read_bytes())
    screen.until("state => state.patches === 2")
    screen.measure((0, 0.5, 0.5), (1, 0.5, 0.5))
    start, end = bm.AtlasPoint(0, 0.5, 0.5), bm.AtlasPoint(1, 0.5, 0.5)
    try:
        expected = bm.geodesic_between(apart, start, end, on_failure="status").status.sentence
    except bm.InputError as error:
        expected = str(error)
    assert screen.get("length").inner_text() == "No length"
    # The points differ in some digits, of which the sentence does not speak.
    assert screen.get("words").inner_text() == expected
    assert screen.page.locator("tr.failed").count() == 1
    # It is drawn all the same, as the straight line that it would be.
    assert screen.state()["lines"]


def test_no_webgl(
    launch: Callable[..., Browser], server: Served, open_page: Callable[..., Screen]
) -> None:
    screen = open_page(server.link, within=launch("--disable-3d-apis"))
    screen.expected = ("WebGL",)
    assert "WebGL" in screen.get("no-graphics").inner_text()
    # The table works all the same.
    screen.take_chart()
    assert screen.get("row-chart:bust_girth").locator(".value").inner_text().endswith("cm")
    screen.get("more").click()
    screen.get("menu-between").click()
    screen.get("between-measure").click()
    screen.until("state => state.tapes.length === 1")
    assert screen.settle()["tapes"][0]["result"]["length"] > 0.05
    # So do the keys, as far as they are not of the scene.
    screen.page.keyboard.press("Control+z")
    assert not screen.state()["tapes"]
    screen.page.keyboard.press("Control+Shift+z")
    screen.page.keyboard.press("h")
    assert not screen.state()["tapes"][0]["visible"]
    for key in ("1", "t", "o", "Home", "f", "Escape", "ArrowLeft"):
        screen.page.keyboard.press(key)
    screen.get("scene").focus()
    for key in ("w", "Enter", "ArrowLeft", "Shift+ArrowUp"):
        screen.page.keyboard.press(key)
    screen.page.keyboard.press("?")
    screen.page.get_by_role("dialog").wait_for()
    screen.page.keyboard.press("Escape")
    screen.page.keyboard.press("/")
    screen.page.keyboard.type("bust girth")
    screen.until("() => document.activeElement.type === 'search'")
    assert "Bust girth" in screen.get("list").inner_text()
    # Nothing is offered that needs a click on the body.
    screen.get("tab-landmarks").click()
    assert screen.get("add-landmark").count() == 0
    screen.get("landmarks").get_by_text("crotch point").click()


def test_context_lost_and_restored(screen: Screen) -> None:
    screen.expected = ("ontext",)
    screen.page.evaluate(
        """() => {
          const context = document.querySelector("canvas").getContext("webgl2");
          window.lose = context.getExtension("WEBGL_lose_context");
          window.lose.loseContext();
        }"""
    )
    banner = screen.get("banner")
    banner.wait_for()
    assert "graphics card" in banner.inner_text()
    frames = screen.state()["frames"]
    screen.page.evaluate("() => window.lose.restoreContext()")
    banner.wait_for(state="hidden")
    screen.until("(state, frames) => state.frames > frames", frames)


def test_without_the_token(browser: Browser, server: Served) -> None:
    page = browser.new_context().new_page()
    page.goto(server.address)
    page.get_by_text("open the link").first.wait_for()
    page.context.close()
