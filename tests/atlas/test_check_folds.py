"""Patches that fold over."""

import numpy as np
from helpers.surfaces.flawed_atlases import (
    flat,
    moved,
    only,
)
from helpers.surfaces.grids import grid_atlas
from hypothesis import assume, example, given
from hypothesis import strategies as st

from bodymeasure.atlas import (
    Atlas,
    FindingKind,
    Severity,
    check_atlas,
)
from bodymeasure.atlas.check.folds import FINEST_LEVEL

# The points of a grid of 129 along a side of a finest cell of the check, the last one left to the
# next cell.
CELL = 128 >> FINEST_LEVEL


@given(
    crest=st.floats(1.2, 3.0),
    # At 0 the fold runs along u = 1/2, a border of all cells.
    end=st.sampled_from([0.0, 0.3]),
    lift=st.floats(0.0, 1e-3),
    swap=st.booleans(),
    exponent=st.floats(-3.0, 6.0),
)
def test_a_patch_that_runs_back_over_itself_is_folded(
    crest: float, end: float, lift: float, swap: bool, exponent: float
) -> None:
    x = np.array([0.0, crest, crest, end])
    net = flat(*np.meshgrid(x, np.arange(4.0) / 3, indexing="ij"))
    # However slightly the surface rises, it has a normal everywhere.
    net[..., 2] = lift * np.arange(4)[:, None]
    net = net.swapaxes(0, 1) if swap else net
    findings = check_atlas(Atlas.from_control_points(net * 10.0**exponent, "cm"))
    assert (findings[0].severity, findings[0].kind) == (Severity.ERROR, FindingKind.FOLDED_PATCH)
    assert "patch 'patch 0' folds over: its normal turns by 1" in findings[0].message


def test_an_inner_control_point_pulled_across_folds_the_patch() -> None:
    atlas = moved(grid_atlas(3, 3), 4, 1, 1, np.array([6.0, 6.0, 0.0]))
    finding = only(check_atlas(atlas))
    assert finding.kind is FindingKind.FOLDED_PATCH
    assert finding.patches == (4,)


def test_a_corner_turned_inside_out_is_a_fold_however_small() -> None:
    net = grid_atlas(1, 1).control_points[0].copy()
    net[0, 0] = (net[0, 1] + net[1, 0]) / 2 + np.array([0.02, 0.02, 0.0])
    findings = check_atlas(Atlas.from_control_points(net, "cm"))
    assert only(findings).kind is FindingKind.FOLDED_PATCH


@given(st.integers(0, 2**32 - 1))
# The tangents at a corner are parallel but for half a degree, and it is turned over there.
@example(12097545)
def test_flat_patches_are_folded_exactly_where_their_area_changes_sign(seed: int) -> None:
    rng = np.random.default_rng(seed)
    net = grid_atlas(1, 1).control_points[0] + 0.4 * rng.normal(size=(4, 4, 3)) * [1, 1, 0]
    t = np.linspace(0.0, 1.0, 129)
    basis = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3], axis=-1)
    slope = np.gradient(basis, t, axis=0, edge_order=2)
    x_u, y_u, _ = np.moveaxis(np.einsum("ai,bj,ijc->abc", slope, basis, net), -1, 0)
    x_v, y_v, _ = np.moveaxis(np.einsum("ai,bj,ijc->abc", basis, slope, net), -1, 0)
    area = x_u * y_v - x_v * y_u
    findings = check_atlas(Atlas.from_control_points(net, "cm"))
    # A corner with nearly parallel tangents is a finding of its own, whichever way they are turned
    # (`test_parallel_tangents_at_a_corner_are_a_warning`): no fold is sought in its finest cell.
    for corner in (rf"({i}, {j})" for i in (0, 1) for j in (0, 1)):
        if any(f"corner (u, v) = {corner}" in finding.message for finding in findings):
            own = tuple(slice(None, CELL) if k == "0" else slice(-CELL, None) for k in corner[1::3])
            area[own] = np.nan
    # Differences are off by 1e-3; patches this close to the limit are left out.
    assume(np.nanmin(area) * np.nanmax(area) < 0 or np.nanmin(abs(area)) > 0.02)
    assume(min(-np.nanmin(area), np.nanmax(area)) > 0.02 or np.nanmin(abs(area)) > 0.02)
    folded = np.nanmin(area) * np.nanmax(area) < 0
    kinds = {finding.kind for finding in findings}
    assert (FindingKind.FOLDED_PATCH in kinds) == folded
