"""Correspondences made from one fit, for bodies of a topology that is not ours, and their files."""

from functools import cache
from pathlib import Path
from typing import Any

import igl
import numpy as np
import pytest
from helpers.bodies_in_poses import body_in_pose
from helpers.foreign_body import foreign_triangles, foreign_vertices
from helpers.speed import quick

from bodymeasure._typing import Array
from bodymeasure.atlas import tessellate
from bodymeasure.errors import FitError, InputError
from bodymeasure.fit.model import atlas_of_vertices, body_model
from bodymeasure.fit.topology import (
    Polygons,
    Topology,
    mapped_vertices,
    polygons_of,
    read_topology,
    require,
    topology_of_fit,
    write_topology,
)


@pytest.mark.parametrize("number", quick([0, 1, 2]))
def test_other_bodies_lie_on_their_meshes(number: int) -> None:
    """The facets are chords of 2 cm that lie up to 2 mm within the surface."""
    exact = body_in_pose(number)[0]
    mesh = foreign_vertices(exact)
    found = atlas_of_vertices(mapped_vertices(mesh, _topology()))
    points = tessellate(found, 4).vertices
    squares = igl.point_mesh_squared_distance(points, mesh, foreign_triangles())[0]
    assert np.sqrt(squares.mean()) < 0.4e-3
    # Places correspond, too, not only surfaces.
    apart = points - tessellate(atlas_of_vertices(exact), 4).vertices
    assert np.sqrt((apart**2).sum(axis=1).mean()) < 0.6e-3


def test_the_fit_itself_comes_back() -> None:
    again = mapped_vertices(foreign_vertices(body_model().mean), _topology())
    assert np.sqrt(((again - body_model().mean) ** 2).sum(axis=1).mean()) < 0.6e-3


def test_regions_without_surface_are_carried_by_their_rim() -> None:
    """Within a hole of the mesh, the points turn and grow with what is about it."""
    mean = body_model().mean
    mesh = _mesh(foreign_vertices(mean))
    crown = mean[mean[:, 2].argmax()]
    away = np.linalg.norm(mesh.vertices[mesh.triangles] - crown, axis=2).min(axis=1)
    cut = polygons_of(mesh.vertices, mesh.triangles[away > 0.06])
    topology = topology_of_fit(cut, cut.vertices, mean, "without a crown")
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    found = mapped_vertices(1.1 * mesh.vertices @ turn.T, topology)
    within = np.linalg.norm(mean - crown, axis=1) < 0.06
    assert np.linalg.norm(found - 1.1 * mean @ turn.T, axis=1)[within].max() < 2e-3


def test_a_part_of_a_body_makes_no_topology() -> None:
    mesh = _mesh(foreign_vertices(body_model().mean))
    upper = mesh.vertices[mesh.triangles][:, :, 2].min(axis=1) > 0.9
    bust = polygons_of(mesh.vertices, mesh.triangles[upper])
    with pytest.raises(FitError, match="of the fitted body lies on the mesh; expected 97 %"):
        topology_of_fit(bust, bust.vertices, body_model().mean, "bust")


def test_a_file_holds_the_same_map(tmp_path: Path) -> None:
    file = tmp_path / "foreign.npz"
    write_topology(file, _topology())
    again = read_topology(file)
    mesh = foreign_vertices(body_in_pose(3)[0])
    assert (again.name, again.gives) == ("foreign", _topology().gives)
    assert np.array_equal(mapped_vertices(mesh, again), mapped_vertices(mesh, _topology()))
    require(_mesh(mesh), again, "body")


def test_another_mesh_of_as_many_vertices_is_refused() -> None:
    mesh = foreign_vertices(body_model().mean)
    other = polygons_of(mesh, (foreign_triangles() + 5) % len(mesh))
    with pytest.raises(InputError, match=r"body\.ply: is not of the topology 'foreign'"):
        require(other, _topology(), "body.ply")


@pytest.mark.parametrize(
    ("name", "spoil", "message"),
    [
        ("weights", lambda values: values[:3], "have shapes"),
        ("weights", lambda values: 2.0 * values, "do not add up to 1"),
        ("weights", lambda values: np.nan * values, "do not add up to 1"),
        ("edges", lambda values: values[:0], "edges have shape"),
        ("indices", lambda values: values + 10**6, "refers to vertices beyond"),
        ("indptr", lambda values: values[::-1], "rows of the map do not follow"),
        ("header", lambda _: np.array("{}"), "its header is wrong"),
        ("header", lambda values: np.array(str(values).replace(":1,", ":2,")), "version 2"),
        ("more", lambda _: np.ones(3), "expected the arrays header, edges, indptr, indices"),
    ],
)
def test_damaged_files_are_refused(tmp_path: Path, name: str, spoil: Any, message: str) -> None:
    file = tmp_path / "foreign.npz"
    write_topology(file, _topology())
    with np.load(file) as data:
        arrays = {each: data[each] for each in data.files}
    arrays[name] = spoil(arrays.get(name))
    np.savez(file, **arrays)
    with pytest.raises(InputError, match=message):
        read_topology(file)


def test_a_file_that_is_no_archive_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "foreign.npz"
    file.write_bytes(b"no archive")
    with pytest.raises(InputError, match=r"is no \.npz file, or damaged"):
        read_topology(file)
    with pytest.raises(InputError, match=r"ends in \.npz"):
        write_topology(tmp_path / "foreign.json", _topology())
    assert [each.name for each in tmp_path.iterdir()] == ["foreign.npz"]


@cache
def _topology() -> Topology:
    mean = body_model().mean
    mesh = _mesh(foreign_vertices(mean))
    return topology_of_fit(mesh, mesh.vertices, mean, "foreign")


def _mesh(vertices: Array) -> Polygons:
    return polygons_of(vertices, foreign_triangles())
