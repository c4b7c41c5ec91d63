import re
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
from helpers.charts.straight_survey import straight_survey

from bodymeasure.atlas import Atlas
from bodymeasure.errors import InputError
from bodymeasure.scene import body_scene, color_bar, histogram


def texts(svg: bytes) -> list[str]:
    root = ElementTree.fromstring(svg.decode())
    return ["".join(element.itertext()).strip() for element in root.iter() if "text" in element.tag]


def test_the_color_bar_names_its_range_and_what_is_there(body: Atlas) -> None:
    missing = np.zeros((len(body), 2), dtype=bool)
    plain = color_bar(body_scene(straight_survey(body, difference=5e-7)).paths)
    assert texts(plain) == ["10⁻⁷", "10⁻⁶", "relative difference from libigl exact"]
    missing[3, 1] = True
    words = texts(color_bar(body_scene(straight_survey(body, no_length=missing)).paths))
    assert "no length" in words
    assert "length not compared" not in words
    words = texts(color_bar(body_scene(straight_survey(body, check=False)).paths))
    assert words == ["length not compared"]


def test_the_histogram_says_the_median_and_the_largest(body: Atlas) -> None:
    difference = np.full((len(body), 2), -3e-8)
    difference[5, 0] = 4e-5
    svg = histogram(straight_survey(body, difference=difference))
    assert "median 3.0 \N{MULTIPLICATION SIGN} 10⁻⁸" in texts(svg)
    assert "largest 4.0 \N{MULTIPLICATION SIGN} 10⁻⁵" in texts(svg)


def test_a_histogram_of_nothing_is_an_error(square: Atlas) -> None:
    with pytest.raises(InputError, match="no differences"):
        histogram(straight_survey(square, check=False))
    with pytest.raises(InputError, match="no differences"):
        histogram(straight_survey(square, no_length=np.ones((1, 2), dtype=bool)))


def test_charts_repeat_themselves_and_share_no_identifiers(body: Atlas) -> None:
    survey = straight_survey(body, difference=np.logspace(-9, -5, 2 * len(body)).reshape(-1, 2))
    bar, bars = color_bar(body_scene(survey).paths), histogram(survey)
    assert bar == color_bar(body_scene(survey).paths)
    assert bars == histogram(survey)
    identifiers = [set(re.findall(rb'\bid="([^"]+)"', svg)) for svg in (bar, bars)]
    assert identifiers[0]
    assert not identifiers[0] & identifiers[1]
    for svg, known in zip((bar, bars), identifiers, strict=True):
        used = set(re.findall(rb'(?:url\(#|href="#)([^")]+)', svg))
        assert used <= known
