"""A bad atlas or a bad place ends with a message and exit code 2, and nothing is written."""

import errno
import math
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers.command_line import Edited, Run
from helpers.surfaces.grids import grid_atlas

from bodymeasure import Atlas, write_atlas
from bodymeasure.samples import sample_path

REPORT = ("--no-cross-check", "--no-pictures")


NOT_THERE = "patch 1 ('patch 1') refers to control point 999, but the points are numbered 0 to 27"


def set_point(value: object) -> Any:
    return lambda content: content["points"].__setitem__(3, [0.0, value, 0.0])


def set_member(key: str, value: object) -> Any:
    return lambda content: content.__setitem__(key, value)


def cut_patch(content: dict[str, Any]) -> None:
    del content["patches"][1]["points"][3]


@pytest.mark.parametrize("command", ["report", "diagonals", "check", "view"])
@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda _: None, "body.atlas: no such file; check the path"),
        (Path.mkdir, "body.atlas: is a directory; give the file inside it"),
        (Path.touch, "body.atlas: is empty; expected a bodymeasure atlas file"),
        (
            lambda path: path.write_bytes(sample_path("enneper").read_bytes()[:-40]),
            "body.atlas, line ",
        ),
    ],
    ids=["missing", "directory", "empty", "truncated"],
)
def test_no_atlas_to_read(
    run: Run,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    command: str,
    make: Any,
    message: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "body.atlas"
    make(path)
    ran = run(command, path)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith(f"Error: {tmp_path}")
    assert message in ran.err
    assert "Traceback" not in ran.err
    assert {found.name for found in tmp_path.iterdir()} <= {"body.atlas"}


@pytest.mark.parametrize(
    ("edit", "message"),
    [
        (set_member("version", 99), "has version 99; this bodymeasure reads version 1"),
        (lambda content: content.pop("unit"), 'has no unit; add a line such as "unit": "cm"'),
        (set_member("unit", "furlong"), "unknown unit 'furlong'; expected one of m, cm, mm, inch"),
        (set_point(math.nan), ": NaN is not a number; expected finite coordinates"),
        (set_point(math.inf), ": Infinity is not a number; expected finite coordinates"),
        (lambda content: content["patches"][1]["points"][0].__setitem__(0, 999), NOT_THERE),
        (cut_patch, "patch 1 ('patch 1'): expected 4 rows of 4 numbers, as of degree 3; got 3"),
    ],
    ids=["version", "no unit", "unknown unit", "nan", "infinity", "out of range", "3x4"],
)
def test_an_atlas_that_is_not_valid(run: Run, edited: Edited, edit: Any, message: str) -> None:
    path = edited(edit)
    ran = run("diagonals", path)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith(f"Error: {path}")
    assert message in ran.err
    assert "Traceback" not in ran.err


def collapsed() -> Atlas:
    nets = np.array(grid_atlas(1, 2).control_points)
    nets[1] = 1.0
    return Atlas.from_control_points(nets, "cm")


def folded() -> Atlas:
    nets = np.array(grid_atlas(1, 1).control_points)
    # The middle rows are swapped far enough for the surface to run back over itself.
    nets[0, 1, :, 0], nets[0, 2, :, 0] = 2.0, -1.0
    return Atlas.from_control_points(nets, "cm")


def gaping() -> Atlas:
    nets = np.array(grid_atlas(1, 2).control_points)
    # One of two sides that meet bulges away by a tenth.
    nets[1, 1:3, 0, 1] += 0.1
    return Atlas.from_control_points(nets, "cm")


UNSOUND = [(collapsed, "collapsed"), (folded, "fold"), (gaping, "gap")]


@pytest.mark.parametrize(("make", "word"), UNSOUND)
def test_the_check_names_what_is_wrong(run: Run, tmp_path: Path, make: Any, word: str) -> None:
    write_atlas(make(), tmp_path / "body.atlas")
    ran = run("check", tmp_path / "body.atlas")
    assert (ran.code, ran.err) == (1, "")
    *findings, summary = ran.out.splitlines()
    errors = [line for line in findings if line.startswith("error ")]
    assert any(word in line and "patch " in line for line in errors)
    assert f"{len(errors)} error" in summary


@pytest.mark.parametrize(("make", "word"), UNSOUND)
@pytest.mark.parametrize(
    "command", [["report"], ["diagonals"], ["view", "--desktop"]], ids=" ".join
)
def test_no_command_measures_an_unsound_atlas_unasked(
    run: Run,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    command: list[str],
    make: Any,
    word: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "body.atlas"
    write_atlas(make(), path)
    ran = run(*command, path)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith(f"Error: {path}: the atlas has ")
    assert word in ran.err
    assert "`bodymeasure check` lists all" in ran.err
    assert "--despite-errors" in ran.err
    assert list(tmp_path.iterdir()) == [path]


def test_an_unsound_atlas_is_measured_if_asked(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "body.atlas"
    write_atlas(gaping(), path)
    ran = run("report", path, "-o", tmp_path / "out", *REPORT, "--despite-errors")
    assert (ran.code, ran.err) == (0, "")
    assert "findings" in ran.out


def test_a_collapsed_patch_is_an_error_even_if_asked(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "body.atlas"
    write_atlas(collapsed(), path)
    ran = run("report", path, "-o", tmp_path / "out", *REPORT, "--despite-errors")
    assert ran.code == 2
    assert "patch 1" in ran.err
    assert "Traceback" not in ran.err
    assert list(tmp_path.iterdir()) == [path]


def no_work(*_: object, **__: object) -> None:
    raise AssertionError("work was begun that could not be written down")


PLACES = [
    ("file/below", "Not a directory"),
    ("file", "it is a file, not a folder"),
    ("/proc/below", "No such file or directory"),
    ("x" * 300, "File name too long"),
]


@pytest.mark.parametrize(("place", "reason"), PLACES)
def test_a_report_that_cannot_be_written_is_not_begun(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, place: str, reason: str
) -> None:
    if place.startswith("/proc") and not Path("/proc/self").exists():
        pytest.skip("this system has no /proc")
    (tmp_path / "file").write_bytes(b"mine")
    monkeypatch.setattr("bodymeasure.cli.measuring.report.measure_atlas", no_work)
    output = tmp_path / place
    ran = run("report", "enneper", "-o", output, *REPORT)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith(f"Error: {output}: cannot be written ({reason}); choose a folder")
    assert (tmp_path / "file").read_bytes() == b"mine"
    assert os.listdir(tmp_path) == ["file"]  # noqa: PTH208


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write all")
def test_a_folder_without_permission_is_told_first(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tmp_path.chmod(0o500)
    monkeypatch.setattr("bodymeasure.cli.measuring.report.measure_atlas", no_work)
    for output in (tmp_path, tmp_path / "new"):
        ran = run("report", "enneper", "-o", output, *REPORT)
        assert (ran.code, ran.out) == (2, "")
        assert "Permission denied" in ran.err


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("gone/body.png", "No such file or directory"),
        ("folder.png", "Is a directory"),
        ("body.jpg", "the picture is a PNG file; give a name that ends in .png, not .jpg"),
    ],
)
def test_a_screenshot_that_cannot_be_written_is_not_begun(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, reason: str
) -> None:
    (tmp_path / "folder.png").mkdir()
    monkeypatch.setattr("bodymeasure.cli.viewing.window.measure_atlas", no_work)
    ran = run("view", "enneper", "--screenshot", tmp_path / name)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith(f"Error: {tmp_path / name}: ")
    assert reason in ran.err


def test_a_window_that_cannot_be_opened_is_not_begun(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "bodymeasure.scene.drawing.opengl_check.opengl_trouble",
        lambda *, window: f"window={window}",
    )
    monkeypatch.setattr("bodymeasure.cli.viewing.window.measure_atlas", no_work)
    ran = run("view", "enneper", "--desktop")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == (
        "Error: no window can be opened, since window=True; "
        "write a picture instead with --screenshot FILE.png\n"
    )


@pytest.mark.parametrize("folder_exists", [False, True])
def test_a_disk_that_runs_full_leaves_nothing(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, folder_exists: bool
) -> None:
    output = tmp_path / "new" / "report"
    if folder_exists:
        output.mkdir(parents=True)
        (output / "report.html").write_bytes(b"the last one")
    calls = []

    def full(descriptor: int) -> None:
        calls.append(descriptor)
        if len(calls) == 3:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    ran = run("report", "enneper", "-o", output, *REPORT)
    assert (ran.code, ran.out) == (2, "")
    assert f"{output}" in ran.err
    assert "cannot be written (No space left on device)" in ran.err
    if folder_exists:
        assert [path.read_bytes() for path in output.iterdir()] == [b"the last one"]
    else:
        assert list(tmp_path.iterdir()) == []


def test_names_are_printed_as_they_are(run: Run, edited: Edited) -> None:
    name = r"[red]:smile: Ärmel[/] \[x] 胸\ "

    def rename(content: dict[str, Any]) -> None:
        content["patches"][0]["name"] = name
        content["name"] = name

    path = edited(rename)
    assert f"{name} diagonal 1" in run("diagonals", path).out
    assert run("check", path).out.startswith(f"{name}: 2 patches")
    assert name in run("diagonals", f"{name}/gone.atlas").err
