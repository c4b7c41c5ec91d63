"""The page of a fit, and the colors of its pictures."""

import numpy as np
import pytest
from helpers.charts.scanned import scanned

from bodymeasure import InputError, load_sample, tessellate
from bodymeasure.report.fits import render_fit
from bodymeasure.scene.fits.pictures import (
    FULL,
    NO_SCAN,
    SCALE,
    Triangles,
    distance_colors,
    fit_pictures,
    vertex_normals,
)

SAMPLE = load_sample("female_average")


def test_the_page_says_how_good_the_fit_is_and_what_it_cannot_see() -> None:
    knees = [i for i, region in enumerate(SAMPLE.regions) if region == "knee left"]
    page = render_fit(scanned(SAMPLE, knees), {"scan explained": "99.2 %"}).decode()
    assert "0.600\N{NO-BREAK SPACE}mm" in page
    assert f"{len(knees)} of 376" in page
    # The region that the scan shows least comes first.
    assert page.index("knee left</th>") < page.index("neck right</th>")
    assert SAMPLE.patch_names[knees[0]] in page
    assert "98 %" in page
    for words in ("The scan has holes.", "99.2 %", "mirrored", "clothes", "scale is wrong"):
        assert words in page
    assert "<img" not in page
    assert "no cause for a warning" in render_fit(scanned(SAMPLE), {}).decode()


def test_an_atlas_without_a_scan_has_no_such_page() -> None:
    with pytest.raises(InputError, match="was not fitted to a scan"):
        render_fit(SAMPLE, {})


def test_colors_tell_inside_from_outside_and_from_no_scan() -> None:
    colors = distance_colors(np.array([-2.0 * FULL, -FULL, 0.0, FULL, np.nan]))
    assert colors[[0, 1, 2, 3]] == pytest.approx(SCALE[[0, 0, 1, 2]])
    assert colors[4] == pytest.approx(NO_SCAN)
    half = distance_colors(np.array([FULL / 2.0]))[0]
    assert half == pytest.approx((SCALE[1] + SCALE[2]) / 2.0)


@pytest.mark.slow
def test_the_pictures_show_body_and_scan() -> None:
    mesh = tessellate(SAMPLE, 2)
    body = Triangles(mesh.vertices, mesh.faces)
    lengths = np.linalg.norm(vertex_normals(body), axis=1)
    assert lengths == pytest.approx(np.ones(len(lengths)))
    seen: list[str] = []
    distance = np.full(len(mesh.vertices), FULL)
    found = fit_pictures(body, distance, body, renderer="software", advance=seen.append)
    assert seen == list(found.body) == ["front", "left", "back"]
    page = render_fit(scanned(SAMPLE), {}, found).decode()
    assert page.count("<img") == 3
    assert "seen from the left" in page
