"""Names, order and circles of rules for landmarks; missing landmarks and mistakes."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.surfaces.tubes import tube

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart import LandmarkRule, derive_landmarks, load_definitions
from bodymeasure.chart.landmarks.rules import Boundary, GirthLevel, Level, Median, Prominent
from bodymeasure.errors import InputError

PICKED = {"crotch point": AtlasPoint(0, 0.25, 0.25), "back neck point": AtlasPoint(2, 0.5, 0.75)}


@pytest.fixture
def atlas() -> Atlas:
    return replace(tube((2.0, 1.0, 1.2, 2.0)), landmarks=PICKED)


def level(name: str, of: str, facing: str = "left") -> Level:
    return Level(name=name, of=of, facing=facing)  # type: ignore[arg-type]


def test_rules_may_stand_in_any_order(atlas: Atlas) -> None:
    chain: list[LandmarkRule] = [
        level("first", "crotch point", "front"),
        level("second", "first"),
        Median(name="third", of="second", through="first", facing="back"),
        level("fourth", "third", "right"),
    ]
    wanted = derive_landmarks(atlas, chain)
    assert wanted.missing == {}
    for rules in (chain[::-1], [chain[2], chain[0], chain[3], chain[1]]):
        derived = derive_landmarks(atlas, rules)
        assert dict(derived.landmarks) == dict(wanted.landmarks)
    assert list(derived.landmarks)[:2] == list(PICKED)
    assert derived.rules["second"] is chain[1]


def test_picked_landmarks_win(atlas: Atlas) -> None:
    derived = derive_landmarks(
        atlas, [level("crotch point", "back neck point"), level("side", "crotch point")]
    )
    assert derived.landmarks["crotch point"] == PICKED["crotch point"]
    assert set(derived.rules) == {"side"}
    height = atlas.position(derived.landmarks["side"])[2]
    assert height == pytest.approx(0.75, abs=1e-14)


def test_a_rule_for_both_sides_gives_two(atlas: Atlas) -> None:
    rule = Level(name="edge {side}", of="crotch point", facing="{side}")
    derived = derive_landmarks(atlas, [rule, level("end {side}", "edge {side}", "front")])
    left, right = (atlas.position(derived.landmarks[f"edge {side}"]) for side in ("left", "right"))
    np.testing.assert_allclose(left, right * [-1.0, 1.0, 1.0], rtol=0.0, atol=1e-14)
    assert left[0] > 0.0
    assert derived.rules["edge right"].description == (
        "outermost to the right at the height of crotch point"
    )
    assert {"end left", "end right"} <= set(derived.landmarks)


def test_what_needs_a_missing_landmark_is_missing_too(atlas: Atlas) -> None:
    derived = derive_landmarks(
        atlas,
        [
            level("second", "first"),
            level("first", "bust point left"),
            level("good", "crotch point"),
            Boundary(name="end", direction="up", regions=("neck",)),
            level("beside end", "end"),
        ],
    )
    assert derived.missing["first"] == (
        "it needs 'bust point left', which the atlas lacks and no rule gives; pick it"
    )
    assert derived.missing["second"] == (
        f"it needs 'first', which is missing: {derived.missing['first']}"
    )
    assert derived.missing["beside end"].startswith("it needs 'end', which is missing: the atlas")
    assert "good" in derived.landmarks
    assert set(derived.rules) == {"first", "second", "good", "end", "beside end"}


@pytest.mark.parametrize(
    ("rules", "message"),
    [
        (
            [level("a", "b"), level("b", "c"), level("c", "a")],
            "circle: 'a' needs 'b' needs 'c' needs 'a'; pick one",
        ),
        ([level("a", "crotch point"), level("x", "x")], "circle: 'x' needs 'x'; pick one"),
        (
            [level("a", "b"), level("b", "crotch pont")],
            r"called 'crotch pont' \('a' needs 'b' needs 'crotch pont'\); did you mean 'crotch p",
        ),
        ([level("a", "qqq")], r"called 'qqq' \('a' needs 'qqq'\); pick it, or give it a rule"),
        # A rule that is not needed here may still be misspelled.
        ([level("crotch point", "bak neck point")], "did you mean 'back neck point'"),
        (
            [level("a", "crotch point"), level("a", "back neck point")],
            "two rules give landmark 'a'; leave one of them out",
        ),
        ([Level(name="a", of="crotch point", facing="{side}")], "needs it in its name, too"),
    ],
)
def test_mistakes_name_the_chain(atlas: Atlas, rules: list[LandmarkRule], message: str) -> None:
    with pytest.raises(InputError, match=message):
        derive_landmarks(atlas, rules)


def test_a_circle_that_a_pick_breaks_is_none(atlas: Atlas) -> None:
    picked = replace(atlas, landmarks={**PICKED, "b": AtlasPoint(1, 0.5, 0.5)})
    derived = derive_landmarks(picked, [level("a", "b"), level("b", "a")])
    assert derived.missing == {}
    assert derived.landmarks["b"] == AtlasPoint(1, 0.5, 0.5)


def test_a_section_that_ends_where_it_is_outermost_is_told() -> None:
    # Half of a tube: it ends at the wearer's left and right.
    whole = tube([1.0] * 4)
    half = replace(
        whole, index=whole.index[2:], patch_names=(), regions=(), landmarks={"here": PICKED_HALF}
    )
    derived = derive_landmarks(half, [level("side", "here"), level("front", "here", "front")])
    assert "ends on the boundary of the atlas, just where it reaches" in derived.missing["side"]
    assert "farthest to the left" in derived.missing["side"]
    assert half.position(derived.landmarks["front"])[1] == pytest.approx(-1.0, abs=1e-14)


PICKED_HALF = AtlasPoint(0, 0.5, 0.5)


def test_the_default_rules_know_all_names_that_they_need() -> None:
    bare = tube((2.0, 1.0, 1.2, 2.0))
    derived = derive_landmarks(bare, load_definitions().landmark)
    assert dict(derived.landmarks) == {}
    assert len(derived.missing) == len(derived.rules) > 20


def test_all_rules_have_words() -> None:
    words = [rule.description for rule in load_definitions().landmark]
    assert len(set(words)) == len(words)
    chest = Prominent(name="c", direction="front", regions=("torso", "neck"), above="a", below="b")
    assert chest.description == "farthest to the front of torso, neck above a and below b"
    girth = GirthLevel(name="c", start="a", end="b", extreme="largest", facing="back")
    assert girth.description == "outermost to the back at the largest girth from a to b"
