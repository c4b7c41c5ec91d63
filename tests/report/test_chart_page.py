import json
import math
import re
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from helpers.charts.hand_made_chart import HOSTILE, MEASURED, hand_made_chart, tape_pictures
from helpers.files.page import Page

from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.report.body import OUTPUTS, chart_document, render_chart, write_chart


def page_of(unit: str = "cm", pictures: Any = None, **changes: Any) -> Page:
    return Page(render_chart(chart_document(hand_made_chart(**changes), unit), pictures))


@pytest.fixture
def page() -> Page:
    pictures = tape_pictures()
    pictures.numbers = {key: number + 3 for key, number in pictures.numbers.items()}
    return page_of(pictures=pictures)


def test_the_page_is_well_formed_and_stands_alone(page: Page) -> None:
    page.check_links()
    page.check_self_contained()


def test_names_are_escaped(page: Page) -> None:
    assert "<script" not in page.source
    assert "<b>Lengths" not in page.source
    assert HOSTILE in page.text
    assert "Body measurements of Anna <Muster>" in page.text
    assert "Drawn without <OpenGL>." in page.text
    assert "the points are <close>" in page.text


def test_a_scene_stands_in_the_page_and_cards_lead_into_it() -> None:
    scene = f"<!DOCTYPE html><title>{HOSTILE}</title></script>".encode()
    document = chart_document(hand_made_chart(), "cm")
    page = Page(render_chart(document, tape_pictures(), scene=scene))
    page.check_links()
    page.check_self_contained(scene=True)
    assert page.scene == scene
    # The frame is filled by the script; nothing of the scene is part of the page before.
    (frame,) = page.all("iframe")
    assert frame["title"] == "The body, to turn"
    assert not {"src", "srcdoc"} & set(frame)
    assert page.source.count("<script") == 2
    shown = [json.loads(a["data-show"] or "") for a in page.all("a") if "data-show" in a]
    valued = [record.key for record in document.measurements if record.value is not None]
    assert sorted(each["key"] for each in shown) == sorted(valued)


@pytest.mark.parametrize(
    ("wanted", "scene", "drawn"),
    [(True, None, [False]), (True, b"", [True]), ("all", b"", [False]), (False, b"", [])],
)
def test_beside_a_scene_few_pictures_are_drawn(
    wanted: Any,
    scene: bytes | None,
    drawn: list[bool],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    asked = []

    def draw(_chart: object, *, few: bool) -> Any:
        asked.append(few)
        return tape_pictures()

    monkeypatch.setattr("bodymeasure.scene.tape_pictures", draw)
    write_chart(hand_made_chart(), tmp_path, pictures=wanted, scene=scene)
    assert asked == drawn


def test_unknown_pictures_are_refused(tmp_path: Path) -> None:
    wanted: Any = "few"
    with pytest.raises(InputError, match=r"pictures is 'few'; expected True, False or 'all'"):
        write_chart(hand_made_chart(), tmp_path, pictures=wanted)


def test_every_tape_has_its_picture_and_its_number(page: Page) -> None:
    images = page.all("img")
    assert len(images) == 3 + 5
    assert all(len(image["alt"] or "") > 20 for image in images)
    assert {(i["width"], i["height"]) for i in images} == {("300", "500"), ("64", "48")}
    seen = [
        re.sub(r".* seen from the (\w+).* under “(.*)” .*", r"\2, \1", i["alt"] or "")
        for i in images
    ]
    assert seen[:3] == ["Girths, front", "Girths, back", "Other measurements, left"]
    # The numbers are those in the pictures; without pictures, measurements with a value are
    # numbered.
    assert "8. Shoulder slope" in page.text
    assert "5. Shoulder slope" in page_of().text
    # A measurement that was not drawn has no number.
    assert re.search(rf"\d\. {re.escape(HOSTILE)}", page.text) is None


def test_values_have_the_digits_of_a_tape(page: Page) -> None:
    for shown in ("91.3", "92.3", "10.2 mm", "30.2", "23.6°", "torso front 50.0", "elsewhere 42.3"):
        assert shown in page.text
    # The left arm is known only to 4 mm.
    assert "30.1" not in page.text
    assert "91.32" not in page.text
    assert re.search(r"\b(nan|None|inf)\b", page.text) is None


def test_inches_stand_beside_fractions() -> None:
    text = page_of("inch").text
    assert "35.95 (35 15/16)" in text
    assert "0.40 in" in text
    assert re.search(r"\bmm\b", text) is None
    # Angles have no fractions.
    assert "23.6°" in text
    assert "23.6° (" not in text


def test_what_is_missing_is_told_with_its_reason(page: Page) -> None:
    assert "5 of 7" in page.text
    assert "2 could not and have no value here (not converged: 1; missing landmark: 1)" in page.text
    assert "no route <here>; run bodymeasure check" in page.text
    assert "lacks the landmark 'waist'; set it on the atlas" in page.text
    assert "no rule for it" in page.text
    whole = page_of(
        measured=tuple(item for item in MEASURED if math.isfinite(item.value)),
        missing_landmarks={},
    )
    assert "All could be measured." in whole.text
    assert "Not measured" not in whole.text.partition("Summary")[0]
    whole.check_links()


def test_a_chart_of_nothing_is_a_page_too() -> None:
    page = page_of(measured=(), landmarks={}, missing_landmarks={})
    page.check_links()
    assert "0 of 0" in page.text


def test_the_sheet_for_the_hand_has_a_blank_for_each(page: Page) -> None:
    blanks = [a for a in page.all("td") if a.get("class") == "blank"]
    # Two readings each, as ISO 20685-1 has them, and none of the chart's own values beside them.
    assert len(blanks) == 2 * len(MEASURED)
    assert "@media print" in page.source
    sheet = page.source.partition('<h2 id="hand"')[2].partition("</section>")[0]
    assert all(field in sheet for field in ("Subject", "Date", "Measured by"))
    assert "91.3" not in sheet
    assert "23.6" not in sheet


def test_the_pictures_have_a_legend(page: Page) -> None:
    for words in ("blue: along the skin", "orange: drawn taut", "black: straight", "pale dashes"):
        assert words in page.text
    assert "blue: along the skin" not in page_of().text


def test_each_measurement_tells_words_landmarks_and_regions(page: Page) -> None:
    for told in ("Horizontal, over the bust points", "Landmarks: bust point left.", "(5.3.4)"):
        assert told in page.text
    assert "shoulder <length>" in page.text


def test_without_jinja2_the_message_names_the_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "jinja2", None)
    with pytest.raises(MissingExtraError, match=r"bodymeasure\[report\]"):
        page_of()


FILES = {
    "chart.html",
    "measurements.json",
    "measurements.csv",
    "measurements.schema.json",
    "anna.smis",
    "freesewing.json",
    "garmentcode.yaml",
}


def test_all_files_are_written_or_none(tmp_path: Path) -> None:
    folder = tmp_path / "new" / "chart"
    paths = write_chart(hand_made_chart(), folder, stem="anna", pictures=tape_pictures())
    assert paths[0] == folder / "chart.html"
    assert {path.name for path in folder.iterdir()} == {path.name for path in paths} == FILES
    (folder / "freesewing.json").unlink()
    (folder / "freesewing.json").mkdir()
    before = (folder / "measurements.csv").read_bytes()
    other = replace(hand_made_chart(), measured=())
    with pytest.raises(InputError, match=r"freesewing\.json: cannot be written"):
        write_chart(other, folder, stem="anna", pictures=False)
    assert (folder / "measurements.csv").read_bytes() == before


def test_an_output_is_one_line_of_the_registry(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(OUTPUTS, "{stem}.txt", lambda document: document.name.encode())
    paths = write_chart(hand_made_chart(), tmp_path, stem="anna", pictures=False)
    assert paths[-1] == tmp_path / "anna.txt"
    assert paths[-1].read_text("utf-8") == "Anna <Muster>"


def test_pictures_are_drawn_unless_they_are_left_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "bodymeasure.scene.tape_pictures", lambda _chart, **_options: tape_pictures()
    )
    page = write_chart(hand_made_chart(), tmp_path)[0]
    assert "data:image/png" in page.read_text("utf-8")
    write_chart(hand_made_chart(), tmp_path, pictures=False)
    assert "data:image/png" not in page.read_text("utf-8")
