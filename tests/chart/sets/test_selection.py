"""Measurements chosen by keys and presets, and what that leaves out."""

from dataclasses import replace
from pathlib import Path

import msgspec
import pytest

import bodymeasure as bm
from bodymeasure.atlas import AtlasPoint
from bodymeasure.chart import both_sides, load_definitions, restricted, selected_keys
from bodymeasure.errors import InputError

DEFAULT = load_definitions()
KEYS = {one.key for one in both_sides(DEFAULT.measurement)}


@pytest.mark.parametrize("preset", DEFAULT.presets)
def test_presets_name_measurements_of_the_default_set(preset: str) -> None:
    keys = selected_keys(DEFAULT, [preset])
    assert len(keys) >= len(DEFAULT.presets[preset])
    assert set(keys) <= KEYS


def test_keys_stand_for_both_sides_in_the_order_of_the_set() -> None:
    keys = selected_keys(DEFAULT, ["knee_height", "waist_girth", "hip_height_left"])
    assert keys == ("waist_girth", "hip_height_left", "knee_height_left", "knee_height_right")


def test_what_is_needed_goes_with_what_is_chosen() -> None:
    chosen, needed = restricted(DEFAULT, ["shoulder_slope_left"])
    assert [one.key for one in chosen.measurement] == ["shoulder_slope_left"]
    assert {one.key for one in needed.measurement} == {
        "shoulder_slope_left",
        "side_neck_height_left",
        "shoulder_height_left",
        "shoulder_chord_left",
    }
    assert needed.landmark == ()
    _, needed = restricted(DEFAULT, ["mid_thigh_girth_left"])
    assert {rule.name for rule in needed.landmark} >= {"mid-thigh point left"}
    assert len(needed.landmark) < 6


FEW = msgspec.structs.replace(
    restricted(DEFAULT, ["stature", "knee_height", "shoulder_slope"])[1],
    presets={"core": ("stature", "knee_height")},
)


def test_a_choice_changes_no_value() -> None:
    body = bm.load_sample("female_average")
    every, few = bm.measure_chart(body, FEW), bm.measure_chart(body, FEW, only=["shoulder_slope"])
    keys = [item.definition.key for item in few.measured]
    assert keys == ["shoulder_slope_left", "shoulder_slope_right"]
    assert all(few[key].value == every[key].value for key in keys)


def test_one_name_is_no_list_of_names() -> None:
    with pytest.raises(InputError, match=r"expected a list of names, such as \['waist_girth'\]"):
        bm.measure_chart(bm.load_sample("paraboloid"), only="waist_girth")


def test_a_body_with_a_head_has_a_stature() -> None:
    body = replace(bm.load_sample("female_average"), given={})
    for only in ([], ["core"]):
        chart = bm.measure_chart(body, FEW, only=only)
        assert "stature" not in [item.definition.key for item in chart.measured]
    assert bm.measure_chart(body, FEW, only=["stature"])["stature"].outcome == "missing landmark"
    crown = AtlasPoint(0, 0.5, 0.5)
    whole = replace(body, landmarks={**body.landmarks, "top of head": crown})
    chart = bm.measure_chart(whole, FEW, only=["core"], despite_errors=True)
    assert chart["stature"].value == pytest.approx(float(body.position(crown)[2]))


def test_a_file_may_add_presets_and_drop_what_others_name(tmp_path: Path) -> None:
    head = 'format = "bodymeasure measurements"\nversion = 1\nname = "Mine"\nextends = "default"\n'
    file = tmp_path / "mine.toml"
    file.write_text(head + 'drop = ["waist_girth"]\n[presets]\nlegs = ["knee_girth"]\n')
    mine = load_definitions(file)
    assert selected_keys(mine, ["legs"]) == ("knee_girth_left", "knee_girth_right")
    assert "waist_girth" not in selected_keys(mine, ["core"])
    file.write_text(head + '[presets]\nlegs = ["knee_girt"]\n')
    with pytest.raises(InputError, match="the preset 'legs' names 'knee_girt', which is no "):
        load_definitions(file)
