import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from helpers.surfaces.surfaces import (
    ENNEPER,
    PARABOLOID,
    PH_CYLINDER,
    PLANE,
    SURFACES,
    Surface,
    plane_length,
)
from helpers.surfaces.surfaces import ph_cylinder_length as cylinder_length

from bodymeasure._typing import Array
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.oracle import LEVELS, mesh_distances

IN_ORDER = pytest.param(False, id="start to end")
SWAPPED = pytest.param(True, id="end to start")

Point = tuple[float, float]


def lengths(
    length: Callable[[Point, Point], float],
    start: Array,
    end: Array,
) -> Array:
    """The lengths of the first patch's pairs in closed form."""
    return np.array(
        [length((a[0], a[1]), (b[0], b[1])) for a, b in zip(start[0], end[0], strict=True)]
    )


@pytest.mark.parametrize("swapped", [IN_ORDER, SWAPPED])
@pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
def test_closed_forms(surface: Surface, swapped: bool) -> None:
    ends = (surface.end, surface.start) if swapped else (surface.start, surface.end)
    measured = mesh_distances(surface.control_points[None], [[ends[0]]], [[ends[1]]])
    error = abs(measured.exact[0, 0] - surface.length)
    assert error < 2e-7 * surface.length
    assert error < measured.exact_uncertainty[0, 0] < 3e-5 * surface.length
    assert measured.heat[0, 0] == pytest.approx(surface.length, rel=0.03)
    assert measured.by_level.shape == (1, 1, len(LEVELS))
    assert measured.failures == {}


def test_a_plane_is_exact_at_every_level(rng: np.random.Generator) -> None:
    start, end = rng.random((2, 1, 5, 2))
    measured = mesh_distances(PLANE[None], start, end, levels=(2, 4))
    expected = lengths(plane_length, start, end)
    # The patch's curved edges do not cut into these chords, so every polyhedral path is straight.
    np.testing.assert_allclose(measured.by_level[0], np.stack([expected] * 2, axis=-1), rtol=1e-9)


@pytest.mark.parametrize("net", [ENNEPER, PARABOLOID], ids=["enneper", "paraboloid"])
def test_polyhedral_lengths_converge_with_the_square_of_the_step(
    net: Array,
) -> None:
    length = next(s.length for s in SURFACES if s.control_points is net)
    measured = mesh_distances(net[None], [[(0, 0)]], [[(1, 1)]], levels=(4, 8, 16, 32))
    error = np.abs(measured.by_level[0, 0] - length)
    rate = np.polyfit(np.log(1 / np.array(measured.levels)), np.log(error), 1)[0]
    assert rate == pytest.approx(2.0, abs=0.05)


def test_ends_anywhere_in_the_patch(rng: np.random.Generator) -> None:
    start, end = rng.random((2, 1, 12, 2))
    start[0, 0] = (0.0, 0.4)  # on an edge
    end[0, 1] = start[0, 1] + (0.0, 0.2 - 0.4 * (start[0, 1, 1] > 0.5))  # on one grid line
    end[0, 2] = start[0, 2] + 1e-3  # near each other
    measured = mesh_distances(PH_CYLINDER[None], start, end)
    expected = lengths(cylinder_length, start, end)
    error = np.abs(measured.exact[0] - expected)
    assert np.all(error <= measured.exact_uncertainty[0])
    assert np.all(error < 1e-6 * expected)


def test_pairs_and_patches_keep_their_places() -> None:
    nets = np.stack([PLANE, PH_CYLINDER])
    start = [[(0, 0), (1, 0), (0.2, 0.3)], [(0, 0), (1, 0), (0.2, 0.3)]]
    end = [[(1, 1), (0, 1), (0.9, 0.4)], [(1, 1), (0, 1), (0.9, 0.4)]]
    together = mesh_distances(nets, start, end)
    for patch in range(2):
        for pair in range(3):
            alone = mesh_distances(
                nets[patch : patch + 1], [[start[patch][pair]]], [[end[patch][pair]]]
            )
            assert together.exact[patch, pair] == alone.exact[0, 0]
            assert together.heat[patch, pair] == alone.heat[0, 0]


def test_lengths_scale_with_the_patch() -> None:
    small, large = (
        mesh_distances(scale * ENNEPER[None], [[(0.1, 0.2)]], [[(0.8, 1.0)]])
        for scale in (1e-3, 1e3)
    )
    np.testing.assert_allclose(1e6 * small.exact, large.exact, rtol=1e-12)


def test_equal_ends_are_no_distance_apart() -> None:
    measured = mesh_distances(ENNEPER[None], [[(0.3, 0.3)]], [[(0.3, 0.3)]])
    assert measured.exact[0, 0] == 0.0


def test_ends_too_near_to_be_meshed_are_told_as_uncertain() -> None:
    start, end = (0.5, 0.2), (0.5 + 1e-7, 0.2 + 2e-7)
    measured = mesh_distances(PH_CYLINDER[None], [[start]], [[end]])
    length = cylinder_length(start, end)
    uncertainty = measured.exact_uncertainty[0, 0]
    assert abs(measured.exact[0, 0] - length) <= uncertainty + 1e-15  # that of `length` itself
    assert uncertainty < 3 * length


def test_a_path_stays_in_its_patch() -> None:
    # The plane's parametrization bends its edge v = 0 outwards in the middle: the chord between
    # two corners leaves the patch.
    bent = PLANE * [1, 1, 0]
    bent[1:3, 0, 1] += 0.4
    measured = mesh_distances(bent[None], [[(0, 0)]], [[(1, 0)]])
    chord = float(np.linalg.norm(bent[3, 0] - bent[0, 0]))
    assert measured.exact[0, 0] > chord * 1.01


def test_a_patch_with_a_collapsed_edge_is_a_triangle() -> None:
    third = np.arange(4) / 3
    u, v = np.meshgrid(third, third, indexing="ij")
    net = np.stack([u, u * v, 0 * u], axis=-1)
    measured = mesh_distances(net[None], [[(0, 0), (0, 1)]], [[(1, 1), (1, 0)]])
    np.testing.assert_allclose(measured.exact, [[math.sqrt(2), 1.0]], rtol=1e-9)


def test_a_degenerate_patch_fails_alone() -> None:
    nets = np.stack([ENNEPER, np.zeros_like(ENNEPER), ENNEPER])
    nets[1, :, :, 0] = np.arange(4)[:, None]  # a line
    ends = np.zeros((3, 1, 2))
    measured = mesh_distances(nets, ends, ends + 1.0)
    assert list(measured.failures) == [1]
    assert "has no area" in measured.failures[1]
    assert np.isnan(measured.exact[1, 0])
    assert np.isnan(measured.exact_uncertainty[1, 0])
    assert measured.exact[0, 0] == measured.exact[2, 0] == pytest.approx(5 * math.sqrt(2) / 3)


@pytest.mark.slow
def test_workers_give_the_same() -> None:
    nets = np.stack([surface.control_points for surface in SURFACES])
    start = np.zeros((len(nets), 2, 2))
    start[:, 1, 0] = 1.0
    told: list[int] = []
    alone = mesh_distances(nets, start, 1.0 - start, levels=(3, 6))
    shared = mesh_distances(
        nets, start, 1.0 - start, levels=(3, 6), processes=2, progress=told.append
    )
    for name in ("exact", "exact_uncertainty", "heat", "by_level"):
        np.testing.assert_array_equal(getattr(alone, name), getattr(shared, name))
    assert told == sorted(told)
    assert told[-1] == 2 * len(nets)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"control_points": ENNEPER}, r"shape \(4, 4, 3\); expected \(patches, 4, 4, 3\)"),
        ({"control_points": ENNEPER[None] * np.nan}, "patch 0 has control points that are not"),
        ({"start": [(0, 0)]}, r"start has shape \(1, 2\); expected \(1, pairs, 2\)"),
        ({"end": [[(1, 1), (1, 0)]]}, r"end has \(1, 2, 2\); expected the same"),
        ({"end": [[(1.0, 1.5)]]}, r"end of pair 0 on patch 0 is \(u, v\) = \(1.0, 1.5\)"),
        ({"start": [[(np.nan, 0.5)]]}, r"start of pair 0 .* expected both in \[0, 1\]"),
        ({"levels": (8,)}, "at least two ascending multiples"),
        ({"levels": (8, 12)}, "multiples of the first"),
        ({"levels": (8, 8)}, "ascending"),
        ({"processes": 0}, "processes is 0; expected at least 1"),
    ],
)
def test_bad_input_is_named(change: dict[str, Any], message: str) -> None:
    arguments: dict[str, Any] = {
        "control_points": ENNEPER[None],
        "start": [[(0, 0)]],
        "end": [[(1, 1)]],
        **change,
    }
    with pytest.raises(InputError, match=message):
        mesh_distances(**arguments)


def test_without_libigl_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("bodymeasure.oracle.libigl.find_spec", lambda _: None)
    with pytest.raises(MissingExtraError, match=r"libigl.*bodymeasure\[oracle\]"):
        mesh_distances(ENNEPER[None], [[(0, 0)]], [[(1, 1)]], processes=2)
