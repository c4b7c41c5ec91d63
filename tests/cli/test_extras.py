"""Commands without the packages of the extras."""

from pathlib import Path
from typing import Any

import pytest
from helpers.command_line import Run, hide, hide_here, run_apart

DRAWING = ("igl", "trimesh", "pyvista", "vtkmodules", "matplotlib", "PIL")


@pytest.mark.parametrize(
    ("hidden", "package", "arguments", "extra", "remedy"),
    [
        ("igl", "libigl", ("report",), "oracle", "--no-cross-check leaves it out"),
        ("igl", "libigl", ("view", "--desktop"), "oracle", "--no-cross-check leaves it out"),
        ("matplotlib", "matplotlib", ("report",), "report", "--no-pictures leaves it out"),
        ("jinja2", "jinja2", ("report", "--no-cross-check"), "report", "the HTML report"),
        ("pyvista", "pyvista", ("view", "--desktop", "--no-cross-check"), "viewer", "the viewer"),
        ("matplotlib", "matplotlib", ("view", "--desktop"), "viewer", "the viewer"),
        ("starlette", "starlette", ("view",), "viewer", "the page"),
        ("uvicorn", "uvicorn", ("view", "--chart"), "viewer", "the page"),
    ],
)
def test_a_missing_package_is_told_before_any_work(
    run: Run,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    hidden: str,
    package: str,
    arguments: tuple[str, ...],
    extra: str,
    remedy: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    hide_here(monkeypatch, hidden)
    # If any work were begun, the missing atlas would be reported.
    ran = run(*arguments, "gone.atlas")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith("Error: ")
    assert f"needs the package {package!r}, which is not installed" in ran.err
    assert ran.err.endswith(f"pip install 'bodymeasure[{extra}]'\n")
    assert remedy in ran.err
    assert list(tmp_path.iterdir()) == []


def test_a_plain_report_needs_one_extra_package(tmp_path: Path) -> None:
    plain: tuple[Any, ...] = ("--no-cross-check", "--no-pictures")
    ran = run_apart("report", "enneper", "-o", tmp_path / "new", *plain, setup=hide(*DRAWING))
    assert (ran.code, ran.err) == (0, "")
    assert len(list((tmp_path / "new").iterdir())) == 4


def test_lengths_need_none(tmp_path: Path) -> None:
    ran = run_apart("diagonals", "enneper", setup=hide(*DRAWING, "jinja2"), cwd=tmp_path)
    assert (ran.code, ran.err) == (0, "")
    assert "2.3570" in ran.out
