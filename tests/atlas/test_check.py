from dataclasses import replace

import numpy as np
import pytest
from helpers.surfaces.grids import grid_atlas, grid_index
from helpers.surfaces.quadrics import sphere_nets
from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation

from bodymeasure import InputError
from bodymeasure._typing import Array
from bodymeasure.atlas import (
    Atlas,
    AtlasPoint,
    Finding,
    FindingKind,
    Severity,
    Unit,
    check_atlas,
    weld,
)
from bodymeasure.bezier import elevate, project
from bodymeasure.measure import body_girth
from bodymeasure.samples import load_sample, sample_names

ARC = 4 / 3 * (np.sqrt(2) - 1)


def quarter(start: Array, corner: Array, end: Array) -> Array:
    """Control points of the usual cubic quarter circle around `start + end - corner`."""
    return np.stack([start, start + ARC * (corner - start), end + ARC * (corner - end), end])


def half_cylinder(radius: float = 1.0, height: float = 2.0) -> Array:
    """A bicubic patch whose normal turns by nearly 180 degrees along u, (4, 4, 3)."""
    x = np.array([1.0, 1.0, -1.0, -1.0]) * radius
    y = np.array([0.0, 4 / 3, 4 / 3, 0.0]) * radius
    z = np.linspace(0.0, height, 4)
    return np.stack(np.broadcast_arrays(x[:, None], y[:, None], z[None]), axis=-1)


def lid() -> Array:
    """A quarter of a dome, whose edge u = 0 is collapsed to the tip."""
    rim = quarter(np.array([1.0, 0, 0]), np.array([1.0, 1, 0]), np.array([0.0, 1, 0]))
    radius, height = np.array([0.0, ARC, 1.0, 1.0]), np.array([1.0, 1.0, ARC, 0.0])
    return np.asarray(
        rim[None] * radius[:, None, None] + height[:, None, None] * np.array([0.0, 0, 1])
    )


def flat(x: Array, y: Array) -> Array:
    return np.stack([x, y, 0.0 * x], axis=-1)


def bumpy(rng: np.random.Generator, height: float = 0.3) -> Atlas:
    return grid_atlas(3, 3, lambda x, y: np.stack([x, y, height * rng.random(x.shape)], -1))


def only(findings: tuple[Finding, ...]) -> Finding:
    assert len(findings) == 1, [finding.message for finding in findings]
    return findings[0]


def moved(atlas: Atlas, patch: int, i: int, j: int, offset: Array) -> Atlas:
    points = atlas.points.copy()
    points[atlas.index[patch, i, j]] += offset
    return replace(atlas, points=points)


def separated(atlas: Atlas, patch: int, offset: float = 0.0) -> Atlas:
    """The patch moved up, with control points of its own."""
    own = atlas.control_points[patch].reshape(-1, 3) + np.array([0.0, 0.0, offset])
    index = atlas.index.copy()
    index[patch] = len(atlas.points) + np.arange(16).reshape(4, 4)
    return replace(atlas, points=np.concatenate([atlas.points, own]), index=index)


# No false alarms


@given(
    seed=st.integers(0, 2**32 - 1),
    height=st.floats(0.0, 0.3),
    exponent=st.floats(-3.0, 6.0),
    turn=arrays(np.float64, (4,), elements=st.floats(-1.0, 1.0)),
    offset=arrays(np.float64, (3,), elements=st.floats(-10.0, 10.0)),
)
def test_mild_patches_are_sound_wherever_they_lie(
    seed: int, height: float, exponent: float, turn: Array, offset: Array
) -> None:
    assume(np.linalg.norm(turn) > 0.1)
    rng = np.random.default_rng(seed)
    flatland = np.stack(np.meshgrid(np.arange(4) / 3, np.arange(4) / 3, indexing="ij"), axis=-1)
    field = np.concatenate([flatland, height * rng.random((4, 4, 1))], axis=-1)
    for net in (field, half_cylinder(), half_cylinder(radius=0.1)):
        placed = Rotation.from_quat(turn).apply(net.reshape(-1, 3)).reshape(4, 4, 3)
        atlas = Atlas.from_control_points((placed + offset) * 10.0**exponent, "mm")
        assert check_atlas(atlas) == ()


@given(seed=st.integers(0, 2**32 - 1), scale=st.sampled_from([1e-3, 1.0, 1e6]))
def test_a_smooth_surface_of_many_patches_is_sound(seed: int, scale: float) -> None:
    rng = np.random.default_rng(seed)
    a, b = rng.normal(size=2)

    def place(x: Array, y: Array) -> Array:
        # The surface is quadratic in each variable: control points on a lattice of thirds join
        # smoothly.
        return scale * np.stack([x, y, 0.2 * (a * x + b * y)], axis=-1)

    assert check_atlas(grid_atlas(3, 4, place)) == ()


def test_a_narrow_strip_has_no_gap_between_its_long_sides() -> None:
    def narrow(x: Array, y: Array) -> Array:
        return flat(x, 0.02 * y)

    assert check_atlas(grid_atlas(3, 1, narrow)) == ()
    assert check_atlas(grid_atlas(3, 2, narrow)) == ()


def test_a_closed_tube_of_one_patch_is_sound() -> None:
    angle = np.linspace(0.0, 2 * np.pi, 7)[:-1]
    lattice = np.stack(
        np.broadcast_arrays(np.cos(angle)[:, None], np.sin(angle)[:, None], np.arange(4.0)[None]),
        axis=-1,
    )
    numbers = np.arange(24).reshape(6, 4)
    index = np.stack([numbers[:4], numbers[[3, 4, 5, 0]]])
    findings = check_atlas(Atlas(lattice.reshape(-1, 3), index, Unit.CM))
    assert {finding.kind for finding in findings} <= {FindingKind.KINKED_SEAM}


@pytest.mark.parametrize("name", sample_names())
def test_samples_have_no_fault_but_kinks(name: str) -> None:
    findings = check_atlas(load_sample(name))
    assert {finding.kind for finding in findings} <= {FindingKind.KINKED_SEAM}


@pytest.mark.parametrize("scale", [1e300, 1e160, 1e-160, 1e-300])
def test_sizes_that_nothing_can_be_said_of_are_refused(scale: float) -> None:
    atlas = grid_atlas(1, 1)
    with pytest.raises(InputError, match=r"extends over .* choose another unit"):
        check_atlas(replace(atlas, points=scale * atlas.points))


# Collapses


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


# Folds


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
def test_flat_patches_are_folded_exactly_where_their_area_changes_sign(seed: int) -> None:
    rng = np.random.default_rng(seed)
    net = grid_atlas(1, 1).control_points[0] + 0.4 * rng.normal(size=(4, 4, 3)) * [1, 1, 0]
    t = np.linspace(0.0, 1.0, 129)
    basis = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3], axis=-1)
    slope = np.gradient(basis, t, axis=0, edge_order=2)
    x_u, y_u, _ = np.moveaxis(np.einsum("ai,bj,ijc->abc", slope, basis, net), -1, 0)
    x_v, y_v, _ = np.moveaxis(np.einsum("ai,bj,ijc->abc", basis, slope, net), -1, 0)
    area = x_u * y_v - x_v * y_u
    # Differences are off by 1e-3; patches this close to the limit are left out.
    assume(area.min() * area.max() < 0 or abs(area).min() > 0.02)
    assume(min(-area.min(), area.max()) > 0.02 or abs(area).min() > 0.02)
    folded = area.min() * area.max() < 0
    kinds = {finding.kind for finding in check_atlas(Atlas.from_control_points(net, "cm"))}
    assert (FindingKind.FOLDED_PATCH in kinds) == folded


# Seams


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


# Reading the findings


def test_errors_come_first(rng: np.random.Generator) -> None:
    atlas = separated(bumpy(rng), 4, 0.01)
    index = atlas.index.copy()
    index[0] = index[0, ::-1]
    severities = [finding.severity for finding in check_atlas(replace(atlas, index=index))]
    assert len(set(severities)) == 2
    assert severities == sorted(severities, key=lambda severity: severity is Severity.WARNING)


def test_messages_use_the_patches_names_and_the_unit() -> None:
    atlas = separated(grid_atlas(2, 1), 1, 0.01)
    atlas = replace(atlas, patch_names=("hip left", "hip right")).converted(Unit.INCH)
    message = check_atlas(atlas)[0].message
    assert "'hip left'" in message
    assert "'hip right'" in message
    assert f"{0.01 / 2.54:.3g} inch" in message


def test_the_order_of_patches_does_not_matter(rng: np.random.Generator) -> None:
    atlas = separated(bumpy(rng), 4, 0.01)
    order = rng.permutation(len(atlas))
    names = tuple(atlas.patch_names[number] for number in order)
    shuffled = replace(atlas, index=atlas.index[order], patch_names=names, regions=())
    kinds = [sorted(f.kind for f in check_atlas(each)) for each in (atlas, shuffled)]
    assert kinds[0] == kinds[1]


def test_a_torus_of_patches_is_sound() -> None:
    rows = columns = 12
    index = grid_index(rows, columns)
    i, j = np.divmod(index, 3 * columns + 1)
    index = (i % (3 * rows)) * 3 * columns + j % (3 * columns)
    big = 2 * np.pi * np.arange(3 * rows)[:, None] / (3 * rows)
    small = 2 * np.pi * np.arange(3 * columns)[None] / (3 * columns)
    radius = 3.0 + np.cos(small)
    points = np.stack(
        np.broadcast_arrays(radius * np.cos(big), radius * np.sin(big), np.sin(small)), axis=-1
    )
    assert check_atlas(Atlas(points.reshape(-1, 3), index, Unit.CM)) == ()


def test_a_patch_without_area_has_no_seams() -> None:
    """Though its neighbor has, whose side is an edge like any other: that one is open then."""
    net = grid_atlas(1, 1).control_points[0]
    flat = np.repeat(net[:, 3:], 4, axis=1)
    index = np.arange(32).reshape(2, 4, 4)
    index[1, :, 0] = index[0, :, 3]
    atlas = Atlas(np.concatenate([net, flat]).reshape(-1, 3), index, Unit.CM)
    assert FindingKind.COLLAPSED_PATCH in {finding.kind for finding in check_atlas(atlas)}


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
