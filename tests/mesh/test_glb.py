"""GLB files of bodies with paths."""

from pathlib import Path

import numpy as np
import pytest

import bodymeasure as bm
from bodymeasure.mesh.tubes import tube_surface

trimesh = pytest.importorskip("trimesh")


def test_a_body_with_a_path_is_in_meters_with_y_upwards(tmp_path: Path) -> None:
    body = bm.load_sample("female_average").converted("cm")
    start, end = (body.position(body.landmarks[f"bust point {side}"]) for side in ("left", "right"))
    line = np.linspace(start, end, 5)
    bm.write_glb(tmp_path / "body.glb", body, {"bust span": line}, segments=2)
    scene = trimesh.load(tmp_path / "body.glb")
    assert set(scene.geometry) == {body.name, "bust span"}
    # In GLB files left is +x, up is +y and the front is +z.
    low, high = scene.geometry[body.name].bounds
    np.testing.assert_allclose([low[1], high[1]], np.array([0.1136, 1.4372]), atol=0.01)
    np.testing.assert_allclose(high[0], -low[0], atol=1e-3)
    tube = scene.geometry["bust span"]
    np.testing.assert_allclose(tube.centroid, [0.0, start[2] / 100, -start[1] / 100], atol=1e-4)
    assert np.ptp(tube.vertices[:, 0]) == pytest.approx(np.linalg.norm(end - start) / 100, rel=1e-6)


def test_the_length_of_a_path_goes_along(tmp_path: Path) -> None:
    pytest.importorskip("igl")
    body = bm.load_sample("female_average")
    neck, bust = (body.landmarks[name] for name in ("back neck point", "bust point left"))
    path = bm.geodesic_between(body, neck, bust)
    bm.write_glb(tmp_path / "body.glb", body, {"neck to bust": path}, segments=1)
    facts = trimesh.load(tmp_path / "body.glb").geometry["neck to bust"].metadata
    assert facts["length"] == path.length
    assert facts["unit"] == "m"


def test_a_path_is_trimeshs_too(tmp_path: Path) -> None:
    pytest.importorskip("igl")
    body = bm.load_sample("female_average")
    neck, bust = (body.landmarks[name] for name in ("back neck point", "bust point left"))
    path = bm.geodesic_between(body, neck, bust)
    line = bm.path_to_trimesh(path)
    # Chords of the smooth path are a little shorter than it.
    assert line.length == pytest.approx(path.length, rel=1e-5)
    assert line.length < path.length
    assert line.metadata["length"] == path.length
    trimesh.Scene([body.to_trimesh(1), line]).export(tmp_path / "both.glb")
    assert len(trimesh.load(tmp_path / "both.glb").geometry) == 2
    with pytest.raises(bm.InputError, match=r"path given is no path"):
        bm.path_to_trimesh([[0.0, 1.0]])


def test_a_path_in_another_unit_is_refused(tmp_path: Path) -> None:
    pytest.importorskip("igl")
    body = bm.load_sample("paraboloid")
    path = bm.geodesic_between(body, bm.AtlasPoint(0, 0.1, 0.2), bm.AtlasPoint(0, 0.8, 0.9))
    with pytest.raises(bm.InputError, match=r"path 'p' is in \w+, but inch is expected"):
        bm.write_glb(tmp_path / "p.glb", body.converted("inch"), {"p": path})


@pytest.mark.parametrize(
    ("name", "paths", "message"),
    [
        ("body.gltf", {}, r"body\.gltf: expected a name that ends in \.glb"),
        ("body.glb", {"waist": [[0.0, 0.0]]}, r"path 'waist' is no path"),
        ("body.glb", {"waist": [[0.0, 0.0, np.nan]]}, r"path 'waist' is no path"),
        ("body.glb", {"waist": "round"}, r"path 'waist' is no path"),
    ],
)
def test_nothing_is_written_of_what_is_wrong(
    tmp_path: Path, name: str, paths: dict[str, object], message: str
) -> None:
    with pytest.raises(bm.InputError, match=message):
        bm.write_glb(tmp_path / name, bm.load_sample("paraboloid"), paths)  # type: ignore[arg-type]
    assert not list(tmp_path.iterdir())


def test_a_mesh_of_an_atlas_knows_where_its_vertices_are() -> None:
    body = bm.load_sample("paraboloid")
    mesh = body.to_trimesh(5)
    attributes = {name: np.asarray(values) for name, values in mesh.vertex_attributes.items()}
    for row in (0, 17, 35):
        point = bm.AtlasPoint(
            int(attributes["patch"][row]), float(attributes["u"][row]), float(attributes["v"][row])
        )
        np.testing.assert_allclose(mesh.vertices[row], body.position(point), atol=1e-12)


def test_a_tube_keeps_its_radius_where_its_path_goes_back() -> None:
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 0, 0], [0, 2, 0]])
    vertices, _, _ = tube_surface(points, 0.1)
    rings = vertices.reshape(len(points), -1, 3)
    away = np.linalg.norm(rings - points[:, None], axis=-1)
    np.testing.assert_allclose(away, 0.1, rtol=1e-12)
