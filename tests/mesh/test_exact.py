"""Exact paths over meshes against closed forms, libigl's distances and one another."""

import numpy as np
import pytest
from scipy.spatial import ConvexHull
from scipy.stats import special_ortho_group

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.mesh.arrays import TriangleMesh
from bodymeasure.mesh.exact import exact_path, length_of
from bodymeasure.oracle import libigl

pytest.importorskip("igl")


def hull(points: Array) -> TriangleMesh:
    """The convex hull of points about 0, its faces oriented outwards."""
    faces = ConvexHull(points).simplices.astype(np.int64)
    a, b, c = points[faces].transpose(1, 0, 2)
    inward = (np.cross(b - a, c - a) * a).sum(axis=1) < 0.0
    faces[inward] = faces[inward, ::-1]
    return TriangleMesh(points, faces)


def field(side: int, heights: Array) -> TriangleMesh:
    """Heights over the unit square, as a mesh of side x side cells."""
    ticks = np.linspace(0.0, 1.0, side + 1)
    x, y = np.meshgrid(ticks, ticks, indexing="ij")
    number = np.arange((side + 1) ** 2).reshape(side + 1, side + 1)
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    faces = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)
    return TriangleMesh(np.stack([x.ravel(), y.ravel(), heights], axis=-1), faces)


@pytest.mark.parametrize("sides", [(1.0, 1.0, 1.0), (1.0, 2.0, 3.0), (0.01, 1.0, 4.0)])
def test_a_path_over_a_box_is_straight_in_its_net(sides: tuple[float, float, float]) -> None:
    signs = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    box = hull(0.5 * signs * sides)
    least, middle, most = sides
    path = exact_path(box, 0, 7)
    assert length_of(path) == pytest.approx(np.hypot(most, least + middle), rel=1e-13)
    np.testing.assert_allclose(path[[0, -1]], box.vertices[[0, 7]])


def test_a_path_into_a_notch_bends_about_its_corner() -> None:
    # An L of three unit squares, around whose inner corner the path leads.
    vertices = [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1), (0, 2), (1, 2)]
    cells = [(0, 1, 4, 3), (1, 2, 5, 4), (3, 4, 7, 6)]
    faces = [face for a, b, c, d in cells for face in ((a, b, c), (a, c, d))]
    path = exact_path(TriangleMesh(np.c_[vertices, np.zeros(8)], np.array(faces)), 5, 7)
    np.testing.assert_allclose(path, [(2, 1, 0), (1, 1, 0), (1, 2, 0)], atol=1e-15)


@pytest.mark.parametrize("seed", range(3))
def test_paths_are_as_short_as_exact_distances_from_both_ends_and_in_every_position(
    seed: int,
) -> None:
    rng = np.random.default_rng(seed)
    balls = rng.normal(size=(150, 3))
    balls /= np.linalg.norm(balls, axis=1, keepdims=True)
    # On rough fields, what is left near a path hangs together by single vertices, too.
    meshes = [
        hull(balls),
        hull(balls * (1.0, 1.0, 0.02)),
        field(14, rng.uniform(0.0, 0.3, 225)),
        field(14, 0.15 * np.sin(9.0 * np.arange(225) / 14.0)),
    ]
    for vertices, faces in meshes:
        turned = TriangleMesh(vertices @ special_ortho_group.rvs(3, random_state=rng), faces)
        for _ in range(6):
            first, last = (int(end) for end in rng.choice(len(vertices), 2, replace=False))
            path = exact_path(TriangleMesh(vertices, faces), first, last)
            length = length_of(path)
            known = libigl.exact_distance(vertices, faces, first, last)
            assert length == pytest.approx(known, rel=1e-9)
            back = exact_path(turned, last, first)
            assert length_of(back) == pytest.approx(length, rel=1e-9)
            np.testing.assert_array_equal(path[0], vertices[first])
            np.testing.assert_allclose(path[-1], vertices[last], atol=1e-14)


def test_paths_agree_with_another_implementation() -> None:
    other = pytest.importorskip("pygeodesic.geodesic")
    rng = np.random.default_rng(5)
    mesh = bm.load_sample("female_average").to_trimesh(2)
    solver = other.PyGeodesicAlgorithmExact(mesh.vertices, mesh.faces)
    vertices, faces = np.asarray(mesh.vertices), np.asarray(mesh.faces)
    for _ in range(6):
        first, last = (int(end) for end in rng.choice(np.unique(faces), 2, replace=False))
        length = length_of(exact_path(TriangleMesh(vertices, faces), first, last))
        assert length == pytest.approx(solver.geodesicDistance(first, last)[0], rel=1e-9)


def test_what_is_known_of_distances_concerns_the_work_only(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    heights = np.random.default_rng(2).uniform(0.0, 0.2, 121)
    mesh = field(10, heights)
    known = exact_path(mesh, 0, 120)
    monkeypatch.setattr("bodymeasure.mesh.exact.BESIDE", 0.0)
    assert length_of(exact_path(mesh, 0, 120)) == pytest.approx(length_of(known), rel=1e-13)


def test_a_search_that_runs_out_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("bodymeasure.mesh.legs.MOST_CONES", 3)
    mesh = field(10, np.random.default_rng(2).uniform(0.0, 0.2, 121))
    with pytest.raises(bm.InputError, match=r"as short as the exact distance"):
        exact_path(mesh, 0, 120)


def test_without_libigl_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(libigl, "find_spec", lambda _: None)
    with pytest.raises(bm.errors.MissingExtraError, match=r"libigl.*bodymeasure\[oracle\]"):
        bm.measure_mesh(field(1, np.zeros(4)), 0, 3)
