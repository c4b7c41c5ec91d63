"""Cloth that bridges hollows."""

from functools import cache

import numpy as np
import pytest
from helpers.panels import cylinder, four_geodesics, interpolated

import bodymeasure as bm
from bodymeasure._typing import Array


@cache
def pieces(surface: str, fold: str = "") -> tuple[bm.Piece, bm.Piece]:
    atlas = interpolated({"hollow": hollow, "bulge": bulge, "cylinder": cylinder}[surface])
    first, second = (
        bm.make_pattern(atlas, four_geodesics(fold=fold), bridge=bridge).pieces[0]
        for bridge in (False, True)
    )
    return first, second


def round_about(u: Array, v: Array, height: float) -> Array:
    """A cylinder with a bump in its middle, or a dent."""
    radius = 0.1 + height * np.exp(-40.0 * ((u - 0.5) ** 2 + (v - 0.5) ** 2))
    x, y = radius * np.cos(2.0 * u), radius * np.sin(2.0 * u)
    return np.stack([x, y, 0.2 * v], axis=-1)


def bulge(u: Array, v: Array) -> Array:
    return round_about(u, v, 0.03)


def hollow(u: Array, v: Array) -> Array:
    return round_about(u, v, -0.03)


def test_a_hollow_is_bridged_and_the_border_stays() -> None:
    skin, cloth = pieces("hollow")
    # Round the body, cloth spans a chord.
    assert 0.008 < cloth.lift < 0.014
    assert cloth.rms_strain < 0.5 * skin.rms_strain
    assert cloth.is_sound
    for edge in cloth.edges:
        assert edge.length == pytest.approx(skin.edge(edge.name).length, abs=1e-12)
        assert edge.cloth_length == pytest.approx(edge.skin_length, abs=1e-12)


def test_what_bulges_carries_the_cloth() -> None:
    skin, cloth = pieces("cylinder")
    assert cloth.lift == 0.0
    np.testing.assert_allclose(cloth.positions, skin.positions, atol=1e-9)
    # Round the foot of a bump it is off by a little.
    skin, cloth = pieces("bulge")
    assert 0.0 < cloth.lift < 0.002
    assert cloth.rms_strain < skin.rms_strain


def test_a_fold_is_lifted_and_straight() -> None:
    skin, cloth = pieces("bulge", fold="da")
    fold = cloth.edge("da")
    # The foot of the bump reaches this fold.
    assert fold.cloth_length > fold.skin_length + 1e-4
    assert fold.length == pytest.approx(fold.cloth_length, abs=1e-12)
    np.testing.assert_allclose(fold.parts[0][:, 0], 0.0, atol=1e-12)
    assert cloth.rms_strain < skin.rms_strain


@pytest.mark.slow
def test_bodies_need_less_strain_where_hollows_are_bridged() -> None:
    body = bm.load_sample("male_average")
    before, after = (bm.make_pattern(body, "bodice", bridge=bridge) for bridge in (False, True))
    assert after.is_sound
    assert after["bodice front"].rms_strain < before["bodice front"].rms_strain
    assert after["bodice back"].lift > 0.003
    assert all(abs(seam.difference) < 1e-9 for seam in after.seams)


def test_bridge_is_yes_or_no() -> None:
    with pytest.raises(bm.InputError, match="bridge is 'yes'"):
        bm.make_pattern(interpolated(cylinder), four_geodesics(), bridge="yes")  # type: ignore[arg-type]
