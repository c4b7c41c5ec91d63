"""Meshes of triangles are not silently taken for atlases."""

from pathlib import Path

import pytest
from helpers.files.format_atlases import UNIT, read
from helpers.surfaces.solids import icosphere, obj_text

from bodymeasure.errors import InputError, TriangleMeshError
from bodymeasure.formats import read_atlas
from bodymeasure.formats.options import ReadOptions

TRIANGLES = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\nf 1 3 4\n"


def test_a_mesh_of_triangles_says_what_it_would_become(tmp_path: Path) -> None:
    path = tmp_path / "scan.obj"
    path.write_text(obj_text(icosphere(2)))
    with pytest.raises(TriangleMeshError) as raised:
        read_atlas(path, unit="cm")
    message = str(raised.value)
    assert message.startswith(
        f"{path}: is a mesh of 320 triangles, and would become 960 patches or more; if it is a body"
    )
    assert f"`bodymeasure fit {path} --file-unit cm`" in message
    assert f"`bodymeasure chart {path} --file-unit cm`" in message
    assert "bm.measure_mesh(trimesh.load(...), start, end)" in message
    assert message.endswith("to have the patches all the same, give --quads (quads=True in Python)")
    assert len(read_atlas(path, unit="cm", quads=True)) == 960


def test_meshes_mostly_of_quads_are_read_as_they_are() -> None:
    quads = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0 0\n"
    assert len(read((quads + "f 1 2 3 4\nf 2 5 6 3\n").encode(), "obj")) > 0
    assert len(read((quads + "f 1 2 3 4\nf 2 5 6 3\nf 5 7 6\n").encode(), "obj")) > 0
    with pytest.raises(TriangleMeshError, match="3 triangles, and would become 13 patches"):
        read((quads + "f 1 2 3 4\nf 2 5 6\nf 2 6 3\nf 5 7 6\n").encode(), "obj")


def test_a_mesh_of_triangles_that_is_no_surface_has_the_same_remedy() -> None:
    third = TRIANGLES + "v 0 0 1\nf 1 3 5\n"
    with pytest.raises(TriangleMeshError, match=r"a manifold.*`bodymeasure fit file --file-unit"):
        read(third.encode(), "obj", ReadOptions(unit=UNIT, quads=True))


@pytest.mark.parametrize("kind", ["stl", "ply", "off", "glb", "gltf"])
def test_files_of_triangles_point_to_the_fit(tmp_path: Path, kind: str) -> None:
    path = tmp_path / f"scan.{kind}"
    path.write_bytes(b"anything")
    unit = "" if kind.startswith("gl") else " --file-unit UNIT"
    with pytest.raises(TriangleMeshError) as raised:
        read_atlas(path)
    message = str(raised.value)
    assert message.startswith(f"{path}: .{kind} files hold triangle meshes and no atlas; if it is")
    assert f"`bodymeasure fit {path}{unit}`, or at once `bodymeasure chart {path}{unit}`" in message


def test_patches_have_no_triangles_to_ask_for(tmp_path: Path) -> None:
    from bodymeasure import load_sample, write_atlas

    write_atlas(load_sample("paraboloid"), tmp_path / "body.atlas")
    with pytest.raises(InputError, match="holds patches and no mesh; leave the quads out"):
        read_atlas(tmp_path / "body.atlas", quads=True)
