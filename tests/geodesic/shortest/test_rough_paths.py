"""Graphs over grids of patches: distances, and paths that differ."""

import numpy as np
import pytest

from bodymeasure._typing import Array
from bodymeasure.geodesic.shortest.grid_graph import LINES, grid_points, shortest_trees
from bodymeasure.geodesic.shortest.polygon_energy import polygon_lengths
from bodymeasure.geodesic.shortest.rough_paths import MOST_PATHS, rough_paths
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.geodesic.surfaces.custom import CustomSurface

# With 16 directions, a path over the grid is longer than the straight one by at most this part.
WORST_DETOUR = 1.0 / np.cos(0.5 * np.arctan(1.0 / 3.0))


def heights(z: Array) -> BezierSurfaces:
    line = np.linspace(0.0, 1.0, 4)
    x, y = np.broadcast_arrays(line[:, None], line)
    return BezierSurfaces(np.stack([np.broadcast_to(each, z.shape) for each in (x, y, z)], axis=-1))


def hump() -> BezierSurfaces:
    z = np.zeros((1, 4, 4))
    z[:, 1:3, 1:3] = 2.0
    return heights(z)


def test_distances_in_a_plane(rng: np.random.Generator) -> None:
    ends = rng.random((2, 5, 2))
    ends[:, 0] = (0.0, 0.0), (1.0, 1.0)
    surface = heights(np.zeros((5, 4, 4)))
    trees = shortest_trees(surface, ends)
    straight = np.linalg.norm(ends[:, :, None] - grid_points(), axis=-1)
    assert (trees.distance >= straight - 1e-15).all()
    assert (trees.distance <= WORST_DETOUR * straight + 1.0 / (LINES - 1)).all()
    from_corner = trees.distance[0, 0].reshape(LINES, LINES)
    assert from_corner[0, 0] == pytest.approx(0.0, abs=1e-15)
    assert from_corner[-1, -1] == pytest.approx(np.sqrt(2.0), rel=1e-14)
    assert from_corner[3, 9] == pytest.approx(np.hypot(0.25, 0.75), rel=1e-14)


def test_the_point_before_lies_nearer_to_the_end(rng: np.random.Generator) -> None:
    surface = heights(rng.random((4, 4, 4)))
    trees = shortest_trees(surface, rng.random((2, 4, 2)))
    size = LINES * LINES
    assert ((trees.before >= 0) & (trees.before <= size)).all()
    known = np.concatenate([trees.distance, np.zeros((2, 4, 1))], axis=2)
    assert (np.take_along_axis(known, trees.before, axis=2) < trees.distance).all()


def test_ways_round_a_hump() -> None:
    ends = np.array([[[0.0, 0.0]], [[1.0, 1.0]]])
    rough = rough_paths(hump(), ends, 32)
    assert (rough.problems == 0).all()
    assert 2 <= len(rough.points) <= MOST_PATHS
    across = rough.points[:, 16, 0] - rough.points[:, 16, 1]
    assert across.min() < -0.3
    assert across.max() > 0.3
    over = polygon_lengths(hump(), np.linspace(ends[0], ends[1], 33).swapaxes(0, 1))
    lengths = polygon_lengths(hump().take(rough.problems), rough.points)
    assert (lengths[:2] < 0.99 * over).all()


def test_polygons_run_from_start_to_end_in_equal_steps(rng: np.random.Generator) -> None:
    surface = heights(rng.random((6, 4, 4)))
    ends = rng.random((2, 6, 2)) * (1.0, 0.3)
    ends[1, :, 1] += 0.7
    rough = rough_paths(surface, ends, 32)
    assert set(rough.problems) == set(range(6))
    assert (rough.points[:, 0] == ends[0, rough.problems]).all()
    assert (rough.points[:, -1] == ends[1, rough.problems]).all()
    positions = surface.take(rough.problems).jet(rough.points, 0)[0]
    steps = np.linalg.norm(np.diff(positions, axis=-1), axis=0)
    # The lengths are equal but for what is cut off where a polygon turns or the surface bends.
    assert (steps.max(axis=1) < 1.2 * np.median(steps, axis=1)).all()


def test_in_a_plane_the_first_way_is_straight() -> None:
    ends = np.array([[[0.1, 0.2]], [[0.9, 0.3]]])
    rough = rough_paths(heights(np.zeros((1, 4, 4))), ends, 32)
    first = rough.points[0]
    assert first[:, 0] == pytest.approx(np.linspace(0.1, 0.9, 33), abs=0.05)
    assert first[:, 1] == pytest.approx(np.linspace(0.2, 0.3, 33), abs=0.05)


def test_ways_keep_off_what_is_not_finite() -> None:
    def derivatives(parameters: Array) -> Array:
        """A plane with a hole across the straight line."""
        u, v = parameters[..., 0], parameters[..., 1]
        result = np.zeros((*u.shape, 10, 3))
        result[..., 0, 0], result[..., 0, 1] = u, v
        result[..., 1, 0] = result[..., 2, 1] = 1.0
        result[np.hypot(u - 0.5, v - 0.5) < 0.2] = np.nan
        return result

    surface = CustomSurface(derivatives)
    rough = rough_paths(surface, np.array([[[0.0, 0.0]], [[1.0, 1.0]]]), 32)
    assert len(rough.points) >= 2
    assert np.isfinite(rough.points).all()
    gap = np.linalg.norm(rough.points - 0.5, axis=-1).min(axis=1)
    assert (gap > 0.15).all()
