"""Verdicts on made-up mesh distances, and one real comparison."""

from typing import Any

import numpy as np
import pytest
from benchmarks.independent.reference import wild_patches
from helpers.surfaces.surfaces import ENNEPER, HYPERBOLIC_PARABOLOID, PARABOLOID, bicubic

from bodymeasure import Atlas, diagonals, solve_geodesic
from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.measure.patches import cross_check as module
from bodymeasure.measure.patches.cross_check import RESOLUTION, SAFETY, Verdict
from bodymeasure.oracle import Engine, MeshDistances, mesh_distances

NETS = np.stack([ENNEPER, PARABOLOID, HYPERBOLIC_PARABOLOID, PARABOLOID])
ATLAS = Atlas.from_control_points(NETS, "cm")


def compare(
    monkeypatch: pytest.MonkeyPatch, exact: Array, uncertainty: Array, atlas: Atlas = ATLAS
) -> Any:
    def pretend(*_: Any, levels: tuple[int, ...], **__: Any) -> MeshDistances:
        by_level = np.repeat(exact[..., None], len(levels), axis=-1)
        return MeshDistances(exact, uncertainty, 1.01 * exact, by_level, levels, {})

    monkeypatch.setattr(module, "mesh_distances", pretend)
    return module.cross_check(
        atlas, diagonals(atlas, on_failure="status"), levels=(4, 8), check="libigl"
    )


def test_verdicts(monkeypatch: pytest.MonkeyPatch) -> None:
    length = diagonals(ATLAS).length
    uncertainty = np.full_like(length, 1e-4)
    exact = length.copy()
    exact[0] += [0.99 * SAFETY * 1e-4, 1.01 * SAFETY * 1e-4]
    exact[1] -= [0.99 * SAFETY * 1e-4, 1.01 * SAFETY * 1e-4]
    # Differences below the resolution of meshes do not count, however certain the meshes are.
    uncertainty[2:] = 0.0
    exact[2] *= [1 + 0.9 * RESOLUTION, 1 - 0.9 * RESOLUTION]
    exact[3] *= [1 + 1.1 * RESOLUTION, 1 - 1.1 * RESOLUTION]
    checked = compare(monkeypatch, exact, uncertainty)
    agrees, longer, shorter = Verdict.AGREES, Verdict.LONGER, Verdict.SHORTER
    assert checked.verdict.tolist() == [
        [agrees, shorter],
        [agrees, longer],
        [agrees, agrees],
        [shorter, longer],
    ]
    np.testing.assert_array_equal(checked.difference, length - exact)
    np.testing.assert_array_equal(checked.relative_difference, (length - exact) / exact)
    np.testing.assert_array_equal(checked.exact, exact)
    np.testing.assert_array_equal(checked.exact_uncertainty, uncertainty)
    np.testing.assert_array_equal(checked.heat, 1.01 * exact)
    assert checked.levels == (4, 8)


def test_without_a_length_or_a_distance_nothing_is_compared(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    line = bicubic({(1, 0): 1}, {}, {})
    atlas = Atlas.from_control_points(np.stack([ENNEPER, line]), "cm")
    exact = np.array([[np.nan, 5 * np.sqrt(2) / 3], [1.0, 1.0]])
    exact[0, 1] = diagonals(atlas, on_failure="status").length[0, 1]
    checked = compare(monkeypatch, exact, np.where(np.isnan(exact), np.nan, 1e-9), atlas)
    assert checked.verdict[0].tolist() == [Verdict.NOT_COMPARED, Verdict.AGREES]
    assert checked.verdict[1].tolist() == 2 * [Verdict.NOT_COMPARED]
    assert np.isnan(checked.difference[1]).all()
    assert np.isnan(checked.relative_difference[1]).all()


def test_a_distance_of_zero_is_no_division(monkeypatch: pytest.MonkeyPatch) -> None:
    # Two corners of this patch coincide: the loop has a length, and the mesh distance is 0.
    exact = np.zeros((4, 2))
    checked = compare(monkeypatch, exact, exact)
    assert (checked.verdict == Verdict.LONGER).all()
    np.testing.assert_array_equal(checked.relative_difference, checked.difference)


def test_verdicts_are_sentences() -> None:
    for verdict in Verdict:
        assert verdict.sentence == verdict.value
        assert verdict.sentence.endswith(".")


def test_libigl_agrees() -> None:
    pytest.importorskip("igl")
    seen: list[int] = []
    solution = diagonals(ATLAS)
    checked = module.cross_check(ATLAS, solution, progress=seen.append)
    assert (checked.verdict == Verdict.AGREES).all()
    assert np.abs(checked.relative_difference).max() < 1e-4
    np.testing.assert_allclose(checked.heat, solution.length, rtol=0.05)
    assert checked.exact.shape == (4, 2)
    assert seen[-1] == 8


def test_along_an_edge_the_extrapolation_is_in_doubt() -> None:
    pytest.importorskip("igl")
    # The shortest path between two corners on one edge runs near that edge and along it; the
    # meshes' own uncertainty is too small there.
    nets = wild_patches(np.random.default_rng(4), 40, 0.6)[32]
    atlas = Atlas.from_control_points(nets, "cm")
    solution = solve_geodesic(nets[None, None], (0.0, 0.0), (0.0, 1.0))
    checked = module.cross_check(atlas, solution)
    assert checked.difference[0, 0] < -SAFETY * checked.exact_uncertainty[0, 0]
    assert checked.verdict[0, 0] is Verdict.AGREES


def flips_that_are_longer(monkeypatch: pytest.MonkeyPatch, patches: tuple[int, ...]) -> None:
    """Let edge flips be caught on ways round that are a thousandth longer, on some patches."""

    def caught(*problems: Any, engine: Engine, **options: Any) -> MeshDistances:
        found = mesh_distances(*problems, engine=engine, **options)
        if engine == "flips":
            for array in (found.exact, found.by_level):
                array[list(patches)] *= 1.001
        return found

    monkeypatch.setattr(module, "mesh_distances", caught)


def many(count: int) -> Atlas:
    return Atlas.from_control_points(np.stack([NETS[k % 3] for k in range(count)]), "cm")


def test_flips_measure_what_libigl_need_not_confirm(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("igl")
    monkeypatch.setattr(module, "WORST", 1)
    atlas = many(41)
    solution = diagonals(atlas)
    checked = module.cross_check(atlas, solution, levels=(5, 10))
    whole = module.cross_check(atlas, solution, levels=(5, 10), check="libigl")
    assert checked.confirmed[::20].all()
    assert checked.confirmed.sum() < 20
    assert whole.confirmed.all()
    assert np.isnan(whole.flips_longer)
    assert 0.0 <= checked.flips_longer < 1e-6
    np.testing.assert_array_equal(checked.verdict, whole.verdict)
    np.testing.assert_allclose(checked.exact, whole.exact, rtol=1e-6)
    np.testing.assert_array_equal(checked.exact[checked.confirmed], whole.exact[checked.confirmed])


def test_libigl_decides_where_flips_disagree(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("igl")
    atlas = many(41)
    solution = diagonals(atlas)
    # One patch that is not in the sample: its lengths seem too short, until libigl confirms them.
    flips_that_are_longer(monkeypatch, (7,))
    checked = module.cross_check(atlas, solution, levels=(5, 10))
    assert checked.confirmed[7]
    assert not checked.confirmed.all()
    assert checked.flips_longer == pytest.approx(1e-3, rel=1e-2)
    assert (checked.verdict == Verdict.AGREES).all()


def test_flips_that_are_often_longer_serve_no_purpose(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("igl")
    monkeypatch.setattr(module, "WORST", 1)
    atlas = many(41)
    flips_that_are_longer(monkeypatch, (0, 20, 40))
    checked = module.cross_check(atlas, diagonals(atlas), levels=(5, 10))
    assert checked.confirmed.all()


def test_without_potpourri3d_libigl_measures_everything(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("igl")
    monkeypatch.setattr("bodymeasure.oracle.flips.find_spec", lambda _: None)
    checked = module.cross_check(ATLAS, diagonals(ATLAS), levels=(4, 8))
    assert checked.confirmed.all()


def test_a_check_that_there_is_not() -> None:
    with pytest.raises(InputError, match="check is 'both'; expected 'flips' or 'libigl'"):
        module.cross_check(ATLAS, diagonals(ATLAS), check="both")  # type: ignore[arg-type]
