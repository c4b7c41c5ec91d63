from collections.abc import Mapping

import numpy as np
import pytest

from bodymeasure.atlas import Atlas
from bodymeasure.atlas.normals import normal_vectors
from bodymeasure.chart import Chart, TapeKind
from bodymeasure.scene import TapeScene
from bodymeasure.scene.drawing.visibility import Sight
from bodymeasure.scene.tapes.build import evenly_spaced, smoothed, without_gaps
from bodymeasure.scene.tapes.camera import (
    best,
    closeup_directions,
    closeup_view,
    seen_lengths,
)
from bodymeasure.scene.tapes.gallery import shown_sides
from bodymeasure.scene.tapes.mesh import BAND, COLORS, forward, tape_colors, tape_mesh


def test_measurements_with_a_value_are_numbered_in_order(chart: Chart, scene: TapeScene) -> None:
    having = [item.definition.key for item in chart.measured[1:]]
    assert scene.numbers == {key: number for number, key in enumerate(having, start=1)}
    assert {line.number for line in scene.tapes} == set(scene.numbers.values())
    assert [mark.text for mark in scene.landmarks[having[-1]]] == ["shoulder point left"]


def test_tapes_are_evenly_spaced_and_keep_their_ends(chart: Chart, scene: TapeScene) -> None:
    tapes = [tape for item in chart.measured for tape in item.tapes]
    for line, tape in zip(scene.tapes, tapes, strict=True):
        step = np.linalg.norm(np.diff(line.points, axis=0), axis=1)
        assert step.max() < 1.001 * scene.size / 300
        np.testing.assert_allclose(line.points[[0, -1]], tape.points[[0, -1]], atol=1e-15)
        given = np.linalg.norm(np.diff(tape.points, axis=0), axis=1).sum()
        # A chord of 5 mm around an arm is shorter than its arc by a 2500th.
        assert given * (1 - 5e-4) < step.sum() < given * (1 + 1e-12)


def test_values_follow_their_polygon() -> None:
    points = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 3.0, 0.0)])
    found, values = evenly_spaced(points, np.array([[0.0], [1.0], [4.0]]), 0.5)
    np.testing.assert_allclose(values[:, 0], np.linspace(0.0, 4.0, 9))
    np.testing.assert_allclose(found[3], [1.0, 0.5, 0.0])


def test_free_tapes_are_lifted_from_one_end_to_the_other() -> None:
    points = np.linspace((0.0, 0.0, 0.0), (2.0, 0.0, 0.0), 3)
    normals = np.array([(0.0, 1.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)])
    np.testing.assert_allclose(
        without_gaps(points, normals)[1], [0.0, np.sqrt(0.5), np.sqrt(0.5)], atol=1e-15
    )
    nothing = np.zeros((3, 3))
    np.testing.assert_array_equal(without_gaps(points, nothing), nothing)


def test_smoothing_takes_out_zigzag_and_keeps_lengths() -> None:
    side = np.where(np.arange(60) % 2 == 0, 0.1, -0.1)
    zigzag = np.stack([side, np.full(60, np.sqrt(0.99)), np.zeros(60)], axis=1)
    smooth = smoothed(zigzag)
    np.testing.assert_allclose(np.linalg.norm(smooth, axis=1), 1.0)
    assert np.abs(smooth[10:-10, 0]).max() < 1e-6
    np.testing.assert_array_equal(smoothed(np.zeros((4, 3))), 0.0)


def test_taut_tapes_are_banded_where_they_stand_free(scene: TapeScene) -> None:
    taut = [line for line in scene.tapes if line.kind is TapeKind.TAUT]
    assert any(line.free.any() for line in taut)
    for line in taut:
        colors = tape_colors(line.free, line.kind)
        banded = (colors == BAND).all(axis=1)
        plain = (colors == COLORS[TapeKind.TAUT]).all(axis=1)
        assert (banded | plain).all()
        assert not banded[~line.free].any()
    # Across the bust, the tape bridges the hollow between the breasts, in the middle.
    bust = taut[0]
    middle = bust.free & (np.abs(bust.points[:, 0]) < 0.02) & (bust.points[:, 1] < 0.0)
    assert middle.any()


def test_tubes_stand_off_the_skin_by_less_than_their_radius(scene: TapeScene) -> None:
    line = scene.tapes[0]
    mesh = tape_mesh([line], 0.01, np.zeros(3))
    rings = mesh.points[: 8 * len(line.points)].reshape(-1, 8, 3)
    away = ((rings - line.points[:, None]) * line.normals[:, None]).sum(axis=-1)
    on_skin = ~line.free
    # Most of each ring is above the skin and a part below it, so that it neither floats nor sinks
    # in.
    assert (away[on_skin].min(axis=1) < 0.0).all()
    assert (away[on_skin].max(axis=1) > 0.01).all()


def test_straight_tapes_are_drawn_before_the_body(
    scene: TapeScene, seen: Mapping[str, Sight]
) -> None:
    lines = [line for line in scene.tapes if line.kind is TapeKind.STRAIGHT]
    view = seen["front"].view
    mesh = tape_mesh(lines, 0.001, forward(scene, lines, view))
    assert (mesh.points @ view.towards).min() > (scene.surface.points @ view.towards).max()
    places, _ = view.project(mesh.points, (500, 500))
    where = tape_mesh(lines, 0.001, np.zeros(3))
    np.testing.assert_allclose(places, view.project(where.points, (500, 500))[0], atol=1e-9)


@pytest.mark.parametrize(
    ("landmark", "sides"),
    [
        ("bust point left", {"front", "left"}),
        ("back waist point", {"back"}),
        ("front hip point", {"front"}),
    ],
)
def test_a_landmark_is_seen_from_its_sides(
    body: Atlas, seen: Mapping[str, Sight], landmark: str, sides: set[str]
) -> None:
    point = body.landmarks[landmark]
    normal = normal_vectors(body.control_points[point.patch], np.array([point.u, point.v]))
    normal /= np.linalg.norm(normal)
    found = {
        side for side, sight in seen.items() if sight.seen(body.position(point)[None], normal[None])
    }
    assert found == sides


def test_what_lies_behind_or_outside_is_not_seen(
    scene: TapeScene, seen: Mapping[str, Sight]
) -> None:
    front = seen["front"]
    center = scene.surface.points.mean(axis=0)
    outside = center + 10.0 * front.view.right
    before = center + front.view.towards
    found = front.seen(np.stack([center, outside, before]), np.zeros((3, 3)))
    np.testing.assert_array_equal(found, [False, False, True])


def test_measurements_are_numbered_where_they_are_seen(
    scene: TapeScene, seen: Mapping[str, Sight]
) -> None:
    shown = list(shown_sides(scene, seen).values())
    bust, waist, left_thigh, right_thigh, nape, span, _ = shown
    assert {"front", "back"} <= bust
    assert {"front", "back"} <= waist
    assert {"front", "back", "left"} <= left_thigh
    assert "right" not in left_thigh
    assert "left" not in right_thigh
    assert nape == {"back"}
    assert "front" in span
    assert not {"left", "right"} & span


@pytest.mark.slow
def test_closeups_are_taken_from_where_a_tape_is_seen(
    scene: TapeScene, chart: Chart, around: list[Sight]
) -> None:
    axes = chart.atlas.axes
    expected = {
        "path_back_neck_point_back_waist_point": -axes.front_vector,
        "chord_bust_point_left_bust_point_right": axes.front_vector,
        "limb_0_50_side_hip_point_left": axes.left_vector,
        "limb_0_50_side_hip_point_right": -axes.left_vector,
    }
    for key, direction in expected.items():
        line = next(line for line in scene.tapes if line.key == key)
        side = around[best([seen_lengths([line], view)[0] for view in around])]
        assert side.view.towards @ direction > -0.1, key
        view = closeup_view(scene, line.points, side, 1.2)
        places, _ = view.project(line.points, (600, 500))
        assert (places.min(axis=0) > (600 * 0.2, 500 * 0.1)).all()
        assert (places.max(axis=0) < (600 * 0.8, 500 * 0.9)).all()


def test_closeup_directions_are_unit_vectors_all_around(body: Atlas) -> None:
    directions = np.array(closeup_directions(body.axes))
    np.testing.assert_allclose(np.linalg.norm(directions, axis=1), 1.0)
    np.testing.assert_allclose(directions.mean(axis=0), 0.0, atol=1e-12)
    assert len(np.unique(directions.round(9), axis=0)) == len(directions)


def test_the_first_of_nearly_equal_sides_is_taken() -> None:
    assert best([1.0, 1.05, 1.2, 1.25]) == 2
    assert best([0.0, 0.0]) == 0
