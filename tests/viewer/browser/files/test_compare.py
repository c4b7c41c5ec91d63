"""Two bodies beside each other under one view, or one colored by its distance from the other."""

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from helpers.viewer_page import Screen, Served, serve

import bodymeasure as bm


@pytest.fixture
def heavy(tmp_path: Path) -> Path:
    path = tmp_path / "heavy.atlas"
    bm.write_atlas(bm.load_sample("female_heavy"), path)
    return path


def compare(screen: Screen, path: Path) -> None:
    screen.get("tab-display").click()
    screen.get("compare-file").set_input_files(path)
    screen.until("state => state.side")


def test_side_by_side_and_differences(screen: Screen, heavy: Path) -> None:
    screen.take_chart()
    compare(screen, heavy)
    assert "Heavy" in screen.get("second-name").inner_text()
    screen.get("tab-list").click()
    first = bm.measure_chart(bm.load_sample("female_average"), only=("core",))
    second = bm.measure_chart(bm.load_sample("female_heavy"), only=("core",))
    values = [{one.definition.key: one.value for one in each.measured} for each in (first, second)]
    for key in ("bust_girth", "hip_girth"):
        difference = 100 * (values[1][key] - values[0][key])
        shown = screen.get(f"row-chart:{key}").locator("td").last.inner_text()
        sign = "+" if difference > 0 else "\N{MINUS SIGN}"
        assert shown == f"{sign}{abs(difference):.2f} cm"
    # Its landmarks and its tapes stand with it, and what is hidden here is hidden there.
    beside = screen.state()["second"]
    assert beside["landmarks"] == len(bm.load_sample("female_heavy").landmarks)
    assert {"chart:bust_girth/0", "chart:hip_girth/0"} <= set(beside["lines"])
    row = screen.get("row-chart:bust_girth")
    # By length, its tapes have the colors of their own lengths: the longer one is darker.
    screen.page.mouse.move(5, 300)
    screen.get("tab-display").click()
    screen.get("tapes").select_option("length")
    screen.get("tab-list").click()
    style = "element => getComputedStyle(element.querySelector('.swatch')).backgroundColor"
    shade = [int(part) for part in re.findall(r"\d+", row.evaluate(style))]
    colored = screen.state()["second"]["colors"]["chart:bust_girth/0"]
    assert sum(int(colored[k : k + 2], 16) for k in (1, 3, 5)) < sum(shade)
    row.hover()
    row.get_by_role("button", name="Hide").click()
    screen.page.mouse.move(5, 300)
    screen.until("state => !state.second.lines.includes('chart:bust_girth/0')")
    # One view for both: turned over the right body, the left one turns as well.
    box = screen.page.locator("canvas").bounding_box()
    assert box is not None
    before = screen.state()["view"]["theta"]
    screen.page.mouse.move(box["x"] + 0.75 * box["width"], 450)
    screen.page.mouse.down()
    screen.page.mouse.move(box["x"] + 0.75 * box["width"] + 90, 450, steps=3)
    screen.page.mouse.up()
    assert abs(screen.state()["view"]["theta"] - before) > 0.2
    screen.page.keyboard.press("1")
    screen.until("state => !state.moving")
    # Over the other body its own patches are named.
    screen.page.mouse.move(box["x"] + 0.72 * box["width"], 400)
    screen.get("readout").get_by_text("Heavy").wait_for()
    screen.page.mouse.click(box["x"] + 0.72 * box["width"], 400)
    assert "at the left" in screen.message()
    screen.get("tab-display").click()
    screen.get("compare-end").click()
    assert not screen.state()["side"]


def test_color_by_distance(screen: Screen, heavy: Path) -> None:
    compare(screen, heavy)
    screen.get("by-distance").click()
    legend = screen.get("legend")
    legend.wait_for()
    assert "Distance" in legend.inner_text()
    assert not screen.state()["side"]
    screen.page.keyboard.press("1")
    screen.hover(screen.seen()[12])
    screen.get("readout").get_by_text("Distance").wait_for()
    screen.get("beside").click()
    screen.until("state => state.side")
    legend.wait_for(state="hidden")


def test_another_layout_says_so(screen: Screen, tmp_path: Path) -> None:
    path = tmp_path / "paraboloid.atlas"
    bm.write_atlas(bm.load_sample("paraboloid"), path)
    compare(screen, path)
    assert "another way" in screen.page.locator(".compare").inner_text()
    assert screen.get("by-distance").is_disabled()


@pytest.fixture
def pair(tmp_path: Path) -> Iterator[Served]:
    """The page of a file with two bodies."""
    path = tmp_path / "two.npz"
    body = bm.load_sample("female_average")
    taller = replace(body, name="Taller body", points=1.02 * body.points)
    bm.write_population([body, taller], path)
    served = serve(str(path))
    yield served
    served.stop()


def test_bodies_of_one_file(pair: Served, open_page: Callable[..., Screen]) -> None:
    """A file of many bodies opens with its first; the others are there to compare and to go to."""
    screen = open_page(pair.link)
    screen.get("tab-display").click()
    screen.get("compare-open").select_option("1")
    screen.until("state => state.side")
    assert "Taller" in screen.get("second-name").inner_text()
    height = screen.until("state => !state.moving && state.view")["height"]
    screen.get("more").click()
    screen.get("menu-body-1").click()
    screen.until("state => state.id === '1' && !state.side")
    assert screen.measure((15, 0.5, 0.5), (173, 0.5, 0.5))["result"]["length"] > 0.1
    # Both are seen whole, whichever is the taller one.
    screen.get("compare-open").select_option("0")
    screen.until("state => state.side")
    view = screen.until("state => !state.moving && state.view")
    assert view["height"] == pytest.approx(height, rel=5e-3)
