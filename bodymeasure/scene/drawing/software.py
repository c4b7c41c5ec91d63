"""Pictures drawn without OpenGL, by a depth buffer in NumPy."""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import reduce
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.mesh.tubes import Mesh
from bodymeasure.scene.camera import View
from bodymeasure.scene.drawing.picture import SAMPLES, Draw, Picture, finished
from bodymeasure.scene.drawing.raster import DepthBuffer, rasterize
from bodymeasure.scene.lighting import glow, glowing, shade
from bodymeasure.scene.model import Surface


@contextmanager
def session() -> Iterator[Draw]:
    """Draw many pictures.

    Yields
    ------
    Draw
    """
    last: _Drawn | None = None

    def draw(picture: Picture) -> NDArray[np.uint8]:
        nonlocal last
        # Pictures of one side follow one another: the surface is drawn once for all of them.
        if last is None or not last.serves(picture):
            last = _drawn(picture)
        image, depth = _with_tubes(last, picture.tubes)
        return finished(picture, image, depth)

    yield draw


class _Drawn(NamedTuple):
    """A surface as it is drawn alone.

    Parameters
    ----------
    surface : Surface
    view : View
    buffer : DepthBuffer
        Of the samples.
    white, body : ndarray, shape (height, width)
        What each sample shows, in the terms of `glow`.
    image : ndarray, shape (height / SAMPLES, width / SAMPLES, 3)
        The finished picture, in [0, 1].
    """

    surface: Surface
    view: View
    buffer: DepthBuffer
    white: Array
    body: Array
    image: Array

    def serves(self, picture: Picture) -> bool:
        """Return whether a picture shows the same surface from the same side."""
        same = self.surface is picture.surface and self.view is picture.view
        return same and self.buffer.depth.shape == picture.samples[::-1]


def _drawn(picture: Picture) -> _Drawn:
    surface, view, size = picture.surface, picture.view, picture.samples
    places, depth = view.project(surface.points, size)
    buffer = rasterize(places, depth, surface.triangles, size, nearest=view.nearest)
    white_of, body_of = glow(surface, view)
    # Where nothing is faded, only the background is white.
    white = np.asarray(buffer.triangle < 0, dtype=np.float64)
    if white_of.any():
        white = buffer.interpolated(white_of, 1.0)
    body = buffer.interpolated(body_of, 0.0)
    image = glowing(_averaged(white), _averaged(body))
    return _Drawn(surface, view, buffer, white, body, image)


def _averaged(samples: Array) -> Array:
    """The mean of each pixel's samples, shape (height, width)."""
    # Several times as fast as the mean of a reshaped array over its short axes.
    rows = reduce(np.add, (samples[i::SAMPLES] for i in range(SAMPLES)))
    return reduce(np.add, (rows[:, i::SAMPLES] for i in range(SAMPLES))) / SAMPLES**2


def _with_tubes(drawn: _Drawn, mesh: Mesh) -> tuple[NDArray[np.uint8], Array]:
    """The surface with tubes, and the depth of what the samples show.

    Only samples that show a tube are computed anew.
    """
    image, depth = drawn.image, drawn.buffer.depth
    if len(mesh.triangles):
        size = depth.shape[1], depth.shape[0]
        tubes = rasterize(*drawn.view.project(mesh.points, size), mesh.triangles, size)
        sample = np.flatnonzero(tubes.depth > depth)
        colors = shade(mesh.normals, drawn.view)[:, None] * mesh.colors
        before = glowing(drawn.white.ravel()[sample], drawn.body.ravel()[sample])
        change = (tubes.at_pixels(colors, sample) - before) / SAMPLES**2
        row, column = np.divmod(sample, size[0])
        height, width = image.shape[:2]
        pixel = (row // SAMPLES) * width + column // SAMPLES
        added = [np.bincount(pixel, channel, height * width) for channel in change.T]
        image = image + np.stack(added, axis=-1).reshape(height, width, 3)
        depth = np.maximum(depth, tubes.depth)
    return np.asarray(np.round(255.0 * np.clip(image, 0.0, 1.0)), dtype=np.uint8), depth
