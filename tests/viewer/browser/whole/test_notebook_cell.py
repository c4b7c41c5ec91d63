"""The notebook's widget in a browser; only what carries messages to and fro is not a notebook's."""

import base64
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from helpers.viewer.cell import Cell
from helpers.viewer_page import PATIENCE, Screen
from playwright.sync_api import Browser

import bodymeasure as bm

# What anywidget does with a widget's program: import it and render it into a cell.
RENDER = """async ({ program, style, height, options }) => {
  document.head.append(Object.assign(document.createElement("style"), { textContent: style }));
  const address = URL.createObjectURL(new Blob([program], { type: "text/javascript" }));
  const { default: widget } = await import(address);
  const listeners = {};
  const values = { height, options };
  // What a notebook tells of a kernel that was started anew.
  window.end = () => listeners["comm_live_update"]();
  window.listening = () => Object.keys(listeners);
  const model = {
    get: (name) => values[name],
    on: (name, heard) => { listeners[name] = heard; },
    off: (name) => { delete listeners[name]; },
    send: async (message) => {
      const { buffers, ...content } = await window.kernel(message);
      const views = buffers.map((text) => {
        // Buffers come as views that begin anywhere.
        const bytes = Uint8Array.from("abc" + atob(text), (letter) => letter.charCodeAt(0));
        return new DataView(bytes.buffer, 3);
      });
      listeners["msg:custom"]?.(content, views);
    },
  };
  window.leave = widget.render({ model, el: document.querySelector("#cell") });
}"""
Shown = Callable[[Any], Screen]


@pytest.fixture
def kept() -> list[Cell]:
    """The kernel's side of the cells that are shown."""
    return []


@pytest.fixture
def shown(browser: Browser, kept: list[Cell]) -> Iterator[Shown]:
    screens: list[Screen] = []

    def start(view: Any) -> Screen:
        context = browser.new_context(
            viewport={"width": 1200, "height": 800}, offline=True, reduced_motion="reduce"
        )
        page = context.new_page()
        screen = Screen.on(page)
        screens.append(screen)
        page.set_content(
            '<!doctype html><p>above</p><div id="cell"></div><p>below</p><div id="other"></div>'
        )
        cell = Cell(view)
        kept.append(cell)

        def kernel(message: dict[str, Any]) -> dict[str, Any]:
            cell.asked.append(message["request"])
            view._received(view, message, [])
            answer = cell.sent.pop()
            answer["buffers"] = [base64.b64encode(part).decode() for part in answer["buffers"]]
            return answer

        page.expose_function("kernel", kernel)
        members = {"height": view.height, "options": view.options}
        page.evaluate(RENDER, {"program": view._esm, "style": view._css, **members})
        page.wait_for_selector("#cell [data-ready]", timeout=PATIENCE * 1000)
        return screen

    yield start
    for screen in screens:
        screen.page.context.close()
        assert not screen.errors, screen.errors


@pytest.fixture(scope="module")
def body() -> bm.Atlas:
    return bm.load_sample("female_average")


def test_two_clicks_in_a_cell_measure_along_the_body(
    shown: Shown, kept: list[Cell], body: bm.Atlas
) -> None:
    screen = shown(bm.show(body, height=560))
    canvas = screen.page.locator("canvas")
    box = screen.page.locator("#cell > div").bounding_box()
    assert box is not None
    assert box["height"] == 560
    # Without this, JupyterLab would take keys in the cell for its own: x cuts the whole cell away.
    screen.get("scene").focus()
    assert screen.get("scene").get_attribute("data-lm-suppress-shortcuts") == "true"
    screen.get("tool-tape").click()
    area = canvas.bounding_box()
    assert area is not None
    # Two places on the trunk; which points of the body they are, the cell says when it asks.
    middle, top = area["x"] + area["width"] / 2, area["y"]
    for part in (0.3, 0.45):
        screen.page.mouse.click(middle, top + part * area["height"])
    row = screen.page.locator("tr[data-id^=tape]")
    row.get_by_text(" cm").first.wait_for(timeout=PATIENCE * 1000)
    value = row.locator(".value").inner_text()
    asked = [each for each in kept[0].asked if each["request"] == "path"][-1]
    start, end = (
        place if isinstance(place, str) else bm.AtlasPoint(*place) for place in asked["locations"]
    )
    assert value == f"{100 * bm.geodesic_between(body, start, end).length:.2f} cm"


def test_a_chart_in_a_cell_is_listed(shown: Shown, body: bm.Atlas) -> None:
    chart = bm.measure_chart(body, only=("waist_girth", "hip_girth"))
    screen = shown(bm.show(chart))
    row = screen.get("row-chart:waist_girth")
    row.wait_for(timeout=PATIENCE * 1000)
    assert f"{100 * chart['waist_girth'].value:.2f} cm" in row.inner_text()


def test_a_cell_that_is_closed_leaves_nothing(shown: Shown, body: bm.Atlas) -> None:
    screen = shown(bm.show(body))
    screen.page.evaluate("() => window.leave()")
    assert screen.page.locator("#cell canvas").count() == 0
    assert screen.page.locator("#cell [data-testid]").count() == 0
    assert screen.page.evaluate("() => window.listening()") == []


def test_a_kernel_that_has_ended_is_said(shown: Shown, body: bm.Atlas) -> None:
    screen = shown(bm.show(body))
    screen.page.evaluate("() => window.end()")
    banner = screen.get("banner")
    banner.wait_for()
    assert "kernel has ended" in banner.inner_text()
    assert "run the cell again" in banner.inner_text()


def test_two_cells_share_no_id(shown: Shown, body: bm.Atlas) -> None:
    """A notebook holds several viewers, each of which has loaded the program for itself."""
    view = bm.show(body)
    screen = shown(view)
    # Which is what three.js finds worth a warning.
    screen.expected = ("Multiple instances",)
    members = {"height": view.height, "options": view.options}
    render = RENDER.replace('querySelector("#cell")', 'querySelector("#other")')
    screen.page.evaluate(render, {"program": view._esm, "style": view._css, **members})
    screen.page.wait_for_selector("#other [data-ready]", timeout=PATIENCE * 1000)
    ids = screen.page.evaluate("() => [...document.querySelectorAll('[id]')].map((one) => one.id)")
    assert len(ids) > 10
    assert len(set(ids)) == len(ids)
    assert view.options["key"] != bm.show(body).options["key"]


def test_what_the_kernel_refuses_is_said_in_the_cell(
    shown: Shown, body: bm.Atlas, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_args: object) -> None:
        raise bm.InputError("the start and the end are on parts that no seam joins")

    screen = shown(bm.show(body))
    screen.get("tool-tape").click()
    monkeypatch.setattr("bodymeasure.viewer.page.widget.answer", refuse)
    area = screen.page.locator("canvas").bounding_box()
    assert area is not None
    for part in (0.3, 0.45):
        screen.page.mouse.click(area["x"] + area["width"] / 2, area["y"] + part * area["height"])
    row = screen.page.locator("tr[data-id^=tape]")
    row.get_by_text("no length").wait_for(timeout=PATIENCE * 1000)
    assert "no seam joins" in (row.locator(".value").get_attribute("title") or "")
