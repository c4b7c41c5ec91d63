"""A set of definitions, and a body with a single landmark, in files."""

from dataclasses import replace
from pathlib import Path

import pytest

from bodymeasure import load_sample, write_atlas

SET = """
format = "bodymeasure measurements"
version = 1
name = "Mine"
[[landmark]]
name = "waist point {side}"
rule = "level"
of = "front waist point"
facing = "{side}"
[[landmark]]
name = "chin point"
rule = "level"
of = "top of head"
facing = "front"
[[measurement]]
key = "waist"
kind = "girth"
name = "Waist"
at = "waist point left"
[[measurement]]
key = "face"
kind = "chord"
name = "Face"
start = "chin point"
end = "top of head"
"""


@pytest.fixture
def mine(tmp_path: Path) -> Path:
    path = tmp_path / "mine.toml"
    path.write_text(SET, "utf-8")
    return path


@pytest.fixture
def bare(tmp_path: Path) -> Path:
    """A body of which a single landmark is picked, in a file of its own."""
    body = load_sample("female_average")
    kept = {"front waist point": body.landmarks["front waist point"]}
    path = tmp_path / "bare.atlas"
    write_atlas(replace(body, landmarks=kept), path)
    return path
