"""Pictures drawn without OpenGL: NumPy shades the surface, matplotlib draws the lines."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bodymeasure.scene.camera import View
from bodymeasure.scene.canvas import draw_on
from bodymeasure.scene.colors import BACKGROUND, ColorScale
from bodymeasure.scene.lighting import shaded
from bodymeasure.scene.model import BodyScene, Surface
from bodymeasure.scene.raster import DepthBuffer, rasterize
from bodymeasure.scene.strokes import Style, runs, strokes

# Each pixel is the mean of this many squared samples.
SAMPLES = 2
# A point of a curve is hidden when the surface lies nearer by more than this fraction of the
# picture's height. Near a silhouette the depth changes by much within one pixel.
HIDDEN = 0.003


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
    image = _downsampled(_picture(surface, buffer, view, fine), size)
    lines = []
    for stroke in strokes(scene, view, scale, style):
        curves = _visible(stroke.points, view, buffer, fine) / SAMPLES
        pieces = [
            (piece, color)
            for curve, color in zip(curves, stroke.colors, strict=True)
            for piece in runs(curve)
        ]
        lines.append(([p for p, _ in pieces], [c for _, c in pieces], stroke.width))
    return draw_on(image, lines=lines)


def _picture(
    surface: Surface, buffer: DepthBuffer, view: View, size: tuple[int, int]
) -> NDArray[np.float64]:
    """The picture without lines, shape (height, width, 3), in [0, 1]."""
    corners = surface.triangles[buffer.triangle]
    normals = np.einsum("pi,pij->pj", buffer.weights, surface.normals[corners])
    image = np.tile(np.array(BACKGROUND), (size[0] * size[1], 1))
    image[buffer.pixel] = shaded(normals, surface.faded[corners[:, 0]], view)
    return image.reshape(size[1], size[0], 3)


def _downsampled(image: NDArray[np.float64], size: tuple[int, int]) -> NDArray[np.float64]:
    blocks = image.reshape(size[1], SAMPLES, size[0], SAMPLES, 3)
    return np.asarray(blocks.mean(axis=(1, 3)))


def _visible(
    points: NDArray[np.float64], view: View, buffer: DepthBuffer, size: tuple[int, int]
) -> NDArray[np.float64]:
    """Curves in pixels, shape (n, k, 2), NaN where they are hidden."""
    pixels, depth = view.project(points, size)
    present = np.isfinite(depth)
    whole = np.floor(np.where(present[..., None], pixels, 0.0)).astype(np.int64)
    column = np.clip(whole[..., 0], 0, size[0] - 1)
    row = np.clip(whole[..., 1], 0, size[1] - 1)
    visible = present & (depth + HIDDEN * view.height >= buffer.depth[row, column])
    return np.where(visible[..., None], pixels, np.nan)
