"""A viewer's server in a process of its own, as tests of its requests use it."""

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import httpx
import psutil
from helpers.command_line import start

# Machines that run tests stall; what takes longer than this will not come.
PATIENCE = 180.0


class Viewer:
    """A server that listens, and a client that has its token."""

    def __init__(self, process: "subprocess.Popen[str]") -> None:
        assert process.stdout is not None
        self.process = process
        self.link = process.stdout.readline().strip()
        self.address, _, self.token = self.link.partition("/#token=")
        assert self.token, "the server has not started"
        self.client = httpx.Client(
            base_url=self.address, headers={"X-Token": self.token}, timeout=PATIENCE
        )

    @property
    def port(self) -> int:
        return int(self.address.rpartition(":")[2])

    def get(self, path: str, **options: Any) -> httpx.Response:
        return self.client.get(path, **options)

    def post(self, path: str, **options: Any) -> httpx.Response:
        return self.client.post(path, **options)

    def workers(self) -> list[psutil.Process]:
        """Return the processes that measure, and the tracker that Python starts with them."""
        found: list[psutil.Process] = psutil.Process(self.process.pid).children(recursive=True)
        return found

    def end(self, sent: int = signal.SIGINT, *, to_all: bool = False) -> tuple[int, str]:
        """End the server by a signal; return its code and what it has said on stderr.

        The Ctrl-C of a terminal goes to all processes of the group.
        """
        if to_all:
            os.killpg(self.process.pid, sent)
        else:
            self.process.send_signal(sent)
        _, said = self.process.communicate(timeout=PATIENCE)
        return self.process.returncode, said


@contextmanager
def viewer(*arguments: object, browser: str = "", **options: Any) -> Iterator[Viewer]:
    """Start the viewer, in a browser if one is given, and end it whatever happens."""
    if browser:
        options["env"] = {**os.environ, "BROWSER": browser}
    else:
        arguments = ("--no-browser", *arguments)
    with start("view", *arguments, **options) as process:
        try:
            found = Viewer(process)
            with found.client:
                yield found
        finally:
            if process.poll() is None:
                process.kill()
                process.communicate(timeout=PATIENCE)


def gone(processes: list[psutil.Process], patience: float = PATIENCE) -> bool:
    """Return whether processes end by themselves."""
    _, alive = psutil.wait_procs(processes, timeout=patience)
    return not bool(alive)


POSIX = sys.platform != "win32" and hasattr(os, "killpg")
