"""The page in one file, opened from the disk with the network off, alone and within a chart."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from bodymeasure.viewer import export_page
from helpers.charts.hand_made_chart import HOSTILE, hand_made_chart
from helpers.charts.scanned import scanned
from helpers.viewer_page import PATIENCE, Screen, findings
from playwright.sync_api import Browser

import bodymeasure as bm
from bodymeasure.report import write_chart, write_report

KEYS = ("waist_girth", "hip_girth", "bust_span")
Opened = Callable[[Path], Screen]


@pytest.fixture(scope="module")
def chart() -> bm.Chart:
    return bm.measure_chart(bm.load_sample("female_average"), only=KEYS)


@pytest.fixture(scope="module")
def file(chart: bm.Chart, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("exported") / "body.html"
    export_page(chart, path)
    return path


@pytest.fixture
def opened(browser: Browser) -> Iterator[Opened]:
    """Open files without a network; at the end, none may have asked for anything but itself."""
    screens: list[tuple[Screen, list[str], str]] = []

    def start(path: Path) -> Screen:
        context = browser.new_context(
            viewport={"width": 1280, "height": 900}, offline=True, reduced_motion="reduce"
        )
        page = context.new_page()
        requests: list[str] = []
        page.on("request", lambda request: requests.append(request.url))
        screen = Screen.on(page)
        screens.append((screen, requests, path.as_uri()))
        page.goto(path.as_uri())
        return screen

    yield start
    for screen, requests, address in screens:
        screen.page.context.close()
        assert not screen.errors, screen.errors
        loaded = [url for url in requests if not url.startswith(("data:", "blob:", "about:"))]
        assert loaded == [address]


def _ready(screen: Screen) -> Screen:
    screen.page.wait_for_selector("#bodymeasure[data-ready]", timeout=PATIENCE * 1000)
    return screen


def test_the_body_and_its_chart_are_there_without_a_network(
    opened: Opened, file: Path, chart: bm.Chart
) -> None:
    screen = _ready(opened(file))
    screen.until("state => state.chart > 0")
    state = screen.state()
    assert state["body"] == chart.atlas.name
    # The tapes are drawn, and so is the body.
    assert {f"chart:{key}" for key in KEYS} <= {line.partition("/")[0] for line in state["lines"]}
    waist = screen.get("row-chart:waist_girth")
    assert f"{100 * chart['waist_girth'].value:.2f} cm" in waist.inner_text()
    screen.get("search").fill("span")
    screen.page.wait_for_function("document.querySelectorAll('tr[data-id]').length === 1")
    assert "Bust span" in screen.get("list").inner_text()


def test_nothing_in_it_keeps_anybody_out(opened: Opened, file: Path, axe: str) -> None:
    screen = _ready(opened(file))
    screen.until("state => state.chart > 0")
    assert not findings(screen, axe)
    screen.get("row-chart:waist_girth").locator(".value").click()
    assert not findings(screen, axe)
    screen.get("tab-display").click()
    assert not findings(screen, axe)


def test_names_from_files_are_text_and_a_scans_uncertainty_is_the_error(
    opened: Opened, tmp_path: Path
) -> None:
    """Made-up numbers: where the scan leaves more open than the computation, that is told."""
    known = hand_made_chart().measured
    scan = replace(known[1], input_uncertainty=0.0123)
    rest = [
        replace(one, input_uncertainty=0.87) if one.definition.key == "shoulder_slope" else one
        for one in known[2:]
    ]
    measured = (replace(known[0], input_uncertainty=1e-12), scan, *rest)
    chart = hand_made_chart(measured=measured, atlas=scanned(hand_made_chart().atlas))
    path = tmp_path / "anna.html"
    export_page(chart, path)
    screen = _ready(opened(path))
    screen.until("state => state.chart > 0")
    assert screen.page.locator("h1").inner_text() == "Anna <Muster>"
    name = screen.get("row-chart:shoulder_length").locator(".row-name")
    assert name.inner_text() == HOSTILE
    assert screen.page.locator("#bodymeasure script, #bodymeasure b").count() == 0
    row = screen.get("row-chart:upper_arm_girth_left")
    assert row.locator("td").last.inner_text() == "± 1.2 cm"
    assert screen.get("row-chart:bust_girth").locator("td").last.inner_text() == "± 1.5 nm"
    assert screen.get("row-chart:shoulder_slope").locator("td").last.inner_text() == "± 0.87°"
    row.locator(".value").click()
    words = screen.get("details").inner_text().replace("\n", " ")
    assert "From scan and landmarks ± 1.2 cm" in words
    assert "Of the computation ± 4.0 mm" in words


def test_two_clicks_give_the_straight_distance_and_say_what_it_is(
    opened: Opened, file: Path, chart: bm.Chart
) -> None:
    screen = _ready(opened(file))
    screen.until("state => state.chart > 0")
    screen.get("tool-tape").click()
    body = chart.atlas
    names = ("bust point left", "front waist point")
    tape = screen.measure(*(list(body.landmarks[name]) for name in names))
    assert tape["locations"] == list(names)
    ends = [body.position(body.landmarks[name]) for name in names]
    assert tape["result"]["length"] == pytest.approx(np.linalg.norm(ends[1] - ends[0]), rel=1e-9)
    assert "cannot measure along the body" in tape["result"]["words"]
    # A point says where it is, in the body's own directions.
    screen.hover(body.landmarks["bust point left"])
    x, y, z = 100.0 * ends[0]
    where = f"{x:.2f} cm left, {z:.2f} cm up, {-y:.2f} cm front"
    assert where in screen.get("readout").inner_text()
    # What would ask the program is not offered.
    for name in ("tool-girth", "tool-loop", "tool-landmark"):
        assert screen.get(name).count() == 0


def test_a_chart_opens_its_scene_and_its_links_choose_what_is_seen(
    opened: Opened, chart: bm.Chart, tmp_path: Path
) -> None:
    write_chart(chart, tmp_path, pictures=False, scene=export_page(chart))
    screen = opened(tmp_path / "chart.html")
    frame = screen.page.frame_locator("#scene-frame")
    # Nothing is unpacked before it comes into sight.
    screen.page.locator("#scene-frame").scroll_into_view_if_needed()
    frame.locator("#bodymeasure[data-ready]").wait_for(timeout=PATIENCE * 1000)
    screen.page.locator("#measurement-hip_girth a[data-show]").click()
    row = frame.get_by_test_id("row-chart:hip_girth")
    row.locator("xpath=self::*[@aria-current='true']").wait_for(timeout=PATIENCE * 1000)
    assert screen.page.url.endswith("#scene")


def test_a_report_opens_its_scene_with_the_diagonals(opened: Opened, tmp_path: Path) -> None:
    survey = bm.measure_atlas(bm.load_sample("paraboloid"))
    write_report(survey, tmp_path, pictures=False, scene=export_page(survey))
    screen = opened(tmp_path / "report.html")
    frame = screen.page.frame_locator("#scene-frame")
    screen.page.locator("#scene-frame").scroll_into_view_if_needed()
    frame.locator("#bodymeasure[data-ready]").wait_for(timeout=PATIENCE * 1000)
    frame.get_by_text("Difference from the mesh").first.wait_for(timeout=PATIENCE * 1000)


def test_without_scripts_a_chart_is_whole_but_for_the_scene(
    browser: Browser, chart: bm.Chart, tmp_path: Path
) -> None:
    write_chart(chart, tmp_path, pictures=False, scene=export_page(chart))
    context = browser.new_context(java_script_enabled=False, offline=True)
    page = context.new_page()
    page.goto((tmp_path / "chart.html").as_uri())
    assert "This part needs JavaScript" in page.locator("#scene").inner_text()
    assert page.get_by_text("Show on the body", exact=True).first.is_hidden()
    assert "Waist girth" in page.locator("main").inner_text()
    context.close()
