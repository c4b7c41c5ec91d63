"""Signals, pipes, full disks and missing packages, which need a process of its own."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from helpers.command_line import part_of_a_body, run_apart, start

from bodymeasure import write_atlas

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals and groups of POSIX")

# This setup reports the progress of the comparison on stdout.
TELL_PROGRESS = """
from contextlib import contextmanager
import bodymeasure.cli.measuring.report as module
@contextmanager
def bar(label, total):
    yield lambda done: print(label, done, flush=True)
module.progress_bar = bar
"""
# This setup has the process interrupt itself while it writes the second file.
INTERRUPT_WRITING = """
import os, signal
calls = []
real = os.fsync
def fsync(descriptor):
    calls.append(descriptor)
    if len(calls) == 2:
        os.kill(os.getpid(), signal.SIGINT)
    real(descriptor)
os.fsync = fsync
"""
# Seconds; machines that run tests stall.
PATIENCE = 180.0
INTERRUPTED = "Interrupted; no half-written file is left.\n"
TERMINATED = "Terminated; no half-written file is left.\n"


def running(group: int) -> bool:
    """Whether a process of a group runs; ended ones that nobody has waited for do not count."""
    try:
        os.killpg(group, 0)
    except ProcessLookupError:
        return False
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, number = stat.read_text().rpartition(")")[2].split()[:3]
        except OSError:  # has ended meanwhile
            continue
        if int(number) == group and state != "Z":
            return True
    return not Path("/proc/self/stat").exists()


@pytest.mark.parametrize(
    ("sent", "to_all", "code", "words"),
    [
        # A terminal sends the signal to all processes of the group.
        (signal.SIGINT, True, 130, INTERRUPTED),
        pytest.param(signal.SIGTERM, True, 143, TERMINATED, marks=pytest.mark.slow),
        pytest.param(signal.SIGTERM, False, 143, TERMINATED, marks=pytest.mark.slow),
    ],
)
def test_an_interrupt_of_the_comparison_leaves_nothing(
    tmp_path: Path, sent: signal.Signals, to_all: bool, code: int, words: str
) -> None:
    write_atlas(part_of_a_body(100, 140), tmp_path / "part.atlas")
    process = start(
        "report",
        tmp_path / "part.atlas",
        "-o",
        tmp_path / "new" / "folder",
        "--processes",
        2,
        setup=TELL_PROGRESS,
    )
    assert process.stdout is not None
    assert process.stdout.readline().startswith("comparing with meshes")
    (os.killpg if to_all else os.kill)(process.pid, sent)
    out, err = process.communicate(timeout=PATIENCE)
    assert process.returncode == code
    assert err.strip() == words.strip()
    assert "drawing" not in out
    assert os.listdir(tmp_path) == ["part.atlas"]  # noqa: PTH208
    patience = 1200
    while running(process.pid) and patience:
        patience -= 1
        time.sleep(0.1)
    assert patience


def test_an_interrupt_of_the_writing_leaves_nothing(tmp_path: Path) -> None:
    ran = run_apart(
        "report",
        "enneper",
        "-o",
        tmp_path / "new",
        "--no-cross-check",
        "--no-pictures",
        setup=INTERRUPT_WRITING,
    )
    assert (ran.code, ran.out, ran.err.strip()) == (130, "", INTERRUPTED.strip())
    assert list(tmp_path.iterdir()) == []


# An importer that is interrupted, as if Ctrl-C came while the command line is imported.
INTERRUPT_IMPORT = """
import sys
class Interrupted:
    def find_spec(name, path=None, target=None):
        if name == "bodymeasure.cli.main":
            raise KeyboardInterrupt
sys.meta_path.insert(0, Interrupted)
sys.argv = ["bodymeasure", "info", "enneper"]
from bodymeasure.__main__ import main
main()
"""


def test_an_interrupt_of_the_imports_shows_no_traceback() -> None:
    ran = subprocess.run(
        [sys.executable, "-c", INTERRUPT_IMPORT], capture_output=True, text=True, check=False
    )
    assert (ran.returncode, ran.stdout, ran.stderr) == (130, "", INTERRUPTED.lstrip())


def test_a_disk_with_little_room_leaves_nothing(tmp_path: Path) -> None:
    # No file may grow beyond 4 KiB, which is an error in Python and as good as a full disk.
    limit = "import resource\nresource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))\n"
    ran = run_apart(
        "report",
        "enneper",
        "-o",
        tmp_path / "new",
        "--no-cross-check",
        "--no-pictures",
        setup=limit,
    )
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith(f"Error: {tmp_path / 'new' / 'report.html'}: cannot be written (")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "arguments", [pytest.param(("--help",), marks=pytest.mark.slow), ("check", "enneper")]
)
def test_a_closed_pipe_is_no_error_to_speak_of(arguments: tuple[str, ...]) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    try:
        ran = run_apart(*arguments, stdout=writer)
    finally:
        os.close(writer)
    assert (ran.code, ran.err) == (141, "")


@pytest.mark.parametrize("command", ["check", pytest.param("diagonals", marks=pytest.mark.slow)])
def test_a_full_disk_behind_the_output_is_told(command: str) -> None:
    full = Path("/dev/full")
    if not full.exists():
        pytest.skip("this system has no /dev/full")
    with full.open("wb") as file:
        ran = run_apart(command, "enneper", stdout=file)
    assert ran.code == 2
    assert ran.err == "Error: the output cannot be written (No space left on device)\n"


def test_a_terminal_without_the_characters_gets_their_numbers(tmp_path: Path) -> None:
    from dataclasses import replace

    path = tmp_path / "body.atlas"
    write_atlas(replace(part_of_a_body(100, 101), name="Körper \u80f8"), path)
    setup = "import sys\nfor s in (sys.stdout, sys.stderr): s.reconfigure(encoding='ascii')"
    ran = run_apart("check", path, setup=setup)
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.startswith(r"K\xf6rper \u80f8: 1 patch")


def test_python_runs_the_package_too() -> None:
    result = subprocess.run(
        [sys.executable, "-m", "bodymeasure", "--version"],
        capture_output=True,
        text=True,
        check=True,
    )
    assert result.stdout.startswith("bodymeasure ")
    assert result.stderr == ""
