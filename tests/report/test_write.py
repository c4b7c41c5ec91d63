import errno
import json
import os
import sys
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from bodymeasure.errors import InputError
from bodymeasure.report import closeup_patches, survey_document, write_report

FILES = {"report.html", "measurements.json", "measurements.csv", "measurements.schema.json"}


def names(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()}


def test_the_files_are_written_and_agree(tmp_path: Path, survey: Any, pictures: Any) -> None:
    folder = tmp_path / "new" / "folder"
    paths = write_report(survey, folder, unit="mm", pictures=pictures)
    assert paths[0] == folder / "report.html"
    assert names(folder) == {path.name for path in paths} == FILES
    schema = json.loads((folder / "measurements.schema.json").read_bytes())
    content = json.loads((folder / "measurements.json").read_bytes())
    jsonschema.Draft202012Validator(schema).validate(content)
    lines = (folder / "measurements.csv").read_bytes().decode().splitlines()
    assert len(lines) == len(content["measurements"]) + 1
    assert "in millimeters" in (folder / "report.html").read_text("utf-8")


def test_pictures_are_drawn_unless_they_are_left_out(
    tmp_path: Path, survey: Any, pictures: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = []

    def draw(shown: Any, closeups: tuple[int, ...]) -> Any:
        asked.append((shown, closeups))
        return pictures

    monkeypatch.setattr("bodymeasure.scene.pictures", draw)
    page = write_report(survey, tmp_path)[0]
    assert asked == [(survey, closeup_patches(survey_document(survey, "cm")))]
    assert "data:image/png" in page.read_text("utf-8")
    write_report(survey, tmp_path, pictures=False)
    assert len(asked) == 1
    assert "data:image/png" not in page.read_text("utf-8")


@pytest.mark.parametrize("at", [1, 2, 3, 4])
def test_a_full_disk_leaves_the_earlier_report_whole(
    tmp_path: Path, survey: Any, monkeypatch: pytest.MonkeyPatch, at: int
) -> None:
    write_report(survey, tmp_path, pictures=False)
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    calls = []

    def full(descriptor: int) -> None:
        calls.append(descriptor)
        if len(calls) == at:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(InputError, match="No space left on device"):
        write_report(survey, tmp_path, unit="mm", pictures=False)
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


def test_an_interrupt_leaves_nothing(
    tmp_path: Path, survey: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls = []

    def interrupted(descriptor: int) -> None:
        calls.append(descriptor)
        if len(calls) == 3:
            raise KeyboardInterrupt

    monkeypatch.setattr(os, "fsync", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_report(survey, tmp_path, pictures=False)
    assert names(tmp_path) == set()


def test_a_failure_to_render_touches_no_file(
    tmp_path: Path, survey: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "jinja2", None)
    with pytest.raises(ImportError):
        write_report(survey, tmp_path / "folder", pictures=False)
    assert names(tmp_path) == set()
