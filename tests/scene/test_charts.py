import re
import xml.etree.ElementTree as ElementTree

import numpy as np
from helpers.charts.straight_survey import straight_survey
from matplotlib.figure import Figure

from bodymeasure.atlas import Atlas
from bodymeasure.scene import body_scene, color_bar
from bodymeasure.scene.figures.color_bar import figure_svg


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


def test_figures_repeat_themselves_and_share_no_identifiers(body: Atlas) -> None:
    survey = straight_survey(body, difference=np.logspace(-9, -5, 2 * len(body)).reshape(-1, 2))
    paths = body_scene(survey).paths
    bar = color_bar(paths)
    assert bar == color_bar(paths)
    figure = Figure()
    figure.add_subplot().plot([0.0, 1.0])
    other = figure_svg(figure, "other")
    identifiers = [set(re.findall(rb'\bid="([^"]+)"', svg)) for svg in (bar, other)]
    assert identifiers[0]
    assert not identifiers[0] & identifiers[1]
    for svg, known in zip((bar, other), identifiers, strict=True):
        used = set(re.findall(rb'(?:url\(#|href="#)([^")]+)', svg))
        assert used <= known
