"""The parts of a body that can be seen from a side."""

from dataclasses import dataclass, replace

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas.queries.outside import outward_sign_of_mesh
from bodymeasure.scene.camera import View
from bodymeasure.scene.drawing.raster import DepthBuffer, rasterize
from bodymeasure.scene.model import Surface

# Height in pixels of the depth buffer that visibility is read from; on a mannequin, a pixel is
# 2 mm.
PIXELS = 700
# The number of pixels that a point may lie behind the surface in its pixel and still count as seen:
# it lies on that surface, which slopes inside the pixel.
SLOPE = 2.5
# A tape counts as hidden where the cosine between the surface's normal and the line of sight is
# less than this: it is about to go round the side.
GRAZING = 0.05


@dataclass(frozen=True, eq=False)
class Sight:
    """The part of a surface that is seen from a side.

    Parameters
    ----------
    view : View
    depth : ndarray, shape (height, width)
        Depth of the surface in each pixel, -inf where there is none.
    surface : Surface
        The patches that are seen; a picture of them is one of the whole surface.
    """

    view: View
    depth: Array
    surface: Surface

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""
        return self.depth.shape[1], self.depth.shape[0]

    def seen(self, points: Array, normals: Array) -> Bools:
        """Find which points on or before the surface are seen.

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
    """Find what is seen of a surface in a view, by a picture that is `pixels` high."""
    size = view.size(pixels)
    buffer = rasterize(*view.project(surface.points, size), surface.triangles, size)
    return Sight(view, buffer.depth, _seen_part(surface, view, buffer))


def _seen_part(surface: Surface, view: View, buffer: DepthBuffer) -> Surface:
    """Select the patches that face the viewer, and those that are seen from inside."""
    sign = outward_sign_of_mesh(surface.points, surface.triangles)
    facing = sign * (surface.normals @ view.towards) > 0.0
    seen = np.asarray(facing[surface.triangles].any(axis=1))
    seen[buffer.triangle[buffer.triangle >= 0]] = True
    part = np.isin(surface.patch, surface.patch[seen])
    return replace(surface, triangles=surface.triangles[part], patch=surface.patch[part])
