"""Helpers that run the command line, in this process or in one of its own."""

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest

from bodymeasure import Atlas, load_sample


@dataclass(frozen=True)
class Ran:
    """How a command ended and what it printed."""

    code: int
    out: str
    err: str


Run = Callable[..., Ran]
Bar = tuple[str, int, list[int]]
Edited = Callable[[Callable[[dict[str, Any]], object]], Any]

# Interrupts are heard as from a terminal: where tests run in the background, children would
# inherit that interrupts are ignored.
HEAR_INTERRUPTS = "import signal\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n"
CALL_MAIN = "\nimport sys\nfrom bodymeasure.cli import main\nmain(sys.argv[1:])\n"

# This hides packages from every finder, as if they were not installed.
HIDE = """
import sys
class Hiding:
    def __init__(self, finder):
        self.finder = finder
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {hidden}:
            return None
        return self.finder.find_spec(name, path, target)
    def __getattr__(self, name):
        return getattr(self.finder, name)
sys.meta_path[:] = [Hiding(finder) for finder in sys.meta_path]
"""


def hide(*packages: str) -> str:
    """A setup for `start` that hides packages."""
    return HIDE.replace("{hidden}", repr(set(packages)))


def hide_here(monkeypatch: pytest.MonkeyPatch, package: str) -> None:
    """Hide a package in this process."""
    monkeypatch.setattr(sys, "meta_path", list(sys.meta_path))
    monkeypatch.delitem(sys.modules, package, raising=False)
    exec(hide(package), {})


def recorded_bars(monkeypatch: pytest.MonkeyPatch, *modules: str) -> list[Bar]:
    """The progress bars of modules of the command line: labels, totals, and counts reported."""
    bars: list[Bar] = []

    @contextmanager
    def bar(label: str, total: int) -> Iterator[Callable[[int], None]]:
        bars.append((label, total, []))
        yield bars[-1][2].append

    for module in modules:
        monkeypatch.setattr(f"bodymeasure.cli.{module}.progress_bar", bar)
    return bars


def run_here(capsys: pytest.CaptureFixture[str], *arguments: object) -> Ran:
    """Run the command line in this process."""
    from bodymeasure.cli import main

    with pytest.raises(SystemExit) as ended:
        main([str(argument) for argument in arguments])
    printed = capsys.readouterr()
    assert isinstance(ended.value.code, int)
    return Ran(ended.value.code, printed.out, printed.err)


def start(*arguments: object, setup: str = "", **options: Any) -> subprocess.Popen[str]:
    """Start the command line in a process and a process group of its own, after some setup."""
    environment = {**os.environ, "OMP_NUM_THREADS": "1"}
    for name in ("NO_COLOR", "FORCE_COLOR", "COLUMNS"):
        environment.pop(name, None)
    return subprocess.Popen(
        [sys.executable, "-c", HEAR_INTERRUPTS + setup + CALL_MAIN, *map(str, arguments)],
        **{
            "stdin": subprocess.DEVNULL,
            "stdout": subprocess.PIPE,
            "stderr": subprocess.PIPE,
            "text": True,
            "encoding": "utf-8",
            "env": environment,
            "start_new_session": True,
            **options,
        },
    )


def run_apart(*arguments: object, setup: str = "", **options: Any) -> Ran:
    """Run the command line in a process of its own."""
    with start(*arguments, setup=setup, **options) as process:
        out, err = process.communicate(timeout=180)
    return Ran(process.returncode, out or "", err or "")


def part_of_a_body(first: int, last: int) -> Atlas:
    """Some patches of a sample, as an atlas of their own."""
    body = load_sample("female_average")
    used, index = np.unique(body.index[first:last], return_inverse=True)
    return replace(
        body,
        points=body.points[used],
        index=index.reshape(-1, 4, 4),
        patch_names=body.patch_names[first:last],
        regions=body.regions[first:last],
        landmarks={},
        name="Part of a body",
    )


def folded_part_of_a_body() -> Atlas:
    """A part of a body with a patch that is folded over itself, which its check finds."""
    part = part_of_a_body(100, 106)
    points = part.points.copy()
    points[part.index[2, 1, 1]] = points[part.index[2, 3, 3]] * 1.5
    return replace(part, points=points)
