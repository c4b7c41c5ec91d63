"""A real server, a real browser, and a page that must stay free of errors and at home."""

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from helpers.viewer_page import REQUIRED, Screen, Served, serve
from playwright.sync_api import Browser, Playwright, sync_playwright

ARGUMENTS = (
    "--no-sandbox",
    "--enable-unsafe-swiftshader",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)
WEB = Path(__file__).parents[3] / "viewer" / "web"
AXE = WEB / "node_modules" / "axe-core" / "axe.min.js"
SIZE = (1400, 900)
HOME = {"127.0.0.1"}

Launch = Callable[..., Browser]
Open = Callable[..., Screen]


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Keep these tests in one process, since browsers are large; and out of the usual run."""
    for item in items:
        if "viewer/browser" in item.path.as_posix():
            item.add_marker("browser")
            item.add_marker(pytest.mark.xdist_group("browser"))


@pytest.fixture(scope="session")
def axe() -> str:
    """The program of axe-core, which looks for what keeps people out."""
    if not AXE.is_file():
        reason = f"there is no axe-core here; `npm ci` in {WEB} fetches it"
        # It comes with what the page is built with, which a machine without Node has not.
        must = REQUIRED and shutil.which("node") is not None
        (pytest.fail if must else pytest.skip)(reason)
    return AXE.read_text(encoding="utf-8")


@pytest.fixture(scope="session")
def chromium() -> str:
    found = shutil.which("chromium") or shutil.which("google-chrome")
    if found is None:
        reason = "there is no Chromium here; apt-get install chromium"
        (pytest.fail if REQUIRED else pytest.skip)(reason)
    return found


@pytest.fixture(scope="session")
def _driver(chromium: str) -> Iterator[Playwright]:
    assert chromium
    with sync_playwright() as driver:
        yield driver


@pytest.fixture(scope="session")
def launch(_driver: Playwright, chromium: str) -> Iterator[Launch]:
    """Start a browser with more arguments."""
    started: list[Browser] = []

    def start(*more: str) -> Browser:
        browser = _driver.chromium.launch(
            executable_path=chromium, headless=True, args=[*ARGUMENTS, *more]
        )
        started.append(browser)
        return browser

    yield start
    for browser in started:
        browser.close()


@pytest.fixture(scope="session")
def browser(launch: Launch) -> Browser:
    return launch()


@pytest.fixture(scope="session")
def server() -> Iterator[Served]:
    served = serve("female_average")
    yield served
    served.stop()


@pytest.fixture
def open_page(browser: Browser, server: Served) -> Iterator[Open]:
    """Open pages in contexts of their own; at the end, none may have complained or gone abroad."""
    screens: list[Screen] = []

    def start(
        link: str | None = None,
        *,
        size: tuple[int, int] = SIZE,
        scheme: str = "light",
        touch: bool = False,
        within: Browser | None = None,
    ) -> Screen:
        context = (within or browser).new_context(
            viewport={"width": size[0], "height": size[1]},
            color_scheme="dark" if scheme == "dark" else "light",
            # Flights would only make tests wait.
            reduced_motion="reduce",
            accept_downloads=True,
            has_touch=touch,
            permissions=["clipboard-read", "clipboard-write"],
        )
        screen = Screen.on(context.new_page())
        screens.append(screen)
        return screen.open(link or server.link)

    yield start
    for screen in screens:
        screen.page.context.close()
        assert not screen.errors, screen.errors
        assert screen.hosts <= HOME, screen.hosts


@pytest.fixture
def screen(open_page: Open) -> Screen:
    return open_page()
