"""Lengths over plain triangle meshes, and their error bounds."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from helpers.speed import quick

import bodymeasure as bm
from bodymeasure._typing import Array, Ints
from bodymeasure.mesh.arrays import TriangleMesh
from bodymeasure.mesh.curved import curved, vertex_normals

pytest.importorskip("igl")


def grid(side: int) -> TriangleMesh:
    """The unit square as a mesh of side x side cells."""
    ticks = np.linspace(0.0, 1.0, side + 1)
    x, y = np.meshgrid(ticks, ticks, indexing="ij")
    number = np.arange((side + 1) ** 2).reshape(side + 1, side + 1)
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    faces = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)
    return TriangleMesh(np.stack([x, y, 0.0 * x], axis=-1).reshape(-1, 3), faces)


def sphere(segments: int) -> TriangleMesh:
    """The unit sphere as a mesh made from the faces of a cube."""
    vertices, faces = grid(segments)
    square = np.tan(np.pi / 2.0 * (vertices[:, :2] - 0.5))
    sides = []
    for axis in range(3):
        for sign in (1.0, -1.0):
            side = np.insert(square, axis, sign, axis=1)
            sides.append(side / np.linalg.norm(side, axis=1, keepdims=True))
    all_faces = np.concatenate([faces + k * len(vertices) for k in range(6)])
    points = np.concatenate(sides)
    corner = points[all_faces]
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    inward = (normal * corner[:, 0]).sum(axis=1) < 0.0
    all_faces[inward] = all_faces[inward, ::-1]
    # Vertices are merged where sides of the cube meet.
    _, first, number = np.unique(
        np.round(points + 0.1234e-6, 9), axis=0, return_index=True, return_inverse=True
    )
    return TriangleMesh(points[first], number.ravel()[all_faces])


def test_a_flat_mesh_is_measured_exactly() -> None:
    path = bm.measure_mesh(grid(7), np.array([0.1, 0.13, 0.0]), np.array([0.83, 0.71, 0.0]))
    assert path.length == pytest.approx(np.hypot(0.73, 0.58), rel=1e-13)
    assert path.error_estimate < 1e-9
    assert path.unit is None


def test_vertices_are_given_by_number_and_the_unit_is_passed_on() -> None:
    path = bm.measure_mesh(grid(5), 0, 35, unit="cm")
    assert path.length == pytest.approx(np.sqrt(2.0), rel=1e-12)
    assert path.unit is bm.Unit.CM
    assert "on the mesh itself, not on a smooth surface" in path.sentence
    assert path.sentence.count(" cm") == 2
    np.testing.assert_allclose(path.points[[0, -1]], [[0, 0, 0], [1, 1, 0]])


def test_paths_lead_through_places_in_order() -> None:
    path = bm.measure_mesh(grid(5), 0, 5, [np.array([1.0, 0.0, 0.0]), np.array([1.0, 1.0, 0.0])])
    assert path.length == pytest.approx(3.0, rel=1e-12)


@pytest.mark.parametrize("segments", quick([4, 8, 16], first=2))
def test_the_estimate_covers_what_a_sphere_is_longer(
    segments: int, rng: np.random.Generator
) -> None:
    mesh = sphere(segments)
    for _ in range(8):
        ends = rng.integers(len(mesh.vertices), size=2)
        first, second = mesh.vertices[ends]
        exact = float(np.arctan2(np.linalg.norm(np.cross(first, second)), first @ second))
        path = bm.measure_mesh(mesh, int(ends[0]), int(ends[1]))
        assert path.length <= exact * (1 + 1e-12)
        assert exact - path.length <= path.error_estimate <= 0.5 * exact * (4.0 / segments) ** 2


@pytest.mark.slow
@pytest.mark.parametrize("segments", [2, 4])
def test_the_estimate_covers_what_is_known_of_bodies(
    segments: int, rng: np.random.Generator
) -> None:
    body = bm.load_sample("female_average")
    mesh = body.to_trimesh(segments)
    ratios = []
    for _ in range(20):
        ends = [bm.AtlasPoint(int(rng.integers(376)), *rng.uniform(0, 1, 2)) for _ in range(2)]
        smooth = bm.geodesic_between(body, ends[0], ends[1], on_failure="status")
        if not smooth.converged:
            continue
        rough = bm.measure_mesh(mesh, body.position(ends[0]), body.position(ends[1]))
        ratios.append(abs(rough.length - smooth.length) / rough.error_estimate)
    assert len(ratios) >= 19
    assert np.mean(np.array(ratios) <= 1.0) >= 0.95
    # The estimate is not far too cautious either.
    assert np.median(ratios) > 0.05


def test_middles_of_curved_triangles_of_a_sphere_lie_nearly_on_it() -> None:
    mesh = sphere(8)
    finer, sag = curved(mesh, vertex_normals(mesh))
    middles = finer.vertices[len(mesh.vertices) :]
    flat = 1.0 - np.linalg.norm(mesh.vertices[mesh.faces].mean(axis=1), axis=1).min()
    assert np.abs(np.linalg.norm(middles, axis=1) - 1.0).max() < 0.1 * flat
    # An arc of the angle a has the sag tan(a / 4) / 2 over its chord.
    assert sag.max() < np.tan(np.pi / 4.0 / 8.0)


Change = Callable[[Array, Ints], tuple[Any, Any, Any, Any]]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda v, f: (v, f, 0, 99), r"the end is vertex 99, .* numbered 0 to 35"),
        (lambda v, f: (v, f, 0, [5.0, 5.0, 0.0]), r"the end.* from the mesh.*and its unit"),
        (lambda v, f: (v, f, 0, [0.0, np.nan, 0.0]), r"the end is .*three finite coordinates"),
        (lambda v, f: (v, f, "neck", 3), r"the start is 'neck'; expected the number of a vertex"),
        (lambda v, f: (v, f[:, :2], 0, 3), r"faces have shape \(50, 2\); expected \(f, 3\)"),
        (lambda v, f: (v, f[:0], 0, 3), r"faces have shape \(0, 3\)"),
        (
            lambda v, f: (np.vstack([v, v + 2.0]), np.vstack([f, f + 36]), 0, 40),
            r"parts of the mesh that no edges join.*merge",
        ),
        (lambda v, f: (v, np.vstack([f, f[:1]]), 0, 3), r"mesh edge|mesh faces"),
        (lambda v, f: (v, np.vstack([f, [[0, 0, 1]]]), 0, 3), r"mesh face \d+ .*has no area"),
        (lambda v, f: (v, np.vstack([f, [[0, 1, 77]]]), 0, 3), r"mesh face 50 .*numbered 0 to 35"),
        (lambda v, f: (np.where(v == 0.2, np.nan, v), f, 0, 3), r"mesh vertex \d+ is not finite"),
        (lambda v, f: (v, f + 0.4, 0, 3), r"its faces float64; expected .*whole numbers"),
        (lambda v, f: (v + 1j, f, 0, 3), r"vertices are complex128 .*expected real numbers"),
        (lambda v, f: ([[0.0], v[0].tolist()], f, 0, 3), r"vertices or faces are ragged"),
        (lambda v, f: (1e-200 * v, f, 0, 3), r"the mesh extends over 1e-200; expected a size"),
        (
            lambda v, f: (np.vstack([v, [[1e6, 0.0, 0.0]]]), f, [50.0, 0.0, 0.0], 3),
            r"the start.* from the mesh.* its size is 1.41",
        ),
    ],
)
def test_bad_meshes_and_places_are_refused(change: Change, message: str) -> None:
    vertices, faces, start, end = change(*grid(5))
    with pytest.raises(bm.InputError, match=message):
        bm.measure_mesh((vertices, faces), start, end)


def test_what_is_no_mesh_is_refused() -> None:
    with pytest.raises(bm.InputError, match=r"the mesh is of type str; expected a trimesh"):
        bm.measure_mesh("body.obj", 0, 1)


def test_other_parts_and_unused_vertices_do_not_matter() -> None:
    vertices, faces = grid(5)
    more = np.vstack([vertices, [[9.0, 9.0, 9.0]], vertices + 4.0])
    both = np.vstack([faces, faces + 37])
    assert bm.measure_mesh((more, both), 0, 35).length == pytest.approx(np.sqrt(2.0))
    assert bm.measure_mesh((more, both), 37, 72).length == pytest.approx(np.sqrt(2.0))
    with pytest.raises(bm.InputError, match=r"the start is vertex 36, which belongs to no face"):
        bm.measure_mesh((more, both), 36, 72)


@pytest.mark.parametrize("scale", [1e-50, 1e-20, 1e20, 1e50])
def test_size_does_not_matter(scale: float) -> None:
    vertices, faces = sphere(4)
    middle = vertices[faces[5]].mean(axis=0)
    known = bm.measure_mesh((vertices, faces), 60, middle)
    path = bm.measure_mesh((scale * vertices, faces), 60, scale * middle)
    assert path.length == pytest.approx(scale * known.length, rel=1e-12)
    assert path.error_estimate == pytest.approx(scale * known.error_estimate, rel=1e-9)


@pytest.mark.parametrize("away", [1e-3, 1e-6, 1e-9, 1e-12, 1e-15])
def test_places_beside_edges_and_vertices_are_not_moved(away: float) -> None:
    for start in ((0.4, 0.4 + away), (0.4, 2.0 / 3.0 - away), (1.0 / 3.0 + away, 1.0 / 3.0)):
        end = np.array([0.9, 0.2, 0.0])
        path = bm.measure_mesh(grid(3), np.array([*start, 0.0]), end)
        assert path.length == pytest.approx(np.hypot(start[0] - 0.9, start[1] - 0.2), rel=1e-14)
        assert path.error_estimate <= 1e-11


def plate(depth: float) -> TriangleMesh:
    """A plate of 10 x 10 x 2, whose top is two triangles and whose bottom has a row of vertices.

    The last two vertices lie in the middle of two opposite sides, `depth` below the top.
    """
    square = np.array([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)])
    row = np.stack([np.linspace(0.0, 10.0, 21), np.full(21, 5.0), np.full(21, -2.0)], axis=1)
    box = [np.column_stack([square, np.full(4, z)]) for z in (0.0, -2.0)]
    ends = [(0.0, 5.0, -depth), (10.0, 5.0, -depth)]
    bottom = [face for k in range(8, 28) for face in ((4, k, k + 1), (7, k + 1, k))]
    rims = [((0, 3, 7, 8, 4), 29), ((1, 5, 28, 6, 2), 30)]
    sides = [
        (*pair, tip) for rim, tip in rims for pair in zip(rim, (*rim[1:], rim[0]), strict=True)
    ]
    rest = [
        (0, 1, 2),
        (0, 2, 3),
        (4, 28, 5),
        (7, 6, 28),
        (0, 4, 5),
        (0, 5, 1),
        (3, 2, 6),
        (3, 6, 7),
    ]
    return TriangleMesh(np.vstack([*box, row, ends]), np.array([*bottom, *sides, *rest]))


@pytest.mark.parametrize("depth", [0.1, 0.2, 0.7])
def test_a_path_crosses_large_faces_whose_vertices_are_far_away(depth: float) -> None:
    path = bm.measure_mesh(plate(depth), 29, 30)
    assert path.length == pytest.approx(10.0 + 2.0 * depth, rel=1e-12)
    assert path.points[:, 2].max() == 0.0
