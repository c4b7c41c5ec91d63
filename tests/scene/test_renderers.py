from typing import Any

import numpy as np
import pytest
from helpers.charts.straight_survey import straight_survey
from numpy.typing import NDArray

from bodymeasure.atlas import Atlas
from bodymeasure.scene import ColorScale, body_scene, body_views, cut_away, patch_scene, patch_view
from bodymeasure.scene.diagonals.gallery import RENDERERS
from bodymeasure.scene.drawing.opengl_check import PYVISTA, SOFTWARE, opengl_trouble
from bodymeasure.scene.drawing.strokes import BODY_STYLE, CLOSEUP_STYLE

PIXELS = 300


@pytest.fixture(params=[SOFTWARE, pytest.param(PYVISTA, marks=pytest.mark.slow)])
def renderer(request: pytest.FixtureRequest) -> str:
    if request.param == PYVISTA and opengl_trouble():
        pytest.skip(opengl_trouble())
    return str(request.param)


def draw(survey: Any, side: str, renderer: str, pixels: int = PIXELS) -> NDArray[np.uint8]:
    scene = body_scene(survey)
    view = body_views(scene, survey.atlas.axes)[side]
    scale = ColorScale.of(scene.paths)
    return RENDERERS[renderer](scene, view, view.size(pixels), scale, BODY_STYLE)


def crimson(image: NDArray[np.uint8]) -> NDArray[np.bool_]:
    """Where a path without a length is drawn: nothing else is red."""
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
    body: Atlas, renderer: str, landmark: str, shown: str, hidden: str
) -> None:
    marked = np.zeros((len(body), 2), dtype=bool)
    marked[body.landmarks[landmark].patch] = True
    survey = straight_survey(body, no_length=marked)
    image = draw(survey, shown, renderer)
    view = body_views(body_scene(survey), body.axes)[shown]
    place, _ = view.project(
        body.control_points[body.landmarks[landmark].patch].mean(axis=(0, 1)), view.size(PIXELS)
    )
    rows, columns = np.nonzero(crimson(image))
    assert len(rows) > 10
    # A patch is about a tenth of the body's height.
    assert np.hypot(columns - place[0], rows - place[1]).max() < 0.1 * PIXELS
    assert not crimson(draw(survey, hidden, renderer)).any()


def test_a_picture_is_a_body_on_white(body: Atlas, renderer: str) -> None:
    image = draw(straight_survey(body), "front", renderer)
    assert image.dtype == np.uint8
    assert image.shape[0] == PIXELS
    white = (image == 255).all(axis=-1)
    border = np.concatenate([white[0], white[-1], white[:, 0], white[:, -1]])
    assert border.all()
    # A body with its arms spread fills a third of its frame.
    assert 0.2 < 1.0 - white.mean() < 0.5


def test_colors_follow_the_difference(square: Atlas, renderer: str) -> None:
    survey = straight_survey(square, difference=np.array([[1e-9, 1e-4]]))
    image = draw(survey, "front", renderer) / 255.0
    scale = ColorScale.of(body_scene(survey).paths)
    assert scale is not None
    # A quarter along each diagonal of the square: (u, v) runs right and up in the picture.
    low, high = scale.rgb(np.array([1e-9, 1e-4]))
    first, second = image[PIXELS * 3 // 4, PIXELS // 4], image[PIXELS // 4, PIXELS // 4]
    for found, expected in ((first, low), (second, high)):
        assert np.abs(found - expected).max() < 0.2


def test_a_closeup_shows_the_boundary_and_both_paths(body: Atlas, renderer: str) -> None:
    survey = straight_survey(body)
    scene = patch_scene(survey, 100)
    view = patch_view(scene, body.axes)
    scale = ColorScale.of(scene.paths)
    part = cut_away(scene, view)
    image = RENDERERS[renderer](part, view, view.size(PIXELS), scale, CLOSEUP_STYLE) / 255.0
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


def test_the_software_renderer_repeats_itself(body: Atlas) -> None:
    survey = straight_survey(body)
    first, second = (draw(survey, "left", SOFTWARE) for _ in range(2))
    np.testing.assert_array_equal(first, second)


@pytest.mark.slow
@pytest.mark.parametrize("side", ["front", "left"])
def test_both_renderers_draw_the_same_silhouette(body: Atlas, side: str) -> None:
    if opengl_trouble():
        pytest.skip(opengl_trouble())
    survey = straight_survey(body)
    ours, theirs = (
        (draw(survey, side, renderer, 600) < 250).any(axis=-1) for renderer in (SOFTWARE, PYVISTA)
    )
    assert (ours & theirs).sum() > 0.98 * (ours | theirs).sum()
