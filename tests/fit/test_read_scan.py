"""Meshes of every kind of file, and what is done to them."""

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from helpers.scans.meshes import ellipsoid, volume

from bodymeasure.fit.scan import Scan, read_scan

# An ellipsoid as tall as a body, without its symmetries.
TALL = ellipsoid((0.2, -0.1, 0.9), (0.3, 0.2, 0.85))


def _closed(scan: Scan) -> float:
    return volume((scan.vertices, scan.triangles))


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("body.stl", {"file_type": "stl"}),
        ("ascii.stl", {"file_type": "stl_ascii"}),
        ("body.ply", {"file_type": "ply"}),
        ("ascii.ply", {"file_type": "ply", "encoding": "ascii"}),
        ("body.obj", {"file_type": "obj"}),
        ("body.off", {"file_type": "off"}),
        ("body.GLB", {"file_type": "glb"}),
    ],
)
def test_every_kind_of_file_gives_the_same_mesh(
    tmp_path: Path, name: str, options: dict[str, Any]
) -> None:
    path = tmp_path / name
    trimesh.Trimesh(*TALL, process=False).export(path, **options)
    scan = read_scan(path, file_unit="m")
    assert scan.name == path.stem
    assert scan.vertices.shape == TALL[0].shape
    assert scan.triangles.shape == TALL[1].shape
    assert _closed(scan) == pytest.approx(volume(TALL), rel=1e-6)
    assert not scan.plate.any()


def test_the_unit_is_the_users_and_glb_is_in_meters(tmp_path: Path) -> None:
    made = trimesh.Trimesh(1000.0 * TALL[0], TALL[1], process=False)
    made.export(tmp_path / "body.ply")
    assert np.ptp(read_scan(tmp_path / "body.ply", file_unit="mm").vertices[:, 2]) == pytest.approx(
        1.7, abs=1e-6
    )
    trimesh.Trimesh(*TALL, process=False).export(tmp_path / "body.glb")
    scan = read_scan(tmp_path / "body.glb")
    assert np.ptp(scan.vertices[:, 2]) == pytest.approx(1.7, abs=1e-6)
    assert scan.file_unit == "m"


def test_parts_of_a_scene_are_at_their_places(tmp_path: Path) -> None:
    lower, upper = ellipsoid((0, 0, 0), (0.3, 0.2, 0.5)), ellipsoid((0, 0, 0), (0.2, 0.2, 0.5))
    scene: Any = trimesh.Scene()
    place = np.eye(4)
    scene.add_geometry(trimesh.Trimesh(*lower, process=False), transform=place)
    place = np.diag([-1.0, 1.0, 1.2, 1.0])
    place[2, 3] = 1.0
    scene.add_geometry(trimesh.Trimesh(*upper, process=False), transform=place)
    scene.export(tmp_path / "scene.glb")
    scan = read_scan(tmp_path / "scene.glb")
    assert scan.vertices[:, 2].min() == pytest.approx(-0.5)
    assert scan.vertices[:, 2].max() == pytest.approx(1.6)
    assert _closed(scan) == pytest.approx(volume(lower) + 1.2 * volume(upper), rel=1e-6)


def test_polygons_are_cut_into_triangles(tmp_path: Path) -> None:
    path = tmp_path / "polygons.obj"
    path.write_text(
        "v 0 0 0\nv 1 0 0\nv 1 0 2\nv 0 0 2\nv -0.2 0.1 1\nv 0.5 0.9 1\n"
        "f 5 4 3 2 1\nf 1 2 6\nf 2/1 3/1 6/1\nf -3 -2 -1\nf 5 1 6\nf 3 4 6\n"
    )
    scan = read_scan(path, file_unit="m")
    assert len(scan.triangles) == 3 + 5
    assert "Cut 1 polygon into triangles." in scan.notes
    assert _closed(scan) > 0.0


@pytest.mark.parametrize("order", ["<", ">"])
def test_binary_ply_files_may_have_polygons_of_several_sizes(tmp_path: Path, order: str) -> None:
    vertices, triangles = TALL
    # The first two triangles of the second ring are one quad; colors stand before and after.
    quad = (*triangles[2], triangles[3][2])
    faces = [tuple(face) for face in triangles[[0, 1]].tolist()] + [quad]
    faces += [tuple(face) for face in triangles[4:].tolist()]
    name = {"<": "little", ">": "big"}[order]
    header = (
        f"ply\nformat binary_{name}_endian 1.0\nelement vertex {len(vertices)}\n"
        "property double x\nproperty double y\nproperty double z\nproperty uchar red\n"
        f"element face {len(faces)}\nproperty short group\n"
        "property list uchar int vertex_indices\nend_header\n"
    )
    content = header.encode()
    content += b"".join(struct.pack(f"{order}3dB", *row, 7) for row in vertices.tolist())
    for face in faces:
        content += struct.pack(f"{order}hB{len(face)}i", -1, len(face), *face)
    path = tmp_path / "mixed.ply"
    path.write_bytes(content)
    scan = read_scan(path, file_unit="m")
    assert scan.notes[0] == "Cut 1 polygon into triangles."
    assert _closed(scan) == pytest.approx(volume(TALL), rel=1e-6)
