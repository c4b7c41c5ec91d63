"""Lengths on surfaces whose geodesics are known."""

import numpy as np
import pytest
from helpers.surfaces.quad_grids import arc_net, cylinder_net, grid_mesh, hilly_net, spline_matrix
from scipy.integrate import quad
from scipy.optimize import minimize

from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.errors import InputError
from bodymeasure.measure import diagonals
from bodymeasure.oracle.libigl import exact_distance
from bodymeasure.paper.surface.corridor import Corridors, shortest_way_out
from bodymeasure.paper.surface.fine_surface import QUICK_LEVELS, closest_limit_points, fine_surface
from bodymeasure.paper.surface.insertion import insert_point
from bodymeasure.paper.surface.laid import lay_curves
from bodymeasure.paper.surface.physical import physical_lengths
from bodymeasure.paper.surface.source_mesh import load_source_mesh
from bodymeasure.samples import load_sample
from bodymeasure.subdivision import part, quads_within, triangles

CYLINDER = cylinder_net(11, 12)
SURFACE = fine_surface(grid_mesh(CYLINDER), QUICK_LEVELS)


def spline_points(net: Array, u: Array, v: Array) -> Array:
    rows, columns = spline_matrix(net.shape[0], u), spline_matrix(net.shape[1], v)
    return np.asarray(np.einsum("pi,pj,ijc->pc", rows, columns, net))


def arc(u0: float, u1: float) -> float:
    """The length of the cylinder's base between two of its parameters."""

    def speed(u: float) -> float:
        slope = spline_matrix(len(CYLINDER), np.array([u]), order=1) @ CYLINDER[:, 0]
        return float(np.linalg.norm(slope))

    knots = [k for k in range(len(CYLINDER)) if u0 < k < u1]
    return float(quad(speed, u0, u1, points=knots or None, epsabs=1e-12)[0])


def line(u0: float, v0: float, u1: float, v1: float) -> Array:
    """Points on the cylinder, straight in its parameters."""
    t = np.linspace(0.0, 1.0, 65)
    return spline_points(CYLINDER, u0 + (u1 - u0) * t, v0 + (v1 - v0) * t)


LINES = [(2.3, 3.1, 6.4, 6.7), (7.2, 2.6, 3.9, 8.3), (2.2, 5.3, 7.7, 5.3), (5.0, 3.0, 5.0, 7.0)]


def test_on_a_cylinder_distances_are_those_of_the_unrolled_plane() -> None:
    paths = np.stack([line(*ends) for ends in LINES])
    measured = physical_lengths(SURFACE, paths, paths[:, [0, -1]])
    expected = [
        np.hypot(arc(min(u0, u1), max(u0, u1)), 0.3 * (v1 - v0)) for u0, v0, u1, v1 in LINES
    ]
    error = np.abs(measured.length - expected)
    assert (error < 3e-5 * measured.length).all()
    assert (error <= measured.uncertainty).all()
    assert (measured.uncertainty < 5e-4 * measured.length).all()


@pytest.mark.slow
def test_workers_measure_the_same() -> None:
    paths = np.stack([line(*ends) for ends in LINES[:2]])
    here = physical_lengths(SURFACE, paths, paths[:, [0, -1]])
    seen: list[int] = []
    there = physical_lengths(SURFACE, paths, paths[:, [0, -1]], processes=2, progress=seen.append)
    np.testing.assert_array_equal(there.length, here.length)
    assert seen == [1, 2]


def test_the_corridor_does_not_cut_the_shortest_path_off() -> None:
    """A detour given as the path leads to the same length as a wide and as a narrow corridor."""
    t = np.linspace(0.0, 1.0, 65)
    detour = spline_points(CYLINDER, 3.0 + 4.0 * t, 4.0 + 3.0 * np.sin(np.pi * t))
    direct = line(3.0, 4.0, 7.0, 4.0)
    ends = direct[[0, -1]][None]
    wide = physical_lengths(SURFACE, detour[None], ends)
    narrow = physical_lengths(SURFACE, direct[None], ends)
    assert wide.length[0] == pytest.approx(narrow.length[0], rel=1e-12)


def test_a_way_out_bounds_every_path_that_leaves() -> None:
    mesh = SURFACE.meshes[-1]
    start, end = line(*LINES[0])[[0, -1]]
    chosen = quads_within(mesh, np.argsort(np.linalg.norm(mesh.vertices - start, axis=1))[:900], 1)
    cut = part(mesh, chosen)[0]
    bound = shortest_way_out(cut, start, start)
    ring = cut.vertices[np.unique(cut.edges.ends[cut.edges.boundary])]
    nearest = 2.0 * np.linalg.norm(ring - start, axis=-1).min()
    assert 0.8 * nearest < bound <= nearest
    assert shortest_way_out(cut, start, end) > np.linalg.norm(end - start) - 0.1


def test_where_no_corridor_holds_the_path_the_doubt_is_told() -> None:
    """Beside the mesh's boundary, a shorter path might run where the mesh is cut off."""
    path = line(2.1, 0.4, 8.0, 0.4)
    measured = physical_lengths(SURFACE, path[None], path[None, [0, -1]])
    inside = line(2.1, 5.5, 8.0, 5.5)
    sure = physical_lengths(SURFACE, inside[None], inside[None, [0, -1]])
    assert measured.uncertainty[0] > 0.01 * measured.length[0]
    assert sure.uncertainty[0] < 5e-4 * sure.length[0]


def test_a_corridor_is_one_piece_though_the_surface_comes_near_itself() -> None:
    """The corridor of a path holds its own sheet, not a parallel one that is joined far away."""
    bend = np.concatenate([np.linspace(0, 4, 9), [4.4], np.linspace(4, 0, 9)])
    height = np.concatenate([np.zeros(9), [0.15], 0.3 * np.ones(9)])
    net = np.stack([np.tile(column[:, None], 9) for column in (bend, height)], axis=-1)
    along = np.broadcast_to(0.5 * np.arange(9.0), (19, 9))
    surface = fine_surface(grid_mesh(np.stack([net[..., 0], along, net[..., 1]], axis=-1)), (1, 2))
    path = np.stack([np.linspace(0.7, 1.7, 9), np.full(9, 2.0), np.zeros(9)], axis=-1)
    corridors = Corridors(surface)
    (coarse, _) = corridors.meshes(corridors.around(path, 0.5))
    assert coarse.vertices[:, 2].max() < 0.15
    assert np.ptp(coarse.vertices[:, 0]) > 1.5


def test_closest_points_are_those_of_the_spline_surface(rng: np.random.Generator) -> None:
    net = hilly_net(9, 9)
    surface = fine_surface(grid_mesh(net), QUICK_LEVELS)
    places = 2.0 + 4.0 * rng.random((6, 2))
    positions = spline_points(net, *places.T) + 0.05 * rng.normal(size=(6, 3))
    found = closest_limit_points(surface, positions)
    for point, position, place in zip(found, positions, places, strict=True):

        def square(uv: Array, position: Array = position) -> float:
            return float(((spline_points(net, uv[:1], uv[1:])[0] - position) ** 2).sum())

        best = minimize(square, place, method="Nelder-Mead", options={"xatol": 1e-9, "fatol": 0})
        expected = spline_points(net, best.x[:1], best.x[1:])[0]
        assert np.linalg.norm(point - expected) < 2e-5


def test_closest_points_though_what_is_kept_round_them_touches_at_a_corner() -> None:
    """Positions six quads apart both ways: what is kept round them shares a vertex alone."""
    x, y = np.meshgrid(np.arange(11.0), np.arange(11.0), indexing="ij")
    plane = fine_surface(grid_mesh(np.stack([x, y, 0.0 * x], axis=-1)), QUICK_LEVELS)
    positions = np.array([[3.0, 3.0, 0.1], [6.0, 6.0, 0.2]])
    found = closest_limit_points(plane, positions)
    np.testing.assert_allclose(found, positions * [1.0, 1.0, 0.0], rtol=0, atol=1e-12)


def test_a_laid_curve_tells_how_far_off_it_was() -> None:
    """A line at a distance d outside a cylinder, along its axis and around it."""
    u0, v0, u1, v1 = 3.0, 3.0, 7.0, 6.0
    t = np.linspace(0.0, 1.0, 65)
    u = u0 + (u1 - u0) * t
    curve = line(u0, v0, u1, v1)
    slope = spline_matrix(len(CYLINDER), u, order=1) @ CYLINDER[:, 0]
    tangent = slope / np.linalg.norm(slope, axis=-1, keepdims=True)
    normal = np.cross(tangent, [0.0, 1.0, 0.0])
    own = np.linalg.norm(np.diff(curve, axis=0), axis=-1).sum()
    for side in (1.0, -1.0):
        shifted = curve + side * 0.01 * normal
        length = np.linalg.norm(np.diff(shifted, axis=0), axis=-1).sum()
        laid = lay_curves(SURFACE, shifted[None], curve[None, [0, -1]], np.array([length]))
        # Measured from the mesh, which sags by h^2 / 8 of its curvature below the surface.
        assert laid.distance[0] == pytest.approx(0.01, abs=2.5e-4)
        assert abs(laid.offset[0]) == pytest.approx(0.01, abs=2.5e-4)
        assert laid.length[0] == pytest.approx(own, rel=2e-5)
        assert abs(laid.length[0] - own) <= laid.uncertainty[0]
        # The quads run from u to v, so that their normals are the opposite of those above.
        assert np.sign(laid.offset[0]) == np.sign(side) * _outwards(normal[0])


def test_a_laid_curve_tells_its_sharpest_bend() -> None:
    """On a cylinder of radius 1, from an arc of radius 1.1."""
    surface = fine_surface(grid_mesh(arc_net(11, 9)), QUICK_LEVELS)
    angle = np.linspace(0.7, 2.0, 65)
    arc_points = np.stack([-np.cos(angle), 0.0 * angle + 1.2, np.sin(angle)], axis=-1)
    outer = arc_points * [1.1, 1.0, 1.1]
    laid = lay_curves(surface, outer[None], arc_points[None, [0, -1]], np.array([1.1 * 1.3]))
    # A bend is measured over five faces of the mesh, which turn by whole angles.
    assert laid.bend[0] == pytest.approx(1.0, abs=0.1)
    assert laid.own_bend[0] == pytest.approx(1.1, rel=1e-12)
    error = abs(laid.length[0] - 1.3)
    assert error < 5e-5
    # The spline's radius is 1 to 1e-5.
    assert error <= laid.uncertainty[0] + 1.3e-5


def _outwards(normal: Array) -> float:
    mesh = SURFACE.meshes[0]
    a, b, c, _ = mesh.vertices[mesh.quads[len(mesh.quads) // 2]]
    return float(np.sign(np.cross(b - a, c - a) @ normal))


def test_ends_that_share_a_face_are_refused() -> None:
    path = line(4.0, 4.0, 4.001, 4.001)
    with pytest.raises(InputError, match="share a face of the mesh; they are too near each other"):
        physical_lengths(SURFACE, path[None], path[None, [0, -1]])


@pytest.mark.slow
def test_on_a_body_corridors_give_the_lengths_of_the_whole_mesh() -> None:
    atlas = load_sample("female_average")
    surface = fine_surface(load_source_mesh("female_average")[0], (1, 2))
    mesh = surface.meshes[0]
    solution = diagonals(atlas)
    t = np.linspace(0.0, 1.0, 65)
    chosen = np.random.default_rng(5).choice(len(atlas), 8, replace=False)
    curves = evaluate(atlas.control_points[chosen], solution.path(t)[chosen, 0])
    ends = closest_limit_points(surface, curves[:, [0, -1]].reshape(-1, 3)).reshape(-1, 2, 3)
    corridors = Corridors(surface)
    for curve, pair in zip(curves, ends, strict=True):
        lengths = []
        for part_mesh in (
            mesh,
            next(corridors.meshes(corridors.around(curve, 0.15 * arc_of(curve)))),
        ):
            vertices, faces, start = insert_point(
                part_mesh.vertices, triangles(part_mesh.quads), pair[0]
            )
            vertices, faces, end = insert_point(vertices, faces, pair[1])
            lengths.append(exact_distance(vertices, faces, start, end))
        assert lengths[0] == pytest.approx(lengths[1], rel=1e-12)


def arc_of(curve: Array) -> float:
    return float(np.linalg.norm(np.diff(curve, axis=0), axis=-1).sum())
