import numpy as np
import pytest
from helpers.surfaces.grids import grid_atlas
from hypothesis import given
from hypothesis import strategies as st

from bodymeasure import Atlas, InputError, Unit, check_atlas
from bodymeasure._typing import Array
from bodymeasure.atlas import FindingKind, edge_table, weld


def hills(x: Array, y: Array) -> Array:
    return np.stack([x, y, 0.2 * np.sin(x + 2.0 * y)], axis=-1)


GRID = grid_atlas(3, 4, hills)


def welded(nets: Array, tolerance: float | None = None) -> Atlas:
    points, index = weld(nets, tolerance)
    assert points.shape == (index.max() + 1, 3)
    return Atlas(points, index, Unit.CM)


def kinds(atlas: Atlas) -> set[FindingKind]:
    return {finding.kind for finding in check_atlas(atlas)}


def turned(nets: Array, rng: np.random.Generator) -> Array:
    """The patches with their parameters swapped or reversed at random."""
    result = nets.copy()
    for net in result:
        net[:] = np.rot90(net, int(rng.integers(4)))
        if rng.random() < 0.5:
            net[:] = net.transpose(1, 0, 2)
    return result


def test_a_grid_gets_its_index_back_however_its_patches_are_turned(
    rng: np.random.Generator,
) -> None:
    for nets in (GRID.control_points, turned(GRID.control_points, rng)):
        atlas = welded(nets)
        np.testing.assert_array_equal(atlas.control_points, nets)
        assert len(atlas.points) == len(GRID.points)
        assert (edge_table(atlas.index).sides == 2).sum() == 3 * 3 + 2 * 4


@given(seed=st.integers(0, 2**32 - 1))
def test_rounding_does_not_part_patches(seed: int) -> None:
    rng = np.random.default_rng(seed)
    nets = turned(GRID.control_points, rng)
    rough = nets + rng.uniform(-1e-8, 1e-8, nets.shape)
    atlas = welded(rough)
    assert len(atlas.points) == len(GRID.points)
    np.testing.assert_allclose(atlas.control_points, nets, rtol=0, atol=1.01e-8)


def test_points_are_numbered_in_the_order_of_the_patches() -> None:
    points, index = weld(GRID.control_points)
    first = np.unique(index, return_index=True)[1]
    assert (np.diff(first) > 0).all()
    np.testing.assert_array_equal(points[index], GRID.control_points)


@pytest.mark.parametrize("gap", [1e-3, 0.02])
def test_a_gap_stays_and_is_reported_unless_it_is_within_the_tolerance(gap: float) -> None:
    nets = grid_atlas(1, 2).control_points.copy()
    nets[1, :, 0, 2] += gap
    assert len(welded(nets).points) == 32
    assert FindingKind.SEAM_GAP in kinds(welded(nets))
    assert len(welded(nets, 0.9 * gap).points) == 32
    joined = welded(nets, 1.1 * gap)
    assert len(joined.points) == 28
    assert FindingKind.SEAM_GAP not in kinds(joined)
    # The first patch keeps its place.
    np.testing.assert_array_equal(joined.control_points[0], nets[0])


def test_a_huge_tolerance_does_not_close_up_narrow_patches() -> None:
    atlas = grid_atlas(1, 3, lambda x, y: np.stack([x, 0.05 * y, 0.0 * x], axis=-1))
    assert len(welded(atlas.control_points, 10.0).points) == len(atlas.points)


def test_t_junctions_stay_and_are_reported() -> None:
    nets = grid_atlas(1, 2).control_points.copy()
    wide = grid_atlas(1, 1).control_points.copy()
    wide[..., 0] = 1.0 + wide[..., 0]
    wide[..., 1] *= 2.0
    atlas = welded(np.concatenate([nets, wide]))
    assert len(atlas.points) == 28 + 16
    assert FindingKind.T_JUNCTION in kinds(atlas)


def cap(count: int) -> Array:
    """Sectors of a dome, whose top is the edge u = 0 of each."""
    angle = 2.0 * np.pi * np.arange(3 * count + 1) / (3 * count)
    # Seams agree to the last bit.
    circle = np.stack([np.cos(angle), np.sin(angle), 0.0 * angle], axis=-1)
    circle[-1] = circle[0]
    radius = np.array([0.0, 1.0, 2.0, 3.0])[:, None, None]
    dome = radius * circle + np.array([0.0, 0.0, 1.0]) * (5.0 - radius**2 / 3.0)
    return np.stack([dome[:, 3 * k : 3 * k + 4] for k in range(count)])


@pytest.mark.parametrize("count", [2, 3, 4])
def test_collapsed_edges_become_one_point_for_all_patches_round_it(count: int) -> None:
    atlas = welded(cap(count))
    assert len(np.unique(atlas.index[:, 0])) == 1
    assert len(atlas.points) == 1 + 3 * 3 * count
    assert FindingKind.SEPARATE_PARTS not in kinds(atlas)


def test_a_patch_that_closes_on_itself_is_joined_to_itself() -> None:
    (net,) = cap(1)
    net = net[None, ::-1]
    atlas = welded(net)
    np.testing.assert_array_equal(atlas.index[0, :, 0], atlas.index[0, :, 3])
    assert len(atlas.points) == 1 + 3 * 3


def test_three_patches_on_one_edge_are_all_joined_and_reported() -> None:
    nets = np.concatenate([grid_atlas(1, 2).control_points, grid_atlas(1, 1).control_points])
    nets[2] = nets[2][..., [0, 2, 1]] + np.array([0.0, 1.0, 0.0])
    atlas = welded(nets)
    assert edge_table(atlas.index).sides.max() == 3
    assert FindingKind.NON_MANIFOLD_SEAM in kinds(atlas)


def test_patches_that_touch_at_a_corner_alone_stay_apart() -> None:
    nets = np.concatenate([GRID.control_points[:1], GRID.control_points[5:6]])
    assert len(welded(nets).points) == 32


def test_many_copies_of_one_patch_are_one_place() -> None:
    nets = np.repeat(GRID.control_points[:1], 3000, axis=0)
    atlas = welded(nets)
    # These are all but the four inner control points.
    assert len(atlas.points) == 12 + 4 * 3000


def test_a_size_beyond_all_bounds_is_refused() -> None:
    with pytest.raises(InputError, match=r"extends over 3e\+200; expected a size between"):
        weld(3e200 * np.ones((1, 4, 4, 3)))


@pytest.mark.parametrize("nudge", [0.0, 1e-9])
def test_edges_with_other_weights_stay_apart(nudge: float, rng: np.random.Generator) -> None:
    nets = turned(grid_atlas(1, 3).control_points, rng)
    nets[1] += nudge
    lattice = rng.uniform(0.5, 2.0, (4, 10))
    weights = np.stack([lattice[:, 3 * k : 3 * k + 4] for k in range(3)])
    # The weights are turned as the nets are, and found by their positions.
    for net, own in zip(nets, weights, strict=True):
        at = np.round(3.0 * net[..., :2]).astype(np.int64)
        own[:] = lattice[at[..., 0], at[..., 1]]
    # Proportional weights are the same.
    weights[1] *= 3.0
    points, index = weld(nets, weights=weights)
    assert len(points) == 40
    Atlas(points, index, Unit.CM, weights=weights)
    # There is another weight on the seam between the last two.
    weights[2][np.isclose(nets[2, ..., :2], [2 / 3, 2.0]).all(axis=-1)] *= 1.1
    points, index = weld(nets, weights=weights)
    assert len(points) == 28 + 16
    Atlas(points, index, Unit.CM, weights=weights)
