"""MakeHuman's base mesh: the map is exact, for all of it, its body alone and Anny's part of it."""

from functools import cache
from pathlib import Path

import igl
import numpy as np
import pytest

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError
from bodymeasure.fit.model import body_model, limit_matrix
from bodymeasure.fit.topology import (
    Topology,
    known_topology,
    mapped_vertices,
    polygons_of,
    read_polygons,
    recognized,
)
from bodymeasure.fit.topology.hm08 import ANNY_LACKS, smoothed_vertices

# The samples' vertices are those of MakeHuman to this, in meters.
EXACT = 1e-6


def test_what_is_smoothed_does_not_matter() -> None:
    model = body_model()
    topology = _topology(*_body())
    spoiled = model.mean.copy()
    spoiled[smoothed_vertices()] += 0.1
    assert len(smoothed_vertices()) == 244
    assert np.abs(mapped_vertices(spoiled, topology) - model.mean).max() < EXACT


def test_any_axes_and_unit_are_kept() -> None:
    topology = _topology(*_body())
    turned = 10.0 * body_model().mean[:, [0, 2, 1]] * [1.0, 1.0, -1.0] + [3.0, 5.0, -7.0]
    assert np.abs(mapped_vertices(turned, topology) - turned).max() < 10.0 * EXACT


def test_helper_geometry_after_the_body_is_left_out() -> None:
    vertices, quads = _body()
    count = len(vertices)
    helpers = np.array([[0, 1, 2, 3], [4, 5, 6, 7]]) + count
    more = np.concatenate([vertices, np.random.default_rng(1).normal(size=(8, 3))])
    topology = _topology(more, np.concatenate([quads, helpers]))
    assert topology.count == count
    assert np.abs(mapped_vertices(more, topology) - vertices).max() < EXACT


def test_the_part_that_anny_has_lacks_vertices_that_are_smoothed() -> None:
    vertices, quads = _body()
    kept = np.setdiff1d(np.arange(len(vertices)), ANNY_LACKS)
    number = np.full(len(vertices), -1)
    number[kept] = np.arange(len(kept))
    left = number[quads[~np.isin(quads, ANNY_LACKS).any(axis=1)]]
    topology = _topology(vertices[kept], left)
    assert np.isin(ANNY_LACKS, smoothed_vertices()).all()
    assert topology.count == len(vertices) - 32
    assert np.abs(mapped_vertices(vertices[kept], topology) - vertices).max() < EXACT


@pytest.mark.parametrize("diagonal", [0, 1])
def test_quads_are_recognized_however_they_are_cut(diagonal: int) -> None:
    vertices, quads = _body()
    turned = np.roll(quads, diagonal, axis=1)
    cut = np.concatenate([turned[:, [0, 1, 2]], turned[:, [0, 2, 3]]])
    shuffled = np.random.default_rng(2).permutation(cut)
    assert _topology(vertices, shuffled).name == "hm08"


def test_another_order_of_vertices_is_not_recognized() -> None:
    vertices, quads = _body()
    order = np.arange(len(vertices))
    order[[100, 5000]] = order[[5000, 100]]
    assert recognized(polygons_of(vertices, order[quads])) is None


def test_a_name_refuses_a_mesh_of_another_topology() -> None:
    square = polygons_of(np.eye(4, 3), [[0, 1, 2, 3]])
    with pytest.raises(InputError, match=r"is not of the topology 'hm08': it has 4 vertices"):
        known_topology("hm08", square, "square.obj")
    with pytest.raises(InputError, match="there is no topology 'smpl'; expected one of 'hm08'"):
        known_topology("smpl", square, "square.obj")


def test_the_surface_may_be_close_to_the_faces() -> None:
    """The control mesh is outside of its surface; the closest surface lies on both sides."""
    vertices, quads = _body()
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    covered = np.unique(quads[body_model().covered])
    rms = {}
    for name in ("hm08", "hm08 faces"):
        topology = known_topology(name, polygons_of(vertices, quads), "body")
        points = (limit_matrix() @ mapped_vertices(vertices, topology))[covered]
        squares = igl.point_mesh_squared_distance(points, vertices, triangles)[0]
        rms[name] = np.sqrt(squares.mean())
    assert rms["hm08"] > 0.5e-3 > 0.4e-3 > rms["hm08 faces"]


def test_a_file_keeps_the_numbers_of_its_vertices(tmp_path: Path) -> None:
    """Texture coordinates split vertices in other readers, and welding joins them."""
    file = tmp_path / "body.obj"
    vertices, quads = _body()
    lines = [f"v {x} {y} {z}" for x, y, z in vertices.tolist()]
    lines += ["vt 0 0", "vt 1 0", "vt 1 1", "vt 0 1"]
    lines += [f"f {a}/1 {b}/2 {c}/3 {d}/4" for a, b, c, d in (quads + 1).tolist()]
    file.write_text("\n".join(lines), encoding="utf-8")
    mesh = read_polygons(file)
    found = recognized(mesh)
    assert found is not None
    assert np.abs(mapped_vertices(mesh.vertices, found) - vertices).max() < EXACT


def test_files_that_do_not_number_vertices_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="do not keep the numbers of vertices"):
        read_polygons(tmp_path / "body.stl")


@cache
def _body() -> tuple[Array, Ints]:
    return body_model().mean, body_model().quads


def _topology(vertices: Array, faces: Ints) -> Topology:
    found = recognized(polygons_of(vertices, faces))
    assert found is not None
    return found
