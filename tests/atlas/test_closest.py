"""Closest points of an atlas."""

import numpy as np
import pytest
from helpers.surfaces.surfaces import SURFACES, Surface
from numpy.typing import ArrayLike

from bodymeasure import Atlas, InputError, Unit
from bodymeasure._typing import Array
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.bezier import derivatives, evaluate


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(1)


def _quarter_pipe_and_plane() -> Atlas:
    """A bent patch and a flat one that share the edge x = 0, by index."""
    x, y = np.meshgrid(np.linspace(-1, 1, 7), np.linspace(0, 1, 4), indexing="ij")
    points = np.stack([x, y, np.where(x < 0, x**2, 0.0)], axis=-1)
    number = np.arange(28).reshape(7, 4)
    return Atlas(points.reshape(-1, 3), np.stack([number[:4], number[3:]]), Unit.CM)


def _parameters(atlas: Atlas, positions: Array) -> tuple[Array, Array]:
    points, distances = closest_points(atlas, positions)
    return np.array([(point.u, point.v) for point in points]), distances


@pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
def test_points_of_the_surface_are_found(surface: Surface, rng: np.random.Generator) -> None:
    atlas = Atlas.from_control_points(surface.control_points, "cm")
    wanted = np.concatenate([rng.random((30, 2)), [(0, 0), (1, 0), (0, 0.3), (1, 1)]])
    found, distances = _parameters(atlas, evaluate(surface.control_points, wanted))
    np.testing.assert_allclose(found, wanted, atol=1e-12)
    np.testing.assert_allclose(distances, 0.0, atol=1e-14)


@pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
@pytest.mark.parametrize("height", [0.05, -0.05])
def test_an_offset_along_the_normal_returns_its_foot(
    surface: Surface, height: float, rng: np.random.Generator
) -> None:
    atlas = Atlas.from_control_points(surface.control_points, "cm")
    wanted = rng.random((30, 2))
    s = derivatives(surface.control_points, wanted, order=1)
    normal = np.cross(s[:, 1, 0], s[:, 0, 1])
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    found, distances = _parameters(atlas, s[:, 0, 0] + height * normal)
    np.testing.assert_allclose(found, wanted, atol=1e-12)
    np.testing.assert_allclose(distances, abs(height), rtol=1e-12)


def test_positions_beyond_the_boundary_land_on_edges_and_corners() -> None:
    plane = np.stack(np.meshgrid(*2 * [np.linspace(0, 1, 4)], [0.0], indexing="ij"), -1)[:, :, 0]
    atlas = Atlas.from_control_points(plane, "cm")
    found, distances = _parameters(
        atlas, np.array([[2.0, 0.25, 0.0], [0.5, -3.0, 4.0], [-3.0, -4.0, 0.0], [1.5, 1.5, 0.0]])
    )
    np.testing.assert_allclose(found, [(1, 0.25), (0.5, 0), (0, 0), (1, 1)], atol=1e-14)
    assert set(found[[0, 2, 3]][:, 0]) == {0.0, 1.0}, "on the boundary, not beside it"
    np.testing.assert_allclose(distances, [1.0, 5.0, 5.0, np.sqrt(0.5)], rtol=1e-14)


def test_no_denser_sampling_finds_a_closer_point(rng: np.random.Generator) -> None:
    side = np.linspace(0.0, 1.0, 4)
    flat = np.stack(np.meshgrid(side, side, [0.0], indexing="ij"), -1)[:, :, 0]
    nets = flat + rng.normal(scale=0.4, size=(6, 4, 4, 3))
    atlas = Atlas.from_control_points(nets, "cm")
    positions = rng.uniform(-1.0, 2.0, (40, 3))
    points, distances = closest_points(atlas, positions)
    reached = np.array([atlas.position(point) for point in points])
    np.testing.assert_allclose(np.linalg.norm(reached - positions, axis=1), distances, rtol=1e-13)

    fine = np.linspace(0.0, 1.0, 201)
    grid = np.stack(np.meshgrid(fine, fine, indexing="ij"), -1)
    samples = evaluate(nets, np.broadcast_to(grid, (6, 201, 201, 2))).reshape(-1, 3)
    dense = np.array([np.linalg.norm(samples - position, axis=1).min() for position in positions])
    assert (distances <= dense + 1e-14).all()
    # Away from the boundary the grid's closest point is off by its spacing squared.
    assert (dense - distances < 1e-2).all()


def test_a_seam_gives_the_lower_patch_and_both_sides_agree() -> None:
    atlas = _quarter_pipe_and_plane()
    seam = np.stack([np.zeros(5), np.linspace(0, 1, 5), np.zeros(5)], axis=1)
    points, distances = closest_points(atlas, seam)
    assert [point.patch for point in points] == [0] * 5
    np.testing.assert_allclose([point.u for point in points], 1.0, atol=1e-12)
    np.testing.assert_allclose(distances, 0.0, atol=1e-14)


def test_a_patch_collapsed_to_a_line_is_still_searched() -> None:
    line = np.zeros((4, 4, 3))
    line[..., 0] = np.linspace(0, 1, 4)[:, None]
    found, distances = _parameters(Atlas.from_control_points(line, "cm"), np.array([[0.3, 1, 0]]))
    assert found[0, 0] == pytest.approx(0.3, abs=1e-12)
    assert distances[0] == pytest.approx(1.0, rel=1e-14)


def test_lengths_scale_with_the_unit(rng: np.random.Generator) -> None:
    atlas = Atlas.from_control_points(SURFACES[0].control_points, "m")
    positions = rng.uniform(0.0, 1.0, (10, 3))
    found, distances = _parameters(atlas, positions)
    found_mm, distances_mm = _parameters(atlas.converted("mm"), 1000.0 * positions)
    np.testing.assert_allclose(found_mm, found, atol=1e-10)
    np.testing.assert_allclose(distances_mm, 1000.0 * distances, rtol=1e-12)


def test_no_positions_give_no_points() -> None:
    atlas = _quarter_pipe_and_plane()
    points, distances = closest_points(atlas, np.empty((0, 3)))
    assert points == ()
    assert distances.shape == (0,)


@pytest.mark.parametrize(
    ("positions", "message"),
    [([0.0, 0.0, 0.0], r"shape \(3,\); expected \(k, 3\)"), ([[0.0, np.nan, 0.0]], "position 0")],
)
def test_bad_positions_are_named(positions: ArrayLike, message: str) -> None:
    with pytest.raises(InputError, match=message):
        closest_points(_quarter_pipe_and_plane(), positions)
