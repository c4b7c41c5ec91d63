"""An answer that comes late is an answer to what was asked, not to what is shown meanwhile."""

import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import psutil
import pytest
from helpers.viewer_page import Screen, Served, serve
from playwright.sync_api import Route

import bodymeasure as bm
from bodymeasure.samples import sample_path

Open = Callable[..., Screen]
FRAMES = "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"


@pytest.fixture(scope="module")
def taller() -> bm.Atlas:
    body = bm.load_sample("female_average")
    return replace(body, name="Taller body", points=1.02 * body.points)


@pytest.fixture(scope="module")
def pair(taller: bm.Atlas, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    """The page of a file with two bodies."""
    path: Path = tmp_path_factory.mktemp("pair") / "two.npz"
    bm.write_population([bm.load_sample("female_average"), taller], path)
    served = serve(str(path))
    yield served
    served.stop()


def hold_first(screen: Screen, address: str) -> list[Route]:
    """Hold back the first request to an address; the others pass."""
    held: list[Route] = []

    def hold(route: Route) -> None:
        if held:
            route.continue_()
        else:
            held.append(route)

    screen.page.route(address, hold)
    return held


def release(screen: Screen, held: list[Route], address: str) -> None:
    """Let a request pass that was held back, and the page do what it does with the answer."""
    with screen.page.expect_response(address) as answered:
        held[0].continue_()
    answered.value.finished()
    screen.page.evaluate(FRAMES)


def held_back(screen: Screen, held: list[Route]) -> None:
    while not held:
        screen.page.wait_for_timeout(20)


def go_to_second(screen: Screen) -> None:
    screen.get("more").click()
    screen.get("menu-body-1").click()
    screen.until("state => state.id === '1'")


def between_landmarks(screen: Screen) -> None:
    screen.get("more").click()
    screen.get("menu-between").click()
    screen.get("between-measure").click()
    screen.until("state => state.tapes.length === 1")


def move_a_landmark(screen: Screen) -> None:
    screen.get("tab-landmarks").click()
    screen.get("landmarks").get_by_text("crotch point").click()
    screen.get("handle-landmark").focus()
    screen.page.keyboard.press("ArrowUp")
    screen.until("state => state.landmarks.some((one) => one.edited)")


def test_the_chart_of_a_body_that_was_left_is_dropped(pair: Served, open_page: Open) -> None:
    screen = open_page(pair.link)
    held = hold_first(screen, "**/api/chart*")
    screen.get("set").select_option("core")
    screen.get("take-chart").click()
    held_back(screen, held)
    go_to_second(screen)
    release(screen, held, "**/api/chart*")
    assert screen.state()["chart"] == 0
    assert screen.get("take-chart").is_enabled()


def test_the_body_that_was_chosen_last_is_shown(pair: Served, open_page: Open) -> None:
    screen = open_page(pair.link)
    held = hold_first(screen, "**/api/body?body=1")
    screen.get("more").click()
    screen.get("menu-body-1").click()
    held_back(screen, held)
    screen.drop("bowl.atlas", sample_path("paraboloid").read_bytes())
    screen.until("state => state.patches === 1")
    release(screen, held, "**/api/body?body=1")
    assert screen.state()["patches"] == 1


def test_nothing_is_said_to_be_under_way_after_a_chart_of_a_body_that_was_left_is_stopped(
    pair: Served, open_page: Open
) -> None:
    screen = open_page(pair.link)
    screen.expected = ("409",)
    screen.get("take-chart").click()
    progress = screen.get("progress")
    progress.locator("progress").wait_for()
    go_to_second(screen)
    # The program is still at it.
    assert screen.get("stop").is_visible()
    with screen.page.expect_response("**/api/chart?body=0"):
        screen.get("stop").click()
    progress.wait_for(state="hidden")
    assert screen.get("take-chart").is_enabled()


def test_a_file_of_the_chart_that_takes_long_is_said_and_stopped(screen: Screen) -> None:
    screen.take_chart()
    held = hold_first(screen, "**/api/export*")
    screen.get("more").click()
    screen.get("menu-json").click()
    held_back(screen, held)
    assert "Writing the file" in screen.get("progress").inner_text()
    assert screen.get("stop").is_visible()
    assert json.loads(held[0].request.post_data or "")["tab"]
    with screen.page.expect_download():
        held[0].continue_()
    screen.get("progress").wait_for(state="hidden")


def test_a_chart_is_of_the_landmarks_that_were_asked_with(screen: Screen) -> None:
    held = hold_first(screen, "**/api/chart*")
    screen.get("set").select_option("core")
    screen.get("take-chart").click()
    held_back(screen, held)
    move_a_landmark(screen)
    release(screen, held, "**/api/chart*")
    screen.until("state => state.chart > 0")
    screen.get("tab-list").click()
    # The page knows that the chart is of older landmarks, and saves the one that it shows.
    screen.get("chart-again").wait_for()
    screen.get("more").click()
    with screen.page.expect_request("**/api/export*") as asked:
        screen.get("menu-json").click()
    content = asked.value.post_data_json
    assert content is not None
    assert content["landmarks"] is None


def test_a_length_is_of_the_body_that_it_was_asked_of(
    pair: Served, taller: bm.Atlas, open_page: Open
) -> None:
    screen = open_page(pair.link)
    held = hold_first(screen, "**/api/path*")
    between_landmarks(screen)
    held_back(screen, held)
    go_to_second(screen)
    release(screen, held, "**/api/path*")
    # The same tape over the other body.
    between_landmarks(screen)
    (tape,) = screen.settle()["tapes"]
    expected = bm.geodesic_between(taller, *tape["locations"])
    assert tape["result"]["length"] == pytest.approx(expected.length, rel=1e-12)


@pytest.fixture
def own() -> Iterator[Served]:
    """A server whose processes a test may kill."""
    served = serve("female_average")
    yield served
    served.stop()


def test_what_failed_is_asked_again_after_a_new_start(own: Served, open_page: Open) -> None:
    screen = open_page(own.link)
    screen.expected = ("500", "ERR_")
    asked: list[Route] = []

    def fail_once(route: Route) -> None:
        asked.append(route)
        if len(asked) == 1:
            route.fulfill(status=500, json={"error": "The process ended."})
        else:
            route.continue_()

    screen.page.route("**/api/path*", fail_once)
    # Without the pointer, whose preview might be what fails.
    between_landmarks(screen)
    screen.settle()
    assert screen.get("words").inner_text() == "The process ended."
    for child in psutil.Process(own.process.pid).children(recursive=True):
        if "spawn_main" in " ".join(child.cmdline()):
            child.kill()
    screen.until("state => state.tapes[0].result && state.tapes[0].result.length > 0.1")


def test_the_color_that_was_chosen_last_is_shown(screen: Screen) -> None:
    screen.get("tab-display").click()
    held = hold_first(screen, "**/api/quantity*")
    screen.get("color").select_option("gaussian")
    held_back(screen, held)
    screen.get("color").select_option("mean")
    legend = screen.get("legend")
    legend.get_by_text("Mean curvature").wait_for()
    release(screen, held, "**/api/quantity*")
    assert "Gaussian" not in legend.inner_text()
    assert screen.get("color").input_value() == "mean"
    assert screen.get("progress").is_hidden()


def test_a_body_that_comes_after_the_end_of_comparing_does_not_appear(
    pair: Served, open_page: Open
) -> None:
    screen = open_page(pair.link)
    screen.get("tab-display").click()
    held = hold_first(screen, "**/api/body*")
    screen.get("compare-open").select_option("1")
    held_back(screen, held)
    # Meanwhile that body itself is opened, and compared with the first.
    go_to_second(screen)
    release(screen, held, "**/api/body*")
    assert not screen.state()["side"]
    screen.get("compare-open").select_option("0")
    screen.until("state => state.side")


def test_lines_of_a_body_that_was_left_are_asked_for_anew(pair: Served, open_page: Open) -> None:
    screen = open_page(pair.link)
    screen.get("tab-display").click()
    held = hold_first(screen, "**/api/layer*")
    screen.get("layer-boundary").click()
    held_back(screen, held)
    with screen.page.expect_response("**/api/layer?body=1*"):
        go_to_second(screen)
    geometries = screen.until("state => state.geometries > 3 && state.geometries")
    release(screen, held, "**/api/layer?body=0*")
    assert screen.state()["geometries"] == geometries
    assert screen.get("layer-boundary").is_checked()
