"""The token leaves the address, the policy holds, and pages of others get nothing."""

import http.server
import threading
from collections.abc import Iterator
from typing import Any

import pytest
from helpers.viewer_page import Screen, Served
from playwright.sync_api import Browser


def test_the_token_leaves_the_address(screen: Screen, server: Served) -> None:
    assert "token" not in screen.page.url
    assert server.token not in screen.page.url
    assert server.token not in screen.page.content()
    # It lasts as long as the tab.
    screen.page.reload()
    screen.page.wait_for_selector("#bodymeasure[data-ready]")
    assert screen.measure((15, 0.5, 0.5), (173, 0.5, 0.5))["result"]["length"] > 0.1


def test_no_script_but_the_pages_own_runs(screen: Screen) -> None:
    screen.expected = ("Content Security Policy",)
    ran = screen.page.evaluate(
        """async () => {
          const script = document.createElement("script");
          script.textContent = "window.strange = true";
          document.head.append(script);
          await new Promise((resolve) => setTimeout(resolve, 200));
          return window.strange === true;
        }"""
    )
    assert ran is False


@pytest.fixture
def stranger() -> Iterator[str]:
    """A page of another origin on this machine."""

    class Blank(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            self.send_header("Content-Type", "text/html")
            self.end_headers()
            self.wfile.write(b"<!doctype html><title>stranger</title>")

        def log_message(self, *_: object) -> None:
            """Say nothing: the tests' output is for failures."""

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Blank)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield f"http://127.0.0.1:{server.server_port}/"
    server.shutdown()
    server.server_close()


def test_a_page_of_another_origin_is_refused(
    browser: Browser, server: Served, stranger: str
) -> None:
    page = browser.new_context().new_page()
    # Browsers keep answers from a page of another site anyway; what counts is that there were none.
    answers: list[int] = []
    said: list[str] = []
    network = page.context.new_cdp_session(page)
    network.send("Network.enable")

    def heard(answer: dict[str, Any]) -> None:
        # The stranger's own server says what it is.
        if "BaseHTTP" not in answer["headers"].get("Server", ""):
            answers.append(answer["statusCode"])

    network.on("Network.responseReceivedExtraInfo", heard)
    page.on("console", lambda message: said.append(message.text))
    page.goto(stranger)
    outcome = page.evaluate(
        """async ([address, token]) => {
          const tried = {};
          for (const [name, options] of Object.entries({
            plain: {}, token: { headers: { "X-Token": token } }, blind: { mode: "no-cors" },
          })) {
            try {
              const answer = await fetch(address + "api/body", options);
              tried[name] = answer.type === "opaque" ? "opaque" : answer.status;
            } catch { tried[name] = "refused"; }
          }
          tried.socket = await new Promise((resolve) => {
            const socket = new WebSocket(address.replace("http", "ws") + "api/events");
            socket.onopen = () => resolve("open");
            socket.onerror = () => resolve("refused");
          });
          const frame = document.createElement("iframe");
          frame.src = address;
          document.body.append(frame);
          await new Promise((resolve) => (frame.onload = resolve));
          try { tried.frame = frame.contentDocument ? "read" : "closed"; }
          catch { tried.frame = "closed"; }
          return tried;
        }""",
        [server.address, server.token],
    )
    assert outcome["plain"] == outcome["token"] == outcome["socket"] == "refused"
    assert outcome["blind"] in ("opaque", "refused")
    assert outcome["frame"] == "closed"
    # Three fetches, of which the one with a token asks whether it may, and the frame.
    assert len(answers) >= 4
    assert set(answers) == {403}
    assert any("WebSocket" in text and "403" in text for text in said)
    page.context.close()
