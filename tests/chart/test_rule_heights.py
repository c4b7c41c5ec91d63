"""Landmarks where a path passes a height."""

from dataclasses import replace

import numpy as np
from helpers.surfaces.tubes import joined, tube

from bodymeasure.atlas import AtlasPoint
from bodymeasure.chart import derive_landmarks
from bodymeasure.chart.landmarks.rules import AtHeight

# Landmarks around the tube, where u = 0 on its patches.
LEFT, FRONT = 0, 3
LANDMARKS = {
    "bottom": AtlasPoint(FRONT, 0.0, 0.1),
    "top": AtlasPoint(FRONT, 0.0, 0.9),
    "left": AtlasPoint(LEFT, 0.0, 0.37),
    "high": AtlasPoint(LEFT, 0.0, 0.95),
}
# The tube is wider above, and heights are still known.
BODY = replace(joined([tube((1.0, 1.2, 1.1, 1.4))], ["torso"]), landmarks=LANDMARKS)


def test_the_point_has_the_height() -> None:
    rules = [
        AtHeight(name="up", start="bottom", end="top", of="left"),
        AtHeight(name="down", start="top", end="bottom", of="left"),
        AtHeight(name="across", start="bottom", end="high", of="left"),
        AtHeight(name="start", start="left", end="top", of="left"),
    ]
    derived = derive_landmarks(BODY, rules)
    assert derived.missing == {}
    height = BODY.position(LANDMARKS["left"])[2]
    for rule in rules:
        position = BODY.position(derived.landmarks[rule.name])
        assert abs(position[2] - height) < 1e-14
    up, down = (BODY.position(derived.landmarks[name]) for name in ("up", "down"))
    np.testing.assert_allclose(up, down, atol=1e-13)
    # The front line is a plane of symmetry, and so its own geodesic.
    assert abs(up[0]) < 1e-12
    start = BODY.position(derived.landmarks["start"])
    np.testing.assert_allclose(start, BODY.position(LANDMARKS["left"]), atol=1e-13)


def test_a_path_that_stays_below_says_so() -> None:
    rule = AtHeight(name="a", start="bottom", end="top", of="high")
    missing = derive_landmarks(BODY, [rule]).missing
    assert missing == {"a": "the path from 'bottom' to 'top' does not pass the height of 'high'"}
