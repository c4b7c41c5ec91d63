"""Which points of a body can be seen from a side."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bodymeasure.scene.camera import View
from bodymeasure.scene.drawing.raster import rasterize
from bodymeasure.scene.model import Surface

# Height of the depth buffer that visibility is read from; on a mannequin a pixel is 2 mm.
PIXELS = 700
# By so many pixels may a point lie behind the surface in its pixel and still be seen: it lies on
# that surface, which slopes inside the pixel.
SLOPE = 2.5
# Where the surface is seen at a flatter angle than this (its cosine with the normal), a tape on it
# is taken for hidden: it is about to go round the side.
GRAZING = 0.05


@dataclass(frozen=True, eq=False)
class Sight:
    """What is seen of a surface from a side.

    Parameters
    ----------
    view : View
    depth : ndarray, shape (height, width)
        Depth of the surface in each pixel, -inf where there is none.
    """

    view: View
    depth: NDArray[np.float64]

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""
        return self.depth.shape[1], self.depth.shape[0]

    def seen(self, points: NDArray[np.float64], normals: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Whether points on or before the surface are seen.

        Parameters
        ----------
        points, normals : ndarray, shape (k, 3)
            The normals point away from the body, and are 0 for points that stand free of it.

        Returns
        -------
        ndarray of bool, shape (k,)
            Points outside the picture are not seen.
        """
        pixels, depth = self.view.project(points, self.size)
        column, row = np.floor(pixels).astype(np.int64).T
        width, height = self.size
        inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
        surface = self.depth[np.clip(row, 0, height - 1), np.clip(column, 0, width - 1)]
        facing = normals @ self.view.towards
        turned = np.linalg.norm(normals, axis=-1) > 0.5
        slack = SLOPE * self.view.height / height
        return np.asarray(inside & (depth > surface - slack) & (~turned | (facing > GRAZING)))

    @property
    def columns(self) -> tuple[float, float]:
        """Left and right end of the silhouette, as fractions of the picture's width."""
        covered = np.flatnonzero(np.isfinite(self.depth).any(axis=0))
        if len(covered) == 0:
            return 0.5, 0.5
        return float(covered[0] / self.size[0]), float((covered[-1] + 1) / self.size[0])


def sight(surface: Surface, view: View, pixels: int = PIXELS) -> Sight:
    """What is seen of a surface in a view, in a picture of that height."""
    size = view.size(pixels)
    places, depth = view.project(surface.points, size)
    return Sight(view, rasterize(places, depth, surface.triangles, size).depth)
