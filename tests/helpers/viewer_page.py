"""The viewer's page in a browser, as tests use it: clicks at known points, and what it holds."""

import os
import re
import subprocess
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from playwright.sync_api import Locator, Page

REQUIRED = os.environ.get("BODYMEASURE_BROWSER") == "required"
# The machines that run tests stall; what takes longer than this will not come.
PATIENCE = 180.0
Location = Sequence[float]


@dataclass
class Served:
    """A server in a process of its own, started as a user starts it.

    Parameters
    ----------
    process : subprocess.Popen
    link : str
    """

    process: "subprocess.Popen[str]"
    link: str

    @property
    def address(self) -> str:
        return self.link.partition("#")[0]

    @property
    def token(self) -> str:
        return self.link.partition("#token=")[2]

    def stop(self) -> None:
        self.process.terminate()
        try:
            self.process.wait(PATIENCE)
        finally:
            self.process.kill()
            if self.process.stdout is not None:
                self.process.stdout.close()


def serve(*arguments: str, token: str | None = None) -> Served:
    """Start the viewer on a body and wait for its link; with a token, it is the one of the link."""
    environment = {**os.environ, **({"BODYMEASURE_VIEW_TOKEN": token} if token else {})}
    process = subprocess.Popen(
        [sys.executable, "-m", "bodymeasure", "view", *arguments, "--no-browser"],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env=environment,
    )
    assert process.stdout is not None
    for line in process.stdout:
        match = re.search(r"http://\S+", line)
        if match:
            return Served(process, match[0])
    raise AssertionError(f"the viewer ended with {process.wait()} and printed no link")


# As a file manager drops it: playwright has no way to do this.
DROP = """([name, bytes]) => {
  const transfer = new DataTransfer();
  transfer.items.add(new File([new Uint8Array(bytes)], name));
  const root = document.querySelector("#bodymeasure");
  for (const type of ["dragover", "drop"]) {
    const event = new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true });
    root.dispatchEvent(event);
  }
}"""


@dataclass
class Screen:
    """A page that shows a body.

    Parameters
    ----------
    page : Page
    errors : list of str
        What the console and the page complained of.
    hosts : set of str
        All hosts that were asked for anything.
    expected : tuple of str
        Parts of complaints that a test provokes.
    """

    page: Page
    errors: list[str] = field(default_factory=list)
    hosts: set[str] = field(default_factory=set)
    expected: tuple[str, ...] = ()

    @classmethod
    def on(cls, page: Page) -> "Screen":
        screen = cls(page)
        page.on("console", lambda message: screen._heard(message.type, message.text))
        page.on("pageerror", lambda error: screen.errors.append(str(error)))
        page.on("request", lambda request: screen._asked(request.url))
        return screen

    def _heard(self, kind: str, text: str) -> None:
        # Drawing in software says so each time that a pixel is read.
        known = ("GPU stall", *self.expected)
        if kind in ("error", "warning") and not any(part in text for part in known):
            self.errors.append(text)

    def _asked(self, address: str) -> None:
        parts = urlsplit(address)
        if parts.scheme not in ("blob", "data"):
            self.hosts.add(parts.hostname or "")

    def open(self, link: str) -> "Screen":
        self.page.goto(link)
        self.page.wait_for_selector("#bodymeasure[data-ready]", timeout=PATIENCE * 1000)
        return self

    def get(self, name: str) -> Locator:
        """The element of a test id."""
        return self.page.get_by_test_id(name)

    def state(self) -> dict[str, Any]:
        state: dict[str, Any] = self.page.evaluate("() => window.bodymeasure.state()")
        return state

    def spot(self, location: Location) -> tuple[float, float] | None:
        """Where a point of the body is on the page; None where it cannot be seen."""
        found = self.page.evaluate("place => window.bodymeasure.project(...place)", list(location))
        return None if found is None else (found[0], found[1])

    def seen(self, *, v: float = 0.5, apart: int = 1) -> list[tuple[int, float, float]]:
        """Middles of patches that can be seen, every `apart`-th one."""
        found = self.page.evaluate(
            """v => {
              const seen = [];
              const page = window.bodymeasure;
              const { patches } = page.state();
              for (let patch = 0; patch < patches; patch++) {
                // At the outline, a pixel more or less misses the body.
                if (page.facing(patch, 0.5, v) < 0.5) continue;
                if (page.project(patch, 0.5, v)) seen.push([patch, 0.5, v]);
              }
              return seen;
            }""",
            v,
        )
        return [(int(patch), u, w) for patch, u, w in found[::apart]]

    def middle_of(self, landmark: str) -> tuple[int, float, float]:
        """The middle of the patch that a landmark lies on."""
        one = next(one for one in self.state()["landmarks"] if one["name"] == landmark)
        return int(one["location"][0]), 0.5, 0.5

    def hover(self, location: Location) -> None:
        place = self.spot(location)
        assert place is not None, f"{location} cannot be seen"
        self.page.mouse.move(*place)

    def click(self, location: Location, *modifiers: str) -> None:
        self.hover(location)
        place = self.spot(location)
        assert place is not None
        for key in modifiers:
            self.page.keyboard.down(key)
        self.page.mouse.click(*place)
        for key in modifiers:
            self.page.keyboard.up(key)

    def until(self, condition: str, argument: Any = None) -> Any:
        """Wait until a function of the state, in JavaScript, gives something; return that."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            found = self.page.evaluate(
                f"argument => (({condition})(window.bodymeasure.state(), argument)) || null",
                argument,
            )
            if found is not None:
                return found
            self.page.wait_for_timeout(30)
        raise AssertionError(f"waited in vain for {condition}")

    def settle(self) -> dict[str, Any]:
        """Wait until all tapes are measured and the view rests; return the state."""
        self.until(
            "state => !state.busy && !state.moving && state.tapes.every((tape) => tape.result)"
        )
        return self.state()

    def measure(self, *locations: Location) -> dict[str, Any]:
        """Click the ends of a tape and wait for its length; return the tape."""
        count = len(self.state()["tapes"])
        for location in locations:
            self.click(location)
        self.until("(state, count) => state.tapes.length > count", count)
        tape: dict[str, Any] = self.settle()["tapes"][-1]
        return tape

    def drop(self, name: str, content: bytes) -> None:
        """Drop a file on the page."""
        self.page.evaluate(DROP, [name, list(content)])

    def take_chart(self, preset: str = "core") -> None:
        """Take the measurements of a preset; all of them would take most of the tests' time."""
        if self.get("set").is_visible():
            self.get("set").select_option(preset)
        self.get("take-chart").click()
        self.until("state => state.chart > 0")

    def message(self) -> str:
        """The last sentence that the page said."""
        last = self.page.locator("[data-testid=messages] .message p").last
        last.wait_for(timeout=PATIENCE * 1000)
        return last.inner_text()


def saved(screen: Screen, action: Any) -> tuple[str, bytes]:
    """Return the name and the content of the file that an action saves."""
    with screen.page.expect_download(timeout=PATIENCE * 1000) as download:
        action()
    return download.value.suggested_filename, Path(download.value.path()).read_bytes()


def findings(screen: Screen, axe: str) -> list[str]:
    """Return the serious and critical findings of axe-core, whose program is given."""
    screen.page.evaluate(axe)
    result: dict[str, Any] = screen.page.evaluate("() => axe.run()")
    return [
        f"{one['impact']} {one['id']}: {[node['html'] for node in one['nodes'][:3]]}"
        for one in result["violations"]
        if one["impact"] in ("serious", "critical")
    ]
