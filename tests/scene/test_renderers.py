from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import scipy.ndimage
from helpers.charts.straight_survey import straight_survey
from numpy.typing import NDArray

from bodymeasure._typing import Bools
from bodymeasure.atlas import Atlas
from bodymeasure.scene import (
    BodyScene,
    ColorScale,
    PathKind,
    View,
    body_scene,
    body_views,
    patch_scene,
    patch_view,
)
from bodymeasure.scene.diagonals.strokes import BODY_STYLE, CLOSEUP_STYLE, scene_picture
from bodymeasure.scene.drawing import software
from bodymeasure.scene.drawing.picture import Draw, Picture, Stroke

PIXELS = 300


STYLE = replace(BODY_STYLE, height=PIXELS)


def picture(survey: Any, view: View) -> Picture:
    scene = body_scene(survey)
    return scene_picture(scene, view, ColorScale.of(scene.paths), STYLE)


def crimson(image: NDArray[np.uint8]) -> Bools:
    """Find the pixels of paths without a length: nothing else is red."""
    red, green = image[..., 0].astype(int), image[..., 1].astype(int)
    return np.asarray(red - green > 80)


@pytest.mark.parametrize(
    ("landmark", "shown", "hidden"),
    [
        ("bust point left", "front", "back"),
        ("back waist point", "back", "front"),
        ("elbow point left", "left", "right"),
        ("elbow point right", "right", "left"),
    ],
)
def test_a_marked_patch_is_where_its_landmark_is(
    body: Atlas,
    survey_scene: BodyScene,
    views: Mapping[str, View],
    draw: Draw,
    landmark: str,
    shown: str,
    hidden: str,
) -> None:
    patch = body.landmarks[landmark].patch
    paths = survey_scene.paths
    kind = paths.kind.copy()
    kind[paths.patch == patch] = PathKind.NO_LENGTH
    marked = replace(survey_scene, paths=replace(paths, kind=kind))
    scale = ColorScale.of(paths)
    image, other = (draw(scene_picture(marked, views[s], scale, STYLE)) for s in (shown, hidden))
    view = views[shown]
    place, _ = view.project(body.control_points[patch].mean(axis=(0, 1)), view.size(PIXELS))
    rows, columns = np.nonzero(crimson(image))
    assert len(rows) > 10
    # A patch is about a tenth of the body's height.
    assert np.hypot(columns - place[0], rows - place[1]).max() < 0.1 * PIXELS
    assert not crimson(other).any()


def test_a_picture_is_a_body_on_white(survey: Any, views: Mapping[str, View], draw: Draw) -> None:
    image = draw(picture(survey, views["front"]))
    assert image.dtype == np.uint8
    assert image.shape[0] == PIXELS
    white = (image == 255).all(axis=-1)
    border = np.concatenate([white[0], white[-1], white[:, 0], white[:, -1]])
    assert border.all()
    # A body with its arms spread fills a third of its frame.
    assert 0.2 < 1.0 - white.mean() < 0.5


def test_colors_follow_the_difference(square: Atlas, draw: Draw) -> None:
    survey = straight_survey(square, difference=np.array([[1e-9, 1e-4]]))
    scene = body_scene(survey)
    image = draw(picture(survey, body_views(scene, square.axes)["front"])) / 255.0
    scale = ColorScale.of(scene.paths)
    assert scale is not None
    # Points a quarter along each diagonal of the square; (u, v) runs right and up in the picture.
    low, high = scale.rgb(np.array([1e-9, 1e-4]))
    first, second = image[PIXELS * 3 // 4, PIXELS // 4], image[PIXELS // 4, PIXELS // 4]
    for found, expected in ((first, low), (second, high)):
        assert np.abs(found - expected).max() < 0.2


def test_a_closeup_shows_the_boundary_and_both_paths(survey: Any, body: Atlas, draw: Draw) -> None:
    scene = patch_scene(survey, 100)
    view = patch_view(scene, body.axes)
    scale = ColorScale.of(scene.paths)
    style = replace(CLOSEUP_STYLE, height=PIXELS)
    image = draw(scene_picture(scene, view, scale, style)) / 255.0
    assert scale is not None
    color = scale.rgb(scene.paths.value[:1])[0]
    for path in scene.paths.lines.points:
        pixels, _ = view.project(path[5:-5], view.size(PIXELS))
        column, row = np.floor(pixels).astype(int).T
        near = np.abs(image[row, column] - color).max(axis=-1) < 0.25
        assert near.mean() > 0.9
    for edge in scene.edges.points:
        pixels, _ = view.project(edge[3:-3], view.size(PIXELS))
        column, row = np.floor(pixels).astype(int).T
        assert (image[row, column].mean(axis=-1) < 0.75).mean() > 0.9


def test_the_software_renderer_repeats_itself(survey: Any, views: Mapping[str, View]) -> None:
    images = []
    for _ in range(2):
        with software.session() as draw:
            images.append(draw(picture(survey, views["left"])))
    np.testing.assert_array_equal(images[0], images[1])


def test_a_line_is_drawn_where_the_surface_does_not_hide_it(
    survey_scene: BodyScene, views: Mapping[str, View], draw: Draw
) -> None:
    view = views["front"]
    surface = survey_scene.surface
    size = view.size(PIXELS)
    middle = surface.points.mean(axis=0)
    extent = float(np.ptp(surface.points, axis=0).max())
    across = np.linspace(-0.5, 0.5, 101)[:, None] * extent * view.right
    magenta = np.array([[1.0, 0.0, 1.0]])
    images = []
    for depth in (extent, -extent):
        points = (middle + across + depth * view.towards)[None]
        stroke = Stroke(points, magenta, 3.0)
        image = draw(Picture(surface, view, size, strokes=[stroke])).astype(int)
        images.append((image[..., 0] - image[..., 1] > 128) & (image[..., 2] > 128))
    before, behind = images
    plain = draw(Picture(surface, view, size))
    body = (plain < 250).any(axis=-1)
    assert before.any(axis=0).mean() > 0.9
    assert (before & body).any()
    # Behind the body the same line is seen beside it alone, but for its own width.
    assert behind.any()
    inner = scipy.ndimage.binary_erosion(body, iterations=4)
    assert not (behind & inner).any()
    outer = ~scipy.ndimage.binary_dilation(body, iterations=4)
    np.testing.assert_array_equal(behind & outer, before & outer)
