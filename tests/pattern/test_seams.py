"""Seams: their sides, and what is eased into them."""

from dataclasses import replace

import pytest
from helpers.panels import cylinder, interpolated

import bodymeasure as bm
from bodymeasure.pattern import Edge, Panel
from bodymeasure.pattern.definitions.checks import panel_faults

# The corners a, b, c, d of a panel, e in the middle of the side from a to c, and places inside.
PLACES = {"e": (0.5, 0.5), "in": (0.6, 0.35), "out": (0.35, 0.55), "near": (0.3, 0.6)}
BODY = interpolated(cylinder)
BODY = replace(
    BODY,
    landmarks={
        **BODY.landmarks,
        "a": bm.AtlasPoint(0, 0.2, 0.2),
        "c": bm.AtlasPoint(0, 0.8, 0.8),
        **{name: bm.AtlasPoint(0, *at) for name, at in PLACES.items()},
    },
)


def panel(through: str, inside: str, seam: str, **members: float) -> Panel:
    """A panel between geodesics, some of whose edges are sewn to one seam."""
    edges = tuple(
        Edge(
            name=a + b,
            kind="geodesic",
            through=(a, b),
            seam="seam" if a + b in seam.split() else "",
            ease=members.get(a + b, 0.0),
        )
        for a, b in zip(through, through[1:] + through[0], strict=True)
    )
    return Panel(name=through, inside=inside, edge=edges)


def pattern(*panels: Panel) -> bm.Pattern:
    return bm.make_pattern(BODY, bm.PatternDefinitions(name="p", panel=panels))


def test_one_edge_is_sewn_to_two_in_a_row() -> None:
    made = pattern(panel("abc", "in", "ca"), panel("aecd", "near", "ae ec"))
    (seam,) = made.seams
    assert seam.pieces == ("abc", "aecd + aecd")
    assert seam.edges == ("ca", "ae + ec")
    assert seam.lengths[1] == pytest.approx(seam.lengths[0], abs=1e-11)
    assert made.warnings == ()


def test_ease_makes_one_side_longer_and_is_no_fault() -> None:
    made = pattern(panel("abc", "in", "ca"), panel("acd", "near", "ac", ac=0.006))
    (seam,) = made.seams
    assert seam.ease == 0.006
    assert seam.difference == pytest.approx(0.006, abs=1e-12)
    assert made.is_sound
    assert made.warnings == ()
    edge = made["acd"].edge("ac")
    assert edge.length == pytest.approx(edge.skin_length + 0.006, abs=1e-12)


def test_what_exceeds_the_ease_is_named() -> None:
    eased = panel("abc", "in", "ca", ca=0.004)
    made = pattern(eased, panel("acd", "near", "cd"))
    assert not made.is_sound
    assert made.warnings
    assert all(", and not 4.0 mm shorter, as their ease asks;" in words for words in made.warnings)
    assert "shorter than 'ca' of 'abc'" in made.warnings[0]


@pytest.mark.parametrize(
    ("ease", "seam", "words"),
    [(2.0, "ca", "expected by how much it is longer"), (0.01, "", "no seam into which")],
)
def test_eases_that_make_no_sense_are_named(ease: float, seam: str, words: str) -> None:
    faults = [*panel_faults(panel("abc", "in", seam, ca=ease))]
    assert len(faults) == 1
    assert words in faults[0]


def test_too_short_an_edge_is_named() -> None:
    with pytest.raises(bm.InputError, match=r"edge 'ca': its ease of -30.0 cm leaves too little"):
        pattern(panel("abc", "in", "ca", ca=-0.3))


def test_an_edge_that_is_alone_in_its_seam_is_a_warning() -> None:
    made = pattern(panel("abc", "in", "ca"))
    assert made.is_sound
    assert made.warnings[0].startswith("seam 'seam': nothing is sewn to edge 'ca' of 'abc'")
