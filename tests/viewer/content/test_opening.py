"""Files that are dropped on the page become bodies, or a sentence that says what to do."""

from pathlib import Path

import pytest
from bodymeasure.viewer.content.answers import answer
from bodymeasure.viewer.content.bodies import Bodies
from bodymeasure.viewer.content.opening import opened, read_again
from bodymeasure.viewer.content.requests import OpenFile
from bodymeasure.viewer.content.shown import ShownBody
from helpers.command_line import folded_part_of_a_body, part_of_a_body

import bodymeasure as bm
from bodymeasure.errors import InputError, TriangleMeshError
from bodymeasure.samples import sample_path

DATA = Path(__file__).parents[2] / "data"
TRIANGLE = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def test_every_format_that_is_read_is_opened(tmp_path: Path) -> None:
    atlas = part_of_a_body(100, 106)
    for suffix, unit in ((".atlas", None), (".npz", None), (".bpt", "m"), (".json", "m")):
        path = tmp_path / f"body{suffix}"
        bm.write_atlas(atlas, path)
        body = opened(OpenFile(name=path.name, content=path.read_bytes(), unit=unit))
        assert len(body.atlas) == len(atlas)
        assert body.name


def test_bodies_get_ids_of_their_own() -> None:
    bodies = Bodies()
    content = sample_path("paraboloid").read_bytes()
    for number in ("1", "2"):
        found = answer(bodies, OpenFile(name="bowl.atlas", content=content))
        assert found == {"id": number, "name": "Paraboloid of revolution", "warnings": []}
        assert len(bodies[number].atlas) == 1


@pytest.mark.parametrize(
    ("name", "content", "unit", "words"),
    [
        ("scan.stl", b"solid", None, "bodymeasure fit"),
        ("scan.ply", b"ply", "m", "bodymeasure fit"),
        ("scan.obj", TRIANGLE, "m", "bodymeasure fit"),
        ("body.atlas", b"", None, "body.atlas: is empty"),
        ("body.atlas", b"{", None, "body.atlas"),
        ("body.bpt", (DATA / "teapot.bpt").read_bytes(), None, "unit"),
        ("picture.png", b"", None, "unknown kind of file '.png'"),
        ("body", b"", None, "has no extension"),
    ],
)
def test_what_is_no_body_is_told(name: str, content: bytes, unit: str, words: str) -> None:
    with pytest.raises(InputError) as told:
        opened(OpenFile(name=name, content=content, unit=unit))
    assert words in str(told.value)


def test_a_scan_is_told_by_its_kind() -> None:
    with pytest.raises(TriangleMeshError):
        opened(OpenFile(name="scan.obj", content=TRIANGLE, unit="m"))


@pytest.mark.parametrize(
    "name", ["../../etc/body.atlas", "C:\\Users\\anna\\body.atlas", "/body.atlas"]
)
def test_only_the_last_part_of_a_name_is_kept(name: str) -> None:
    content = sample_path("paraboloid").read_bytes()
    assert opened(OpenFile(name=name, content=content)).file == "body.atlas"


def test_a_file_is_read_again_with_what_was_said_of_it(tmp_path: Path) -> None:
    path = tmp_path / "body.bpt"
    bm.write_atlas(part_of_a_body(100, 106), path)
    body = ShownBody("0", bm.read_atlas(path, unit="cm"), "b", str(path), settings={"unit": "cm"})
    bm.write_atlas(part_of_a_body(100, 103), path)
    again = read_again(body)
    assert (len(again.atlas), again.atlas.unit, again.version) == (3, "cm", 2)
    path.write_bytes(b"half")
    with pytest.raises(InputError, match=r"body\.bpt"):
        read_again(body)


def test_what_a_check_finds_is_told_of_a_dropped_file_and_of_one_that_has_changed(
    tmp_path: Path,
) -> None:
    path = tmp_path / "folded.atlas"
    bm.write_atlas(folded_part_of_a_body(), path)
    (told,) = opened(OpenFile(name="folded.atlas", content=path.read_bytes())).warnings
    assert told.startswith("The check of the atlas finds ")
    whole = ShownBody("0", part_of_a_body(100, 106), "b", str(path), settings={})
    assert read_again(whole).warnings == (told,)


def test_a_file_without_a_unit_is_told_by_its_kind(tmp_path: Path) -> None:
    bm.write_atlas(part_of_a_body(100, 106), tmp_path / "part.bpt")
    with pytest.raises(bm.MissingUnitError, match="says no unit"):
        opened(OpenFile(name="part.bpt", content=(tmp_path / "part.bpt").read_bytes()))
