"""What a folder of many bodies remembers, and the names of its scans."""

from pathlib import Path

import pytest

from bodymeasure import InputError
from bodymeasure.cli.fitting.batch import named_scans
from bodymeasure.cli.fitting.done import FILE, Done, key_of
from bodymeasure.cli.fitting.scans import is_scan


def test_scans_are_named_as_their_files_and_equal_names_are_numbered() -> None:
    found = named_scans(["a/anna.ply", "b/anna.stl", "anna 1.ply", "ben.ply"])
    assert [scan.name for scan in found] == ["anna 2", "anna 3", "anna 1", "ben"]
    with pytest.raises(InputError, match=r"^a\.ply: is given twice"):
        named_scans(["a.ply", "b.ply", "./a.ply"])


def test_files_are_done_as_long_as_they_and_their_key_are_there(tmp_path: Path) -> None:
    one, other = tmp_path / "one.atlas", tmp_path / "one.fit.html"
    done = Done(tmp_path)
    assert not done.has("key", one)
    for file in (one, other):
        file.write_text("x", "utf-8")
    # A file that a killed run has left counts for nothing before it is noted.
    assert not Done(tmp_path).has("key", one)
    done.add("key", one, other)
    again = Done(tmp_path)
    assert again.has("key", one, other)
    assert not again.has("another key", one)
    other.unlink()
    assert not again.has("key", one, other)
    assert again.has("key", one)
    (tmp_path / FILE).write_text("{", "utf-8")
    assert not Done(tmp_path).has("key", one)


def test_a_key_is_of_the_content_and_of_the_settings(tmp_path: Path) -> None:
    scan, copy = tmp_path / "scan.ply", tmp_path / "copy.ply"
    for file in (scan, copy):
        file.write_bytes(b"ply")
    key = key_of((scan,), {"unit": "mm", "up": "+y"})
    assert key == key_of((copy,), {"up": "+y", "unit": "mm"})
    assert key != key_of((scan,), {"unit": "cm", "up": "+y"})
    copy.write_bytes(b"ply ")
    assert key != key_of((copy,), {"unit": "mm", "up": "+y"})
    with pytest.raises(InputError, match="no such file"):
        key_of((tmp_path / "no.ply",), {})


def test_an_obj_file_is_a_scan_if_it_is_made_of_triangles(tmp_path: Path) -> None:
    file = tmp_path / "body.obj"
    vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    file.write_text(vertices + "f 1/1 2/2 3/3\nf 1 3 4\n", "utf-8")
    assert is_scan(str(file))
    file.write_text(vertices + "f 1 2 3 4\n", "utf-8")
    assert not is_scan(str(file))
    file.write_text(vertices, "utf-8")
    assert not is_scan(str(file))
    assert is_scan("person.STL")
    assert not is_scan("female_average")
    assert not is_scan("person.atlas")
