"""The viewer's processes: they end together, in order, and leave nothing behind."""

import os
import signal
import socket
import threading
from pathlib import Path

import httpx
import psutil
import pytest
from helpers.command_line import run_apart, run_here
from helpers.viewer_server import PATIENCE, POSIX, Viewer, gone, viewer

pytestmark = pytest.mark.skipif(not POSIX, reason="signals of POSIX")
NOTE = "The page is open until you press Ctrl-C here.\n"


class Listening:
    """A page that listens to the server's events, in a thread of its own."""

    def __init__(self, server: Viewer) -> None:
        self.begun = threading.Event()
        self.lines: list[str] = []
        self.failed = False
        self._thread = threading.Thread(target=self._listen, args=(server,), daemon=True)
        self._thread.start()
        assert self.begun.wait(PATIENCE)

    def _listen(self, server: Viewer) -> None:
        headers = {"X-Token": server.token}
        try:
            with httpx.stream(
                "GET", f"{server.address}/api/events", headers=headers, timeout=PATIENCE
            ) as stream:
                for line in stream.iter_lines():
                    self.lines.append(line)
                    self.begun.set()
        except httpx.HTTPError:
            self.failed = True

    def ended(self) -> bool:
        self._thread.join(PATIENCE)
        return not self._thread.is_alive()


@pytest.mark.parametrize(
    ("sent", "code", "words"),
    [
        pytest.param(signal.SIGINT, 130, "Interrupted", id="Ctrl-C"),
        pytest.param(signal.SIGTERM, 143, "Terminated", id="SIGTERM", marks=pytest.mark.slow),
    ],
)
def test_an_end_is_clean_although_a_page_listens(sent: int, code: int, words: str) -> None:
    with viewer("paraboloid") as server:
        assert server.get("/api/body").status_code == 200
        page = Listening(server)
        workers = server.workers()
        assert workers
        ended, said = server.end(sent, to_all=sent == signal.SIGINT)
        assert ended == code
        assert said.split("\n\n" if "\n\n" in said else "\n", 1) == [
            NOTE.strip(),
            f"{words}; no half-written file is left.\n",
        ]
        assert gone(workers)
        # The stream has ended in order, not by a broken connection.
        assert page.ended()
        assert not page.failed


@pytest.mark.slow
def test_an_end_is_clean_although_something_is_measured() -> None:
    with viewer("female_average") as server:
        page = Listening(server)
        answers: list[httpx.Response] = []
        thread = threading.Thread(
            target=lambda: answers.append(server.post("/api/chart", json={"set": "default"}))
        )
        thread.start()
        while not any("progress" in line for line in page.lines):
            page.begun.clear()
            assert page.begun.wait(PATIENCE)
        workers = server.workers()
        # An impatient user presses Ctrl-C several times.
        for _ in range(2):
            os.killpg(server.process.pid, signal.SIGINT)
        code, said = server.end(to_all=True)
        assert code == 130
        assert said.split() == f"{NOTE} Interrupted; no half-written file is left.".split()
        assert gone(workers)
        thread.join(PATIENCE)
        assert answers[0].status_code == 500
        assert answers[0].json() == {"error": "the viewer has ended"}


def _compare_in_vain(server: Viewer) -> None:
    with pytest.raises(httpx.HTTPError):
        server.get("/api/layer?name=diagonals&compare=true")


@pytest.mark.slow
def test_no_process_outlives_a_viewer_that_was_killed() -> None:
    with viewer("female_average") as server:
        page = Listening(server)
        threading.Thread(target=_compare_in_vain, args=(server,), daemon=True).start()
        while not any("progress" in line for line in page.lines):
            page.begun.clear()
            assert page.begun.wait(PATIENCE)
        workers = server.workers()
        assert len(workers) >= 2
        server.process.send_signal(signal.SIGKILL)
        server.process.wait(PATIENCE)
        # The comparison would take minutes more; nobody waits for it.
        assert gone(workers, patience=60.0)


@pytest.mark.slow
def test_a_worker_that_dies_is_replaced_and_the_page_is_told() -> None:
    with viewer("female_average") as server:
        page = Listening(server)
        asked = {"locations": ["back neck point", "bust point left"]}
        before = server.post("/api/path", json=asked).json()
        for process in server.workers():
            if "resource_tracker" not in " ".join(process.cmdline()):
                process.kill()
        while '{"worker":"restarted"}' not in page.lines:
            page.begun.clear()
            assert page.begun.wait(PATIENCE)
        assert server.post("/api/path", json=asked).json() == before
        assert server.get("/api/body").status_code == 200


def test_a_port_that_is_taken_is_told() -> None:
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        ran = run_apart("view", "paraboloid", "--no-browser", "--port", port)
        assert (ran.code, ran.out) == (2, "")
        assert f"cannot listen at 127.0.0.1, port {port}" in ran.err
        assert "choose another --port" in ran.err
        assert "Traceback" not in ran.err


def test_an_address_that_is_not_ours_is_told() -> None:
    ran = run_apart("view", "paraboloid", "--no-browser", "--host", "192.0.2.1")
    assert (ran.code, ran.out) == (2, "")
    assert "192.0.2.1" in ran.err
    assert "Traceback" not in ran.err


@pytest.mark.slow
def test_a_port_that_was_given_is_taken_again_at_once() -> None:
    with viewer("paraboloid") as server:
        port = server.port
        Listening(server)
        server.end()
    with viewer("paraboloid", "--port", port) as server:
        assert server.port == port
        assert server.get("/api/body").status_code == 200


@pytest.mark.slow
def test_a_token_may_be_given_but_none_that_can_be_guessed(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    token = "a_token-of_20_letters_and_more"
    with viewer("paraboloid", env={**os.environ, "BODYMEASURE_VIEW_TOKEN": token}) as server:
        assert server.token == token
        assert server.get("/api/body").status_code == 200
    for bad in ("", "short", "x" * 19, "a token of 20 letters and more", "x" * 30 + "#"):
        monkeypatch.setenv("BODYMEASURE_VIEW_TOKEN", bad)
        ran = run_here(capsys, "view", "paraboloid", "--no-browser")
        assert (ran.code, ran.out) == (2, "")
        assert "expected 20 to 200 letters, digits" in ran.err


@pytest.mark.slow
def test_another_address_says_what_it_means() -> None:
    with viewer("paraboloid", "--host", "0.0.0.0") as server:
        server.address = f"http://127.0.0.1:{server.port}"
        found = httpx.get(
            f"{server.address}/api/body", headers={"X-Token": server.token}, timeout=PATIENCE
        )
        assert found.status_code == 200
        assert httpx.get(f"{server.address}/api/body").status_code == 403
        _, said = server.end()
    assert "Other machines that reach 0.0.0.0 can open the page if they know this link" in said
    assert "not encrypted" in said


@pytest.mark.slow
def test_the_link_goes_to_the_browser_through_a_file_of_the_user(tmp_path: Path) -> None:
    # What a browser's command line says can be read by all users of the machine.
    opened = tmp_path / "opened"
    script = tmp_path / "browser"
    script.write_text(
        f'#!/bin/sh\nstat -c %a "$(dirname "${{1#file://}}")" > {opened}\n'
        f'cat "${{1#file://}}" >> {opened}\necho >> {opened}\necho "$1" >> {opened}\n'
    )
    script.chmod(0o700)
    with viewer("paraboloid", browser=str(script)) as server:
        while not opened.exists() or "file://" not in opened.read_text():
            psutil.Process(server.process.pid).cpu_percent(0.05)
        mode, *page, address = opened.read_text().splitlines()
        assert mode == "700"
        assert server.link in "".join(page)
        assert server.token not in address
        server.end()
        assert not Path(address.removeprefix("file://")).exists()
