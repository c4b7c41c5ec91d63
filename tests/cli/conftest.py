"""Fixtures that run the command line in this process, and small atlases to run it on."""

import json
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from helpers.command_line import Edited, Run, part_of_a_body, run_here
from helpers.surfaces.grids import grid_atlas

from bodymeasure import write_atlas


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    """Run a command in this process."""
    return partial(run_here, capsys)


@pytest.fixture(scope="session")
def part(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The file of an atlas of six patches of a body."""
    path = tmp_path_factory.mktemp("part") / "part.atlas"
    write_atlas(part_of_a_body(100, 106), path)
    return path


@pytest.fixture
def edited(tmp_path: Path) -> Edited:
    """Write two good patches to a file, after an edit of its JSON."""

    def edited(edit: Callable[[dict[str, Any]], object]) -> Path:
        path = tmp_path / "edited.atlas"
        write_atlas(grid_atlas(1, 2), path)
        content = json.loads(path.read_bytes())
        edit(content)
        path.write_text(json.dumps(content), "utf-8")
        return path

    return edited
