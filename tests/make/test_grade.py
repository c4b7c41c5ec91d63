"""Families of bodies, and the sizes of a table."""

from pathlib import Path

import pytest

import bodymeasure as bm
from bodymeasure.errors import InputError

VALUES = {"bust_girth": 88.0, "waist_girth": 72.0, "hip_girth": 97.0}


@pytest.mark.slow
def test_a_measurement_is_varied_and_the_others_stay() -> None:
    family = bm.grade_body(VALUES, {"bust": ["+4cm", "-2cm"]}, unit="cm")
    assert list(family) == ["base", "bust_girth+4cm", "bust_girth-2cm"]
    for body, bust in zip(family.values(), (88.0, 92.0, 86.0), strict=True):
        found = {one.value.key: one.found for one in body.asked}
        assert found["bust_girth"] == pytest.approx(bust, abs=2e-3)
        assert found["waist_girth"] == pytest.approx(72.0, abs=2e-3)


@pytest.mark.slow
def test_a_measurement_that_was_not_asked_for_varies_from_what_the_body_has() -> None:
    family = bm.grade_body(VALUES, {"stature": ["+6cm"], "waist_girth": ["+1in"]}, unit="cm")
    base, taller = family.values()
    assert 100.0 * (_stature(taller) - _stature(base)) == pytest.approx(6.0, abs=2e-3)
    assert taller.asked[1].found == pytest.approx(72.0 + 2.54, abs=2e-3)


def _stature(body: bm.MadeBody) -> float:
    return body.atlas.given["stature"].value


@pytest.mark.slow
def test_sizes_of_a_table_become_bodies_and_patterns_fit_them(tmp_path: Path) -> None:
    path = tmp_path / "roll.csv"
    path.write_text("size,bust (cm),waist (cm),hip (cm)\n36,84,68,93\n44,100,84,109\n")
    sizes = bm.make_sizes(bm.read_measurements(path), sex="female")
    assert list(sizes) == ["36", "44"]
    bodies = {name: body.atlas for name, body in sizes.items()}
    graded = bm.grade_pattern(bodies, "skirt")
    small, large = (each["skirt back"].edge("waist") for each in graded.patterns.values())
    assert large.length > small.length


@pytest.mark.parametrize(
    ("vary", "message"),
    [
        ({}, "vary holds no change"),
        ({"bust_girth": []}, "vary holds no change"),
        ({"bust_girth": ["4cm"]}, "has no sign"),
        ({"bust_girth": ["+4"]}, "has no unit, and none is guessed"),
        ({"bust_girth": ["+4deg"]}, "expected a length"),
        (
            {"bust_girth": "+4cm"},
            "vary: bust_girth is '+4cm'; expected several of them",
        ),
        ({"bust_girth": [4]}, "vary: bust_girth, item 0, is 4; expected a change"),
        ({"bust_girth": None}, "vary: bust_girth is None"),
        ({1: ["+4cm"]}, "vary: a measurement is 1; expected its key"),
        ({"bust_girth": ["+4cm"], "hip_girth": ["+4cm", "+8cm"]}, "numbers of changes differ"),
        ({"bist_girth": ["+4cm"]}, "did you mean"),
        ({"bust_girth": ["+4cm"], "bust": ["+8cm"]}, "'bust_girth' is given a second time"),
        ({"bust_girth": ["+4cm", "+4 cm"]}, "bust_girth+4cm comes a second time"),
        ({"bust_girth": ["-1m"]}, "bust_girth is 88.0 cm, of which -1m leaves nothing"),
        ({"bust_girth": ["+90cm"]}, "the first body is possible, so change it by less"),
    ],
)
def test_bad_changes_are_refused(vary: object, message: str) -> None:
    with pytest.raises(InputError) as caught:
        bm.grade_body(VALUES, vary, unit="cm")  # type: ignore[arg-type]
    assert message in str(caught.value)


def test_sizes_need_names_of_their_own(tmp_path: Path) -> None:
    path = tmp_path / "one.csv"
    path.write_text("size,bust (cm),waist (cm),hip (cm)\n36,84,68,93\n")
    sizes = bm.read_measurements(path)
    with pytest.raises(InputError, match="two sizes have the name '36'"):
        bm.make_sizes([*sizes, *sizes])
    path.write_text("size,bust (cm),waist (cm),hip (cm)\n36,84,38,93\n")
    sizes = bm.read_measurements(path)
    with pytest.raises(InputError, match="36: waist_girth does not go with"):
        bm.make_sizes(sizes)
