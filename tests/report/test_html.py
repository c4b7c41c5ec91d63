import json
import re
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from helpers.files.page import Page

from bodymeasure.errors import MissingExtraError
from bodymeasure.geodesic.status import Status
from bodymeasure.report import closeup_patches, render_html, survey_document


def page_of(survey: Any, pictures: Any = None, unit: str = "cm") -> Page:
    return Page(render_html(survey_document(survey, unit), pictures))


@pytest.fixture
def page(survey: Any, pictures: Any) -> Page:
    return page_of(survey, pictures)


def test_the_page_is_well_formed_and_its_links_lead_somewhere(page: Page) -> None:
    page.check_links()


def test_the_page_loads_nothing_from_elsewhere(page: Page) -> None:
    page.check_self_contained()


def test_names_are_escaped(page: Page) -> None:
    assert "<script" not in page.source
    assert "<b>arm</b>" not in page.source
    assert '<script>alert("x")</script> & \u00c4rmel, "links"' in page.text
    assert "Measurements of Anna <Muster>" in page.text
    assert "Drawn without <OpenGL>." in page.text


def test_a_scene_stands_in_the_page_and_cards_lead_into_it(survey: Any, pictures: Any) -> None:
    scene = b"<!DOCTYPE html><title>Anna</title></script>"
    page = Page(render_html(survey_document(survey, "cm"), pictures, scene=scene))
    page.check_links()
    page.check_self_contained(scene=True)
    assert page.scene == scene
    shown = [json.loads(a["data-show"] or "") for a in page.all("a") if "data-show" in a]
    assert {each["patch"] for each in shown} == set(range(len(survey.atlas)))


def test_every_picture_has_an_alternative_text_and_a_size(page: Page) -> None:
    images = page.all("img")
    # There are four sides, the color bar, and a picture of each patch that is a worst case or
    # unmeasured.
    assert len(images) >= 4 + 1 + 2
    for image in images:
        assert len(image["alt"] or "") > 20
    sized = [image for image in images if (image["src"] or "").startswith("data:image/png")]
    assert {(i["width"], i["height"]) for i in sized} == {("300", "500"), ("64", "64")}
    for svg in page.all("svg"):
        assert svg["role"] == "img"


def test_each_status_is_explained_in_its_own_words(survey_of: Callable[..., Any]) -> None:
    unmeasured = tuple(status for status in Status if status is not Status.CONVERGED)
    page = page_of(survey_of(statuses=unmeasured[:4]))
    for status in (Status.CONVERGED, *unmeasured[:4]):
        assert status.value.replace("`", "") in page.text


def test_lengths_are_rounded_and_missing_ones_are_not_shown(survey_of: Callable[..., Any]) -> None:
    # There is no cross-check, whose distances the page would show where a length is missing.
    survey = survey_of(check=False)
    text = page_of(survey).text
    diagonals = survey.diagonals
    for length, raw in zip(diagonals.length.flat, diagonals.raw_length.flat, strict=True):
        assert (f"{100.0 * raw:.2f}" in text) == bool(np.isfinite(length))
    for length in survey.boundary.length.flat:
        assert f"{100.0 * length:.2f}" in text
    assert re.search(r"\b(nan|None|inf)\b", text) is None


def test_the_summary_counts_and_names_the_worst(page: Page) -> None:
    assert "6 of 8 diagonals could be measured; 2 could not" in page.text
    assert "leaves the patch: 1; not converged: 1" in page.text
    assert "5 agree with it and 1 do not" in page.text
    assert "torso front left 1-1 diagonal 2 differs most: by 3.0 \u00d7 10\u207b\u2074" in page.text
    assert "\u2260 disagrees" in page.text


def test_the_summary_and_the_tables_tell_what_is_proven(survey_of: Callable[..., Any]) -> None:
    survey = survey_of()
    page = page_of(survey)
    proven, measured = survey.diagonals.proven_shortest, np.isfinite(survey.diagonals.length)
    told = f"{proven.sum()} of these {measured.sum()} are proven to be the only shortest ways"
    assert told in page.text
    assert page.text.count("proven") > proven.sum()
    survey.diagonals.proven_shortest = measured
    assert "Each is proven to be the only shortest way" in page_of(survey).text


def test_the_summary_tells_of_paths_along_an_edge(survey_of: Callable[..., Any]) -> None:
    one, none = page_of(survey_of(statuses=(Status.ON_BOUNDARY,))), page_of(survey_of())
    assert "1 of those measured runs along an edge of the patch in part" in one.text
    assert "of those measured" not in none.text


def test_the_histogram_counts_every_difference(survey: Any, page: Page) -> None:
    assert len(page.all("rect")) >= 2
    bars = re.findall(r"<title>\S.* to .*: (\d+)</title>", page.source)
    compared = np.isfinite(survey.cross_check.relative_difference).sum()
    assert sum(map(int, bars)) == compared


def test_a_report_without_a_cross_check_says_so(survey_of: Callable[..., Any]) -> None:
    page = page_of(survey_of(check=False))
    assert "No cross-check was made" in page.text
    assert page.all("rect") == []
    assert "with the largest error estimates" in page.text


def test_a_report_without_pictures_or_findings_has_neither(survey_of: Callable[..., Any]) -> None:
    page = page_of(survey_of(findings=False))
    assert page.all("img") == []
    assert "Nothing was found wrong" in page.text


def test_nothing_measured_is_reported_too(survey_of: Callable[..., Any]) -> None:
    survey = survey_of()
    survey.diagonals.status[:] = Status.NOT_CONVERGED
    for values in (
        survey.diagonals.length,
        survey.cross_check.difference,
        survey.cross_check.relative_difference,
    ):
        values[:] = np.nan
    page = page_of(survey)
    assert "0 of 8 diagonals could be measured; 8 could not" in page.text
    assert "No diagonal was measured." in page.text
    assert "No diagonal could be compared." in page.text


def test_how_it_was_computed_is_told(survey: Any, page: Page) -> None:
    for word in (survey.atlas.digest, "Wu C6", "2.4", "0.07 s", "CC0 1.0", "a <scan>"):
        assert word in page.text


def test_closeups_are_of_the_worst_and_of_what_was_not_measured(survey: Any) -> None:
    patches = closeup_patches(survey_document(survey, "cm"))
    assert patches[0] == 0
    missing = np.flatnonzero(np.isnan(survey.diagonals.length).any(axis=1))
    assert set(missing) <= set(patches)
    assert len(patches) == len(set(patches))


def test_without_jinja2_the_message_names_the_extra(
    survey: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "jinja2", None)
    with pytest.raises(MissingExtraError, match=r"bodymeasure\[report\]"):
        page_of(survey)
