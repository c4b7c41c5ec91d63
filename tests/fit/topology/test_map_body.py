"""Whole bodies by their topology: the public functions."""

from dataclasses import replace
from pathlib import Path

import igl
import numpy as np
import pytest
from helpers.bodies_in_poses import body_in_pose
from helpers.foreign_body import foreign_triangles, foreign_vertices
from scipy.spatial import cKDTree

import bodymeasure as bm
from bodymeasure.extremities.places import HANDS, places
from bodymeasure.fit.model import body_model, limit_matrix, shaped
from bodymeasure.fit.topology import polygons_of, topology_of_fit


@pytest.mark.slow
def test_hm08_is_recognized_and_not_fitted(tmp_path: Path) -> None:
    vertices = body_in_pose(5)[0]
    file = tmp_path / "anna.obj"
    lines = [f"v {100 * x} {100 * z} {-100 * y}" for x, y, z in vertices.tolist()]
    lines += [f"f {a} {b} {c} {d}" for a, b, c, d in (body_model().quads + 1).tolist()]
    file.write_text("\n".join(lines), encoding="utf-8")
    body = bm.fit_body(file, file_unit="cm")
    again = bm.map_body((vertices, body_model().quads), "hm08", file_unit="m", name="anna")
    assert body.atlas.name == "anna"
    assert "mapped from anna" in body.atlas.provenance["source"]
    assert np.abs(body.vertices - again.vertices).max() < 1e-6
    assert body.atlas.scan is not None
    assert body.atlas.scan.done[0].startswith("Mapped exactly")
    # The wearer's left is left.
    sides = [
        body.atlas.position(body.atlas.landmarks[f"bust point {side}"])
        for side in ("left", "right")
    ]
    assert sides[0][0] > 0.03 > -0.03 > sides[1][0]


@pytest.mark.slow
def test_a_stored_topology_maps_other_bodies(tmp_path: Path) -> None:
    file = tmp_path / "model.npz"
    mean = (limit_matrix() @ body_model().mean, body_model().quads)
    rest = bm.map_body(mean, "hm08 faces", file_unit="m")
    model = (foreign_vertices(rest.vertices), foreign_triangles())
    # The rest body stands where it was put, so that its file's frame is the atlas's.
    at_home = replace(rest, transform=np.eye(4))
    bm.save_topology(file, model, at_home, name="dual")
    vertices, coefficients, _ = body_in_pose(6)
    body = bm.map_body((1000.0 * foreign_vertices(vertices), model[1]), file, file_unit="mm")
    assert body.atlas.scan is not None
    assert "'dual'" in body.atlas.scan.done[0]
    # Facets of 2 cm leave the surface by some tenths of a millimeter.
    assert 0.1e-3 < body.scores.rms < 0.5e-3
    stature = np.ptp((limit_matrix() @ shaped(coefficients))[:, 2])
    assert abs(body.scores.stature - stature) < 0.02


@pytest.mark.slow
def test_the_distance_from_the_faces_is_that_of_libigl() -> None:
    quads = body_model().quads
    body = bm.map_body((body_in_pose(2)[0], quads), "hm08 faces", file_unit="m")
    points = bm.tessellate(body.atlas, 5).vertices
    squares = igl.point_mesh_squared_distance(points, body.scan.vertices, body.scan.triangles)[0]
    scan = body.atlas.scan
    assert scan is not None
    assert scan.rms == pytest.approx(np.sqrt(squares.mean()), rel=0.1)
    assert len(set(scan.distance.tolist())) == len(body.atlas)
    # Lengths of the head are no surer than the surface.
    assert body.atlas.given["head_girth"].uncertainty > 0.3e-3


@pytest.mark.slow
def test_a_hand_that_the_mesh_lacks_has_no_length() -> None:
    """A stored correspondence gives points there, too, by the affine map of the wrist."""
    mean = body_model().mean
    vertices, triangles = foreign_vertices(mean), foreign_triangles()
    region = places().region[cKDTree(mean).query(vertices)[1]]
    hand = np.isin(region, HANDS["left"])[triangles].any(axis=1)
    mesh = polygons_of(vertices, triangles[~hand])
    topology = topology_of_fit(mesh, vertices, mean, "one hand")
    body = bm.map_body((vertices, triangles[~hand]), topology, file_unit="m")
    given = body.atlas.given
    assert "hand_length_right" in given
    assert not [key for key in given if key.startswith(("hand", "palm")) and key.endswith("_left")]
    assert np.isnan(body.distance[np.isin(places().region, HANDS["left"])]).mean() > 0.9


@pytest.mark.slow
def test_a_mapped_body_has_what_a_fit_has_besides() -> None:
    mesh = (body_in_pose(5)[0], body_model().quads)
    mapped, fitted = bm.map_body(mesh, file_unit="m"), bm.fit_body(mesh, file_unit="m")
    assert mapped.atlas.given["stature"] == fitted.atlas.given["stature"]
    assert mapped.atlas.landmarks == fitted.atlas.landmarks


def test_what_cannot_be_mapped_is_refused(tmp_path: Path) -> None:
    square = (np.eye(4, 3), [[0, 1, 2, 3]])
    with pytest.raises(bm.InputError, match="is of no topology that is known"):
        bm.map_body(square, file_unit="m")
    with pytest.raises(bm.InputError, match="a mesh says no unit"):
        bm.map_body(square)
    with pytest.raises(bm.InputError, match=r"model\.npz: no such file"):
        bm.map_body(square, tmp_path / "model.npz", file_unit="m")
    with pytest.raises(bm.InputError, match="no landmarks: leave the topology out"):
        bm.fit_body(square, file_unit="m", topology="hm08", landmarks={})


def test_wrong_arguments_are_named() -> None:
    vertices, quads = body_model().mean, body_model().quads
    ragged = [[0, 1, 2], [0, 1, 2, 3]]
    with pytest.raises(bm.InputError, match=r"the faces is .*; expected whole numbers of vertices"):
        bm.map_body((vertices, ragged), file_unit="m")
    with pytest.raises(bm.InputError, match=r"the triangles is .*; expected whole numbers"):
        bm.fit_body((vertices, ragged), file_unit="m")
    with pytest.raises(bm.InputError, match="up is 'z'; expected one of"):
        bm.map_body((vertices, quads), file_unit="m", up="z")


def test_a_folder_does_not_hide_a_topology_of_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    Path(tmp_path, "hm08").mkdir()
    monkeypatch.chdir(tmp_path)
    with pytest.raises(bm.InputError, match="is not of the topology 'hm08'"):
        bm.map_body((np.eye(4, 3), [[0, 1, 2, 3]]), "hm08", file_unit="m")
