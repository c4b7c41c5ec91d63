"""Meshes that no body can be fitted to, and what the refusal says."""

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from helpers.scans.meshes import ellipsoid, joined

from bodymeasure.errors import InputError
from bodymeasure.fit import map_body
from bodymeasure.fit.scan import load as loading
from bodymeasure.fit.scan import read_scan, scan_of

TALL = ellipsoid((0.0, 0.0, 0.9), (0.3, 0.2, 0.85))
ONE = "v 0 0 0\nv 1 0 0\nv 0 0 1.7\n"


def _refused(path: Path, content: str | bytes, unit: str | None = "m") -> str:
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(InputError) as raised:
        read_scan(path, file_unit=unit)
    message = str(raised.value)
    assert message.startswith(f"{path}: ")
    return message.removeprefix(f"{path}: ")


def test_a_missing_unit_names_the_option(tmp_path: Path) -> None:
    said = _refused(tmp_path / "body.stl", b"solid", unit=None)
    assert said == (
        "a mesh says no unit, and none was given; say in which unit its coordinates are (one of m, "
        "cm, mm, inch): file_unit=... in Python, --file-unit on the command line"
    )


def test_that_a_file_is_missing_comes_before_its_unit(tmp_path: Path) -> None:
    for reads in (read_scan, map_body):
        with pytest.raises(InputError, match=r"nothing\.ply: no such file; check the path"):
            reads(tmp_path / "nothing.ply")


@pytest.mark.parametrize(
    ("true", "given", "length"),
    [("mm", "m", "1.67e+03"), ("cm", "m", "167"), ("m", "mm", "0.00167"), ("mm", "cm", "16.7")],
)
def test_a_wrong_unit_is_told_with_the_right_one(true: str, given: str, length: str) -> None:
    factor = {"m": 1.0, "cm": 100.0, "mm": 1000.0}[true]
    with pytest.raises(InputError) as raised:
        scan_of(factor * TALL[0], TALL[1], file_unit=given)
    assert str(raised.value) == (
        f"the mesh: is {length} m long in the unit {given}, and a body 1 to 3 m; in {true} it "
        "would be; check the unit of the file (file_unit=... in Python, --file-unit on the command "
        "line)"
    )


def test_a_bust_alone_is_too_short() -> None:
    with pytest.raises(
        InputError, match=r"is 0\.588 m long in the unit m, .* give the mesh of a whole body"
    ):
        scan_of(*ellipsoid((0, 0, 0), (0.2, 0.15, 0.3)), file_unit="m")


def test_two_people_are_told_to_be_parted() -> None:
    other = TALL[0] + np.array([0.8, 0.3, 0.0]), TALL[1]
    with pytest.raises(InputError) as raised:
        scan_of(*joined(TALL, other), file_unit="m")
    assert str(raised.value) == (
        "the mesh: holds 2 pieces of the size of a body, two of them 0.85 m apart; expected one "
        "person: cut the others away, or save each in a file of its own"
    )
    # The front and the back of one person are closer.
    vertices, triangles = TALL
    front = vertices[triangles].mean(axis=1)[:, 1] < 0.0
    behind = vertices + np.array([0.0, 0.01, 0.0])
    halves = joined((vertices, triangles[front]), (behind, triangles[~front]))
    assert "The mesh is in 2 pieces." in scan_of(*halves, file_unit="m").notes


@pytest.mark.parametrize("name", ["cloud.obj", "cloud.ply"])
def test_a_cloud_of_points_has_no_surface(tmp_path: Path, name: str) -> None:
    cloud: Any = trimesh.PointCloud(TALL[0])  # type: ignore[no-untyped-call]
    cloud.export(tmp_path / "cloud.ply")
    text = "".join(f"v {x} {y} {z}\n" for x, y, z in TALL[0].tolist())
    content = {".obj": text.encode(), ".ply": (tmp_path / "cloud.ply").read_bytes()}
    said = _refused(tmp_path / name, content[Path(name).suffix])
    assert said == (
        f"holds {len(TALL[0])} vertices and no triangle; it is a cloud of points; make a surface "
        "of it first, for example with MeshLab's Screened Poisson Surface Reconstruction, or "
        "export the scanner's mesh"
    )


@pytest.mark.parametrize("kind", ["stl", "ply", "obj", "off", "glb", "gltf"])
def test_an_empty_file_is_refused(tmp_path: Path, kind: str) -> None:
    for content in (b"", b" \n"):
        said = _refused(tmp_path / f"empty.{kind}", content)
        assert said == "is empty; expected a triangle mesh, export it again"


def test_one_triangle_is_no_body(tmp_path: Path) -> None:
    said = _refused(tmp_path / "one.obj", ONE + "f 1 2 3\n")
    assert said == (
        "has 0 m² beside its flat sides; expected the mesh of a body, which has more than 0.5 m²"
    )
    assert "all triangles are without area" in _refused(tmp_path / "none.obj", ONE + "f 1 2 2\n")


def test_triangles_that_nothing_joins_are_no_surface() -> None:
    vertices = TALL[0][TALL[1]]
    middle = vertices.mean(axis=1, keepdims=True)
    apart = (middle + 0.99 * (vertices - middle)).reshape(-1, 3)
    with pytest.raises(InputError, match="falls into 960 pieces, of which none has 3% of the area"):
        scan_of(apart, np.arange(len(apart)).reshape(-1, 3), file_unit="m")


def test_files_that_are_cut_off_say_so(tmp_path: Path) -> None:
    mesh = trimesh.Trimesh(*TALL, process=False)
    binary = mesh.export(file_type="stl")
    said = _refused(tmp_path / "cut.stl", binary[:-10])
    assert said == (
        "is no STL file, or cut off: as a binary one of 960 triangles it would have 48,084 bytes, "
        "and it has 48,074; export it again"
    )
    text = str(mesh.export(file_type="stl_ascii"))
    said = _refused(tmp_path / "cut.stl", text[: text.rindex("endsolid")])
    assert said == "does not end with endsolid; it is cut off, export it again"
    text = text.replace("vertex", "vertex x", 1)
    assert "line 4: a vertex of 4 numbers; expected vertex x y z" in _tail(tmp_path, text)
    off = str(mesh.export(file_type="off"))
    said = _refused(tmp_path / "cut.off", off[: len(off) // 2])
    assert "it is cut off, export it again" in said
    glb = mesh.export(file_type="glb")
    assert _refused(tmp_path / "cut.glb", glb[:60]) == "is no GLB file, or cut off; export it again"


def _tail(folder: Path, text: str) -> str:
    path = folder / "text.stl"
    path.write_text(text)
    with pytest.raises(InputError) as raised:
        read_scan(path, file_unit="m")
    return str(raised.value).removeprefix(f"{path}, ")


def test_too_many_triangles_are_refused_before_they_are_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    many = 3_000_000
    content = b"\0" * 80 + struct.pack("<I", many)
    with (tmp_path / "huge.stl").open("wb") as file:
        file.write(content)
        file.truncate(84 + 50 * many)
    with pytest.raises(InputError, match=r"has 3,000,000 triangles; expected 2,000,000 at most"):
        read_scan(tmp_path / "huge.stl", file_unit="m")
    monkeypatch.setattr(loading, "MOST_BYTES", 1000)
    with pytest.raises(InputError, match=r"at most; reduce it to 500,000 triangles, for example"):
        read_scan(tmp_path / "huge.stl", file_unit="m")


def test_unknown_kinds_and_axes_are_refused(tmp_path: Path) -> None:
    assert "expected one of .stl, .ply, .obj" in _refused(tmp_path / "body.xyz", b"1 2 3")
    for given in ({"up": "z"}, {"front": "left"}):
        with pytest.raises(InputError, match=r"expected one of \+x, -x, \+y, -y, \+z, -z, or None"):
            scan_of(*TALL, file_unit="m", **given)
    with pytest.raises(InputError, match="lie along the same axis"):
        scan_of(*TALL, file_unit="m", up="+y", front="-y")
    with pytest.raises(InputError, match="unknown unit 'km'"):
        scan_of(*TALL, file_unit="km")


def test_arrays_that_are_no_mesh_are_refused() -> None:
    for vertices, triangles, said in (
        (TALL[0][:, :2], TALL[1], r"the vertices have shape \(482, 2\); expected \(n, 3\)"),
        (TALL[0], TALL[1][:, :2], r"the triangles have shape \(960, 2\)"),
        (TALL[0], 1.0 * TALL[1], "the triangles is .*; expected whole numbers of vertices"),
        (TALL[0], TALL[1][:0], "the mesh has no triangle; a cloud of points"),
        (TALL[0], TALL[1] + 1, "refer to vertices 1 to 482; expected 0 to 481"),
    ):
        with pytest.raises(InputError, match=f"(?s){said}"):
            scan_of(vertices, triangles, file_unit="m")
