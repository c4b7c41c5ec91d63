"""A depth buffer in NumPy, which finds the triangle that each pixel of a picture shows."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Ints

# A triangle's span in a row is widened by so many pixels, so that round-off leaves no crack between
# neighbors; where both then cover a pixel, the nearer wins.
CRACK = 1e-7
# A triangle of less than half this area, in pixels, is seen edge-on and covers nothing.
EDGE_ON = 1e-9
# The number of triangles at a time, which bounds the memory for the pixels that they cover to some
# tens of megabytes.
CHUNK = 4096


@dataclass(frozen=True)
class DepthBuffer:
    """The triangles that the pixels of a picture show.

    Parameters
    ----------
    depth : ndarray, shape (height, width)
        Depth of the nearest triangle, -inf where there is none.
    triangle : ndarray of int, shape (height, width)
        Its number, -1 where there is none.
    triangles : ndarray of int, shape (m, 3)
    edge : ndarray, shape (m, 3, 3)
        Coefficients (a, b, c) of each triangle's barycentric coordinates a column + b row + c.
    """

    depth: Array
    triangle: Ints
    triangles: Ints
    edge: Array

    def interpolated(self, values: Array, background: float) -> Array:
        """Interpolate a quantity given at the vertices to the pixels, shape (height, width)."""
        covered = np.flatnonzero(self.triangle >= 0)
        picture = np.full(self.triangle.size, background)
        picture[covered] = self.at_pixels(values[:, None], covered)[:, 0]
        return picture.reshape(self.triangle.shape)

    def at_pixels(self, values: Array, pixel: Ints) -> Array:
        """Interpolate c quantities given at the vertices to some pixels.

        Parameters
        ----------
        values : ndarray, shape (n, c)
        pixel : ndarray of int, shape (k,)
            Numbers of pixels that show a triangle, row by row.

        Returns
        -------
        ndarray, shape (k, c)
        """
        shown = self.triangle.ravel()[pixel]
        row, column = np.divmod(pixel, self.triangle.shape[1])
        channels = [
            _at(_planes(self.edge, channel[self.triangles]), shown, column, row)
            for channel in values.T
        ]
        return np.stack(channels, axis=-1)


def rasterize(
    pixels: Array,
    depth: Array,
    triangles: Ints,
    size: tuple[int, int],
    *,
    nearest: float = np.inf,
) -> DepthBuffer:
    """Find the nearest triangle at the center of each pixel.

    Parameters
    ----------
    pixels : ndarray, shape (n, 2)
        Projected vertices, in pixels from the picture's top left corner.
    depth : ndarray, shape (n,)
        Their depth, larger for nearer vertices.
    triangles : ndarray of int, shape (m, 3)
    size : tuple of int
        Width and height in pixels.
    nearest : float
        The largest depth that is drawn; what is nearer is cut away.
    """
    width, height = size
    buffer = np.full(height * width, -np.inf)
    shown = np.full(height * width, -1)
    corner = pixels[triangles] - 0.5  # pixel centers now lie at whole numbers
    low, high = corner.min(axis=1), corner.max(axis=1)
    inside = (high[:, 0] >= 0) & (low[:, 0] < width) & (high[:, 1] >= 0) & (low[:, 1] < height)
    seen = np.flatnonzero(inside)
    edge, plane = np.zeros((len(triangles), 3, 3)), np.zeros((len(triangles), 3))
    function, area = _edge_functions(corner[seen])
    broad = np.abs(area) > EDGE_ON
    seen = seen[broad]
    edge[seen] = function[broad] / area[broad, None, None]
    plane[seen] = _planes(edge[seen], depth[triangles[seen]])
    for chunk in np.array_split(seen, max(1, -(-len(seen) // CHUNK))):
        which, row = _rows(corner[chunk, :, 1], height)
        which = chunk[which]
        first, last = _span(edge[which], row, width)
        count = np.maximum(last - first + 1, 0)
        which, row, column = np.repeat(which, count), np.repeat(row, count), _ranges(first, count)
        z = _at(plane, which, column, row)
        pixel = row * width + column
        if nearest < np.inf:
            kept = z <= nearest
            z, pixel, which = z[kept], pixel[kept], which[kept]
        np.maximum.at(buffer, pixel, z)
        # Any one of several triangles at the same depth will do.
        wins = z == buffer[pixel]
        shown[pixel[wins]] = which[wins]
    shape = (height, width)
    return DepthBuffer(buffer.reshape(shape), shown.reshape(shape), triangles, edge)


def _planes(edge: Array, values: Array) -> Array:
    """Coefficients, shape (m, 3), of the linear functions with given values at the corners."""
    return np.asarray((values[:, None, :] @ edge)[:, 0])


def _at(
    plane: Array,
    triangle: Ints,
    column: Ints,
    row: Ints,
) -> Array:
    a, b, c = plane.T
    return np.asarray(a[triangle] * column + b[triangle] * row + c[triangle])


def _edge_functions(
    corner: Array,
) -> tuple[Array, Array]:
    """Coefficients (a, b, c), shape (m, 3, 3), of a x + b y + c = area times the barycentrics."""
    following, last = np.roll(corner, -1, axis=1), np.roll(corner, -2, axis=1)
    a = following[..., 1] - last[..., 1]
    b = last[..., 0] - following[..., 0]
    c = following[..., 0] * last[..., 1] - last[..., 0] * following[..., 1]
    return np.stack([a, b, c], axis=-1), c.sum(axis=-1)


def _rows(y: Array, height: int) -> tuple[Ints, Ints]:
    """Find all pairs of a triangle and a row of pixels that it crosses."""
    first = np.clip(np.ceil(y.min(axis=1)), 0, height).astype(np.int64)
    last = np.clip(np.floor(y.max(axis=1)), -1, height - 1).astype(np.int64)
    count = np.maximum(last - first + 1, 0)
    return np.repeat(np.arange(len(y)), count), _ranges(first, count)


def _ranges(first: Ints, count: Ints) -> Ints:
    """Join runs of consecutive whole numbers, given by their first numbers and their lengths."""
    ends = np.cumsum(count)
    return np.repeat(first - (ends - count), count) + np.arange(count.sum())


def _span(edge: Array, row: Ints, width: int) -> tuple[Ints, Ints]:
    """The first and the last pixel of a row inside a triangle."""
    slope = edge[..., 0]
    rest = edge[..., 1] * row[:, None] + edge[..., 2]
    crossing = np.divide(-rest, slope, out=np.zeros_like(rest), where=slope != 0.0)
    first = np.where(slope > 0.0, crossing, -np.inf).max(axis=1)
    last = np.where(slope < 0.0, crossing, np.inf).min(axis=1)
    outside = ((slope == 0.0) & (rest < 0.0)).any(axis=1)
    first = np.where(outside, np.inf, first)
    return (
        np.ceil(np.clip(first - CRACK, 0, width)).astype(np.int64),
        np.floor(np.clip(last + CRACK, -1, width - 1)).astype(np.int64),
    )
