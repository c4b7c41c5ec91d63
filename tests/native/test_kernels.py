"""The compiled kernels do what the NumPy forms of the same functions do."""

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
import scipy
from helpers.surfaces.grids import grid_atlas
from helpers.surfaces.tubes import cone
from hypothesis import given
from hypothesis import strategies as st

import bodymeasure as bm
from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.normals import normals_and_bends
from bodymeasure.atlas.queries.feet import feet_over_seams
from bodymeasure.atlas.topology.edges import edges_of
from bodymeasure.atlas.topology.joins import over_sides
from bodymeasure.bezier import homogeneous
from bodymeasure.bezier.power_form import jets, power_coefficients
from bodymeasure.geodesic.across.routes.graph import patch_graph
from bodymeasure.geodesic.across.routes.ways import COURSE, along_way, first_ways
from bodymeasure.geodesic.contact.legs import Contact, Ends
from bodymeasure.geodesic.contact.moving_ends import solve_with_moving_ends
from bodymeasure.geodesic.lengths.functionals import energy, energy_of_a_flat_surface
from bodymeasure.geodesic.lengths.measure import measure_length
from bodymeasure.geodesic.numerics.banded import BoxModels
from bodymeasure.geodesic.shortest.descent import descend
from bodymeasure.geodesic.shortest.grid_graph import shortest_trees
from bodymeasure.geodesic.shortest.polygon_energy import polygon_lengths
from bodymeasure.geodesic.solving.newton import newton
from bodymeasure.geodesic.solving.on_spaces import straight
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.geodesic.surfaces.control_points import extents, of_size_one
from bodymeasure.native import (
    MeshArrays,
    PatchSeams,
    WayFound,
    is_compiled,
    lengths,
    planar_hull,
    way_straightened,
)
from bodymeasure.native.library import SWITCH, without_kernels
from bodymeasure.section import Plane
from bodymeasure.section.pieces import CutSurface, Pieces
from bodymeasure.section.roots import bracketed_roots
from bodymeasure.taut.equilibrium import Walls, equilibrium

pytestmark = pytest.mark.skipif(not is_compiled(), reason="built without a compiler")

seeds = st.integers(0, 2**32 - 1)
UP = np.array([0.0, 0.0, 1.0])


@contextmanager
def by_numpy() -> Iterator[None]:
    """Switch the kernels off."""
    with without_kernels():
        assert not is_compiled()
        yield
    assert is_compiled()


def assert_near(one: Array, other: Array, part: float = 1e-13) -> None:
    np.testing.assert_allclose(one, other, rtol=0.0, atol=part * np.abs(other).max(initial=1e-300))


@given(
    seeds,
    st.tuples(st.integers(1, 6), st.integers(1, 6)),
    st.integers(2, 24),
    st.sampled_from([energy, energy_of_a_flat_surface]),
    st.sampled_from([slice(None), slice(1, -1), slice(0, -1)]),
)
def test_the_energy_of_paths_to_the_second_order(
    seed: int,
    degrees: tuple[int, int],
    degree: int,
    functional: Callable[..., object],
    nodes: slice,
) -> None:
    rng = np.random.default_rng(seed)
    surface = BezierSurfaces(rng.normal(size=(3, degrees[0] + 1, degrees[1] + 1, 3)))
    space, values = polynomial_space(degree), rng.random((3, 2, degree + 1))
    compiled = functional(surface, space, values, nodes)
    with by_numpy():
        plain = functional(surface, space, values, nodes)
    for name in ("value", "gradient", "hessian"):
        assert getattr(compiled, name).shape == getattr(plain, name).shape
        assert_near(getattr(compiled, name), getattr(plain, name))


@given(
    seeds,
    st.tuples(st.integers(1, 4), st.integers(1, 4)),
    st.integers(2, 20),
    st.integers(0, 20),
    st.sampled_from([2, 4, 8]),
)
def test_lengths_with_their_errors(
    seed: int, degrees: tuple[int, int], degree: int, count: int, lanes: int
) -> None:
    rng = np.random.default_rng(seed)
    nets = rng.normal(size=(count, degrees[0] + 1, degrees[1] + 1, 3))
    # Some are so flat that rounding errors of derivatives count.
    surface = BezierSurfaces(nets * (1.0, 0.2 ** rng.integers(0, 9), 0.1))
    space, ends = polynomial_space(degree), rng.random((2, count, 2, 1))
    bows = 0.1 * rng.normal(size=(count, 2, 1)) * np.sin(np.pi * space.nodes)
    values = ends[0] + (ends[1] - ends[0]) * space.nodes + bows
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(lengths, "MOST_LANES", lanes)
        compiled = measure_length(surface, space, values)
    with by_numpy():
        plain = measure_length(surface, space, values)
    np.testing.assert_allclose(compiled.raw, plain.raw, rtol=1e-13)
    near_zero = 1e-14 * plain.raw
    assert (
        abs(compiled.correction - plain.correction) <= 1e-9 * abs(plain.correction) + near_zero
    ).all()
    np.testing.assert_allclose(compiled.residual, plain.residual, rtol=1e-9)
    np.testing.assert_array_equal(compiled.index, plain.index)
    np.testing.assert_array_equal(compiled.trusted, plain.trusted)
    known = np.isfinite(plain.error)
    np.testing.assert_array_equal(np.isfinite(compiled.error), known)
    error, expected = compiled.error[known], plain.error[known]
    assert (abs(error - expected) <= 1e-6 * expected + 1e2 * near_zero[known]).all()


@given(seeds, st.tuples(st.integers(1, 4), st.integers(1, 4)), st.sampled_from([1, 2, 8, 13]))
def test_paths_by_collocation(seed: int, degrees: tuple[int, int], degree: int) -> None:
    rng = np.random.default_rng(seed)
    line = [np.linspace(0.0, 1.0, each + 1) for each in degrees]
    flat = np.stack(
        [*np.meshgrid(*line, indexing="ij"), np.zeros((degrees[0] + 1, degrees[1] + 1))], 2
    )
    nets = flat + 0.1 * rng.normal(size=(6, *flat.shape))
    # One is not finite, and one is a point, whose system is singular.
    nets[4, 0, 0, 0], nets[5] = np.nan, 0.0
    surface, space = BezierSurfaces(nets), polynomial_space(degree)
    first, last = rng.random((2, 6, 2))
    start = straight(first, last, space.nodes)
    compiled = newton(surface, space, start)
    with by_numpy(), np.errstate(invalid="ignore"):
        plain = newton(surface, space, start)
    for name in ("converged", "singular", "iterations"):
        np.testing.assert_array_equal(getattr(compiled, name), getattr(plain, name))
    found = plain.converged & ~plain.singular
    assert found[:4].all()
    assert_near(compiled.values[found], plain.values[found], 1e-10)


@given(seeds)
def test_paths_with_ends_that_move_along_edges(seed: int) -> None:
    rng = np.random.default_rng(seed)
    heights = 0.1 * rng.normal(size=(4, 4, 4))
    line = np.broadcast_to(np.linspace(0.0, 1.0, 4), heights.shape)
    nets = np.stack([line.swapaxes(1, 2), line, heights], axis=-1)
    surface, space = BezierSurfaces(nets), polynomial_space(12)
    first, last = Contact(1, 0.0), Contact(0, 1.0)
    ends: list[Ends] = [(None, None), (first, None), (None, last), (first, last)]
    # Bows that touch the edges where they end.
    times = space.nodes
    bow = np.stack([0.2 + 0.8 * np.sin(0.5 * np.pi * times), 1.0 - np.cos(0.5 * np.pi * times)])
    guesses = bow + 0.01 * rng.normal(size=(4, 2, 1)) * np.sin(np.pi * times)
    compiled = solve_with_moving_ends(surface, space, guesses, ends)
    with by_numpy():
        plain = solve_with_moving_ends(surface, space, guesses, ends)
    assert np.isfinite(compiled[0]).all()
    assert np.isfinite(plain[0]).all()
    # From far away, rounding errors decide whether steps lead to a path.
    known = np.isfinite(plain) & np.isfinite(compiled)
    assert_near(compiled[known], plain[known], 1e-9)


@given(seeds, st.integers(2, 40), st.tuples(st.integers(1, 4), st.integers(1, 4)))
def test_polygons_at_rest(seed: int, edges: int, degrees: tuple[int, int]) -> None:
    rng = np.random.default_rng(seed)
    line = [np.linspace(0.0, 1.0, each + 1) for each in degrees]
    flat = np.stack(
        [*np.meshgrid(*line, indexing="ij"), np.zeros((degrees[0] + 1, degrees[1] + 1))], 2
    )
    surface = BezierSurfaces(flat + 0.05 * rng.normal(size=(5, *flat.shape)))
    first, last = rng.random((2, 5, 1, 2))
    # Some begin outside the box.
    start = first + (last - first) * np.linspace(0.0, 1.0, edges + 1)[:, None]
    start[:, 1:-1] += 0.1 * rng.normal(size=(5, edges - 1, 2))
    compiled = descend(surface, start)
    with by_numpy():
        plain = descend(surface, start)
    assert ((compiled >= 0.0) & (compiled <= 1.0)).all()
    one, other = (polygon_lengths(surface, each) for each in (compiled, plain))
    np.testing.assert_allclose(one, other, rtol=1e-9)


def test_no_points_have_derivatives_of_the_same_shape() -> None:
    surface = BezierSurfaces(np.zeros((0, 4, 4, 3)))
    assert surface.jet(np.zeros((0, 5, 2)), 2).shape == (6, 3, 0, 5)


@given(seeds, st.integers(1, 40), st.integers(1, 9), st.floats(-0.5, 2.0))
def test_steps_to_the_minima_of_models_in_a_box(
    seed: int, size: int, width: int, definiteness: float
) -> None:
    rng = np.random.default_rng(seed)
    bands = rng.normal(size=(4, min(width, size), size))
    # The last entries of a band lie outside of the matrix: what they are must not matter.
    bands[:, 0] = np.abs(bands[:, 0]) + definiteness * width
    place = np.clip(rng.normal(0.5, 0.5, (4, size)), 0.0, 1.0)
    model = BoxModels(bands, rng.normal(size=(4, size)), place, rng.random((4, size)) < 0.1)
    step, definite = model.steps()
    with by_numpy():
        plain, is_definite = model.steps()
    np.testing.assert_array_equal(definite, is_definite)
    assert not step[~definite].any()
    # A model that is nearly singular has a long step, with few digits.
    for one, other in zip(step, plain, strict=True):
        assert_near(one, other, 1e-9)


def test_models_that_are_not_finite_have_no_step() -> None:
    bands = np.ones((2, 1, 3))
    bands[0, 0, 1] = np.nan
    gradient = np.ones((2, 3))
    gradient[1, 2] = np.inf
    idle = np.zeros((2, 3), bool)
    step, definite = BoxModels(bands, gradient, np.full((2, 3), 0.5), idle).steps()
    assert not definite.any()
    assert not step.any()


@pytest.mark.parametrize("sample", ["female_average", "paraboloid"])
def test_paths_across_patches(sample: str, rng: np.random.Generator) -> None:
    atlas = bm.load_sample(sample)
    for _ in range(6):
        start, end = (
            bm.AtlasPoint(int(rng.integers(len(atlas))), *map(float, rng.random(2)))
            for _ in range(2)
        )
        compiled = bm.geodesic_between(atlas, start, end, on_failure="status")
        with by_numpy():
            plain = bm.geodesic_between(atlas, start, end, on_failure="status")
        assert compiled.status is plain.status
        assert compiled.length == pytest.approx(plain.length, rel=1e-14, nan_ok=True)


@given(
    seeds,
    st.tuples(st.integers(1, 6), st.integers(1, 6)),
    st.integers(0, 3),
    st.sampled_from((1, 3, 4)),
    st.integers(0, 7),
)
def test_derivatives_of_patches(
    seed: int, degrees: tuple[int, int], order: int, coordinates: int, points: int
) -> None:
    rng = np.random.default_rng(seed)
    nets = rng.normal(size=(4, degrees[0] + 1, degrees[1] + 1, coordinates))
    # Between the nodes a path may leave its patch.
    parameters = rng.uniform(-0.1, 1.1, (4, points, 2))
    compiled = BezierSurfaces(nets).jet(parameters, order)
    with by_numpy():
        plain = BezierSurfaces(nets).jet(parameters, order)
    assert compiled.shape == plain.shape
    assert_near(compiled, plain)


@given(seeds, st.integers(1, 9), st.integers(0, 20))
def test_roots_in_brackets(seed: int, degree: int, count: int) -> None:
    rng = np.random.default_rng(seed)
    # They rise or fall in the whole of [0, 1], and touch zero at an end now and then.
    coefficients = np.cumsum(rng.random((count, degree + 1)), axis=1) * rng.choice(
        (-1, 1), (count, 1)
    )
    coefficients -= rng.choice((0.0, 0.5, 1.0), (count, 1)) * coefficients[:, -1:]
    lower, upper = np.sort(rng.random((2, count)), axis=0)
    compiled = bracketed_roots(coefficients, lower, upper)
    with by_numpy():
        plain = bracketed_roots(coefficients, lower, upper)
    np.testing.assert_allclose(compiled, plain, rtol=0.0, atol=1e-14)


@given(seeds, st.integers(1, 6), st.sampled_from((3, 4)))
def test_jets_of_patches_in_powers(seed: int, degree: int, coordinates: int) -> None:
    rng = np.random.default_rng(seed)
    coefficients = rng.random((5, degree + 1, degree + 1, coordinates))
    # A weight of 1 and more everywhere.
    coefficients[:, 0, 0, -1] += 1.0
    x = rng.random((5, 2))
    compiled = jets(coefficients, x)
    with by_numpy():
        assert_near(compiled, jets(coefficients, x))


@given(seeds, st.integers(1, 5))
def test_closest_points_of_patches(seed: int, degree: int) -> None:
    rng = np.random.default_rng(seed)
    coefficients = power_coefficients(rng.normal(size=(6, degree + 1, degree + 1, 3)))
    targets, start = rng.normal(size=(6, 3)), (np.arange(6), rng.random((6, 2)))
    sides = np.full((6, 4), -1)
    seams = PatchSeams(sides, sides, np.zeros((6, 4), dtype=np.bool_))
    _, _, compiled = feet_over_seams(coefficients, seams, targets, start, last_step=1e-12, tied=0.0)
    with by_numpy():
        _, _, plain = feet_over_seams(
            coefficients, seams, targets, start, last_step=1e-12, tied=0.0
        )
    # On a saddle of the distance rounding decides which way a search goes.
    agree = np.abs(compiled - plain) <= 1e-9 * (1.0 + plain)
    assert agree.sum() >= 5


@pytest.mark.parametrize("sample", ["female_average", "paraboloid"])
def test_closest_points_beyond_seams(sample: str, rng: np.random.Generator) -> None:
    atlas = bm.load_sample(sample)
    coefficients = power_coefficients(atlas.control_points)
    seams = PatchSeams(*over_sides(edges_of(atlas)))
    patch = rng.integers(len(atlas), size=300)
    # The search begins on one patch, and its target lies near another one.
    aside, start = rng.normal(scale=0.05, size=(300, 3)), (patch, rng.random((300, 2)))
    targets = atlas.control_points[patch, 0, 0, :3] + aside
    compiled = feet_over_seams(coefficients, seams, targets, start, last_step=1e-10, tied=1e-24)
    with by_numpy():
        plain = feet_over_seams(coefficients, seams, targets, start, last_step=1e-10, tied=1e-24)
    assert (compiled[0] != patch).any() or len(atlas) == 1
    # A tie of two patches is broken by rounding.
    agree = np.abs(compiled[2] - plain[2]) <= 1e-12
    assert agree.mean() > 0.99


@given(seeds, st.integers(1, 6), st.sampled_from((3, 4)), st.integers(0, 6))
def test_points_of_sections(seed: int, degree: int, coordinates: int, count: int) -> None:
    rng = np.random.default_rng(seed)
    nets = rng.random((3, degree + 1, degree + 1, coordinates))
    # The height rises with u and v, so that every level has one place for each of them at most.
    nets[..., 2] = np.cumsum(np.cumsum(nets[..., 2], axis=1), axis=2)
    if coordinates == 4:
        nets = homogeneous(nets[..., :3], np.ones(nets.shape[:3]) * rng.uniform(0.5, 1.0))
    level = float(rng.uniform(0.0, nets[..., 2].max()))
    surface = CutSurface(nets, Plane(level * UP, UP), np.zeros((3, 4), bool))
    start, stop, low, high = rng.random((4, count))
    pieces = Pieces(
        rng.integers(0, 3, count),
        rng.integers(0, 2, count),
        *(start, stop, np.minimum(low, high), np.maximum(low, high)),
    )
    fraction = rng.random((count, 4))
    compiled = surface.points(pieces, fraction)
    with by_numpy():
        plain = surface.points(pieces, fraction)
    for one, other in zip(compiled, plain, strict=True):
        assert one.shape == other.shape
        assert_near(one, other, 1e-11)


@given(seeds, st.integers(2, 6))
def test_normals_and_how_they_bend(seed: int, degree: int) -> None:
    rng = np.random.default_rng(seed)
    nets = rng.normal(size=(4, degree + 1, degree + 1, 3))
    # One patch has a pole.
    nets[1, 0] = nets[1, 0, 0]
    patch, x = rng.integers(0, 4, 12), rng.random((12, 2))
    x[:4, 0] = 0.0
    compiled = normals_and_bends(power_coefficients(nets), patch, x)
    with by_numpy():
        plain = normals_and_bends(power_coefficients(nets), patch, x)
    for one, other in zip(compiled, plain, strict=True):
        # Where tangents are nearly parallel, fewer digits are left.
        assert_near(one, other, 1e-9)


@given(seeds, st.integers(1, 12), st.sampled_from((0.0, 0.3, 3.0)))
def test_the_equilibrium_of_a_string(seed: int, count: int, bend: float) -> None:
    rng = np.random.default_rng(seed)
    nodes, weights = np.cumsum(rng.random((count + 2, 3)), axis=0), rng.uniform(0.5, 1.5, count + 1)
    normal = rng.normal(size=(count, 2, 3))
    normal /= np.linalg.norm(normal, axis=2, keepdims=True)
    curved = bend * rng.normal(size=(count, 2, 3, 3))
    there = rng.random((count, 2)) < (1.0, 0.4)
    gap = np.where(there, rng.uniform(-0.2, 0.5, (count, 2)), 0.0)
    walls = Walls(normal, gap, curved + curved.swapaxes(2, 3), there)
    held, load = rng.random((count, 2)) < 0.4, rng.random((count, 2))
    compiled = equilibrium(nodes, weights, walls, load, held)
    with by_numpy():
        plain = equilibrium(nodes, weights, walls, load, held)
    np.testing.assert_array_equal(compiled[2], plain[2])
    for one, other in zip(compiled[:2], plain[:2], strict=True):
        assert_near(one, other, 1e-9)


@pytest.mark.parametrize("longest", [8192, 8])
@pytest.mark.parametrize(
    "atlas",
    [bm.load_sample("female_average"), bm.load_sample("male_average"), cone(0.5), grid_atlas(1, 1)],
    ids=["female", "male", "cone", "patch"],
)
def test_ways_that_are_pulled_straight(
    atlas: bm.Atlas, longest: int, rng: np.random.Generator, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Strips for which there is no room are left to Python.
    monkeypatch.setattr("bodymeasure.native.ways.LONGEST", longest)
    mesh = patch_graph(atlas).mesh.surface
    for _ in range(6):
        start, end = (
            bm.AtlasPoint(int(rng.integers(len(atlas))), *map(float, rng.random(2)))
            for _ in range(2)
        )
        compiled = first_ways(atlas, start, end)
        with by_numpy():
            plain = first_ways(atlas, start, end)
        assert len(compiled) == len(plain) > 0
        for one, other in zip(compiled, plain, strict=True):
            # A way through a vertex may lead over the faces on either side of it.
            first, second = (along_way(way.points(mesh), COURSE) for way in (one, other))
            assert_near(first, second, 1e-12)
            assert one.length == pytest.approx(other.length, rel=1e-14)
            for found in (one, other):
                assert len(found.along) == len(found.sides) == len(found.strip) - 1


@pytest.mark.parametrize("weights", [[np.nan, 0.5, 0.5], [np.inf, 0.0, 0.0]])
def test_ways_whose_places_are_not_finite_are_left_to_python(weights: list[float]) -> None:
    # Three triangles in a row: a funnel among places that compare with nothing may close on none.
    tip = 0.5 + 0.5j * np.sqrt(3.0)
    mesh = MeshArrays(
        faces=np.array([[0, 1, 2], [1, 3, 2], [2, 3, 4]]),
        over=np.array([[-1, 1, -1], [-1, 2, 0], [1, -1, -1]]),
        apex=np.full((3, 3), tip),
        angle=np.full(5, np.pi),
        vertices=np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], *[[0.5, 1.0, 0.0]] * 3]),
    )
    inside = [0.3, 0.3, 0.4]
    assert isinstance(way_straightened(mesh, (0, 2), (inside, inside), np.array([2])), WayFound)
    for ends in ((weights, inside), (inside, weights), (weights, weights)):
        assert way_straightened(mesh, (0, 2), ends, np.array([2])) == 1


def test_a_loop_round_a_body() -> None:
    atlas = bm.load_sample("female_average")
    compiled = bm.closed_geodesic(atlas, "side waist point left")
    with by_numpy():
        plain = bm.closed_geodesic(atlas, "side waist point left")
    assert compiled.length == pytest.approx(plain.length, rel=1e-14)


def random_nets(rng: np.random.Generator, count: int, kind: str) -> Array:
    """Mild and wild patches over a square, and ones without any shape."""
    if kind == "shapeless":
        return rng.normal(size=(count, 4, 4, 3))
    even, nets = np.linspace(0.0, 1.0, 4), np.zeros((count, 4, 4, 3))
    nets[..., 0], nets[..., 1] = even[:, None], even
    nets[..., 2] = {"mild": 0.3, "wild": 2.0}[kind] * rng.random((count, 4, 4))
    return nets


@pytest.mark.parametrize("lanes", [2, 4, 8])
@pytest.mark.parametrize("kind", ["mild", "wild", "shapeless"])
@pytest.mark.parametrize("ends", ["corners", "anywhere"])
def test_diagonals(kind: str, ends: str, lanes: int, rng: np.random.Generator) -> None:
    # One more than vectors hold.
    nets = random_nets(rng, 41, kind)
    start = rng.integers(0, 2, (41, 2)).astype(float) if ends == "corners" else rng.random((41, 2))
    end = 1.0 - start if ends == "corners" else rng.random((41, 2))

    def solve() -> bm.GeodesicSolution:
        return bm.solve_geodesic(nets, start, end, search="straight", on_failure="status")

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(lengths, "MOST_LANES", lanes)
        compiled = solve()
    with by_numpy():
        plain = solve()
    for name in ("status", "index", "functions", "iterations"):
        np.testing.assert_array_equal(getattr(compiled, name), getattr(plain, name))
    np.testing.assert_allclose(compiled.length, plain.length, rtol=1e-14)
    # What is estimated of differences that nearly vanish is rounding.
    allowed = 1e-3 * plain.error_estimate + 1e-15 * plain.raw_length
    assert (
        np.abs(compiled.error_estimate - plain.error_estimate)[compiled.converged]
        <= allowed[compiled.converged]
    ).all()
    times = np.linspace(0.0, 1.0, 9)
    one, other = (each.path(times)[compiled.converged] for each in (compiled, plain))
    np.testing.assert_allclose(one, other, rtol=0.0, atol=1e-9)


@pytest.mark.parametrize("lanes", [2, 4, 8])
def test_a_diagonal_does_not_depend_on_its_batch(
    lanes: int, monkeypatch: pytest.MonkeyPatch, rng: np.random.Generator
) -> None:
    monkeypatch.setattr(lengths, "MOST_LANES", lanes)
    nets, order = random_nets(rng, 40, "mild"), rng.permutation(40)

    def digits(rows: Ints) -> Array:
        found = bm.solve_geodesic(nets[rows], (0, 0), (1, 1), search="straight")
        names = ("length", "raw_length", "error_estimate", "residual", "functions")
        return np.stack([getattr(found, name) for name in names])

    whole = digits(np.arange(40))
    np.testing.assert_array_equal(digits(order), whole[:, order])
    for rows in (np.arange(3), np.arange(5, 18), np.array([39])):
        np.testing.assert_array_equal(digits(rows), whole[:, rows])


@pytest.mark.parametrize("sample", ["female_average", "male_average"])
def test_diagonals_of_bodies(sample: str) -> None:
    atlas = bm.load_sample(sample)
    compiled = bm.diagonals(atlas, search="straight", on_failure="status")
    with by_numpy():
        plain = bm.diagonals(atlas, search="straight", on_failure="status")
    np.testing.assert_array_equal(compiled.status, plain.status)
    np.testing.assert_array_equal(compiled.index, plain.index)
    np.testing.assert_allclose(compiled.length, plain.length, rtol=1e-14)


def test_kernels_that_do_not_serve_a_space_leave_it_to_numpy(rng: np.random.Generator) -> None:
    nets = random_nets(rng, 20, "mild")
    # Too few functions first, then ones in several pieces, and then others.
    for method in (
        bm.RBFCollocation(functions=(4, 8, 24), tolerance=1e-13),
        bm.RBFCollocation(bm.WU_C2, functions=(8, 12)),
        bm.PolynomialCollocation((7, 9)),
    ):
        compiled = bm.solve_geodesic(nets, (0, 0), (1, 1), method=method, on_failure="status")
        with by_numpy():
            plain = bm.solve_geodesic(nets, (0, 0), (1, 1), method=method, on_failure="status")
        np.testing.assert_array_equal(compiled.status, plain.status)
        np.testing.assert_array_equal(compiled.functions, plain.functions)
        np.testing.assert_allclose(compiled.length, plain.length, rtol=1e-14)


@given(seeds, st.integers(1, 4))
def test_shortest_ways_over_grids_of_patches(seed: int, count: int) -> None:
    rng = np.random.default_rng(seed)
    nets = random_nets(rng, count, "wild")
    # Ways do not lead over places that are not finite.
    nets[0] *= rng.choice([1.0, 1e200])
    surface, ends = BezierSurfaces(nets), rng.random((2, count, 2))
    with np.errstate(all="ignore"):
        compiled = shortest_trees(surface, ends)
        with by_numpy():
            plain = shortest_trees(surface, ends)
    np.testing.assert_allclose(compiled.distance, plain.distance, rtol=1e-12)
    np.testing.assert_allclose(compiled.roughness, plain.roughness, rtol=0.0, atol=1e-12)
    reached = np.isfinite(plain.distance)
    # Of two ways that are as long either may be told.
    same = (compiled.before == plain.before)[reached]
    assert same.all() or same.mean() > 0.99


@given(seeds, st.integers(0, 5), st.integers(1, 11))
def test_extents_of_patches(seed: int, count: int, points: int) -> None:
    rng = np.random.default_rng(seed)
    nets = rng.normal(size=(count, points, 1, 3))
    if count:
        nets[0, 0, 0, 1] = rng.choice([np.nan, np.inf, -np.inf, -3.0])
    with by_numpy():
        plain = extents(nets)
    for one, other in zip(extents(nets), plain, strict=True):
        finite = np.isfinite(plain[1])
        np.testing.assert_array_equal(one[finite], other[finite])
        assert not np.isfinite(one[~finite]).any()
        assert not np.isfinite(other[~finite]).any()


@given(seeds, st.integers(-1074, 1000))
def test_patches_of_size_one(seed: int, exponent: int) -> None:
    nets = np.ldexp(np.random.default_rng(seed).normal(size=(3, 4, 4, 3)), exponent)
    nets[0] = 1.0
    with by_numpy():
        plain = of_size_one(nets)
    for one, other in zip(of_size_one(nets), plain, strict=True):
        np.testing.assert_array_equal(one[1:], other[1:])


@pytest.mark.parametrize(("value", "expected"), [("0", "False"), ("", "True")])
def test_the_environment_switches_the_kernels_off(value: str, expected: str) -> None:
    program = "from bodymeasure.native import is_compiled; print(is_compiled())"
    ran = subprocess.run(
        [sys.executable, "-c", program],
        env={**os.environ, SWITCH: value},
        capture_output=True,
        text=True,
        check=True,
    )
    assert ran.stdout.strip() == expected


def test_an_environment_that_names_no_library_is_refused(tmp_path: Path) -> None:
    other = tmp_path / "other.so"
    other.write_bytes(b"no library")
    for value in ("1", str(other)):
        ran = subprocess.run(
            [sys.executable, "-m", "bodymeasure", "diagonals", "paraboloid"],
            env={**os.environ, SWITCH: value},
            capture_output=True,
            text=True,
            check=False,
        )
        assert ran.returncode == 2
        assert f"{SWITCH} is {value!r}" in ran.stderr
        assert "unset it" in " ".join(ran.stderr.split())
        assert "Traceback" not in ran.stderr


@given(seeds, st.integers(3, 200))
def test_hulls_of_points_in_a_plane(seed: int, count: int) -> None:
    points = np.random.default_rng(seed).standard_normal((count, 2))
    corners, expected = planar_hull(points), scipy.spatial.ConvexHull(points).vertices
    first = int(np.flatnonzero(expected == corners[0])[0])
    np.testing.assert_array_equal(corners, np.roll(expected, -first))


@given(st.integers(1, 5))
def test_points_on_a_line_have_no_hull(count: int) -> None:
    x = np.arange(float(count))
    assert len(planar_hull(np.stack([x, 2.0 * x], axis=1))) < 3
