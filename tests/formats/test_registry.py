from pathlib import Path

import pytest
from helpers.surfaces.grids import grid_atlas

from bodymeasure import InputError, read_atlas, write_atlas


def test_a_file_holds_what_was_written(tmp_path: Path) -> None:
    atlas = grid_atlas(2, 2)
    for path in (tmp_path / "body.atlas", str(tmp_path / "BODY 2.ATLAS")):
        write_atlas(atlas, path)
        assert read_atlas(path).digest == atlas.digest


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"gone.atlas: no such file; check the path"):
        read_atlas(tmp_path / "gone.atlas")


@pytest.mark.parametrize("name", ["folder", "folder.atlas"])
def test_a_folder_is_no_file(tmp_path: Path, name: str) -> None:
    (tmp_path / name).mkdir()
    with pytest.raises(InputError, match=f"{name}: is a directory; give the file inside it"):
        read_atlas(tmp_path / name)


def test_unknown_extensions_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "body.stl"
    with pytest.raises(InputError, match=r"body.stl: unknown kind of file '.stl'; .* \.atlas"):
        write_atlas(grid_atlas(1, 1), path)
    assert not path.exists()
    unknown = tmp_path / "body.xyz"
    unknown.write_bytes(b"1 2 3")
    with pytest.raises(InputError, match=r"unknown kind of file '.xyz'; expected one of \.atlas"):
        read_atlas(unknown)


def test_faults_inside_name_the_file(tmp_path: Path) -> None:
    path = tmp_path / "body.atlas"
    path.write_bytes(b"{}")
    with pytest.raises(InputError, match=r"body.atlas: is not a bodymeasure atlas file"):
        read_atlas(path)
