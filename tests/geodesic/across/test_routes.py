"""The parts of `geodesic_between`, each against values that are known without it."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.surfaces.cut_atlases import random_point, wavy_plane
from helpers.surfaces.grids import grid_atlas
from helpers.surfaces.tubes import cone

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.geodesic.across.pieces.problem import RouteProblem
from bodymeasure.geodesic.across.pieces.refine import refine, sharpened
from bodymeasure.geodesic.across.routes.finer import fine_route
from bodymeasure.geodesic.across.routes.graph import patch_graph
from bodymeasure.geodesic.across.routes.mesh import RouteMesh
from bodymeasure.geodesic.across.routes.reading import route_of
from bodymeasure.geodesic.across.routes.route import Route
from bodymeasure.geodesic.across.routes.ways import first_ways
from bodymeasure.geodesic.across.search.other_routes import other_routes
from bodymeasure.geodesic.across.search.search import shortest_along
from bodymeasure.geodesic.numerics.banded import banded_product, solve_free
from bodymeasure.geodesic.numerics.box_newton import SecondOrder, minimize_in_box
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.samples import load_sample


def place_of(point: AtlasPoint) -> AtlasPoint:
    return point


@pytest.mark.parametrize(
    "place",
    [
        AtlasPoint(4, 0.5, 0.5),  # a vertex
        AtlasPoint(4, 1.0, 0.25),  # one on a seam
        AtlasPoint(4, 0.3, 0.1),  # within a face
        AtlasPoint(4, 0.3, 0.3),  # on the diagonal between two
        AtlasPoint(4, 1.0, 0.6),  # on a seam
        AtlasPoint(1, 0.0, 0.6),  # on the boundary
        AtlasPoint(0, 0.0, 0.0),  # in a corner
        AtlasPoint(8, 1.0, 1.0),
    ],
)
def test_points_are_found_on_faces_of_the_mesh(place: AtlasPoint, rng: np.random.Generator) -> None:
    mesh = RouteMesh.of(wavy_plane(rng), 4)
    face, weights = mesh.holding(place)
    assert mesh.patch[face] == place.patch
    assert min(weights) >= -1e-15
    assert sum(weights) == pytest.approx(1.0, abs=1e-15)
    there = np.array(weights) @ mesh.parameters[face]
    np.testing.assert_allclose(there, place[1:], atol=1e-15)


def test_beside_a_tip_a_face_is_a_whole_cell() -> None:
    mesh = RouteMesh.of(cone(1.0), 4)
    face, weights = mesh.holding(AtlasPoint(1, 0.1, 0.3))
    (tip,) = np.flatnonzero(mesh.free[face].any(axis=1))
    # A tenth of the way from the tip is 0.4 of the first cell.
    assert np.array(weights)[tip] == pytest.approx(0.6, abs=1e-15)
    others = np.delete(mesh.parameters[face], tip, axis=0)[:, 1]
    share = np.delete(weights, tip)
    assert share @ others / share.sum() == pytest.approx(0.3, abs=1e-15)


@pytest.mark.slow
def test_ways_over_the_mesh_of_a_plane_are_straight(rng: np.random.Generator) -> None:
    atlas = wavy_plane(rng)
    surface = patch_graph(atlas).mesh.surface
    for _ in range(20):
        start, end = place_of(random_point(rng, atlas)), place_of(random_point(rng, atlas))
        way, *_ = first_ways(atlas, start, end)
        points = way.points(surface)
        length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
        assert length == pytest.approx(way.length, rel=1e-12)
        assert length == pytest.approx(np.linalg.norm(points[-1] - points[0]), rel=1e-12)


def test_a_way_is_led_round_vertices_but_not_over_a_hole() -> None:
    square = grid_atlas(3, 3)
    ring = Atlas(square.points, np.delete(square.index, 4, axis=0), square.unit)
    # From (0.2, 1.4) to (2.8, 1.4), past the hole [1, 2] x [1, 2].
    way, *_ = first_ways(ring, AtlasPoint(1, 0.2, 0.4), AtlasPoint(6, 0.8, 0.4))
    assert way.length == pytest.approx(2.0 * np.hypot(0.8, 0.4) + 1.0, rel=1e-12)


def test_the_ways_on_both_sides_of_an_obstacle_are_found() -> None:
    def hill(x: Array, y: Array) -> Array:
        return np.stack([x, y, 2.5 * np.exp(-2.0 * ((x - 2.0) ** 2 + (y - 2.0) ** 2))], axis=-1)

    atlas = grid_atlas(4, 4, hill)
    start, end = AtlasPoint(8, 0.02, 0.01), AtlasPoint(11, 0.02, 0.99)
    mesh = patch_graph(atlas).mesh.surface
    middles = [way.points(mesh)[len(way.strip) // 2, 0] for way in first_ways(atlas, start, end)]
    assert min(middles) < 2.0 < max(middles)


def test_routes_read_off_the_mesh_hang_together(rng: np.random.Generator) -> None:
    atlas = wavy_plane(rng)
    neighbors = Neighbors(atlas)
    mesh = patch_graph(atlas).mesh
    for _ in range(20):
        ends = place_of(random_point(rng, atlas)), place_of(random_point(rng, atlas))
        way, *_ = first_ways(atlas, *ends)
        route = route_of(neighbors, mesh, ends, way)
        assert route is not None
        assert route.ends == ends
        for number, crossing in enumerate(route.crossings):
            assert crossing in neighbors.over[route.patches[number], crossing.from_side]
            leave, enter = route.crossed[number]
            np.testing.assert_allclose(atlas.position(leave), atlas.position(enter), atol=1e-13)


def test_a_route_begins_beyond_the_seam_on_which_its_start_lies() -> None:
    atlas = grid_atlas(2, 1)
    ends = AtlasPoint(0, 1.0, 0.2), AtlasPoint(1, 0.7, 0.9)
    way, *_ = first_ways(atlas, *ends)
    route = route_of(Neighbors(atlas), patch_graph(atlas).mesh, ends, way)
    assert route == Route((AtlasPoint(1, 0.0, 0.2), ends[1]))


def test_on_a_finer_mesh_ways_cross_seams_nearer_to_the_smooth_path(
    rng: np.random.Generator,
) -> None:
    body = load_sample("female_average")
    neighbors, mesh = Neighbors(body), patch_graph(body).mesh
    off = np.zeros(2)
    for _ in range(8):
        ends = place_of(random_point(rng, body)), place_of(random_point(rng, body))
        way, *_ = first_ways(body, *ends)
        routes = route_of(neighbors, mesh, ends, way), fine_route(body, neighbors, ends, way)
        rough, fine = routes
        assert rough is not None
        assert fine is not None
        if rough.key == fine.key:
            smooth = refine(body, fine, 8, 1.0).route.along
            off += [np.abs(np.subtract(each.along, smooth)).sum() for each in (rough, fine)]
    # Round-off decides which of several ways of one length over the mesh is taken.
    assert 0.0 < off[1] < 0.3 * off[0]


@pytest.fixture
def problem() -> RouteProblem:
    """A route over three patches of a bumpy atlas, all of them turned differently."""
    atlas = grid_atlas(2, 2, lambda x, y: np.stack([x, y, np.sin(2 * x + y * y)], axis=-1))
    index = atlas.index.copy()
    index[1] = np.rot90(index[1])
    index[3] = index[3, ::-1].T
    atlas = type(atlas)(atlas.points, index, atlas.unit)
    neighbors = Neighbors(atlas)
    corner = AtlasPoint(0, 1.0, 1.0)
    # From patch 0 over patch 1 to patch 3, as about the corner, but crossing in the seams' middle.
    goal = next(place for place in neighbors.same(corner) if place.patch == 3)
    way = next(way for way in neighbors.ways(corner, goal) if way[0].place.patch == 1)
    crossings = tuple(step.crossing for step in way)
    route = Route((AtlasPoint(0, 0.2, 0.3), AtlasPoint(3, 0.4, 0.6)), crossings, (0.4, 0.55))
    return RouteProblem(atlas, route, polynomial_space(5), 2.0)


def test_the_derivatives_of_the_length(problem: RouteProblem, rng: np.random.Generator) -> None:
    place = np.clip(problem.unknowns() + rng.normal(0.0, 0.02, problem.count), 0.0, 1.0)
    here = problem.expand(place)
    step = 1e-6
    for _ in range(5):
        way = rng.normal(size=problem.count)
        ahead, behind = (problem.expand(place + sign * step * way) for sign in (1.0, -1.0))
        slope = (ahead.value - behind.value) / (2.0 * step)
        assert here.gradient @ way == pytest.approx(slope, rel=1e-7)
        bend = (ahead.gradient - behind.gradient) / (2.0 * step)
        np.testing.assert_allclose(
            banded_product(here.bands, way), bend, atol=1e-7 * np.abs(bend).max()
        )


def test_no_unknown_moves_the_ends_apart_at_a_seam(
    problem: RouteProblem, rng: np.random.Generator
) -> None:
    values = problem.values(rng.random(problem.count))
    ends = problem.surface.control_points.mean(axis=(1, 2))[:, None] * 0.0
    ends = ends + problem.surface.positions(values[:, :, [0, -1]].transpose(0, 2, 1))
    np.testing.assert_allclose(ends[:-1, 1], ends[1:, 0], atol=1e-14)


def banded(matrix: Array) -> Array:
    bands = np.zeros_like(matrix)
    for row in range(len(matrix)):
        bands[row, : len(matrix) - row] = np.diagonal(matrix, -row)
    return bands


def test_minima_of_quadratics_in_the_box(rng: np.random.Generator) -> None:
    on_bounds = 0
    for _ in range(20):
        root = rng.normal(size=(6, 6))
        matrix, center = root @ root.T + 0.1 * np.eye(6), rng.uniform(-1.0, 2.0, 6)

        def expand(x: Array, matrix: Array = matrix, center: Array = center) -> SecondOrder:
            off = x - center
            return SecondOrder(
                value=float(1.0 + 0.5 * off @ matrix @ off),
                gradient=matrix @ off,
                bands=banded(matrix),
            )

        idle = np.arange(6) == 2
        found = minimize_in_box(expand, np.full(6, 0.5), idle)
        assert found.converged
        assert found.unknowns[2] == 0.5
        # The conditions of Karush, Kuhn and Tucker.
        slope, x = matrix @ (found.unknowns - center), found.unknowns
        free = (x > 0.0) & (x < 1.0) & ~idle
        np.testing.assert_allclose(slope[free], 0.0, atol=1e-6)
        assert (slope[(x == 0.0)] >= 0.0).all()
        assert (slope[(x == 1.0)] <= 0.0).all()
        np.testing.assert_array_equal(found.held, ((x == 0.0) | (x == 1.0)) & ~idle)
        on_bounds += int(found.held.sum())
    assert on_bounds > 10


def test_free_unknowns_of_an_indefinite_system_have_no_minimum() -> None:
    matrix = np.diag([1.0, -1.0, 2.0])
    right = np.ones(3)
    assert solve_free(banded(matrix), right, np.ones(3, bool)) is None
    solved = solve_free(banded(matrix), right, np.array([True, False, True]))
    assert solved is not None
    np.testing.assert_allclose(solved, np.array([1.0, 1.0, 0.5]))


def around_the_corner(way: tuple[int, ...]) -> tuple[Neighbors, Route, Atlas]:
    """On four unit squares, a route from the first to the last by the patches in `way`."""
    atlas = grid_atlas(2, 2)
    neighbors = Neighbors(atlas)
    corner = AtlasPoint(0, 1.0, 1.0)
    goal = AtlasPoint(3, 0.0, 0.0)
    steps = next(
        steps
        for steps in neighbors.ways(corner, goal)
        if tuple(step.place.patch for step in steps) == way
    )
    route = Route.of((AtlasPoint(0, 0.5, 0.8), AtlasPoint(3, 0.1, 0.7)), steps)
    return neighbors, route, atlas


def test_a_route_on_the_wrong_side_of_a_corner_is_repaired() -> None:
    # The line from (0.5, 0.8) to (1.1, 1.7) crosses patch 1, which is [0, 1] x [1, 2].
    neighbors, wrong, atlas = around_the_corner((2, 3))
    pressed = refine(atlas, wrong, 8, 1.0)
    assert pressed.length > np.hypot(0.6, 0.9) * (1.0 + 1e-3)
    assert (1, 3) in {route.patches[1:] for route in other_routes(neighbors, pressed)}
    found = shortest_along(atlas, neighbors, [wrong], 1.0)
    assert found.refined.route.patches == (0, 1, 3)
    assert found.part.length.corrected == pytest.approx(np.hypot(0.6, 0.9), rel=1e-9)


def test_needless_crossings_are_taken_back_and_missing_ones_found() -> None:
    atlas = grid_atlas(2, 1)
    neighbors = Neighbors(atlas)
    (there,) = neighbors.over[0, 1]
    (back,) = neighbors.over[1, 0]
    needless = Route((AtlasPoint(0, 0.5, 0.1), AtlasPoint(0, 0.6, 0.9)), (there, back), (0.3, 0.6))
    found = shortest_along(atlas, neighbors, [needless], 1.0)
    assert found.refined.route.patches == (0,)
    assert found.part.length.corrected == pytest.approx(np.hypot(0.1, 0.8), rel=1e-12)


def touching_route(atlas: Atlas) -> tuple[Route, float]:
    """A route over a seam and back, whose path only touches the seam, and the path's length.

    It is where a mirror would throw it back.
    """
    neighbors = Neighbors(atlas)
    crossings = (neighbors.over[0, 1][0], neighbors.over[1, 0][0])
    ends = (AtlasPoint(0, 0.5, 0.1), AtlasPoint(0, 0.6, 0.9))
    return Route(ends, crossings, (0.3, 0.6)), float(np.hypot(0.9, 0.8))


def test_only_a_path_that_is_plainly_too_long_is_not_made_exact() -> None:
    atlas = grid_atlas(2, 1)
    touching, length = touching_route(atlas)
    exact = refine(atlas, touching, 8, 1.0)
    assert exact.length == pytest.approx(length, rel=1e-12)
    close = refine(atlas, touching, 8, 1.0, most=length)
    assert (close.length, close.steps) == (exact.length, exact.steps)
    rough = refine(atlas, touching, 8, 1.0, most=length * (1.0 - 1e-5))
    assert rough.steps < exact.steps
    assert exact.length <= rough.length <= length * (1.0 + 1e-6)


def test_a_path_that_is_not_at_rest_or_varies_in_speed_is_made_exact() -> None:
    atlas = grid_atlas(2, 1)
    touching, length = touching_route(atlas)
    most = length * (1.0 - 1e-5)
    rough = refine(atlas, touching, 8, 1.0, most=most)
    minimum, idle = rough.minimum, rough.problem.idle
    assert rough.smoothed.any()
    assert sharpened(rough, idle, most) is rough
    # Energies that are greater than the length by this say nothing of where the length may go.
    for doubtful in (
        replace(minimum, converged=False),
        replace(minimum, value=minimum.value + 2e-5),
    ):
        found = sharpened(replace(rough, minimum=doubtful), idle, most)
        assert found.steps > rough.steps


def test_a_neighbor_that_a_path_needs_is_found() -> None:
    # The seam bulges into the first patch: the chord leaves that patch.
    def bulge(x: Array, y: Array) -> Array:
        return np.stack([x - 0.5 * np.sin(np.pi * y) * np.sin(np.pi * x / 2.0), y, 0.0 * x], -1)

    atlas = grid_atlas(2, 1, bulge)
    neighbors = Neighbors(atlas)
    start, end = AtlasPoint(0, 0.95, 0.05), AtlasPoint(0, 0.95, 0.95)
    chord = np.linalg.norm(atlas.position(end) - atlas.position(start))
    alone = Route((start, end))
    assert refine(atlas, alone, 8, 1.0).length > chord * (1.0 + 1e-3)
    found = shortest_along(atlas, neighbors, [alone], 1.0)
    assert found.refined.route.patches == (0, 1, 0)
    assert found.part.length.corrected == pytest.approx(chord, rel=1e-9)


def test_a_first_piece_without_length_is_trimmed() -> None:
    atlas = grid_atlas(2, 1)
    neighbors = Neighbors(atlas)
    (there,) = neighbors.over[0, 1]
    for start, end, along in (
        (AtlasPoint(0, 1.0, 0.2), AtlasPoint(1, 0.7, 0.9), 0.6),
        (AtlasPoint(0, 0.3, 0.2), AtlasPoint(1, 0.0, 0.9), 0.4),
    ):
        found = shortest_along(atlas, neighbors, [Route((start, end), (there,), (along,))], 1.0)
        assert len(found.refined.route.patches) == 1
        chord = np.linalg.norm(atlas.position(end) - atlas.position(start))
        assert found.part.length.corrected == pytest.approx(chord, rel=1e-12)
