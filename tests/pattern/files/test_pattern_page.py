"""The page of a pattern."""

from dataclasses import replace
from datetime import UTC, datetime
from html.parser import HTMLParser

import msgspec
import numpy as np
import pytest

import bodymeasure as bm
from bodymeasure.pattern import strain_colors
from bodymeasure.report.patterns import render_pattern
from bodymeasure.scene.panels.pictures import panel_pictures

MOMENT = datetime(2026, 3, 1, 12, 0, tzinfo=UTC)


class Read(HTMLParser):
    """The words of a page, its rows of tables, and what it would load or link to."""

    def __init__(self, page: bytes) -> None:
        super().__init__()
        self.rows: list[list[str]] = []
        self.links: list[str] = []
        self.loads: list[str] = []
        self.ids: set[str] = set()
        self.open: list[str] = []
        self.feed(page.decode())

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        self.ids |= {given["id"] or ""} if "id" in given else set()
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")
        if tag == "a":
            self.links.append(given["href"] or "")
        if given.get("src"):
            self.loads.append(given["src"] or "")
        self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        while self.open and self.open.pop() != tag:
            pass

    def handle_data(self, data: str) -> None:
        if {"td", "th"} & set(self.open[-1:]):
            self.rows[-1][-1] += data


def test_the_page_lists_seams_darts_and_edges(bodice: bm.Pattern) -> None:
    read = Read(render_pattern(bodice, files=("pattern.pdf", "pattern.svg"), created=MOMENT))
    seams = [row for row in read.rows if row[0] == "side" and len(row) == 7]
    length = f"{1000.0 * bodice.seams[0].lengths[0]:.1f}"
    assert seams == [
        ["side", "bodice front: side", length, "bodice back: side", length, "none", "none"]
    ]
    (dart,) = bodice["bodice front"].darts
    assert ["waist dart", "bodice front: waist"] in [row[:2] for row in read.rows]
    assert any(f"{1000.0 * dart.intake:.1f}" in row for row in read.rows)
    edges = [row for row in read.rows if len(row) == 6 and row[0] == "center front"]
    assert edges[0][2] == "on the fold"
    assert read.links[-2:] == ["pattern.pdf", "pattern.svg"]
    assert {link[1:] for link in read.links if link.startswith("#")} <= read.ids
    assert not read.loads


def test_names_from_files_are_escaped_on_the_page(bodice: bm.Pattern) -> None:
    front, back = bodice.pieces
    panel = msgspec.structs.replace(back.panel, name="<script>x", cut="<i>")
    edges = tuple(replace(edge, seam="<b>&") for edge in back.edges)
    pattern = replace(bodice, pieces=(replace(back, panel=panel, edges=edges), front))
    page = render_pattern(pattern, created=MOMENT).decode()
    assert "<script>x" not in page
    assert "<i>" not in page
    assert "<b>&" not in page
    assert "&lt;script&gt;x" in page


def test_the_same_pattern_is_the_same_page(bodice: bm.Pattern) -> None:
    assert render_pattern(bodice, created=MOMENT) == render_pattern(bodice, created=MOMENT)


def test_colors_run_from_no_strain_to_much() -> None:
    low, high, more = strain_colors(np.array([0.0, 0.15, 0.3]))
    assert low == pytest.approx(np.array([68, 1, 84]) / 255.0)
    assert high == pytest.approx(np.array([253, 231, 37]) / 255.0)
    assert more.tolist() == high.tolist()


@pytest.mark.slow
@pytest.mark.parametrize("renderer", ["software", None])
def test_pictures_show_the_panels_on_the_body(bodice: bm.Pattern, renderer: str | None) -> None:
    pictures = panel_pictures(bodice, renderer=renderer)
    # The pieces are those of the left half.
    assert [*pictures.body] == ["front", "left", "back"]
    read = Read(render_pattern(bodice, pictures, created=MOMENT))
    assert len(read.loads) == 3
    assert all(load.startswith("data:image/webp;base64,") for load in read.loads)
