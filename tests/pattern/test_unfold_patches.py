import re
from dataclasses import replace

import numpy as np
import pytest
from helpers.speed import quick

from bodymeasure import Atlas, load_sample, unfold_patches
from bodymeasure._typing import Array
from bodymeasure.bezier import bernstein, derivatives
from bodymeasure.pattern import patches_sheet, patches_table
from bodymeasure.pattern.patches.six_lengths import flat_quadrilaterals, lengths_of, turned_over

BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")
# What theory says of small geodesic squares, see `unfold_patches`.
Q = (2.0 + np.sqrt(2.0)) / 24.0


def curvature_integrals(atlas: Atlas, points: int = 8) -> tuple[Array, Array]:
    """The integral of Gaussian curvature over each patch, and the area."""
    nodes, weights = np.polynomial.legendre.leggauss(points)
    t, w = (nodes + 1.0) / 2.0, weights / 2.0
    u, v = np.meshgrid(t, t, indexing="ij")
    d = derivatives(atlas.control_points, np.stack([u, v], axis=-1)[None], order=2)
    su, sv = d[..., 1, 0, :], d[..., 0, 1, :]
    cross = np.cross(su, sv)
    area = np.linalg.norm(cross, axis=-1)
    second = [(d[..., i, j, :] * cross).sum(axis=-1) / area for i, j in ((2, 0), (1, 1), (0, 2))]
    density = (second[0] * second[2] - second[1] ** 2) / area
    whole = w[:, None] * w
    return (density * whole).sum(axis=(1, 2)), (area * whole).sum(axis=(1, 2))


def spherical_square(half: float) -> Atlas:
    """A square of great circles on the unit sphere, by the interpolation of its gnomonic image."""
    nodes = 0.5 - 0.5 * np.cos(np.pi * np.arange(10) / 9)
    x = half * (2.0 * nodes - 1.0)
    points = np.stack([*np.meshgrid(x, x, indexing="ij"), np.ones((10, 10))], axis=-1)
    points /= np.linalg.norm(points, axis=-1, keepdims=True)
    inverse = np.linalg.inv(bernstein(9, nodes)[:, 0])
    net = np.einsum("ai,bj,ijc->abc", inverse, inverse, points)
    return Atlas.from_control_points(net, unit="m")


def test_a_plane_patch_unfolds_without_misfit(rng: np.random.Generator) -> None:
    corners = np.array([[0, 0], [3, 0.2], [2.5, 2], [-0.4, 1.5]])
    u, v = np.meshgrid(np.linspace(0.0, 1.0, 4), np.linspace(0.0, 1.0, 4), indexing="ij")
    weights = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], axis=-1)
    net = weights @ corners
    rotation = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    in_space = np.concatenate([net, np.zeros((4, 4, 1))], axis=-1) @ rotation
    unfolded = unfold_patches(Atlas.from_control_points(in_space, unit="cm"))
    assert unfolded.worst[0] < 1e-13
    lengths = [np.linalg.norm(corners[i] - corners[j]) for i, j in ((0, 1), (1, 2), (0, 2), (1, 3))]
    np.testing.assert_allclose(unfolded.lengths[0, [0, 1, 4, 5]], lengths, rtol=1e-12)
    assert not unfolded.turned_over.any()


@pytest.mark.parametrize("half", [0.02, 0.04, 0.08])
def test_misfits_of_small_spherical_squares_are_those_of_theory(half: float) -> None:
    atlas = spherical_square(half)
    integral, area = curvature_integrals(atlas)
    misfit = unfold_patches(atlas).misfit[0]
    found = (misfit[4:].sum() - misfit[:4].sum()) / np.sqrt(area[0])
    # The next term of the series is of the order of the square's area.
    assert found == pytest.approx(-Q * integral[0], rel=1.5 * half**2 + 2e-5)


@pytest.mark.parametrize("name", quick(BODIES))
def test_misfits_follow_the_integral_of_gaussian_curvature(name: str) -> None:
    atlas = load_sample(name)
    unfolded = unfold_patches(atlas)
    assert not unfolded.turned_over.any()
    integral, area = curvature_integrals(atlas)
    misfit = unfolded.misfit
    found = (misfit[:, 4:].sum(axis=1) - misfit[:, :4].sum(axis=1)) / np.sqrt(area)
    # Patches are no squares, and their sides no geodesics, so that the law holds on the whole.
    assert np.corrcoef(found, integral)[0, 1] < -0.8
    slope = -(found @ integral) / (integral @ integral)
    assert 0.09 < slope < 0.15


def test_the_map_does_not_depend_on_the_order_of_corners(rng: np.random.Generator) -> None:
    corners = np.array([[0, 0], [1, 0], [1.2, 0.9], [0.1, 1.1]]) + rng.normal(0, 0.1, (20, 4, 2))
    lengths = lengths_of(corners) * (1.0 + rng.normal(0, 0.01, (20, 6)))
    turned = lengths[:, [1, 2, 3, 0, 5, 4]]
    found, other = flat_quadrilaterals(lengths), flat_quadrilaterals(turned)
    np.testing.assert_allclose(
        lengths_of(found)[:, [1, 2, 3, 0, 5, 4]], lengths_of(other), rtol=1e-12
    )
    np.testing.assert_allclose(found[:, 1, 1], 0.0, atol=1e-15)


def test_the_fit_is_stationary(rng: np.random.Generator) -> None:
    corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) + rng.normal(0, 0.1, (10, 4, 2))
    wanted = lengths_of(corners) * (1.0 + rng.normal(0, 0.02, (10, 6)))
    found = flat_quadrilaterals(wanted)
    least = ((lengths_of(found) - wanted) ** 2).sum(axis=1)
    for _ in range(20):
        moved = found + rng.normal(0, 1e-4, found.shape)
        assert (((lengths_of(moved) - wanted) ** 2).sum(axis=1) > least).all()


def test_a_collapsed_side_makes_a_triangle() -> None:
    lengths = np.array([[3.0, 0.0, 5.0, 4.0, 3.0, 5.0]])
    corners = flat_quadrilaterals(lengths)
    np.testing.assert_allclose(corners[0], [[0, 0], [3, 0], [3, 0], [0, 4]], atol=1e-7)
    assert not turned_over(corners)[0]


def test_quadrilaterals_that_cross_themselves_are_named() -> None:
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    dented = square.copy()
    dented[2] = 0.3
    assert turned_over(np.stack([square, dented, square[::-1], square[[0, 1, 3, 2]]])).tolist() == [
        False,
        False,
        True,
        True,
    ]


def test_the_sheet_shows_each_patch_in_true_size() -> None:
    atlas = load_sample("female_average")
    unfolded = unfold_patches(replace(atlas, patch_names=("<b>&", *atlas.patch_names[1:])))
    sheet = patches_sheet(unfolded)
    polygons = re.findall(r'<polygon points="([^"]*)".*?<title>([^<]*)</title>', sheet)
    assert len(polygons) == len(atlas)
    names = [title.rpartition(":")[0] for _, title in polygons]
    assert "&lt;b&gt;&amp;" in names
    assert "<b>" not in sheet
    patch = atlas.patch_number("patch 100") if "patch 100" in atlas.patch_names else 100
    points = polygons[names.index(atlas.patch_names[patch])][0]
    drawn = np.array([[float(x) for x in pair.split(",")] for pair in points.split()])
    np.testing.assert_allclose(
        lengths_of(drawn), 1000.0 * lengths_of(unfolded.corners[patch]), atol=3e-3
    )
    rows = patches_table(unfolded).splitlines()
    assert len(rows) == len(atlas) + 1
    values = [float(x) for x in rows[1 + patch].rsplit(",", 12)[1:]]
    np.testing.assert_allclose(values[:6], 1000.0 * unfolded.lengths[patch], atol=1e-4)
