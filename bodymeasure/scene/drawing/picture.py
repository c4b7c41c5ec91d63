"""One picture as plain data: what both renderers draw, and nothing else."""

from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.mesh.tubes import Mesh, joined
from bodymeasure.scene.camera import View
from bodymeasure.scene.figures.canvas import Lines, Text, draw_on
from bodymeasure.scene.model import Surface

# Each pixel is the mean of this many squared samples, on every machine alike. An OpenGL driver's
# own smoothing of edges differs from machine to machine, and takes longer.
SAMPLES = 2

NO_TUBES = joined([])


@dataclass(frozen=True)
class Stroke:
    """Curves of one width that the surface may hide.

    Parameters
    ----------
    points : ndarray, shape (n, k, 3)
        In the atlas's unit, NaN in gaps.
    colors : ndarray, shape (n, 3)
        In [0, 1]; they are not shaded.
    width : float
        In pixels of the finished picture.
    """

    points: Array
    colors: Array
    width: float


@dataclass(frozen=True, eq=False)
class Picture:
    """A surface with what is drawn on it and over it, in a view.

    Parameters
    ----------
    surface : Surface
        Successive pictures of the same object are drawn faster.
    view : View
    size : tuple of int
        Width and height in pixels.
    tubes : Mesh
        Colored triangles, shaded as the surface is.
    strokes : sequence of Stroke
        In the order of drawing.
    marks : sequence of Lines
        Lines drawn over everything, in pixels from the top left.
    texts : sequence of Text
        Texts drawn over the marks.
    """

    surface: Surface
    view: View
    size: tuple[int, int]
    tubes: Mesh = NO_TUBES
    strokes: Sequence[Stroke] = ()
    marks: Sequence[Lines] = ()
    texts: Sequence[Text] = ()

    @property
    def samples(self) -> tuple[int, int]:
        """Width and height in samples."""
        return SAMPLES * self.size[0], SAMPLES * self.size[1]


Draw = Callable[[Picture], NDArray[np.uint8]]
"""Draws a picture, uint8 of shape (height, width, 3)."""

Renderer = Callable[[], AbstractContextManager[Draw]]
"""Begins to draw, and ends it: a session in which what pictures share is made once."""


def finished(picture: Picture, image: NDArray[np.uint8], depth: Array | None) -> NDArray[np.uint8]:
    """Draw the lines and texts of a picture over its surface and tubes.

    Parameters
    ----------
    picture : Picture
    image : ndarray of uint8, shape (height, width, 3)
        The surface with the tubes.
    depth : ndarray, shape (SAMPLES height, SAMPLES width), or None
        Depth of what each sample shows, -inf for the background; needed if there are strokes.
    """
    lines = [_unhidden(stroke, picture, depth) for stroke in picture.strokes if depth is not None]
    return draw_on(image, lines=[*lines, *picture.marks], texts=picture.texts)


def _unhidden(stroke: Stroke, picture: Picture, depth: Array) -> Lines:
    """The parts of a stroke that nothing hides, in pixels."""
    places, nearness = picture.view.project(stroke.points, picture.samples)
    present = np.isfinite(nearness)
    sample = np.floor(np.where(present[..., None], places, 0.0)).astype(np.int64)
    height, width = depth.shape
    column = np.clip(sample[..., 0], 0, width - 1)
    row = np.clip(sample[..., 1], 0, height - 1)
    seen = present & (nearness >= depth[row, column]) & (nearness <= picture.view.nearest)
    parts, curve = pieces(np.where(seen[..., None], places / SAMPLES, np.nan))
    return parts, stroke.colors[curve], stroke.width


class Runs(NamedTuple):
    """Pieces of curves between their gaps, in the order of the curves.

    Parameters
    ----------
    curve, first, end : ndarray of int, shape (m,)
        Each piece holds the points from `first` up to, but without, `end` of a curve.
    """

    curve: Ints
    first: Ints
    end: Ints


def runs(present: Bools) -> Runs:
    """Find the pieces of at least two points of curves, shape (n, k), that have gaps."""
    padded = np.pad(present, ((0, 0), (1, 1))).astype(np.int8)
    change = np.diff(padded, axis=1)
    curve, first = np.nonzero(change == 1)
    _, end = np.nonzero(change == -1)
    long = end - first > 1
    return Runs(curve[long], first[long], end[long])


def pieces(curves: Array) -> tuple[list[Array], Ints]:
    """Cut curves, shape (n, k, d), at their NaN; also which curve each piece is part of."""
    found = runs(np.isfinite(curves[..., 0]))
    return [curves[c, a:b] for c, a, b in zip(*found, strict=True)], found.curve
