"""Files from other programs: the Utah teapot in three formats, a sphere, geomdl's surfaces."""

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from bodymeasure import Atlas, Status, check_atlas, diagonals, read_atlas
from bodymeasure._typing import Array
from bodymeasure.atlas import FindingKind, Severity, edge_table, summarize
from bodymeasure.bezier import evaluate
from bodymeasure.measure.patches.cross_check import Verdict, cross_check

DATA = Path(__file__).parents[1] / "data"
TEAPOT = read_atlas(DATA / "teapot.bpt", unit="cm")


def turns(net: Array) -> Iterator[Array]:
    """A net with its parameters reversed and swapped in all eight ways."""
    for quarter in range(4):
        turned = np.rot90(net, quarter)
        yield turned
        yield turned.transpose(1, 0, 2)


def test_the_teapot_of_three_js_is_that_of_the_bpt_file() -> None:
    members = json.loads((DATA / "three_teapot.json").read_bytes())
    vertices = np.array(members["vertices"], dtype=np.float64)
    nets = vertices[np.array(members["patches"])].reshape(-1, 4, 4, 3).transpose(0, 2, 1, 3)
    np.testing.assert_array_equal(TEAPOT.control_points, nets)


def test_the_teapot_of_geomview_is_that_of_the_bpt_file_without_its_bottom() -> None:
    found = read_atlas(DATA / "teapot.bez", unit="cm").control_points
    # This one is mirrored, moved, and a quarter of the size; its heights are 1229/4096 and so on.
    wanted = TEAPOT.control_points[:28] * np.array([0.25, -0.25, 0.25]) + np.array([0.5, 0.0, 0.0])
    height = 4096 * found[..., 2]
    np.testing.assert_allclose(height, np.round(height), rtol=0, atol=0.005)
    wanted[..., 2] += (found - wanted)[..., 2].mean()
    steps = np.array([6e-6, 6e-6, 3.5 / 4096])
    partners = []
    for net in found:
        apart = [
            min((np.abs(turned - net) / steps).max() for turned in turns(candidate))
            for candidate in wanted
        ]
        assert np.sort(apart)[0] < 1.01 < 10.0 < np.sort(apart)[1]
        partners.append(int(np.argmin(apart)))
    # Up to order, which is the same.
    assert partners == list(range(28))


def test_the_teapot_is_welded_into_its_four_parts() -> None:
    summary = summarize(TEAPOT)
    assert (summary.patches, summary.parts, summary.seams) == (32, 4, 52)
    # The lid and the bottom have a pole of four patches each.
    assert summary.collapsed_edges == 8
    for lid in (slice(20, 24), slice(28, 32)):
        assert len(np.unique(TEAPOT.index[lid][:, :, 0])) == 1
    assert edge_table(TEAPOT.index).sides.max() == 4  # a pole's four collapsed sides
    findings = check_atlas(TEAPOT)
    assert all(finding.severity == Severity.WARNING for finding in findings)
    kinds = {finding.kind for finding in findings}
    assert kinds == {FindingKind.COLLAPSED_EDGE, FindingKind.SEPARATE_PARTS}


def test_every_diagonal_of_the_teapot_has_a_value_or_a_reason() -> None:
    solutions = diagonals(TEAPOT)
    assert solutions.length.shape == (32, 2)
    # Every diagonal has a value, even one that ends at a pole.
    assert np.isfinite(solutions.length).all()
    assert set(np.asarray(solutions.status).ravel()) == {Status.CONVERGED, Status.ON_BOUNDARY}
    assert (solutions.error_estimate < 2e-10).all()
    # The rim, body, lid and bottom are four turns of one quarter; the handle and spout have two
    # halves.
    quarters = solutions.length[[*range(12), *range(20, 32)]].reshape(6, 8)
    np.testing.assert_allclose(quarters, quarters[:, :1] + np.zeros(8), rtol=1e-10)
    halves = solutions.length[12:20].reshape(4, 2, 2)
    np.testing.assert_allclose(halves[:, 0], halves[:, 1, ::-1], rtol=1e-10)


@pytest.mark.slow
def test_every_length_of_the_teapot_agrees_with_libigl() -> None:
    pytest.importorskip("igl")
    checked = cross_check(TEAPOT, diagonals(TEAPOT), processes=2)
    assert (checked.verdict == Verdict.AGREES).all()
    relative = np.abs(checked.relative_difference)
    assert np.median(relative) <= 1e-5
    assert relative.max() <= 1e-4


def test_an_octant_of_a_sphere_is_round() -> None:
    octant = read_atlas(DATA / "octant.bez", unit="m")
    places = np.linspace(0.0, 1.0, 9)
    grid = np.stack(np.meshgrid(places, places, indexing="ij"), axis=-1)
    found = evaluate(octant.control_points[0], grid)
    np.testing.assert_allclose(np.linalg.norm(found, axis=-1), 1.0, rtol=0, atol=3e-16)
    assert (found > -1e-16).all()
    np.testing.assert_allclose(found[0, 0], [0, 0, 1], atol=1e-16)


def test_surfaces_of_geomdl_are_where_geomdl_says() -> None:
    atlas = read_atlas(DATA / "geomdl_surface.json", unit="mm")
    expected = json.loads((DATA / "geomdl_points.json").read_bytes())
    uv = np.array(expected["uv"])
    # There are three pieces along u and three along v, then two along u.
    pieces = (
        (np.array([0.0, 0.3, 0.6, 1.0]), np.array([0.0, 0.4, 0.7, 1.0]), 0, "sheet"),
        (np.array([0.0, 0.5, 1.0]), np.array([0.0, 1.0]), 9, "rational"),
    )
    assert len(atlas) == 11
    for us, vs, first, name in pieces:
        for (u, v), point in zip(uv, expected[name], strict=True):
            i = min(int(np.searchsorted(us, u, side="right")) - 1, len(us) - 2)
            j = min(int(np.searchsorted(vs, v, side="right")) - 1, len(vs) - 2)
            place = (u - us[i]) / (us[i + 1] - us[i]), (v - vs[j]) / (vs[j + 1] - vs[j])
            patch = first + i * (len(vs) - 1) + j
            found = evaluate(atlas.control_points[patch], place)
            np.testing.assert_allclose(found, point, rtol=0, atol=1e-14)


def test_geomdl_surfaces_are_joined_across_knots() -> None:
    atlas: Atlas = read_atlas(DATA / "geomdl_surface.json", unit="mm")
    sides = edge_table(atlas.index).sides
    assert (sides == 2).sum() == 2 * 3 + 3 * 2 + 1
    assert atlas.is_rational
    assert atlas.patch_names == tuple(f"patch {number}" for number in range(11))
