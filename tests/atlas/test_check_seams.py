"""Gaps, edges that are not joined, kinks, and patches that face the wrong way."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.surfaces.flawed_atlases import (
    bumpy,
    only,
    separated,
)
from helpers.surfaces.grids import grid_atlas
from helpers.surfaces.quadrics import sphere_nets

from bodymeasure._typing import Array
from bodymeasure.atlas import (
    Atlas,
    AtlasPoint,
    FindingKind,
    Severity,
    Unit,
    check_atlas,
    weld,
)
from bodymeasure.bezier import elevate, project
from bodymeasure.measure import body_girth


@pytest.mark.parametrize("gap", [1e-4, 0.01, 0.05])
def test_a_patch_moved_away_leaves_gaps(gap: float) -> None:
    findings = check_atlas(separated(grid_atlas(3, 3), 4, gap))
    gaps = [finding for finding in findings if finding.kind is FindingKind.SEAM_GAP]
    assert {finding.patches for finding in gaps} == {(1, 4), (3, 4), (4, 5), (4, 7)}
    assert all(finding.severity is Severity.ERROR for finding in gaps)
    assert f"nearly meet but leave a gap of up to {gap:.3g} cm" in gaps[0].message
    assert "edge u = 1 of patch 'patch 1' and edge u = 0 of patch 'patch 4'" in gaps[0].message
    rest = {finding.kind for finding in findings} - {FindingKind.SEAM_GAP}
    assert rest == {FindingKind.SEPARATE_PARTS}


def test_a_gap_between_shared_corners_is_found() -> None:
    atlas = grid_atlas(2, 1)
    points = np.concatenate([atlas.points, atlas.points[atlas.index[1, 0, 1:3]] + [0, 0, 0.04]])
    index = atlas.index.copy()
    index[1, 0, 1:3] = [len(atlas.points), len(atlas.points) + 1]
    findings = check_atlas(replace(atlas, points=points, index=index))
    gap = next(finding for finding in findings if finding.kind is FindingKind.SEAM_GAP)
    # Two of the four control points are off by 0.04, the curve by 3/4 of it.
    assert "a gap of up to 0.03 cm" in gap.message


def test_a_gap_is_found_whichever_way_the_edges_run() -> None:
    atlas = separated(grid_atlas(2, 1), 1, 0.01)
    for turns in range(4):
        index = atlas.index.copy()
        index[1] = np.rot90(index[1], turns)
        findings = check_atlas(replace(atlas, index=index))
        assert [f.patches for f in findings if f.kind is FindingKind.SEAM_GAP] == [(0, 1)]


def test_patches_far_apart_are_parts_not_gaps() -> None:
    finding = only(check_atlas(separated(grid_atlas(2, 1), 1, 0.5)))
    assert (finding.severity, finding.kind) == (Severity.WARNING, FindingKind.SEPARATE_PARTS)
    assert "2 parts that share no seam (1 with patch 'patch 0', 1 with 'patch 1')" in (
        finding.message.replace("with patch 'patch 1'", "with 'patch 1'")
    )


@pytest.mark.parametrize("noise", [0.0, 1e-8])
def test_seams_that_coincide_but_are_not_joined_are_one_warning(
    noise: float, rng: np.random.Generator
) -> None:
    nets = grid_atlas(3, 3).control_points
    nets = nets + noise * rng.uniform(-1, 1, size=nets.shape)
    finding = only(check_atlas(Atlas.from_control_points(nets, "cm")))
    assert (finding.severity, finding.kind) == (Severity.WARNING, FindingKind.UNJOINED_SEAM)
    assert finding.patches == tuple(range(9))
    assert finding.message.startswith("12 seams are not joined by index")


def test_an_edge_with_three_patches_is_an_error() -> None:
    atlas = grid_atlas(2, 1)
    wing = atlas.control_points[1] @ np.diag([0.0, 1.0, 0.0]) + [1.0, 0.0, 0.0]
    wing[..., 2] = np.arange(4)[:, None] / 3
    index = np.concatenate([atlas.index, len(atlas.points) + np.arange(16).reshape(1, 4, 4)])
    index[2, 0] = index[1, 0]
    points = np.concatenate([atlas.points, wing.reshape(-1, 3)])
    finding = check_atlas(Atlas(points, index, Unit.CM))[0]
    assert (finding.severity, finding.kind) == (Severity.ERROR, FindingKind.NON_MANIFOLD_SEAM)
    assert finding.patches == (0, 1, 2)
    assert finding.message.startswith(
        "3 patches meet along one edge: edge u = 1 of patch 'patch 0', "
        "edge u = 0 of patch 'patch 1', edge u = 0 of patch 'patch 2'"
    )


@pytest.mark.parametrize("number", range(9))
def test_a_patch_turned_round_is_named(number: int, rng: np.random.Generator) -> None:
    atlas = bumpy(rng, height=0.01)
    index = atlas.index.copy()
    index[number] = index[number, ::-1]
    finding = only(check_atlas(replace(atlas, index=index)))
    assert (finding.severity, finding.kind) == (Severity.WARNING, FindingKind.ORIENTATION)
    assert finding.patches == (number,)


def test_rows_may_run_any_way_that_keeps_the_side(rng: np.random.Generator) -> None:
    atlas = bumpy(rng, height=0.01)
    index = np.array([np.rot90(net, int(rng.integers(4))) for net in atlas.index])
    assert check_atlas(replace(atlas, index=index)) == ()


def test_a_moebius_band_has_one_side() -> None:
    count = 9
    turn = 2 * np.pi * np.arange(3 * count) / (3 * count)
    across = np.linspace(-0.4, 0.4, 4)
    radius = 2 + across[None] * np.cos(turn / 2)[:, None]
    points = np.stack(
        [
            radius * np.cos(turn)[:, None],
            radius * np.sin(turn)[:, None],
            across[None] * np.sin(turn / 2)[:, None],
        ],
        axis=-1,
    )
    rows = np.arange(12 * count).reshape(-1, 4)
    rows = np.concatenate([rows, rows[:1, ::-1]])
    index = np.stack([rows[3 * i : 3 * i + 4] for i in range(count)])
    findings = check_atlas(Atlas(points.reshape(-1, 3), index, Unit.CM))
    one_sided = [finding for finding in findings if finding.kind is FindingKind.ORIENTATION]
    assert "form a surface with one side only" in only(tuple(one_sided)).message


@pytest.mark.parametrize("angle", [5.0, 14.0, 16.0, 90.0, 170.0])
@pytest.mark.parametrize("reverse", [False, True])
def test_a_kinked_seam_is_reported_with_its_angle(angle: float, reverse: bool) -> None:
    def bent(x: Array, y: Array) -> Array:
        slope = np.radians(angle)
        beyond = np.maximum(x - 1.0, 0.0)
        return np.stack([x - beyond + beyond * np.cos(slope), y, beyond * np.sin(slope)], axis=-1)

    atlas = grid_atlas(2, 1, bent)
    index = atlas.index.copy()
    index[1] = index[1, ::-1] if reverse else index[1]
    kinks = [
        finding
        for finding in check_atlas(replace(atlas, index=index))
        if finding.kind is FindingKind.KINKED_SEAM
    ]
    if angle < 15.0:
        assert kinks == []
        return
    assert only(tuple(kinks)).severity is Severity.WARNING
    assert f"the normal jumps by {angle:.0f} degrees between edge u = 1" in kinks[0].message


def test_an_edge_met_in_its_middle_is_a_t_junction() -> None:
    # There is one patch of side 2 below, and two of side 1 above it.
    left, right = grid_atlas(2, 1).control_points + np.array([0.0, 1.0, 0.0])
    below = grid_atlas(1, 1).control_points[0] * [2.0, 1.0, 1.0]
    findings = check_atlas(Atlas.from_control_points([below, left, right], "cm"))
    touched = next(f for f in findings if f.kind is FindingKind.T_JUNCTION)
    assert touched.severity is Severity.WARNING
    assert touched.patches[0] == 0
    assert "edge v = 1 of patch 'patch 0' is touched in its middle" in touched.message


def test_open_edges_that_merely_share_a_corner_are_no_fault() -> None:
    atlas = grid_atlas(3, 3)
    assert (
        check_atlas(replace(atlas, index=atlas.index[[0, 1, 3]], patch_names=(), regions=())) == ()
    )


@pytest.mark.parametrize("magnitude", [0.0, 12.0, 290.0])
def test_a_factor_of_a_patchs_weights_changes_nothing(
    magnitude: float, rng: np.random.Generator
) -> None:
    nets = elevate(sphere_nets(), 3, 3)
    factor = 10.0 ** rng.uniform(-magnitude, magnitude, (len(nets), 1, 1))
    weights = nets[..., 3] * factor
    points, index = weld(project(nets), weights=weights)
    sphere = Atlas(points, index, Unit.M, weights=weights)
    assert len(points) == 62
    assert {finding.kind for finding in check_atlas(sphere)} == {FindingKind.COLLAPSED_EDGE}
    position = sphere.position(AtlasPoint(0, 0.3, 0.4))
    girth = body_girth(sphere, AtlasPoint(0, 0.3, 0.4)).contact
    assert girth == pytest.approx(2.0 * np.pi * np.hypot(*position[:2]), rel=1e-13)


def test_weights_of_many_magnitudes_are_joined() -> None:
    """Check that numbers are the same but for rounding, relative to each."""
    weights = np.broadcast_to([1e-12, 1.0, 3.0, 1e-7], (2, 4, 4)).copy()
    weights[1] *= 0.3 * (1.0 + 2e-16 * np.array([1.0, -1.0, 1.0, 0.0]))
    nets = grid_atlas(2, 1).control_points
    points, index = weld(nets, weights=weights)
    assert len(points) == 28
    assert len(Atlas(points, index, Unit.M, weights=weights)) == 2
    weights[1, 0, 0] *= 1.0 + 1e-9
    assert len(weld(nets, weights=weights)[0]) == 32
