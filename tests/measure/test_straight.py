"""Heights, breadths, depths and straight distances."""

import math
from dataclasses import replace

import numpy as np
import pytest
from helpers.surfaces.tubes import tube

from bodymeasure.atlas import Atlas, AtlasPoint, Axes
from bodymeasure.measure import (
    body_girth,
    breadth,
    chord,
    depth,
    height,
)


def at(x: float, y: float, z: float) -> np.ndarray:
    return np.array([x, y, z])


def turned(atlas: Atlas, turn: np.ndarray) -> Atlas:
    return replace(atlas, points=atlas.points @ turn.T)


def test_straight_measures() -> None:
    atlas = replace(
        tube([1.0, 2.0, 2.0, 1.0]), landmarks={"top": AtlasPoint(0, 0.0, 1.0), "side": _BELLY}
    )
    assert height(atlas, "top") == pytest.approx(3.0, rel=1e-15)
    assert height(atlas, "top", floor=-0.5) == pytest.approx(3.5, rel=1e-15)
    assert height(atlas, "side") == pytest.approx(1.5, rel=1e-15)
    assert chord(atlas, "top", "side") == pytest.approx(math.hypot(1.5, 0.75), rel=1e-14)
    loop = body_girth(atlas, "side").loop
    assert breadth(atlas, loop) == pytest.approx(3.5, rel=1e-13)
    assert depth(atlas, loop) == pytest.approx(3.5, rel=1e-13)


_BELLY = AtlasPoint(0, 0.0, 0.5)


def test_breadth_and_depth_follow_the_axes() -> None:
    round_tube = tube([1.0] * 4)
    oval = replace(round_tube, points=round_tube.points * (2.0, 1.0, 1.0))
    loop = body_girth(oval, at(0, 0, 1)).loop
    assert (breadth(oval, loop), depth(oval, loop)) == pytest.approx((4.0, 2.0), rel=1e-13)
    sideways = replace(oval, axes=Axes(up="+z", front="+x"))
    assert (breadth(sideways, loop), depth(sideways, loop)) == pytest.approx((2.0, 4.0), rel=1e-13)
    lying = replace(oval, points=oval.points[:, [0, 2, 1]], axes=Axes(up="+y", front="+z"))
    assert height(lying, AtlasPoint(0, 0.0, 1.0)) == pytest.approx(3.0, rel=1e-15)
    assert body_girth(lying, at(0, 1, 0)).contact == pytest.approx(loop.length, rel=1e-13)
