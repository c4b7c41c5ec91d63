import math
import sys
from typing import Any

import numpy as np
import pytest
from helpers.surfaces.grids import grid_atlas
from helpers.surfaces.surfaces import PARABOLOID
from scipy.integrate import dblquad

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, Tessellation, Unit, tessellate
from bodymeasure.bezier import evaluate
from bodymeasure.errors import InputError, MissingExtraError


def edge_uses(faces: Ints) -> Ints:
    edges = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
    return np.unique(edges, axis=0, return_counts=True)[1]


def euler_characteristic(mesh: Tessellation) -> int:
    return len(mesh.vertices) - len(edge_uses(mesh.faces)) + len(mesh.faces)


def areas(mesh: Tessellation) -> Array:
    a, b, c = np.moveaxis(mesh.vertices[mesh.faces], 1, 0)
    return np.asarray(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=-1))


def torus(rows: int, columns: int) -> Atlas:
    """Patches that close in both directions, like a torus that is only roughly round."""
    i, j = np.meshgrid(np.arange(3 * rows), np.arange(3 * columns), indexing="ij")
    a, b = 2 * np.pi * i / (3 * rows), 2 * np.pi * j / (3 * columns)
    points = np.stack(
        [(3 + np.cos(b)) * np.cos(a), (3 + np.cos(b)) * np.sin(a), np.sin(b)], axis=-1
    )
    numbers = np.arange(i.size).reshape(i.shape)
    ring_u = (3 * np.arange(rows)[:, None] + np.arange(4)) % (3 * rows)
    ring_v = (3 * np.arange(columns)[:, None] + np.arange(4)) % (3 * columns)
    index = numbers[ring_u[:, None, :, None], ring_v[None, :, None, :]].reshape(-1, 4, 4)
    return Atlas(points.reshape(-1, 3), index, Unit.CM)


@pytest.fixture
def bumpy() -> Atlas:
    """Six patches in a grid, two of which are turned around, so that seams run both ways."""
    atlas = grid_atlas(2, 3, lambda x, y: np.stack([x, y, np.sin(2 * x + y * y)], axis=-1))
    index = atlas.index.copy()
    index[1] = np.rot90(index[1])
    index[4] = index[4, ::-1].T
    return Atlas(atlas.points, index, Unit.CM)


@pytest.mark.parametrize("segments", [1, 2, 5])
def test_a_disc_is_welded_into_one_piece(bumpy: Atlas, segments: int) -> None:
    mesh = tessellate(bumpy, segments)
    assert len(mesh.vertices) == (2 * segments + 1) * (3 * segments + 1)
    assert len(mesh.faces) == 6 * 2 * segments**2
    assert euler_characteristic(mesh) == 1
    uses = edge_uses(mesh.faces)
    assert uses.max() == 2
    assert np.count_nonzero(uses == 1) == 2 * (2 + 3) * segments


@pytest.mark.parametrize("segments", [1, 4])
def test_a_torus_is_closed(segments: int) -> None:
    mesh = tessellate(torus(3, 4), segments)
    assert euler_characteristic(mesh) == 0
    assert np.all(edge_uses(mesh.faces) == 2)


def test_vertices_are_never_welded_by_distance() -> None:
    net = grid_atlas(1, 1).control_points[0]
    mesh = tessellate(Atlas.from_control_points(np.stack([net, net]), Unit.CM), 3)
    assert len(mesh.vertices) == 2 * 4**2


def test_patch_and_parameters_give_the_vertex(bumpy: Atlas) -> None:
    mesh = tessellate(bumpy, 4)
    positions = evaluate(bumpy.control_points[mesh.patch], mesh.parameters)
    np.testing.assert_array_equal(positions, mesh.vertices)
    assert mesh.parameters.min() == 0.0
    assert mesh.parameters.max() == 1.0


def test_faces_lie_on_their_patch_and_face_its_way(bumpy: Atlas) -> None:
    mesh = tessellate(bumpy, 4)
    for patch, net in enumerate(bumpy.control_points):
        faces = mesh.faces[mesh.face_patch == patch]
        grid = np.stack(np.meshgrid(*2 * [np.arange(5) / 4], indexing="ij"), axis=-1).reshape(-1, 2)
        positions = evaluate(net, grid)
        # Find the corners on this patch, since a neighbor may own the vertices of a seam.
        apart = np.linalg.norm(mesh.vertices[faces][..., None, :] - positions, axis=-1)
        assert apart.min(axis=-1).max() < 1e-14
        uv = grid[apart.argmin(axis=-1)]
        first, second = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
        turn = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
        np.testing.assert_allclose(turn, 1 / 16, rtol=1e-12)


def test_the_area_converges_with_the_square_of_the_step() -> None:
    area = dblquad(lambda u, v: math.sqrt(1 + 4 * u**2 + 4 * v**2), 0, 1, 0, 1, epsabs=1e-12)[0]
    atlas = Atlas.from_control_points(PARABOLOID, Unit.CM)
    segments = np.array([8, 16, 32, 64])
    errors = [area - areas(tessellate(atlas, int(n))).sum() for n in segments]
    rate = np.polyfit(np.log(1 / segments), np.log(np.abs(errors)), 1)[0]
    assert rate == pytest.approx(2.0, abs=0.02)


def test_a_collapsed_edge_becomes_one_vertex() -> None:
    atlas = grid_atlas(1, 2)
    index = atlas.index.copy()
    index[:, 0, :] = index[0, 0, 0]
    segments = 3
    mesh = tessellate(Atlas(atlas.points, index, Unit.CM), segments)
    assert areas(mesh).min() > 1e-3
    assert euler_characteristic(mesh) == 1
    assert len(mesh.faces) == 2 * (2 * segments**2 - segments)


def test_trimesh_carries_the_parameters(bumpy: Atlas) -> None:
    trimesh = pytest.importorskip("trimesh")
    mesh = tessellate(bumpy, 3)
    exported = mesh.to_trimesh()
    assert isinstance(exported, trimesh.Trimesh)
    np.testing.assert_array_equal(exported.vertices, mesh.vertices)
    np.testing.assert_array_equal(exported.faces, mesh.faces)
    attributes = exported.vertex_attributes
    np.testing.assert_array_equal(attributes["patch"], mesh.patch)
    np.testing.assert_array_equal(attributes["u"], mesh.parameters[:, 0])
    np.testing.assert_array_equal(attributes["v"], mesh.parameters[:, 1])


def test_without_trimesh_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "trimesh", None)
    mesh = tessellate(grid_atlas(1, 1), 1)
    with pytest.raises(MissingExtraError, match=r"bodymeasure\[oracle\]"):
        mesh.to_trimesh()


@pytest.mark.parametrize("segments", [0, -3, 2.5, "4"])
def test_no_segments_are_refused(segments: Any) -> None:
    with pytest.raises(InputError, match=rf"segments is {segments}; expected at least 1"):
        tessellate(grid_atlas(1, 1), segments)


@pytest.mark.parametrize("segments", [1, 3])
def test_faces_know_where_on_their_own_patch_they_lie(bumpy: Atlas, segments: int) -> None:
    mesh = tessellate(bumpy, segments)
    there = evaluate(bumpy.control_points[mesh.face_patch], mesh.face_parameters)
    np.testing.assert_allclose(there, mesh.vertices[mesh.faces], atol=1e-14)
