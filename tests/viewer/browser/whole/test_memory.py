"""What was deleted is given back, tabs leave nothing, and a page at rest draws nothing."""

import time
from collections.abc import Callable

import psutil
from helpers.viewer_page import PATIENCE, Screen, Served

START, END = (15, 0.5, 0.5), (173, 0.5, 0.5)
TABS = 50
MEBIBYTE = 2**20


def test_geometries_fall_after_delete(screen: Screen) -> None:
    before = screen.state()["geometries"]
    screen.measure(START, END)
    screen.measure(screen.middle_of("front waist point"), END)
    screen.until("(state, before) => state.geometries >= before + 2", before)
    for _ in range(2):
        screen.page.keyboard.press("Delete")
        tapes = screen.state()["tapes"]
        if tapes:
            screen.get(f"row-{tapes[0]['id']}").locator(".value").click()
    screen.page.mouse.move(30, 600)
    screen.until("(state, before) => !state.tapes.length && state.geometries <= before", before)


def test_geometries_do_not_grow_while_an_end_is_dragged(screen: Screen) -> None:
    tape = screen.measure(START, END)
    handle = screen.get(f"handle-{tape['id']}-1")
    handle.focus()
    screen.settle()
    before = screen.state()["geometries"]
    for key in ("ArrowUp", "ArrowDown") * 10:
        screen.page.keyboard.press(key)
        screen.settle()
    assert screen.state()["geometries"] <= before + 1


def test_a_page_at_rest_draws_nothing(screen: Screen) -> None:
    screen.measure(START, END)
    screen.page.mouse.move(30, 600)
    screen.until("state => !state.moving")
    screen.page.wait_for_timeout(600)
    frames = screen.state()["frames"]
    screen.page.wait_for_timeout(1500)
    assert screen.state()["frames"] == frames


def test_tabs_leave_nothing_on_the_server(server: Served, screen: Screen) -> None:
    process = psutil.Process(server.process.pid)
    context = screen.page.context

    def visit() -> None:
        page = context.new_page()
        page.goto(server.link)
        page.wait_for_selector("#bodymeasure[data-ready]", timeout=PATIENCE * 1000)
        page.close()

    for _ in range(4):
        visit()
    screen.page.wait_for_timeout(500)
    connections = len(process.net_connections())
    memory = process.memory_info().rss
    for _ in range(TABS - 4):
        visit()
    # A connection is let go a moment after its page.
    patience = time.monotonic() + PATIENCE
    while len(process.net_connections()) > connections + 2 and time.monotonic() < patience:
        screen.page.wait_for_timeout(100)
    assert len(process.net_connections()) <= connections + 2
    assert process.memory_info().rss - memory < 20 * MEBIBYTE
    # And the page that was open all the time measures as before.
    assert screen.measure(START, END)["result"]["length"] > 0.1


def test_two_tabs_do_not_disturb_each_other(open_page: Callable[..., Screen]) -> None:
    first, second = open_page(), open_page()
    first.click(START)
    second.click(screen_middle := second.middle_of("front waist point"))
    first.click(END)
    second.click(END)
    tapes = [one.settle()["tapes"] for one in (first, second)]
    assert [len(each) for each in tapes] == [1, 1]
    assert tapes[0][0]["locations"][0][0] == START[0]
    assert tapes[1][0]["locations"][0][0] == screen_middle[0]
