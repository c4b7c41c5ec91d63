from collections.abc import Sequence
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from helpers.bodies import BODIES, ONE_QUICKLY
from helpers.surfaces.quad_grids import grid_mesh, hilly_net, spline_atlas

from bodymeasure import InputError
from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.bezier import evaluate
from bodymeasure.subdivision import (
    PatchNets,
    PolygonMesh,
    QuadMesh,
    limit_positions,
    loop_schaefer,
    quads_of,
    subdivide,
)
from bodymeasure.subdivision.polygons import refined as subdivided

SAMPLES = Path(__file__).parents[2] / "sample_patches" / "quad_meshes.npz"
NO_CREASES = np.empty((0, 2), dtype=np.int64)
CUBE = np.array([[x, y, z] for x in (0.0, 2.0) for y in (0.0, 1.0) for z in (0.0, 1.5)])
SIX = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])


def polygons(mesh: QuadMesh, creases: Ints = NO_CREASES) -> PolygonMesh:
    return PolygonMesh(
        mesh.vertices, mesh.quads.ravel(), np.full(len(mesh.quads), 4), np.asarray(creases)
    )


@cache
def sample(body: str) -> QuadMesh:
    with np.load(SAMPLES) as file:
        return QuadMesh(1e-6 * file[body], file["quads"].astype(np.int64))


def net(patches: PatchNets) -> Array:
    return patches.points[patches.index]


def regular_quads(mesh: QuadMesh) -> Bools:
    """The quads whose patch must be the limit surface itself."""
    quads = np.bincount(mesh.quads.ravel())
    edges = np.bincount(mesh.edges.ends.ravel())
    inside = edges == quads
    return np.asarray(np.where(inside, quads == 4, quads == 2)[mesh.quads].all(axis=1))


def refined(mesh: QuadMesh, steps: int, corners: Sequence[int] = ()) -> tuple[QuadMesh, Array]:
    """The mesh after some steps, and (u, v) of each new quad's corners on its original quad.

    The vertices `corners` stay where they are.
    """
    kept = mesh.vertices[list(corners)]
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    places = np.broadcast_to(square, (len(mesh.quads), 4, 2))
    for _ in range(steps):
        mesh = subdivide(mesh)
        mesh.vertices[list(corners)] = kept
        middle = (places + np.roll(places, -1, axis=1)) / 2.0
        center = np.broadcast_to(places.mean(axis=1, keepdims=True), places.shape)
        children = [places, middle, center, np.roll(middle, 1, axis=1)]
        places = np.stack(children, axis=2).reshape(-1, 4, 2)
    return mesh, places


def distance_from_limit(
    mesh: QuadMesh, patches: PatchNets, steps: int, corners: Sequence[int] = ()
) -> Array:
    """The largest distance of each patch from the limit surface at some points, shape (quads,)."""
    fine, places = refined(mesh, steps, corners)
    positions = limit_positions(fine)
    positions[list(corners)] = mesh.vertices[list(corners)]
    limits = positions[fine.quads].reshape(len(mesh.quads), -1, 3)
    found = evaluate(net(patches), places.reshape(len(mesh.quads), -1, 2))
    return np.asarray(np.linalg.norm(found - limits, axis=-1).max(axis=1))


def test_on_a_regular_mesh_the_patches_are_the_spline_surface() -> None:
    points = hilly_net(7, 6)
    patches = net(loop_schaefer(polygons(grid_mesh(points)))).reshape(6, 5, 4, 4, 3)
    spline = spline_atlas(points, margin=1).control_points.reshape(4, 3, 4, 4, 3)
    np.testing.assert_allclose(patches[1:-1, 1:-1], spline, rtol=0, atol=1e-14)


def test_on_the_boundary_the_patches_are_the_spline_surface_of_reflected_points() -> None:
    points = hilly_net(5, 6)
    wide = np.concatenate([2 * points[:1] - points[1:2], points, 2 * points[-1:] - points[-2:-1]])
    sides = 2 * wide[:, :1] - wide[:, 1:2], 2 * wide[:, -1:] - wide[:, -2:-1]
    wide = np.concatenate([sides[0], wide, sides[1]], axis=1)
    patches = net(loop_schaefer(polygons(grid_mesh(points))))
    spline = spline_atlas(wide, margin=1)
    np.testing.assert_allclose(patches, spline.control_points, rtol=0, atol=1e-14)


@pytest.mark.parametrize("body", ONE_QUICKLY)
def test_on_a_body_regular_patches_are_the_limit_surface(body: str) -> None:
    mesh = sample(body)
    whole = polygons(mesh)
    distance = distance_from_limit(mesh, loop_schaefer(whole), 2)
    regular = regular_quads(mesh)
    assert regular.mean() > 0.95
    assert distance[regular].max() < 1e-15
    # Elsewhere they are close to it, within 1.4 mm on quads of 1 to 2 cm; but `subdivide` rounds
    # the corners of the boundary.
    rounded = whole.corner_vertices[mesh.quads].any(axis=1)
    assert 1e-6 < distance[~regular & ~rounded].max() < 1.5e-3


def test_every_vertex_inside_lies_on_the_limit_surface() -> None:
    mesh = QuadMesh(CUBE, SIX)
    patches = loop_schaefer(polygons(mesh))
    np.testing.assert_allclose(patches.points[:8], limit_positions(mesh), rtol=0, atol=1e-15)


@pytest.mark.parametrize("body", BODIES[:1])
def test_neighbors_share_the_control_points_of_their_edge(body: str) -> None:
    mesh = sample(body)
    index = loop_schaefer(polygons(mesh)).index
    sides = np.stack([index[:, :, 0], index[:, 3], index[:, ::-1, 3], index[:, 0, ::-1]], axis=1)
    edges = mesh.edges
    rows = sides.reshape(-1, 4)
    forwards = rows[:, 0] < rows[:, 3]
    canonical = np.where(forwards[:, None], rows, rows[:, ::-1])
    # There are as many different rows of numbers as edges.
    assert len(np.unique(canonical, axis=0)) == len(edges.ends)
    for edge in (0, 77, 4000):
        assert len(np.unique(canonical[edges.of_side.ravel() == edge], axis=0)) == 1


def cut_along(points: Array, row: int) -> tuple[QuadMesh, QuadMesh]:
    """The two halves of a grid on either side of a row of vertices."""
    return grid_mesh(points[: row + 1]), grid_mesh(points[row:])


def test_a_crease_is_the_boundary_of_both_its_sides() -> None:
    points, row = hilly_net(7, 6), 3
    crease = np.stack([row * 6 + np.arange(5), row * 6 + np.arange(1, 6)], axis=-1)
    whole = net(loop_schaefer(polygons(grid_mesh(points), crease)))
    halves = [net(loop_schaefer(polygons(half))) for half in cut_along(points, row)]
    np.testing.assert_allclose(whole, np.concatenate(halves), rtol=0, atol=1e-15)
    smooth = net(loop_schaefer(polygons(grid_mesh(points))))
    assert np.abs(whole - smooth).max() > 0.005


def test_a_crease_that_ends_inside_fades_out() -> None:
    points, row = hilly_net(7, 9), 3
    crease = row * 9 + np.array([[0, 1], [1, 2], [2, 3], [3, 4]])
    creased = net(loop_schaefer(polygons(grid_mesh(points), crease))).reshape(6, 8, 4, 4, 3)
    smooth = net(loop_schaefer(polygons(grid_mesh(points)))).reshape(6, 8, 4, 4, 3)
    np.testing.assert_array_equal(creased[:, 5:], smooth[:, 5:])
    # Beside the end itself, control points move with its limit.
    changed = (creased[:, 4] != smooth[:, 4]).any(axis=-1)
    assert changed.sum() == 2 * 4
    assert changed[2, 2:, :2].all()
    assert changed[3, :2, :2].all()
    assert np.abs(creased[2, :3] - smooth[2, :3]).max() > 0.005


@pytest.mark.parametrize("crease", [[[2, 3]], [[2, 3], [3, 7]]])
def test_the_end_of_a_crease_lies_where_repeated_subdivision_brings_it(
    crease: list[list[int]],
) -> None:
    mesh = polygons(QuadMesh(CUBE, SIX), np.array(crease))
    ends = [crease[0][0], crease[-1][1]]
    limits = loop_schaefer(mesh).points[ends]
    away = []
    for _ in range(7):
        mesh = subdivided(mesh)
        np.testing.assert_allclose(loop_schaefer(mesh).points[ends], limits, rtol=0, atol=1e-14)
        away.append(np.abs(mesh.vertices[ends] - limits).max())
    assert away[-1] < 1e-3
    # Each of the later steps takes away more than half of the distance.
    assert (np.divide(away[3:], away[2:-1]) < 0.5).all()


def test_a_cube_with_sharp_edges_is_a_cube() -> None:
    edges = QuadMesh(CUBE, SIX).edges.ends
    patches = net(loop_schaefer(polygons(QuadMesh(CUBE, SIX), edges)))
    u = np.linspace(0.0, 1.0, 5)
    places = np.stack(np.meshgrid(u, u, indexing="ij"), axis=-1)
    found = evaluate(patches, np.broadcast_to(places, (6, 5, 5, 2)))
    corners = CUBE[SIX]
    a, b = places[..., :1], places[..., 1:]
    expected = (
        corners[:, None, None, 0]
        + a * (corners[:, 1] - corners[:, 0])[:, None, None]
        + b * (corners[:, 3] - corners[:, 0])[:, None, None]
    )
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-15)


@pytest.mark.parametrize(
    ("mesh", "corners", "largest"),
    [
        (QuadMesh(CUBE / CUBE.max(axis=0), SIX), [0], 0.065),
        (QuadMesh(CUBE / CUBE.max(axis=0), SIX), list(range(8)), 0.065),
        # On a regular mesh only the quads beside the corner differ.
        (grid_mesh(hilly_net(7, 7)), [24], 0.01),
        (grid_mesh(hilly_net(7, 7)), [24, 38], 0.01),
    ],
)
def test_tagged_vertices_stay_where_they_are(
    mesh: QuadMesh, corners: list[int], largest: float
) -> None:
    whole = PolygonMesh(
        mesh.vertices, mesh.quads.ravel(), np.full(len(mesh.quads), 4), NO_CREASES, tagged=corners
    )
    patches = loop_schaefer(whole)
    np.testing.assert_array_equal(patches.points[corners], mesh.vertices[corners])
    distance = distance_from_limit(mesh, patches, 5, corners)
    inner = ~(whole.sides == 1)[whole.edge].reshape(-1, 4).any(axis=1)
    assert distance[inner].max() < largest
    beside = np.isin(mesh.quads, corners).any(axis=1)
    if len(mesh.quads) > 6:
        assert distance[inner & ~beside].max() < 1e-14
        assert distance[beside].max() > 1e-5


def test_the_boundary_may_be_smooth_at_its_corners() -> None:
    mesh = grid_mesh(hilly_net(5, 5))
    whole = PolygonMesh(mesh.vertices, mesh.quads.ravel(), np.full(16, 4), NO_CREASES, rounded=True)
    patches = loop_schaefer(whole)
    np.testing.assert_allclose(patches.points[:25], limit_positions(mesh), rtol=0, atol=1e-15)
    distance = distance_from_limit(mesh, patches, 4).reshape(4, 4)
    corners = distance[[0, 0, 3, 3], [0, 3, 0, 3]]
    assert 1e-5 < corners.max() < 0.015
    distance[[0, 0, 3, 3], [0, 3, 0, 3]] = 0.0
    assert distance.max() < 1e-14
    sharp = loop_schaefer(polygons(mesh))
    np.testing.assert_array_equal(sharp.points[[0, 4, 20, 24]], mesh.vertices[[0, 4, 20, 24]])


def test_a_crease_that_turns_round_one_face_is_smooth() -> None:
    rim = np.array([[0, 1], [1, 3], [3, 2], [2, 0]])
    patches = loop_schaefer(polygons(QuadMesh(CUBE, SIX), rim))
    before, after = CUBE[[2, 0, 1, 3]], CUBE[[1, 3, 2, 0]]
    np.testing.assert_allclose(
        patches.points[[0, 1, 3, 2]], (4.0 * CUBE[[0, 1, 3, 2]] + before + after) / 6.0, atol=1e-15
    )


def test_triangles_become_quads_with_the_same_limit() -> None:
    # A mesh with one face that is no quad is refined as `subdivide` refines a quad mesh.
    mesh = grid_mesh(hilly_net(8, 8))
    quads = mesh.quads
    # The first quad, which is far from those compared, is given as two triangles.
    corners = np.concatenate([quads[0, [0, 1, 2, 0, 2, 3]], quads[1:].ravel()])
    sizes = np.concatenate([[3, 3], np.full(len(quads) - 1, 4)])
    finer, face = quads_of(PolygonMesh(mesh.vertices, corners, sizes, NO_CREASES))
    assert (finer.sizes == 4).all()
    np.testing.assert_array_equal(np.bincount(face), sizes)
    patches = net(loop_schaefer(finer))
    expected = net(loop_schaefer(polygons(subdivide(mesh))))
    inner = (np.arange(1, 7)[:, None] * 7 + np.arange(1, 6)).ravel()
    inner = inner[inner < 7 * 6]
    inner = inner[(inner > 16)]
    for quad in inner:
        np.testing.assert_allclose(
            patches[face == quad + 1], expected[4 * quad : 4 * quad + 4], rtol=0, atol=1e-15
        )


def test_a_mesh_of_quads_is_left_alone() -> None:
    mesh = polygons(grid_mesh(hilly_net(3, 3)))
    assert quads_of(mesh)[0] is mesh


def test_creases_and_corners_survive_the_step_to_quads() -> None:
    # A tetrahedron whose edges are all sharp keeps its shape.
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=np.float64)
    corners = np.array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3])
    creases = np.array([[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]])
    quads, _ = quads_of(PolygonMesh(vertices, corners, np.full(4, 3), creases))
    assert len(quads.sizes) == 12
    points = net(loop_schaefer(quads))
    flat = np.stack([points[..., 0], points[..., 1], points[..., 2], 1 - points.sum(-1)], -1)
    np.testing.assert_allclose(np.abs(flat).min(axis=-1), 0.0, rtol=0, atol=1e-15)
    assert (points.reshape(-1, 3) == 1.0).any()


def faces(*corners: list[int], creases: Ints = NO_CREASES) -> PolygonMesh:
    sizes = np.array([len(face) for face in corners])
    points = np.random.default_rng(3).normal(size=(12, 3))
    return PolygonMesh(points, np.concatenate(corners).astype(np.int64), sizes, creases)


@pytest.mark.parametrize(
    ("corners", "message"),
    [
        ([[0, 1, 2, 3], [4, 5]], "face 1: 2 corners; expected at least 3"),
        ([[0, 1, 2, 3], [4, 5, 4, 6]], "face 1: a vertex occurs twice"),
        (
            [[0, 1, 2, 3], [0, 1, 4, 5], [1, 0, 6, 7]],
            "face 0, face 1, face 2 share one edge, between the vertices 1 and 2; expected at most",
        ),
        (
            [[0, 1, 2, 3], [0, 1, 4, 5]],
            r"face 0, face 1 face opposite ways: .* vertices 1 and 2, in the .*\(1 such edge\)",
        ),
        ([[0, 1, 2, 3], [0, 4, 5, 6]], "face 0, face 1 touch at vertex 1 alone"),
        (
            [[0, 1, 2], [0, 2, 3], [0, 3, 1], [0, 4, 5], [0, 5, 6], [0, 6, 4]],
            "face 0, face 1, face 2, face 3 and 2 more touch at vertex 1 alone",
        ),
    ],
)
def test_what_is_no_oriented_manifold_is_refused(corners: list[list[int]], message: str) -> None:
    with pytest.raises(InputError, match=message):
        faces(*corners)


def test_a_crease_beside_the_edges_is_refused() -> None:
    with pytest.raises(InputError, match="a crease runs from vertex 1 to 3, where no edge is"):
        faces([0, 1, 2, 3], creases=np.array([[0, 2]]))


def test_only_quads_become_patches() -> None:
    with pytest.raises(InputError, match="a face is no quad"):
        loop_schaefer(faces([0, 1, 2]))
