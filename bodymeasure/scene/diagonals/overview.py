"""One picture of a body from its four sides, with titles and the color bar."""

from typing import TYPE_CHECKING

import numpy as np

from bodymeasure.scene.camera import body_views
from bodymeasure.scene.colors import ColorScale
from bodymeasure.scene.diagonals.build import body_scene
from bodymeasure.scene.diagonals.gallery import RENDERERS, png
from bodymeasure.scene.drawing.opengl_check import choose_renderer
from bodymeasure.scene.drawing.strokes import BODY_STYLE
from bodymeasure.scene.figures.canvas import Text, draw_on
from bodymeasure.scene.figures.color_bar import color_bar_image

if TYPE_CHECKING:
    from bodymeasure.measure import Survey

BODY_PIXELS = 900
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
        As for `pictures`.
    """
    render = RENDERERS[choose_renderer(renderer).renderer]
    scene = body_scene(survey)
    scale = ColorScale.of(scene.paths)
    images, titles, left = [], [], 0
    for side, view in body_views(scene, survey.atlas.axes).items():
        image = render(scene, view, view.size(BODY_PIXELS), scale, BODY_STYLE)
        gap = np.full((BODY_PIXELS, GAP, 3), 255, dtype=np.uint8)
        images += [image, gap]
        titles.append(
            Text(left + image.shape[1] / 2, TITLE_PIXELS / 2, TITLES[side], TITLE_PIXELS / 2)
        )
        left += image.shape[1] + GAP
    row = np.concatenate(images, axis=1)

    bar = color_bar_image(scene.paths, BAR_DPI)
    width = max(row.shape[1], bar.shape[1])
    parts = [np.full((TITLE_PIXELS, width, 3), 255, dtype=np.uint8)]
    for part in (row, bar):
        start = (width - part.shape[1]) // 2
        padding = ((0, 0), (start, width - part.shape[1] - start), (0, 0))
        parts.append(np.pad(part, padding, constant_values=255))
    return png(draw_on(np.concatenate(parts), texts=titles))
