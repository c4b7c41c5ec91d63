import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bodymeasure._typing import Array
from bodymeasure.scene.tapes.label_layout import PITCH, Columns, Layout, place_labels

COLUMNS = Columns(left=100.0, right=900.0, top=0.0, bottom=1000.0, label_height=26.0)
# Leaders may touch where their anchors coincide; crossings are deeper than this, in pixels squared.
ROUNDING = 1e-6

pixel = st.floats(110.0, 890.0).map(lambda value: round(value, 2))
things = st.lists(st.tuples(pixel, pixel, pixel, pixel), min_size=1, max_size=70)


def placed(drawn: list[tuple[float, float, float, float]]) -> tuple[Array, Layout]:
    ends = np.array(drawn).reshape(-1, 2, 2)
    order = np.argsort(ends[..., 0], axis=1)[..., None]
    ends = np.take_along_axis(ends, order, axis=1)
    return ends, place_labels(ends[:, 0], ends[:, 1], COLUMNS)


def leaders(layout: Layout) -> Array:
    start = np.where(layout.on_right, COLUMNS.right, COLUMNS.left)
    return np.stack([np.stack([start, layout.y], axis=1), layout.anchor], axis=1)


def turn(a: Array, b: Array, c: Array) -> float:
    return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))


def cross(one: Array, other: Array) -> bool:
    """Whether two segments have inner points in common."""
    sides = turn(one[0], one[1], other[0]), turn(one[0], one[1], other[1])
    others = turn(other[0], other[1], one[0]), turn(other[0], other[1], one[1])
    return (
        min(sides) < -ROUNDING
        and max(sides) > ROUNDING
        and min(others) < -ROUNDING
        and max(others) > ROUNDING
    )


@settings(deadline=None, max_examples=50)
@given(things)
def test_leaders_do_not_cross(drawn: list[tuple[float, float, float, float]]) -> None:
    _, layout = placed(drawn)
    for one, other in itertools.combinations(leaders(layout), 2):
        assert not cross(one, other)


@settings(deadline=None, max_examples=50)
@given(things)
def test_labels_do_not_overlap_and_stay_inside(
    drawn: list[tuple[float, float, float, float]],
) -> None:
    _, layout = placed(drawn)
    for side in (False, True):
        y = np.sort(layout.y[layout.on_right == side])
        assert (np.diff(y) >= layout.label_height * (1.0 + 1e-9)).all()
        assert (y >= COLUMNS.top + layout.label_height / 2).all()
        assert (y <= COLUMNS.bottom - layout.label_height / 2).all()


@settings(deadline=None, max_examples=50)
@given(things)
def test_each_label_is_led_to_its_own_thing(
    drawn: list[tuple[float, float, float, float]],
) -> None:
    ends, layout = placed(drawn)
    expected = np.where(layout.on_right[:, None], ends[:, 1], ends[:, 0])
    np.testing.assert_array_equal(layout.anchor, expected)
    # Anchors labeled from the left are to the left of those labeled from the right.
    left, right = layout.anchor[~layout.on_right, 0], layout.anchor[layout.on_right, 0]
    assert left.max(initial=-np.inf) <= right.min(initial=np.inf)


def test_labels_far_apart_are_level_with_their_anchors_on_the_nearer_side() -> None:
    anchors = np.array([(200.0, 100.0), (300.0, 400.0), (700.0, 100.0), (800.0, 700.0)])
    layout = place_labels(anchors, anchors, COLUMNS)
    np.testing.assert_array_equal(layout.on_right, [False, False, True, True])
    np.testing.assert_allclose(layout.y, anchors[:, 1])
    assert layout.label_height == COLUMNS.label_height


def test_labels_that_crowd_spread_evenly_about_their_anchors() -> None:
    x = [150.0, 160.0, 170.0, 780.0, 790.0, 800.0]
    anchors = np.stack([x, np.full(6, 500.0)], axis=1)
    layout = place_labels(anchors, anchors, COLUMNS)
    pitch = PITCH * COLUMNS.label_height
    for side in (False, True):
        y = np.sort(layout.y[layout.on_right == side])
        np.testing.assert_allclose(y, [500.0 - pitch, 500.0, 500.0 + pitch])


def test_anchors_close_to_the_column_do_not_send_a_far_one_astray() -> None:
    x = [890.0, 891.0, 892.0, 893.0, 500.0]
    y = [300.0, 301.0, 302.0, 303.0, 420.0]
    others = np.stack([np.full(5, 200.0), 100.0 * np.arange(1, 6)], axis=1)
    anchors = np.concatenate([others, np.stack([x, y], axis=1)])
    layout = place_labels(anchors, anchors, COLUMNS)
    assert layout.on_right[5:].all()
    assert layout.y[9] == pytest.approx(420.0)


def test_too_many_labels_become_smaller() -> None:
    y = np.linspace(0.0, 1000.0, 200)
    anchors = np.stack([np.tile([300.0, 700.0], 100), y], axis=1)
    layout = place_labels(anchors, anchors, COLUMNS)
    assert layout.label_height == pytest.approx(1000.0 / 100 / PITCH)
    for side in (False, True):
        assert np.diff(np.sort(layout.y[layout.on_right == side])).min() > layout.label_height


def test_nothing_to_label() -> None:
    layout = place_labels(np.empty((0, 2)), np.empty((0, 2)), COLUMNS)
    assert len(layout.y) == 0
