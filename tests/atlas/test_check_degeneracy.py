"""Patches, edges and corners that collapse."""

import numpy as np
import pytest
from helpers.surfaces.flawed_atlases import bumpy, flat, lid, only
from helpers.surfaces.grids import grid_atlas
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from bodymeasure._typing import Array
from bodymeasure.atlas import (
    Atlas,
    FindingKind,
    Severity,
    Unit,
    check_atlas,
)


@pytest.mark.parametrize("position", [[0.0, 0, 0], [1e3, 2e3, -3e3]])
def test_a_patch_of_one_point_is_an_error(position: list[float]) -> None:
    net = np.broadcast_to(position, (4, 4, 3))
    finding = only(check_atlas(Atlas.from_control_points(net, "cm")))
    assert (finding.severity, finding.kind) == (Severity.ERROR, FindingKind.COLLAPSED_PATCH)
    assert finding.patches == (0,)
    assert finding.message.startswith(
        "patch 'patch 0' has no area: its 16 control points span 0 cm"
    )


@given(arrays(np.float64, (4, 4), elements=st.floats(-1.0, 1.0)))
def test_a_patch_on_a_line_is_an_error(along: Array) -> None:
    net = along[..., None] * np.array([1.0, -2.0, 0.3]) + 5.0
    findings = check_atlas(Atlas.from_control_points(net, "cm"))
    assert [finding.kind for finding in findings] == [FindingKind.COLLAPSED_PATCH]


def test_a_collapsed_patch_among_sound_ones_is_found(rng: np.random.Generator) -> None:
    nets = bumpy(rng).control_points + 10.0 * np.arange(9)[:, None, None, None]
    nets[4] = nets[4, 0, 0] + 1e-9 * rng.random((4, 4, 3))
    kinds = {f.kind: f.patches for f in check_atlas(Atlas.from_control_points(nets, "cm"))}
    assert kinds[FindingKind.COLLAPSED_PATCH] == (4,)


@pytest.mark.parametrize("noise", [0.0, 1e-12, 1e-9, 3e-7])
def test_a_lids_tip_is_only_a_warning(noise: float, rng: np.random.Generator) -> None:
    net = lid()
    net[0] += noise * rng.uniform(-1, 1, size=(4, 3))
    finding = only(check_atlas(Atlas.from_control_points(net, "cm")))
    assert (finding.severity, finding.kind) == (Severity.WARNING, FindingKind.COLLAPSED_EDGE)
    assert "edge u = 0 of patch 'patch 0' is a single point" in finding.message


def test_the_patches_round_a_lids_tip_are_one_surface() -> None:
    turn = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    nets, net = [], lid()
    for _ in range(4):
        nets.append(net)
        net = net @ turn.T
    atlas = Atlas.from_control_points(nets, "cm")
    kinds = [finding.kind for finding in check_atlas(atlas)]
    assert kinds == [FindingKind.COLLAPSED_EDGE] * 4 + [FindingKind.UNJOINED_SEAM]


@pytest.mark.parametrize(
    ("corner", "name"),
    [((0, 0), "(0, 0)"), ((3, 0), "(1, 0)"), ((0, 3), "(0, 1)"), ((3, 3), "(1, 1)")],
)
@pytest.mark.parametrize("excess", [-1e-3, -1e-12, 0.0, 1e-12, 1e-3])
def test_parallel_tangents_at_a_corner_are_a_warning(
    corner: tuple[int, int], name: str, excess: float
) -> None:
    # The control points next to the corner straighten it to an angle of 180 degrees.
    i, j = corner
    net = grid_atlas(1, 1).control_points[0].copy()
    along_u, along_v = (abs(i - 1), j), (i, abs(j - 1))
    middle = (net[along_u] + net[along_v]) / 2
    net[i, j] = middle + excess * (net[1, 1] - net[i, j])
    finding = only(check_atlas(Atlas.from_control_points(net, "cm")))
    assert (finding.severity, finding.kind) == (Severity.WARNING, FindingKind.SINGULAR_CORNER)
    assert f"(u, v) = {name} have tangents there" in finding.message


def test_a_point_without_a_normal_inside_is_a_warning() -> None:
    # x = (2u - 1)^3 stops at u = 1/2 without turning back.
    net = flat(*np.meshgrid([-1.0, 1.0, -1.0, 1.0], np.arange(4.0), indexing="ij"))
    finding = only(check_atlas(Atlas.from_control_points(net, "cm")))
    assert (finding.severity, finding.kind) == (Severity.WARNING, FindingKind.SINGULAR_POINT)
    assert "no normal near (u, v) = (0.4" in finding.message or "(0.5" in finding.message


def test_a_patch_without_area_has_no_seams() -> None:
    """Though its neighbor has, whose side is an edge like any other: that one is open then."""
    net = grid_atlas(1, 1).control_points[0]
    flat = np.repeat(net[:, 3:], 4, axis=1)
    index = np.arange(32).reshape(2, 4, 4)
    index[1, :, 0] = index[0, :, 3]
    atlas = Atlas(np.concatenate([net, flat]).reshape(-1, 3), index, Unit.CM)
    assert FindingKind.COLLAPSED_PATCH in {finding.kind for finding in check_atlas(atlas)}
