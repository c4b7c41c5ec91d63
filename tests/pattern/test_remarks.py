"""What is said of pieces that are not right: the reason, and a remedy that helps."""

import pytest
from msgspec.structs import replace

import bodymeasure as bm
from bodymeasure.pattern import Dart, Panel

BODICE = bm.load_pattern("bodice")


def front(panel: Panel) -> bm.Piece:
    panels = replace(BODICE, panel=(panel,))
    return bm.make_pattern(bm.load_sample("female_average"), panels).pieces[0]


@pytest.mark.slow
def test_a_dart_that_another_one_leaves_no_cloth_for_is_not_said_to_be_in_a_hollow_alone() -> None:
    panel = BODICE.panel[0]
    to_the_bust = Dart(name="side dart", edge="side", at=0.3, tip="bust point left")
    piece = front(replace(panel, dart=(*panel.dart, to_the_bust)))
    assert [dart.name for dart in piece.darts] == ["side dart"]
    assert "dart 'waist dart' is left out" in piece.warnings[0]
    assert piece.warnings[0].endswith(", or another dart takes it up")


@pytest.mark.slow
def test_an_outline_that_crosses_itself_for_its_ease_is_to_be_eased_less() -> None:
    panel = BODICE.panel[0]
    edges = (replace(edge, ease=0.15) if edge.name == "side" else edge for edge in panel.edge)
    piece = front(replace(panel, edge=tuple(edges)))
    assert not piece.is_sound
    assert "the outline crosses itself; ease less into its seams, cut" in piece.warnings[0]
