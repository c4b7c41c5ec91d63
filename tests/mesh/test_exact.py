"""Exact paths over meshes against closed forms, libigl's distances and one another."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.spatial import ConvexHull, Delaunay
from scipy.stats import special_ortho_group

import bodymeasure as bm
from bodymeasure._typing import Array, Ints
from bodymeasure.mesh.arrays import TriangleMesh
from bodymeasure.mesh.coarseness import length_of
from bodymeasure.mesh.exact import MeshPoint, exact_path
from bodymeasure.oracle import libigl


def between(mesh: TriangleMesh, first: int, last: int) -> float:
    """The length of the path between two vertices."""
    ends = (MeshPoint.at_vertex(mesh, number) for number in (first, last))
    return length_of(exact_path(mesh, *ends))


def hull(points: Array) -> TriangleMesh:
    """The convex hull of points about 0, its faces oriented outwards."""
    return TriangleMesh(points, oriented(points, ConvexHull(points).simplices.astype(np.int64)))


def oriented(points: Array, faces: Ints) -> Ints:
    """Faces about 0, oriented outwards."""
    a, b, c = points[faces].transpose(1, 0, 2)
    inward = (np.cross(b - a, c - a) * a).sum(axis=1) < 0.0
    return np.where(inward[:, None], faces[:, ::-1], faces)


def field(side: int, heights: Array) -> TriangleMesh:
    """Heights over the unit square, as a mesh of side x side cells."""
    ticks = np.linspace(0.0, 1.0, side + 1)
    x, y = np.meshgrid(ticks, ticks, indexing="ij")
    number = np.arange((side + 1) ** 2).reshape(side + 1, side + 1)
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    faces = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)
    return TriangleMesh(np.stack([x.ravel(), y.ravel(), heights], axis=-1), faces)


def cone(spokes: Array) -> TriangleMesh:
    """The triangles between spokes (n, 3) that lead from 0, which is vertex 0."""
    rim = np.arange(1, len(spokes) + 1)
    faces = np.stack([np.zeros_like(rim), rim, np.roll(rim, -1)], axis=1)
    return TriangleMesh(np.vstack([np.zeros(3), spokes]), faces)


def plane(points: Array) -> TriangleMesh:
    """The Delaunay triangles of points (n, 2), without those that have no area."""
    faces = Delaunay(points).simplices.astype(np.int64)
    a, b, c = points[faces].transpose(1, 0, 2)
    area = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    faces = np.where((area < 0.0)[:, None], faces[:, ::-1], faces)
    longest = np.ptp(points[faces], axis=1).max(axis=1)
    return TriangleMesh(np.c_[points, 0.0 * points[:, 0]], faces[np.abs(area) > 1e-13 * longest**2])


def some_place(mesh: TriangleMesh, rng: np.random.Generator) -> MeshPoint:
    """A place within a face, on a side, at a corner or beside one."""
    weights = rng.dirichlet(np.ones(3))
    kind, corner = rng.integers(4), rng.integers(3)
    if kind == 1:
        weights[corner] = 0.0
    elif kind > 1:
        weights *= 0.0 if kind == 2 else 10.0 ** -rng.uniform(5.0, 17.0)
        weights[corner] = 0.0
        weights[corner] = 1.0 - weights.sum()
    return MeshPoint(int(rng.integers(len(mesh.faces))), weights / weights.sum())


@pytest.mark.parametrize("sides", [(1.0, 1.0, 1.0), (1.0, 2.0, 3.0), (0.01, 1.0, 4.0)])
def test_a_path_over_a_box_is_straight_in_its_net(sides: tuple[float, float, float]) -> None:
    signs = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    least, middle, most = sides
    length = between(hull(0.5 * signs * sides), 0, 7)
    assert length == pytest.approx(np.hypot(most, least + middle), rel=1e-14)


def test_a_path_over_an_icosahedron_crosses_the_triangular_lattice() -> None:
    golden = 0.5 * (1.0 + np.sqrt(5.0))
    signs = [(one, other) for one in (-1.0, 1.0) for other in (-1.0, 1.0)]
    corners = np.array([np.roll([0.0, a, golden * b], k) for k in range(3) for a, b in signs])
    corners /= 2.0
    opposite = int(np.argmin(corners @ corners[0]))
    # It leads two edges one way and one another: 2^2 + 2 * 1 + 1^2 = 7.
    assert between(hull(corners), 0, opposite) == pytest.approx(np.sqrt(7.0), rel=1e-14)


@pytest.mark.parametrize("wave", [0.0, 0.4, 1.5])
def test_a_path_over_a_cone_unrolls_it_or_leads_over_its_tip(wave: float) -> None:
    turns = np.arange(24) * np.pi / 12.0
    spokes = np.stack([np.cos(turns), np.sin(turns), 0.6 + wave * np.cos(3.0 * turns)], axis=1)
    spokes /= np.linalg.norm(spokes, axis=1, keepdims=True)
    mesh = cone(spokes)
    steps = 2.0 * np.arcsin(0.5 * np.linalg.norm(spokes - np.roll(spokes, -1, axis=0), axis=1))
    # Between places so close to the tip that the straight way does not come near the rim.
    places = [MeshPoint(face, np.array([0.7, 0.3, 0.0])) for face in range(24)]
    for spoke in range(2, 24):
        angle = min(steps[:spoke].sum(), steps[spoke:].sum())
        known = 0.6 * np.sin(0.5 * min(angle, np.pi))
        length = length_of(exact_path(mesh, places[0], places[spoke]))
        assert length == pytest.approx(known, rel=1e-14)


def test_a_path_into_a_notch_bends_about_its_corner() -> None:
    # An L of three unit squares, around whose inner corner the path leads.
    vertices = [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1), (0, 2), (1, 2)]
    cells = [(0, 1, 4, 3), (1, 2, 5, 4), (3, 4, 7, 6)]
    faces = [face for a, b, c, d in cells for face in ((a, b, c), (a, c, d))]
    mesh = TriangleMesh(np.c_[vertices, np.zeros(8)].astype(float), np.array(faces))
    path = exact_path(mesh, MeshPoint.at_vertex(mesh, 5), MeshPoint.at_vertex(mesh, 7))
    np.testing.assert_allclose(path, [(2, 1, 0), (1, 1, 0), (1, 2, 0)], atol=1e-15)


def test_a_path_leads_through_a_vertex_in_which_alone_faces_touch() -> None:
    vertices = np.array([(0, 0, 0), (-2, 1, 0), (-2, -1, 0), (2, -1, 0), (2, 1, 0)], float)
    mesh = TriangleMesh(vertices, np.array([(0, 1, 2), (0, 3, 4)]))
    ends = MeshPoint(0, np.array([0.5, 0.5, 0.0])), MeshPoint(1, np.array([0.2, 0.0, 0.8]))
    path = exact_path(mesh, *ends)
    np.testing.assert_allclose(path, [(-1, 0.5, 0), (0, 0, 0), (1.6, 0.8, 0)], atol=1e-15)


@pytest.mark.parametrize("kind", ["uniform", "lattice", "clusters", "layers"])
def test_paths_in_a_plane_are_straight_whatever_its_triangles(kind: str) -> None:
    rng = np.random.default_rng(4)
    points = rng.uniform(size=(150, 2))
    if kind == "lattice":
        points = np.stack(np.meshgrid(*2 * [np.linspace(0.0, 1.0, 13)]), axis=-1).reshape(-1, 2)
    elif kind == "clusters":
        points = np.vstack([points + d * rng.normal(size=(150, 2)) for d in (0.0, 1e-7, 1e-4)])
    elif kind == "layers":
        points[:, 1] **= 9
    frame = [(-1.0, -1.0), (2.0, -1.0), (2.0, 2.0), (-1.0, 2.0)]
    vertices, faces = plane(np.vstack([points, frame]))
    mesh = TriangleMesh(vertices @ special_ortho_group.rvs(3, random_state=rng), faces)
    for _ in range(5):
        ends = some_place(mesh, rng), some_place(mesh, rng)
        first, last = (place.position(mesh) for place in ends)
        length = length_of(exact_path(mesh, *ends))
        assert abs(length - np.linalg.norm(first - last)) <= 2e-15


@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_paths_are_as_short_as_libigls_and_the_same_both_ways(seed: int) -> None:
    pytest.importorskip("igl")
    rng = np.random.default_rng(seed)
    balls = rng.normal(size=(60, 3))
    balls /= np.linalg.norm(balls, axis=1, keepdims=True)
    spiky = hull(balls)
    meshes = [
        spiky,
        spiky._replace(vertices=balls * rng.uniform(0.3, 1.0, (60, 1))),
        hull(balls * (1.0, 1.0, 0.02)),
        # On rough fields, what is left near a path hangs together by single vertices, too.
        field(9, rng.uniform(0.0, 0.3, 100)),
        field(9, 0.15 * np.sin(9.0 * np.arange(100) / 9.0)),
    ]
    for mesh in meshes:
        for _ in range(4):
            first, last = (int(end) for end in rng.choice(len(mesh.vertices), 2, replace=False))
            length = between(mesh, first, last)
            known = libigl.exact_distance(*mesh, first, last)
            assert length == pytest.approx(known, rel=1e-12)
            assert between(mesh, last, first) == pytest.approx(length, rel=1e-13)
        for _ in range(4):
            ends = some_place(mesh, rng), some_place(mesh, rng)
            path = exact_path(mesh, *ends)
            back = length_of(exact_path(mesh, ends[1], ends[0]))
            assert back == pytest.approx(length_of(path), rel=1e-13, abs=1e-15)
            for point, place in zip(path[[0, -1]], ends, strict=True):
                np.testing.assert_allclose(point, place.position(mesh), atol=1e-15)


def test_distances_of_places_are_a_metric() -> None:
    rng = np.random.default_rng(7)
    mesh = field(7, rng.uniform(0.0, 0.3, 64))
    for _ in range(4):
        a, b, c = (some_place(mesh, rng) for _ in range(3))
        ab, bc, ca = (length_of(exact_path(mesh, *ends)) for ends in ((a, b), (b, c), (c, a)))
        assert max(ab, bc, ca) <= 0.5 * (ab + bc + ca) + 1e-14


def test_lengths_on_spheres_converge_to_arcs_of_great_circles() -> None:
    ends = np.array([(1.0, 1.0, 1.0), (-1.0, 0.0, 0.0)])
    lengths = []
    for segments in (4, 8, 16):
        ticks = np.linspace(-1.0, 1.0, segments + 1)
        cube = np.stack(np.meshgrid(ticks, ticks, ticks), axis=-1).reshape(-1, 3)
        cube = cube[np.abs(cube).max(axis=1) == 1.0]
        first, last = (int(np.flatnonzero((cube == end).all(axis=1))[0]) for end in ends)
        ball = np.tan(0.25 * np.pi * cube)
        ball /= np.linalg.norm(ball, axis=1, keepdims=True)
        lengths.append(between(hull(ball), first, last))
    arc = np.arccos(-1.0 / np.sqrt(3.0))
    errors = arc - np.array(lengths)
    assert all(np.log2(coarse / fine) > 1.8 for coarse, fine in pairwise(errors))
    extrapolated = lengths[2] + (lengths[2] - lengths[1]) / 3.0
    assert abs(extrapolated - arc) < 0.05 * errors[2]


def test_a_search_that_runs_out_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("bodymeasure.mesh.exact.search.MOST_WINDOWS", 3)
    mesh = field(10, np.random.default_rng(2).uniform(0.0, 0.2, 121))
    with pytest.raises(bm.ConvergenceError, match=r"shortest after .* \(via\)"):
        between(mesh, 0, 120)


def test_without_libigl_the_extra_is_named_for_places(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(libigl, "find_spec", lambda _: None)
    mesh = field(1, np.zeros(4))
    assert bm.measure_mesh(mesh, 0, 3).length == pytest.approx(np.sqrt(2.0), rel=1e-15)
    with pytest.raises(bm.errors.MissingExtraError, match=r"libigl.*bodymeasure\[oracle\]"):
        bm.measure_mesh(mesh, 0, np.array([1.0, 0.5, 0.0]))
