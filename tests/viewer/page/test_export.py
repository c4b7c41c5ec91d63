import base64
import gzip
import hashlib
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bodymeasure.viewer import export_page
from bodymeasure.viewer.content.wire import packed, unpacked
from bodymeasure.viewer.page.compact import compact
from helpers.charts.hand_made_chart import HOSTILE, hand_made_chart

import bodymeasure as bm


class Exported:
    """What a page holds, read as a browser reads it."""

    def __init__(self, page: bytes) -> None:
        self.source = page.decode()
        # Elements of this kind end at the first such tag, whatever stands before it.
        self.scripts = re.findall(r"<script([^>]*)>(.*?)</script", self.source, flags=re.DOTALL)
        self.data = json.loads(self._of('id="bodymeasure-data"'))
        self.program = self._of('type="module"')

    def _of(self, attribute: str) -> str:
        (found,) = (content for tag, content in self.scripts if attribute in tag)
        return str(found)

    def message(self, *names: str) -> tuple[dict[str, Any], dict[str, Any]]:
        text: Any = self.data
        for name in names:
            text = text[name]
        return unpacked(gzip.decompress(base64.b64decode(text, validate=True)))


@pytest.fixture(scope="module")
def body() -> bm.Atlas:
    return bm.load_sample("female_average")


@pytest.fixture(scope="module")
def page(body: bm.Atlas) -> Exported:
    return Exported(export_page(body))


def test_the_body_is_as_exact_as_its_triangles(page: Exported, body: bm.Atlas) -> None:
    header, arrays = page.message("body")
    assert (header["segments"], header["patches"]) == (8, 376)
    corner = arrays["positions"][30, 8, 0]
    x, y, z = body.position(bm.AtlasPoint(30, 1.0, 0.0))
    # The page's axes are left, up and front.
    np.testing.assert_allclose(corner, [x, z, -y], atol=1e-5)
    assert np.abs(np.linalg.norm(arrays["normals"], axis=-1) - 1.0).max() < 0.01
    names = [each["name"] for each in header["landmarks"]]
    assert names == list(body.landmarks)


def test_the_page_loads_nothing_and_runs_nothing_else(page: Exported) -> None:
    assert re.findall(r'(?:src|href)="(?!data:)[^"]*', page.source) == []
    (policy,) = re.findall(r'Content-Security-Policy" content="([^"]*)"', page.source)
    policy = policy.replace("&#x27;", "'")
    assert policy.startswith("default-src 'none';")
    digest = base64.b64encode(hashlib.sha256(page.program.encode()).digest()).decode()
    assert f"script-src 'sha256-{digest}';" in policy
    assert "connect-src" not in policy
    assert "unsafe" not in policy
    # The licenses of what it is made of ask to go with it.
    assert "three-mesh-bvh" in page._of('id="licenses"')


@pytest.mark.slow
def test_a_body_with_a_full_chart_is_small_enough_to_mail(body: bm.Atlas) -> None:
    chart = bm.measure_chart(body)
    page = export_page(chart)
    assert len(page) < 3e6
    header, _ = Exported(page).message("chart")
    assert len(header["measurements"]) == len(chart.measured) > 90


def test_a_page_has_the_measurements_and_tapes_of_its_chart(body: bm.Atlas) -> None:
    keys = ("bust_girth", "waist_girth", "stature")
    chart = bm.measure_chart(body, only=keys)
    small = Exported(export_page(chart))
    header, arrays = small.message("chart")
    assert [each["key"] for each in header["measurements"]] == list(keys)
    bust = header["measurements"][0]
    assert bust["value"] == pytest.approx(chart["bust_girth"].value, rel=1e-12)
    tape = header["tapes"][bust["tapes"][0]]
    points = arrays["tape_points"][tape["first"] : tape["first"] + tape["count"]]
    length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    assert (tape["kind"], tape["closed"]) == ("contact", True)
    assert length == pytest.approx(chart["bust_girth"].contact, rel=1e-3)
    assert small.data["options"]["chart"] is True


@pytest.mark.parametrize("compare", [True, False])
def test_a_survey_comes_with_its_diagonals_and_differences(compare: bool) -> None:
    pytest.importorskip("igl")
    survey = bm.measure_atlas(bm.load_sample("paraboloid"), compare=compare)
    exported = Exported(export_page(survey))
    header, arrays = exported.message("layers", "diagonals")
    first = header["items"][0]
    assert len(header["items"]) == 2 == len(arrays["points"])
    assert first["length"] == survey.diagonals.length[0, 0] * survey.atlas.unit.meters
    lines = np.linalg.norm(np.diff(arrays["points"][0], axis=0), axis=1).sum()
    assert lines == pytest.approx(first["length"], rel=1e-3)
    if survey.cross_check is not None:
        assert first["difference"] == survey.cross_check.relative_difference[0, 0]
    assert ("difference" in first) == compare
    settings = exported.data["options"]["settings"]
    assert settings["lines"] == ("difference" if compare else "error")


def test_names_from_files_are_no_part_of_the_page(tmp_path: Path) -> None:
    chart = hand_made_chart()
    exported = Exported(export_page(chart, tmp_path / "anna.html"))
    assert (tmp_path / "anna.html").read_text("utf-8") == exported.source
    # Names are packed with the body and the chart; the page has them as text (see the tests in a
    # browser), and what stands in its own source is its title.
    assert "<title>Anna &lt;Muster&gt; · bodymeasure</title>" in exported.source
    header, _ = exported.message("chart")
    assert HOSTILE in [each["title"] for each in header["measurements"]]
    assert len(exported.scripts) == 3


def test_what_would_end_the_elements_is_written_otherwise(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from bodymeasure.viewer.page import document

    texts = {"viewer.js": 'let a = "</script><!--";', "viewer.css": "a{content:'</style>'}"}
    monkeypatch.setattr(document, "_static", lambda name: texts.get(name, "<b>"))
    exported = Exported(document.page_of("</title>", {"a": "</script><!--"}))
    assert exported.data == {"a": "</script><!--"}
    assert exported.program == 'let a = "<\\/script><\\!--";'
    assert exported.source.count("</style>") == 1
    assert exported.source.count("</title>") == 1


def test_the_same_body_makes_the_same_page(page: Exported, body: bm.Atlas) -> None:
    assert export_page(body).decode() == page.source


def test_files_are_read_with_their_unit(tmp_path: Path) -> None:
    bm.write_atlas(bm.load_sample("paraboloid"), tmp_path / "p.bpt")
    with pytest.raises(bm.InputError, match="unit"):
        export_page(tmp_path / "p.bpt")
    header, _ = Exported(export_page(tmp_path / "p.bpt", unit="mm")).message("body")
    assert (header["unit"], header["name"]) == ("mm", "p")
    with pytest.raises(bm.InputError, match=r"unit is 'mm', but .* no name of a file is given"):
        export_page(bm.load_sample("paraboloid"), unit="mm")


def test_a_page_that_cannot_be_made_or_written_is_told(tmp_path: Path) -> None:
    nothing: Any = 3
    with pytest.raises(bm.InputError, match=r"nothing to show in 3; expected an Atlas, a Chart"):
        export_page(nothing)
    with pytest.raises(bm.InputError, match=r"missing/page.html: cannot be written"):
        export_page(bm.load_sample("paraboloid"), tmp_path / "missing" / "page.html")


@pytest.mark.parametrize("size", [1e-3, 1.7, 1700.0])
def test_coordinates_are_rounded_in_proportion_to_the_body(
    size: float, rng: np.random.Generator
) -> None:
    points = size * rng.random((1000, 3))
    normals = rng.standard_normal((1000, 3))
    numbers = np.arange(5, dtype=np.uint32)
    message = packed({"name": "x"}, {"points": points, "tape_normals": normals, "numbers": numbers})
    content = base64.b64decode(compact(message, size))
    header, arrays = unpacked(gzip.decompress(content))
    assert header["name"] == "x"
    assert np.abs(arrays["points"] - points).max() <= 2.0**-17 * size
    assert np.abs(arrays["tape_normals"] - normals).max() <= 2.0**-9
    np.testing.assert_array_equal(arrays["numbers"], numbers)
    assert len(content) < 0.7 * len(message)


def test_a_missing_line_stays_missing() -> None:
    points = np.array([[0.0, 1.0, np.nan]])
    content = gzip.decompress(base64.b64decode(compact(packed({}, {"points": points}), 1.0)))
    assert np.isnan(unpacked(content)[1]["points"][0, 2])
