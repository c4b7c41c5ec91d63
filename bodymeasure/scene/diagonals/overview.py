"""One picture of a body from its four sides, with titles and the color bar."""

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from bodymeasure.scene.camera import body_views
from bodymeasure.scene.colors import ColorScale
from bodymeasure.scene.diagonals.build import body_scene
from bodymeasure.scene.diagonals.strokes import BODY_STYLE, scene_picture
from bodymeasure.scene.drawing import RENDERERS
from bodymeasure.scene.drawing.opengl_check import choose_renderer
from bodymeasure.scene.figures.canvas import Text, draw_on, png
from bodymeasure.scene.figures.color_bar import color_bar_image

if TYPE_CHECKING:
    from bodymeasure.measure import Survey

STYLE = replace(BODY_STYLE, height=900)
TITLES = {"front": "front", "back": "back", "left": "wearer's left", "right": "wearer's right"}
TITLE_PIXELS = 44
BAR_DPI = 150
GAP = 16


def body_overview(survey: "Survey", *, renderer: str | None = None) -> bytes:
    """Draw a body from its four sides side by side, as a PNG file.

    Parameters
    ----------
    survey : Survey
    renderer : str, optional
        ``pyvista`` or ``software``; by default as `choose_renderer` says.

    Raises
    ------
    InputError
        If there is no such renderer.
    MissingExtraError
        If matplotlib is not installed.
    """
    scene = body_scene(survey)
    scale = ColorScale.of(scene.paths)
    images, titles, left = [], [], 0
    with RENDERERS[choose_renderer(renderer).renderer]() as draw:
        for side, view in body_views(scene, survey.atlas.axes).items():
            image = draw(scene_picture(scene, view, scale, STYLE))
            images.append(np.pad(image, ((0, 0), (0, GAP), (0, 0)), constant_values=255))
            middle = left + image.shape[1] / 2
            titles.append(Text(middle, TITLE_PIXELS / 2, TITLES[side], TITLE_PIXELS / 2))
            left += image.shape[1] + GAP
    row = np.concatenate(images, axis=1)
    row = np.pad(row, ((TITLE_PIXELS, 0), (0, 0), (0, 0)), constant_values=255)
    row = draw_on(row, texts=titles)

    bar = color_bar_image(scene.paths, BAR_DPI)
    width = max(row.shape[1], bar.shape[1])
    parts = []
    for part in (row, bar):
        start = (width - part.shape[1]) // 2
        padding = ((0, 0), (start, width - part.shape[1] - start), (0, 0))
        parts.append(np.pad(part, padding, constant_values=255))
    return png(np.concatenate(parts))
