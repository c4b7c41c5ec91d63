"""A file that changes is read again under the user's hands, and nothing that was made is lost."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from helpers.viewer_page import Screen, Served, serve
from playwright.sync_api import Route

import bodymeasure as bm

START, END = (15, 0.5, 0.5), (173, 0.5, 0.5)
READ = "The file changed and was read again."
Open = Callable[..., Screen]


@pytest.fixture
def own(tmp_path: Path) -> Iterator[tuple[Path, Served]]:
    """A body in a file that a test may change."""
    path = tmp_path / "own.atlas"
    bm.write_atlas(bm.load_sample("female_average"), path)
    served = serve(str(path))
    yield path, served
    served.stop()


def change(path: Path) -> None:
    atlas = bm.read_atlas(path)
    landmarks = {**atlas.landmarks, "mole": bm.AtlasPoint(30, 0.5, 0.5)}
    bm.write_atlas(replace(atlas, landmarks=landmarks), path)


def test_what_is_made_meanwhile_stays_and_can_be_undone(
    own: tuple[Path, Served], open_page: Open
) -> None:
    path, served = own
    screen = open_page(served.link)
    first = screen.measure(START, END)
    held: list[Route] = []
    screen.page.route("**/api/body*", lambda route: held.append(route))
    change(path)
    while not held:
        screen.page.wait_for_timeout(20)
    # The new body is under way; another tape is made before it arrives.
    second = screen.measure(START, screen.middle_of("front waist point"))
    held[0].continue_()
    screen.page.get_by_text(READ).wait_for()
    state = screen.settle()
    assert any(one["name"] == "mole" for one in state["landmarks"])
    assert [one["id"] for one in state["tapes"]] == [first["id"], second["id"]]
    screen.page.keyboard.press("Control+z")
    assert [one["id"] for one in screen.state()["tapes"]] == [first["id"]]
    screen.page.keyboard.press("Control+Shift+z")
    assert len(screen.state()["tapes"]) == 2


def test_the_body_that_is_compared_with_is_read_again(
    own: tuple[Path, Served], open_page: Open
) -> None:
    path, served = own
    screen = open_page(served.link)
    screen.drop("other.atlas", path.read_bytes())
    screen.until("state => state.id.startsWith('1-')")
    screen.get("tab-display").click()
    screen.get("compare-open").select_option("0")
    marks = screen.until("state => state.second && state.second.landmarks")
    change(path)
    screen.until("(state, marks) => state.second && state.second.landmarks > marks", marks)
    assert screen.state()["id"].startswith("1-")


def test_another_body_is_not_read_again(own: tuple[Path, Served], open_page: Open) -> None:
    path, served = own
    screen = open_page(served.link)
    screen.drop("other.atlas", path.read_bytes())
    screen.until("state => state.id.startsWith('1-')")
    asked: list[str] = []
    screen.page.on("request", lambda request: asked.append(request.url))
    with screen.page.expect_event("console", lambda message: message.text == "changed"):
        screen.page.evaluate(
            """async (token) => {
              const answer = await fetch("api/events", { headers: { "X-Token": token } });
              const reader = answer.body.pipeThrough(new TextDecoderStream()).getReader();
              (async () => {
                for (;;) {
                  const { value, done } = await reader.read();
                  if (done) return;
                  if (value.includes("changed")) console.log("changed");
                }
              })();
            }""",
            served.token,
        )
        change(path)
    # What the page is told next, it is told after that.
    path.write_bytes(b"half")
    screen.page.get_by_text("own.atlas").first.wait_for()
    assert not [address for address in asked if "/api/body" in address]
