"""Girths at a clicked height and closed loops from a clicked point."""

import numpy as np
import pytest
from helpers.viewer_page import Screen

import bodymeasure as bm
from bodymeasure.measure import body_girth, closed_geodesic


def test_girth(screen: Screen) -> None:
    atlas = bm.load_sample("female_average")
    screen.get("tool-girth").click()
    tape = screen.measure(screen.middle_of("front waist point"))
    assert tape["mode"] == "girth"
    girth = body_girth(atlas, bm.AtlasPoint(*tape["locations"][0]))
    assert tape["result"]["length"] == pytest.approx(girth.taut, abs=1e-12)
    shown = screen.get("length").inner_text().removesuffix(" cm")
    assert shown == f"{100 * girth.taut:.{len(shown.partition('.')[2])}f}"
    # It lies level, and is closed.
    points = np.array(tape["result"]["points"])
    assert np.ptp(points[:, 1]) < 1e-6
    screen.get("kind-contact").click()
    on_skin = screen.settle()["tapes"][0]["result"]
    assert on_skin["length"] == pytest.approx(girth.contact, abs=1e-12)


def test_closed_loop(screen: Screen) -> None:
    atlas = bm.load_sample("female_average")
    screen.page.keyboard.press("l")
    tape = screen.measure(screen.middle_of("front waist point"))
    assert tape["mode"] == "closed"
    path = closed_geodesic(atlas, bm.AtlasPoint(*tape["locations"][0]), on_failure="status")
    if np.isfinite(path.length):
        assert tape["result"]["length"] == path.length
    else:
        assert screen.get("length").inner_text() == "No length"
    assert screen.get("words").inner_text()
