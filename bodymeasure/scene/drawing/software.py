"""Pictures drawn without OpenGL: NumPy shades the surface, matplotlib draws the lines."""

import numpy as np
from numpy.typing import NDArray

from bodymeasure.scene.camera import View
from bodymeasure.scene.colors import ColorScale
from bodymeasure.scene.drawing.raster import DepthBuffer, rasterize
from bodymeasure.scene.drawing.samples import SAMPLES, downsampled
from bodymeasure.scene.drawing.strokes import Style, runs, strokes
from bodymeasure.scene.figures.canvas import draw_on
from bodymeasure.scene.lighting import glow, glowing
from bodymeasure.scene.model import BodyScene, Surface


def render(
    scene: BodyScene, view: View, size: tuple[int, int], scale: ColorScale | None, style: Style
) -> NDArray[np.uint8]:
    """A picture of a scene.

    Parameters
    ----------
    scene : BodyScene
    view : View
    size : tuple of int
        Width and height in pixels.
    scale : ColorScale or None
        Colors of the compared paths.
    style : Style

    Returns
    -------
    ndarray, shape (height, width, 3)
    """
    surface = scene.surface
    fine = (SAMPLES * size[0], SAMPLES * size[1])
    pixels, depth = view.project(surface.points, fine)
    buffer = rasterize(pixels, depth, surface.triangles, fine)
    image = _picture(surface, buffer, view)
    lines = []
    for stroke in strokes(scene, view, scale, style):
        curves = _visible(stroke.points, view, buffer, fine) / SAMPLES
        pieces, colors = [], []
        for number in np.flatnonzero(np.isfinite(curves[..., 0]).any(axis=1)):
            found = runs(curves[number])
            pieces += found
            colors += [stroke.colors[number]] * len(found)
        lines.append((pieces, np.array(colors).reshape(-1, 3), stroke.width))
    return draw_on(image, lines=lines)


def _picture(surface: Surface, buffer: DepthBuffer, view: View) -> NDArray[np.float64]:
    """The picture without lines, shape (height, width, 3), in [0, 1]."""
    white, body = glow(surface, view)
    return glowing(
        downsampled(buffer.interpolated(white, background=1.0)),
        downsampled(buffer.interpolated(body, background=0.0)),
    )


def _visible(
    points: NDArray[np.float64], view: View, buffer: DepthBuffer, size: tuple[int, int]
) -> NDArray[np.float64]:
    """Curves in pixels, shape (n, k, 2), NaN where they are hidden."""
    pixels, depth = view.project(points, size)
    present = np.isfinite(depth)
    whole = np.floor(np.where(present[..., None], pixels, 0.0)).astype(np.int64)
    column = np.clip(whole[..., 0], 0, size[0] - 1)
    row = np.clip(whole[..., 1], 0, size[1] - 1)
    visible = present & (depth >= buffer.depth[row, column])
    return np.where(visible[..., None], pixels, np.nan)
