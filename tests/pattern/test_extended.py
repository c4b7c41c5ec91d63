"""Paper beyond an edge of a piece."""

import re

import msgspec
import numpy as np
import pytest
from helpers.panels import cylinder, four_geodesics, interpolated

import bodymeasure as bm
from bodymeasure.pattern import Dart, Extend, Panel
from bodymeasure.pattern.definitions.checks import panel_faults

BODY = interpolated(cylinder)


def piece(extend: Extend | None, **members: object) -> bm.Piece:
    return bm.make_pattern(BODY, four_geodesics(extend=extend, fold="da", **members)).pieces[0]


def test_paper_below_a_hem() -> None:
    bare, longer = piece(None), piece(Extend(edge="ab", length=0.3, flare=0.04))
    assert longer.is_sound
    assert longer.rms_strain == pytest.approx(bare.rms_strain, abs=1e-12)
    added = {edge.name: edge.length - bare.edge(edge.name).length for edge in longer.edges}
    assert added["cd"] == 0.0
    # The fold runs straight down, and the other side aside by the flare.
    assert added["da"] == pytest.approx(0.3, abs=1e-12)
    assert added["bc"] == pytest.approx(np.hypot(0.3, 0.04), abs=1e-12)
    np.testing.assert_allclose(longer.edge("da").parts[0][:, 0], 0.0, atol=1e-12)
    hem, was = longer.edge("ab").parts[0], bare.edge("ab").parts[0]
    # This fold is listed downwards, so that the bottom of the panel is up.
    np.testing.assert_allclose(hem[:, 1], was[:, 1] + 0.3, atol=1e-12)
    wider = np.abs(hem[[0, -1], 0] - was[[0, -1], 0])
    np.testing.assert_allclose(np.sort(wider), [0.0, 0.04], atol=1e-12)
    for edge in longer.edges:
        assert edge.length == pytest.approx(edge.cloth_length, abs=1e-12)
        assert edge.skin_length == bare.edge(edge.name).skin_length
    assert np.ptp(longer.outline[:, 1]) - np.ptp(bare.outline[:, 1]) == pytest.approx(0.3)


def test_paper_that_crosses_itself_is_to_flare_more() -> None:
    folded = piece(Extend(edge="ab", length=0.5, flare=-0.5))
    assert not folded.is_sound
    assert "the outline crosses itself; shorten its extension" in folded.warnings[0]


def test_paper_above_an_edge() -> None:
    bare, longer = piece(None), piece(Extend(edge="cd", length=0.05))
    assert np.ptp(longer.outline[:, 1]) - np.ptp(bare.outline[:, 1]) == pytest.approx(0.05)
    assert longer.edge("ab").length == bare.edge("ab").length


@pytest.mark.parametrize(
    ("extend", "change", "words"),
    [
        (Extend(edge="hem", length=0.3), {}, "extends the edge 'hem', which it lacks"),
        (Extend(edge="da", length=0.3), {}, "extends its fold"),
        (Extend(edge="ab", length=30.0), {}, "is extended by 30.0 .* expected lengths in meters"),
        (Extend(edge="ab", length=0.3, flare=0.4), {}, "flare no more than the length"),
        (Extend(edge="ab", length=0.3), {"fold": ""}, "has none; name the edge of its grain"),
    ],
)
def test_what_cannot_be_extended_is_named(
    extend: Extend, change: dict[str, str], words: str
) -> None:
    panel: Panel = four_geodesics(**{"fold": "da", **change}).panel[0]
    (fault,) = panel_faults(msgspec.structs.replace(panel, extend=extend))
    assert re.search(words, fault)


def test_an_edge_with_a_dart_has_no_paper() -> None:
    dome = interpolated(
        lambda u, v: np.stack([0.3 * u, 0.3 * v, 0.3 * u * (1 - u) * 4 * v * (1 - v)], axis=-1)
    )
    dart = Dart(name="dart", edge="bc", at=0.5, tip="m", short=0.02)
    panels = four_geodesics(fold="da", dart=(dart,), extend=Extend(edge="bc", length=0.1))
    with pytest.raises(bm.InputError, match="'bc' has a dart, so that there is no paper"):
        bm.make_pattern(dome, panels)
