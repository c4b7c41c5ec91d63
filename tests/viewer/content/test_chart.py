"""The page's chart is the library's, with the names of the reports."""

from dataclasses import replace
from typing import Any, get_args, get_type_hints

import numpy as np
import pytest
from bodymeasure.viewer.content.answers import File, answer
from bodymeasure.viewer.content.bodies import Bodies
from bodymeasure.viewer.content.chart import FILES, sets_of
from bodymeasure.viewer.content.requests import Export, MeasureChart
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.content.wire import unpacked
from helpers.speed import quick
from msgspec import json

import bodymeasure as bm
from bodymeasure.chart import Chart, Definitions, load_definitions
from bodymeasure.chart.kinds import HeightMeasure, PathMeasure
from bodymeasure.errors import InputError
from bodymeasure.report.body import chart_document

SETS = ("core", "tops")


@pytest.fixture(scope="module")
def core(female: ShownBody) -> Chart:
    return bm.measure_chart(female.atlas, only=["trousers"])


@pytest.fixture(scope="module")
def message(bodies: Bodies) -> bytes:
    found = answer(bodies, MeasureChart(set="trousers"))
    assert isinstance(found, bytes)
    return found


def test_values_and_names_are_those_of_the_report(core: Chart, message: bytes) -> None:
    header, _ = unpacked(message)
    records = chart_document(core, "m").measurements
    assert len(header["measurements"]) == len(records) > 10
    for found, record in zip(header["measurements"], records, strict=True):
        assert (found["key"], found["value"]) == (record.key, record.value)
        assert found["error_estimate"] == record.error_estimate
        assert (found["title"], found["group"]) == (record.name, record.group)
        assert found["codes"].get("seamlyme", []) == record.seamly
        assert found["codes"].get("freesewing") == record.freesewing
        assert found["landmarks"] == record.landmarks
    waist = next(one for one in header["measurements"] if one["key"] == "waist_girth")
    assert (waist["kind"], waist["side"]) == ("length", "")
    assert waist["codes"]["iso"].startswith("Waist girth ")


def test_tapes_are_drawn_with_their_lengths(core: Chart, message: bytes) -> None:
    header, arrays = unpacked(message)
    tapes, points = header["tapes"], arrays["tape_points"]
    assert sum(tape["count"] for tape in tapes) == len(points) == len(arrays["tape_free"])
    for found, item in zip(header["measurements"], core.measured, strict=True):
        own = [tapes[number] for number in found["tapes"]]
        assert [tape["kind"] for tape in own] == [tape.kind.value for tape in item.tapes]
        for tape, drawn in zip(own, item.tapes, strict=True):
            assert tape["key"] == found["key"]
            line = points[tape["first"] : tape["first"] + tape["count"]]
            length = np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
            whole = np.linalg.norm(np.diff(drawn.points, axis=0), axis=1).sum()
            assert length == pytest.approx(whole, rel=5e-3)
            assert tape["closed"] == bool(np.allclose(line[0], line[-1], atol=1e-7))


def test_landmarks_on_the_page_are_those_that_were_used(core: Chart, message: bytes) -> None:
    header, _ = unpacked(message)
    found = {mark["name"]: mark for mark in header["landmarks"]}
    assert {name: tuple(mark["location"]) for name, mark in found.items()} == dict(core.landmarks)
    assert found["back neck point"]["origin"] == "file"
    ruled = [name for name in core.landmarks if name not in core.atlas.landmarks]
    assert ruled
    assert all(found[name]["origin"] == "rule" for name in ruled)


def knee_and_back() -> Definitions:
    return Definitions(
        name="Two",
        measurement=(
            HeightMeasure(key="knee", name="Knee", at="patella point left"),
            PathMeasure(key="back", name="Back", through=("back neck point", "back waist point")),
        ),
    )


def values(bodies: Bodies, **members: Any) -> dict[str, Any]:
    found = answer(bodies, MeasureChart(set="own", **members))
    assert isinstance(found, bytes)
    header, _ = unpacked(found)
    return {one["key"]: one for one in header["measurements"]}


def test_landmarks_that_the_page_moves_or_takes_off_count(female: ShownBody) -> None:
    bodies = Bodies(own=knee_and_back())
    bodies.put(female)
    atlas = female.atlas
    before = values(bodies)
    assert before["knee"]["value"] == atlas.position(atlas.landmarks["patella point left"])[2]
    place = atlas.landmarks["elbow point left"]
    moved = values(bodies, landmarks={"patella point left": tuple(place)})
    assert moved["knee"]["value"] == atlas.position(place)[2]
    assert moved["back"]["value"] == before["back"]["value"]
    without = values(bodies, landmarks={"patella point left": None})
    assert without["knee"]["value"] is None
    assert without["knee"]["outcome"] == "missing landmark"
    assert "patella point left" in without["knee"]["reason"]
    assert values(bodies)["knee"]["value"] == before["knee"]["value"]


def test_a_chart_is_measured_once_for_all_of_its_files(
    female: ShownBody, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls = []
    real = bm.measure_chart

    def counting(*arguments: Any, **settings: Any) -> Chart:
        calls.append(arguments)
        return real(*arguments, **settings)

    monkeypatch.setattr("bodymeasure.viewer.content.chart.measure_chart", counting)
    bodies = Bodies(own=knee_and_back())
    bodies.put(female)
    values(bodies)
    for form in ("csv", "json", "smis", "freesewing", "garmentcode"):
        answer(bodies, Export(set="own", format=form))
    assert len(calls) == 1
    bodies.put(replace(female, version=2))
    values(bodies)
    assert len(calls) == 2


def test_each_format_that_may_be_asked_for_is_written() -> None:
    assert set(get_args(get_type_hints(Export)["format"])) == set(FILES)


@pytest.mark.parametrize("unit", quick(["inch", "cm"]))
def test_a_file_holds_the_values_in_its_unit(bodies: Bodies, core: Chart, unit: Any) -> None:
    found = answer(bodies, Export(set="trousers", format="json", unit=unit))
    assert isinstance(found, File)
    assert found.name == "Average.json"
    document = json.decode(found)
    expected = chart_document(core, unit)
    assert document["unit"] == unit
    told = [one["value"] for one in document["measurements"]]
    assert told == [record.value for record in expected.measurements]


def test_progress_is_told(female: ShownBody) -> None:
    bodies = Bodies(own=knee_and_back())
    bodies.put(female)
    told: list[tuple[int, int, str]] = []
    answer(bodies, MeasureChart(set="own"), lambda *done: told.append(done))
    assert told == [(1, 2, "measuring"), (2, 2, "measuring")]


def test_sets_are_the_default_one_its_presets_and_the_users() -> None:
    whole = load_definitions()
    keys = [one["key"] for one in sets_of(None)]
    assert keys == ["default", *whole.presets]
    assert sets_of(knee_and_back())[0] == {"key": "own", "label": "Two"}


def test_a_set_that_there_is_not_is_told(bodies: Bodies) -> None:
    with pytest.raises(InputError, match="there is no set 'cores' of measurements; did you mean"):
        answer(bodies, MeasureChart(set="cores"))
    with pytest.raises(InputError, match="there is no set 'own'"):
        answer(bodies, MeasureChart(set="own"))


def test_landmarks_that_contradict_the_sides_are_told_unless_the_user_wants_it(
    female: ShownBody,
) -> None:
    landmarks = dict(female.atlas.landmarks)
    for name in ("elbow point", "bust point", "patella point", "shoulder point"):
        left, right = landmarks[f"{name} left"], landmarks[f"{name} right"]
        landmarks[f"{name} left"], landmarks[f"{name} right"] = right, left
    swapped = replace(female, atlas=replace(female.atlas, landmarks=landmarks))
    bodies = Bodies(own=knee_and_back())
    bodies.put(swapped)
    with pytest.raises(InputError, match="the landmarks contradict the axes, the sides or the"):
        values(bodies)
    bodies.put(replace(swapped, despite_errors=True))
    assert values(bodies)["knee"]["value"] is not None
