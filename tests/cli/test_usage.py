import importlib.metadata
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from helpers.command_line import Run, run_apart, start
from helpers.speed import quick

from bodymeasure import read_atlas, sample_names
from bodymeasure.cli.commands import COMMANDS


def test_the_version_is_that_of_the_package(run: Run) -> None:
    ran = run("--version")
    assert (ran.code, ran.err) == (0, "")
    assert ran.out == f"bodymeasure {importlib.metadata.version('bodymeasure')}\n"


def test_a_bare_checkout_has_a_version_too(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> str:
        raise importlib.metadata.PackageNotFoundError(name)

    monkeypatch.setattr(importlib.metadata, "version", missing)
    ran = run("--version")
    assert (ran.code, ran.err) == (0, "")
    assert "not installed" in ran.out


@pytest.mark.parametrize("option", ["-h", "--help"])
def test_the_help_tells_commands_and_exit_codes(run: Run, option: str) -> None:
    ran = run(option)
    assert (ran.code, ran.err) == (0, "")
    listed = [line.split()[0] for line in ran.out.splitlines() if line.startswith("  ")]
    places = [listed.index(command) for command in COMMANDS]
    assert places == sorted(places)
    words = " ".join(ran.out.split())
    for said in ("0 done", "1 done, but", "2 bad input", "130 interrupted"):
        assert said in words
    # No command's summary is cut off.
    assert "..." not in ran.out.partition("Commands:")[2]


@pytest.mark.parametrize("option", ["--help", "--version"])
def test_the_help_imports_nothing_slow(option: str) -> None:
    program = (
        "import sys\nfrom bodymeasure.cli.main import main\n"
        f"try:\n    main([{option!r}])\n"
        "finally:\n    print(sorted({'numpy', 'scipy', 'rich', 'msgspec'} & sys.modules.keys()))"
    )
    ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert (ran.returncode, ran.stderr) == (0, "")
    assert ran.stdout.splitlines()[-1] == "[]"


@pytest.mark.parametrize("command", COMMANDS)
def test_each_command_has_help(run: Run, command: str) -> None:
    ran = run(command, "--help")
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.startswith(f"Usage: bodymeasure {command} [OPTIONS]")
    if command != "samples":
        assert "Exit codes: 0 done; 1 done, but" in " ".join(ran.out.split())


def test_no_arguments_give_the_help_and_a_usage_error(run: Run) -> None:
    ran = run()
    assert (ran.code, ran.out) == (2, "")
    assert "Commands:" in ran.err


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("frobnicate",), "No such command 'frobnicate'"),
        (("report", "--frobnicate"), "No such option"),
        (("diagonals",), "Missing argument 'ATLAS'"),
        (("diagonals", "enneper", "--unit", "ft"), "'ft' is not one of 'm', 'cm', 'mm', 'inch'"),
        (("diagonals", "enneper", "--format", "xml"), "not one of 'table', 'csv', 'json'"),
        (("report", "--processes", "0"), "0 is not in the range"),
        (("check", "enneper", "more"), "unexpected extra argument"),
    ],
)
def test_wrong_usage_is_told(run: Run, arguments: tuple[str, ...], message: str) -> None:
    ran = run(*arguments)
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err
    assert "Try 'bodymeasure " in ran.err


def test_samples_are_listed_with_a_line_each(run: Run) -> None:
    ran = run("samples")
    assert (ran.code, ran.err) == (0, "")
    lines = ran.out.splitlines()
    assert tuple(line.split()[0] for line in lines[1:]) == sample_names()
    assert all(line == line.rstrip() for line in lines)


def test_the_files_of_samples_can_be_read(run: Run) -> None:
    ran = run("samples", "--paths")
    assert (ran.code, ran.err) == (0, "")
    paths = [Path(line) for line in ran.out.splitlines()]
    assert tuple(path.stem for path in paths) == sample_names()
    assert len(read_atlas(paths[0])) == 1


@pytest.mark.parametrize("name", ["female_avrage", "female_average.atlas", "femaleaverage"])
def test_a_misspelt_sample_is_guessed(run: Run, name: str) -> None:
    ran = run("check", name)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == (
        f"Error: {name}: no such file, and no sample of that name; did you mean the sample "
        "'female_average'?\n"
    )


def test_an_unknown_name_refers_to_the_list_of_samples(run: Run) -> None:
    ran = run("check", "zzz")
    assert (ran.code, ran.out) == (2, "")
    assert "zzz: no such file, and no sample of that name; `bodymeasure samples`" in ran.err


def test_a_folder_named_as_a_sample_does_not_hide_it(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "enneper").mkdir()
    monkeypatch.chdir(tmp_path)
    ran = run("check", "enneper")
    assert (ran.code, ran.err) == (0, "")
    assert ran.out == "Enneper's surface: 1 patch in cm, 0 errors, 0 warnings\n"


def test_into_a_pipe_go_no_colors_and_no_remarks() -> None:
    ran = run_apart("check", "female_average")
    assert (ran.code, ran.err) == (0, "")
    assert "\x1b" not in ran.out
    assert ran.out.startswith("warning kinked seam: ")


def in_a_terminal(*arguments: object, setup: str = "") -> tuple[int, str]:
    """What a command prints to a terminal of 40 columns, and its exit code."""
    pty = pytest.importorskip("pty")
    termios = pytest.importorskip("termios")
    controller, terminal = pty.openpty()
    termios.tcsetwinsize(terminal, (24, 40))
    process = start(
        *arguments,
        setup=setup,
        stdin=terminal,
        stdout=terminal,
        stderr=terminal,
    )
    os.close(terminal)
    printed = b""
    try:
        while part := os.read(controller, 65536):
            printed += part
    except OSError:  # so Linux says that the other end was closed
        pass
    finally:
        os.close(controller)
    return process.wait(timeout=180), printed.decode()


needs_terminal = pytest.mark.skipif(sys.platform == "win32", reason="pseudo terminals of POSIX")


@needs_terminal
@pytest.mark.parametrize("no_color", quick([False, True]))
def test_a_terminal_gets_colors_unless_they_are_unwanted(no_color: bool) -> None:
    setup = f"import os\nos.environ.update(TERM='xterm', {'NO_COLOR=1' if no_color else ''})"
    setup = setup.replace("NO_COLOR=1", "NO_COLOR='1'")
    code, printed = in_a_terminal("check", "zzz", setup=setup)
    assert code == 2
    assert ("\x1b[1;31mError:" in printed) is not no_color
    assert "Error:" in printed


@needs_terminal
def test_a_narrow_terminal_gets_a_progress_bar_and_a_narrow_table(tmp_path: Path) -> None:
    folder = tmp_path / "out"
    code, printed = in_a_terminal(
        "report",
        "enneper",
        "-o",
        folder,
        "--no-pictures",
        setup="import os\nos.environ.update(TERM='xterm', NO_COLOR='1')",
    )
    assert code == 0
    bar, _, table = printed.rpartition("\x1b[2K")
    assert "comparing with meshes" in bar
    lines = re.sub(r"\x1b\[[0-9;]*m|\r", "", table).splitlines()
    assert lines[0].rstrip() == "Enneper's surface"
    assert all(len(line) <= 40 for line in lines if str(tmp_path) not in line)
    assert "Traceback" not in printed
