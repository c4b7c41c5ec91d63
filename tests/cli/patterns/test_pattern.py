from pathlib import Path

from helpers.command_line import Run


def test_patches_are_unfolded_into_a_folder(run: Run, part: Path, tmp_path: Path) -> None:
    ran = run("pattern", part, "--patches", "-o", tmp_path / "out")
    assert (ran.code, ran.err) == (0, "")
    assert "none turned over" in ran.out
    assert {path.name for path in (tmp_path / "out").iterdir()} == {"patches.svg", "patches.csv"}


def test_what_cannot_be_read_leaves_nothing(run: Run, tmp_path: Path) -> None:
    ran = run("pattern", tmp_path / "missing.atlas", "--patches", "-o", tmp_path / "out")
    assert ran.code == 2
    assert "missing.atlas" in ran.err
    assert not (tmp_path / "out").exists()
