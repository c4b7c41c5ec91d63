"""Pictures of tapes drawn without OpenGL."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure.mesh.tubes import Mesh
from bodymeasure.scene.camera import View
from bodymeasure.scene.drawing.raster import DepthBuffer, rasterize
from bodymeasure.scene.drawing.samples import SAMPLES, downsampled
from bodymeasure.scene.lighting import glow, glowing, shade
from bodymeasure.scene.model import Surface

Drawing = Callable[[View, tuple[int, int], Mesh], NDArray[np.uint8]]
"""Draws tubes before a body: a view, the picture's size, the tubes; uint8 (height, width, 3)."""


@contextmanager
def session(surface: Surface) -> Iterator[Drawing]:
    """Draw many pictures of one body.

    Parameters
    ----------
    surface : Surface

    Yields
    ------
    Drawing
    """
    last: _Body | None = None

    def draw(view: View, size: tuple[int, int], mesh: Mesh) -> NDArray[np.uint8]:
        nonlocal last
        fine = (SAMPLES * size[0], SAMPLES * size[1])
        # Pictures of one side follow one another: the body is drawn once for them.
        if last is None or last.view is not view or last.size != fine:
            last = _body(surface, view, fine)
        return _with_tubes(last, mesh)

    yield draw


class _Body(NamedTuple):
    """A picture of the body alone.

    Parameters
    ----------
    view : View
    size : tuple of int
        Width and height in samples.
    buffer : DepthBuffer
        Of those.
    white, body : ndarray, shape (height, width)
        What each sample shows, as `glow` says it.
    image : ndarray, shape (height / SAMPLES, width / SAMPLES, 3)
        The finished picture, in [0, 1].
    """

    view: View
    size: tuple[int, int]
    buffer: DepthBuffer
    white: NDArray[np.float64]
    body: NDArray[np.float64]
    image: NDArray[np.float64]


def _body(surface: Surface, view: View, size: tuple[int, int]) -> _Body:
    pixels, depth = view.project(surface.points, size)
    buffer = rasterize(pixels, depth, surface.triangles, size)
    of_white, of_body = glow(surface, view)
    # Where nothing is faded, only the background is white.
    white = np.asarray(buffer.triangle < 0, dtype=np.float64)
    if of_white.any():
        white = buffer.interpolated(of_white, 1.0)
    body = buffer.interpolated(of_body, 0.0)
    return _Body(view, size, buffer, white, body, glowing(downsampled(white), downsampled(body)))


def _with_tubes(body: _Body, mesh: Mesh) -> NDArray[np.uint8]:
    """The picture of the body with tubes; only samples that show a tube are computed again."""
    pixels, depth = body.view.project(mesh.points, body.size)
    tubes = rasterize(pixels, depth, mesh.triangles, body.size)
    sample = np.flatnonzero(tubes.depth > body.buffer.depth)
    colors = shade(mesh.normals, body.view)[:, None] * mesh.colors
    before = glowing(body.white.ravel()[sample], body.body.ravel()[sample])
    change = (tubes.at_pixels(colors, sample) - before) / SAMPLES**2
    row, column = np.divmod(sample, body.size[0])
    height, width = body.image.shape[:2]
    pixel = (row // SAMPLES) * width + column // SAMPLES
    added = [np.bincount(pixel, channel, height * width) for channel in change.T]
    image = body.image + np.stack(added, axis=-1).reshape(height, width, 3)
    return np.asarray(np.round(255.0 * np.clip(image, 0.0, 1.0)), dtype=np.uint8)
