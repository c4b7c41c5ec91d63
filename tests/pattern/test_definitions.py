"""Files of panels: what is read, and what is refused in which words."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from helpers.command_line import hide_here
from helpers.panels import cylinder, four_geodesics, interpolated

import bodymeasure as bm
from bodymeasure.pattern import SETS, Dart, Edge, Panel, load_pattern, set_text
from bodymeasure.pattern.definitions.read import known_seams
from bodymeasure.pattern.definitions.seams import lonely_seams

HEAD = 'format = "bodymeasure pattern"\nversion = 1\nname = "Mine"\n'
PANEL = """
[[panel]]
name = "{name}"
inside = "m"
"""
EDGE = """
[[panel.edge]]
name = "{name}"
kind = "geodesic"
through = {through}
"""

RULE = """
[[landmark]]
name = "n"
rule = "{}"
"""


def panel_text(name: str = "one", edges: str = "ab bc ca") -> str:
    parts = [EDGE.format(name=ends, through=[*ends]) for ends in edges.split()]
    return PANEL.format(name=name) + "".join(parts)


def read(folder: Path, text: str) -> bm.PatternDefinitions:
    path = folder / "mine.toml"
    path.write_text(text)
    return load_pattern(path)


@pytest.mark.parametrize("name", SETS)
def test_sets_come_along_and_stand_for_themselves(name: str, tmp_path: Path) -> None:
    assert read(tmp_path, set_text(name)) == load_pattern(name)


def test_a_set_extends_another(tmp_path: Path) -> None:
    mine = HEAD + 'extends = "bodice"\ndrop = ["bodice back"]\n' + panel_text()
    assert [panel.name for panel in read(tmp_path, mine).panel] == ["bodice front", "one"]


def test_panels_for_both_sides(tmp_path: Path) -> None:
    text = HEAD + panel_text("cuff {side}").replace("'a'", "'wrist point {side}'")
    panels = read(tmp_path, text).panel
    assert [panel.name for panel in panels] == ["cuff left", "cuff right"]
    assert panels[1].edge[0].through == ("wrist point right", "b")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("name = 3", "is no set of panels"),
        (HEAD.replace("version = 1", "version = 2"), "reads version 1"),
        (HEAD + "[[panel", "is not valid TOML"),
        (HEAD, "has no panel"),
        (HEAD + panel_text() + 'seem = "side"\n', r"panel 'one', edge 'ca'.*unknown field `seem`"),
        (HEAD + panel_text() + "seam = 3\n", r"panel 'one', edge 'ca', member 'seam'.*`str`"),
        (HEAD + panel_text(edges="ab bc"), "has 2 edges; expected three or more"),
        (
            HEAD + panel_text(edges="ab cb ca"),
            "edge 'ab' ends at 'b', but the next edge 'cb' begins at 'c'",
        ),
        (HEAD + panel_text() + panel_text(), "two panels are named 'one'"),
        (HEAD + 'extends = "bodise"\n' + panel_text(), "did you mean 'bodice'"),
        (HEAD + 'extends = "skirt"\ndrop = ["front"]\n', "drop names 'front'"),
        (
            HEAD + panel_text() + 'plane = "front"\n',
            "edge 'ca' is a geodesic, which has neither plane nor via",
        ),
        (
            HEAD + panel_text() + '[[panel.dart]]\nname = "d"\nedge = "xy"\nat = 0.5\ntip = "m"\n',
            "dart 'd' begins on the edge 'xy', which it lacks",
        ),
        (
            HEAD + panel_text() + '[[panel.dart]]\nname = "d"\nedge = "ab"\nat = 1.5\ntip = "m"\n',
            "at is 1.5",
        ),
        (
            HEAD + panel_text() + '[[panel.dart]]\nname = "d"\nedge = "ab"\ntip = "m"\n',
            "one of 'foot' and 'at'",
        ),
        (HEAD + panel_text().replace('inside = "m"', 'inside = "m"\nfold = "fo"'), "fold names"),
        (HEAD + panel_text() + RULE.format("nearest"), r"landmark 'n', member 'rule': .*nearest"),
        (HEAD + panel_text() + RULE.format("between"), r"landmark 'n': .*missing.*`start`"),
        (
            HEAD + panel_text().replace("geodesic", "section", 1),
            "edge 'ab' is a section without a plane; give three landmarks",
        ),
        (
            HEAD + panel_text().replace('"geodesic"', '"section"\nplane = ["a"]', 1),
            "edge 'ab' has a plane of 'a'; expected three different landmarks",
        ),
        (HEAD + panel_text() + "ease = 0.01\n", "edge 'ca' has ease, but no seam into which"),
        (
            HEAD + 'ease = {m = "4cm"}\n' + panel_text(),
            "member 'ease': Expected `float`.*docs patterns",
        ),
        (HEAD + panel_text(name=" "), "panel ' ' has the name ' '; expected one of printable"),
        (
            HEAD + panel_text().replace("'ab'", "''").replace('"ab"', '""'),
            "edge 1: has the name ''",
        ),
        (HEAD + panel_text(name="a\\u0000b"), "expected one of printable"),
    ],
)
def test_what_is_wrong_is_named(text: str, words: str, tmp_path: Path) -> None:
    with pytest.raises(bm.InputError, match=words) as caught:
        read(tmp_path, text)
    assert str(tmp_path / "mine.toml") in str(caught.value)


def test_a_misspelled_set_is_no_file() -> None:
    with pytest.raises(bm.InputError, match="did you mean 'bodice'"):
        load_pattern("bodise")


BODY = interpolated(cylinder)


def made(**members: object) -> bm.Piece:
    return bm.make_pattern(BODY, four_geodesics(**members)).pieces[0]


@pytest.mark.parametrize(
    ("members", "words"),
    [
        (
            {"inside": "x"},
            "panel 'panel' needs the landmark 'x', which neither the body nor a rule has .*pick it",
        ),
        (
            {"dart": (Dart(name="d", edge="ab", at=0.5, tip="m", length=0.5),)},
            "dart 'd': its length would be 50.0 cm",
        ),
        (
            {"dart": (Dart(name="d", edge="ab", at=0.01, tip="m"),)},
            "dart 'd': its foot is .* mm from the end of edge 'ab', where no dart can be sewn",
        ),
        (
            {
                "dart": tuple(
                    Dart(name=name, edge="ab", at=at, tip="m")
                    for name, at in (("d", 0.5), ("e", 0.52))
                )
            },
            "the feet of darts 'd' and 'e' are .* mm apart; let them begin 10 mm apart",
        ),
        (
            {"dart": (Dart(name="d", edge="ab", foot="m", tip="c"),)},
            "dart 'd': its foot is .* cm from the edge",
        ),
    ],
)
def test_what_a_body_cannot_give_is_named(members: dict[str, object], words: str) -> None:
    if "inside" in members:
        definitions = four_geodesics()
        panel = definitions.panel[0]
        other = Panel(name=panel.name, inside="x", edge=panel.edge)
        with pytest.raises(bm.InputError, match=words):
            bm.make_pattern(BODY, bm.PatternDefinitions(name="p", panel=(other,)))
        return
    with pytest.raises(bm.InputError, match=words):
        made(**members)


def test_a_place_outside_and_edges_that_cross_are_named() -> None:
    def of(through: str, inside: str) -> bm.PatternDefinitions:
        edges = tuple(
            Edge(name=a + b, kind="geodesic", through=(a, b))
            for a, b in zip(through, through[1:] + through[0], strict=True)
        )
        panel = Panel(name="panel", inside=inside, edge=edges)
        return bm.PatternDefinitions(name="panel", panel=(panel,))

    with pytest.raises(bm.InputError, match=r"panel 'panel': .*open end .*there are 'ab', 'bm'"):
        bm.make_pattern(BODY, of("abm", "d"))
    # Its edges ac and bd cross, so that one triangle of the bow has no part of da.
    words = (
        r"panel 'panel': .*in turn \(round 'inside' there are 'ac', 'cb', 'bd'\); an edge crosses"
    )
    with pytest.raises(bm.InputError, match=words):
        bm.make_pattern(BODY, of("acbd", "m"))


def test_one_curve_with_two_seams_is_a_misspelled_name(tmp_path: Path) -> None:
    text = set_text("bodice").replace('seam = "shoulder"', 'seam = "sholder"', 1)
    words = "mine.toml: edge 'shoulder' of panel 'bodice front' and edge .* 'bodice back' are one"
    with pytest.raises(bm.InputError, match=words):
        read(tmp_path, text)


def test_an_edge_to_which_nothing_is_sewn_is_said(tmp_path: Path) -> None:
    mine = HEAD + panel_text() + 'seam = "sholder"\n'
    (words,) = lonely_seams(read(tmp_path, mine).panel, known_seams())
    assert words.startswith("seam 'sholder': nothing is sewn to edge 'ca' of 'one'; did you mean")
    assert "'shoulder'" in words
    # The waist of a bodice is sewn to a skirt, which is in another set.
    assert not [*lonely_seams(load_pattern("bodice").panel, known_seams())]


def test_a_dart_that_reaches_the_other_side_is_named() -> None:
    dart = Dart(name="d", edge="ab", at=0.5, tip="out")
    body = replace(BODY, landmarks={**BODY.landmarks, "out": bm.AtlasPoint(0, 0.97, 0.97)})
    with pytest.raises(bm.InputError, match=r"panel 'panel': dart 'd': it leaves the piece"):
        bm.make_pattern(body, four_geodesics(dart=(dart,)))


@pytest.mark.parametrize("step", [0.0, 1.0, np.nan, "fine"])
def test_steps_are_lengths(step: float) -> None:
    with pytest.raises(bm.InputError, match="step is"):
        bm.make_pattern(BODY, four_geodesics(), step=step)


def test_shapely_is_asked_for_only_by_those_who_cut(monkeypatch: pytest.MonkeyPatch) -> None:
    hide_here(monkeypatch, "shapely")
    assert not bm.unfold_patches(BODY).turned_over.any()
    with pytest.raises(bm.MissingExtraError, match=r"pip install 'bodymeasure\[pattern\]'"):
        made()


def test_a_set_has_landmarks_of_its_own(tmp_path: Path) -> None:
    rule = RULE.format("between") + 'start = "a {side}"\nend = "b"\n'
    definitions = read(tmp_path, HEAD + rule.replace('"n"', '"n {side}"') + panel_text())
    assert [each.name for each in definitions.landmark] == ["n left", "n right"]
    middle = RULE.format("between") + 'start = "a"\nend = "b"\n'
    # The way from a to b over the place in its middle is the way from a to b.
    over = panel_text().replace("['a', 'b']", "['a', 'n', 'b']")
    body = replace(BODY, landmarks={**BODY.landmarks, "m": bm.AtlasPoint(0, 0.6, 0.4)})
    piece, other = (
        bm.make_pattern(body, read(tmp_path, text)).pieces[0]
        for text in (HEAD + middle + over, HEAD + panel_text())
    )
    assert piece.edge("ab").length == pytest.approx(other.edge("ab").length, rel=1e-9)


def test_a_landmark_that_the_body_lacks_is_named_with_the_reason(tmp_path: Path) -> None:
    rule = RULE.format("between") + 'start = "bust point left"\nend = "b"\n'
    panel = panel_text().replace("['a', 'b']", "['a', 'n', 'b']")
    words = r"needs the landmark 'n', which is missing: .*bust point left.*; pick it with"
    with pytest.raises(bm.InputError, match=words):
        bm.make_pattern(BODY, read(tmp_path, HEAD + rule + panel))
