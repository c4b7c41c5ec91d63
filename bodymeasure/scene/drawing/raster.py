"""A depth buffer in NumPy: which triangle each pixel of an orthographic picture shows."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

# Widens a triangle's span in a row by so many pixels, so that round-off leaves no crack between
# neighbours; where both then cover a pixel, the nearer wins.
CRACK = 1e-7
# Twice the area in pixels below which a triangle is seen edge-on and covers nothing.
EDGE_ON = 1e-9
# Triangles at a time: bounds the memory for what they cover to some tens of megabytes.
CHUNK = 4096


@dataclass(frozen=True)
class DepthBuffer:
    """What each pixel shows.

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

    depth: NDArray[np.float64]
    triangle: NDArray[np.int64]
    triangles: NDArray[np.int64]
    edge: NDArray[np.float64]

    def interpolated(self, values: NDArray[np.float64], background: float) -> NDArray[np.float64]:
        """What each pixel shows of a quantity given at the vertices, shape (height, width)."""
        covered = np.flatnonzero(self.triangle >= 0)
        picture = np.full(self.triangle.size, background)
        picture[covered] = self.at_pixels(values[:, None], covered)[:, 0]
        return picture.reshape(self.triangle.shape)

    def at_pixels(
        self, values: NDArray[np.float64], pixel: NDArray[np.int64]
    ) -> NDArray[np.float64]:
        """What some pixels show of c quantities given at the vertices.

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
    pixels: NDArray[np.float64],
    depth: NDArray[np.float64],
    triangles: NDArray[np.int64],
    size: tuple[int, int],
) -> DepthBuffer:
    """Find the nearest triangle at the center of each pixel.

    Parameters
    ----------
    pixels : ndarray, shape (n, 2)
        Projected vertices, from the picture's top left corner.
    depth : ndarray, shape (n,)
        Their depth; nearer is more.
    triangles : ndarray of int, shape (m, 3)
    size : tuple of int
        Width and height in pixels.
    """
    width, height = size
    buffer = np.full(height * width, -np.inf)
    nearest = np.full(height * width, -1)
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
        np.maximum.at(buffer, pixel, z)
        # Of triangles at the same depth, any one will do.
        wins = z == buffer[pixel]
        nearest[pixel[wins]] = which[wins]
    shape = (height, width)
    return DepthBuffer(buffer.reshape(shape), nearest.reshape(shape), triangles, edge)


def _planes(edge: NDArray[np.float64], values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Coefficients, shape (m, 3), of the linear functions with given values at the corners."""
    return np.asarray((values[:, None, :] @ edge)[:, 0])


def _at(
    plane: NDArray[np.float64],
    triangle: NDArray[np.int64],
    column: NDArray[np.int64],
    row: NDArray[np.int64],
) -> NDArray[np.float64]:
    a, b, c = plane.T
    return np.asarray(a[triangle] * column + b[triangle] * row + c[triangle])


def _edge_functions(
    corner: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Coefficients (a, b, c), shape (m, 3, 3), of a x + b y + c = area times the barycentrics."""
    following, last = np.roll(corner, -1, axis=1), np.roll(corner, -2, axis=1)
    a = following[..., 1] - last[..., 1]
    b = last[..., 0] - following[..., 0]
    c = following[..., 0] * last[..., 1] - last[..., 0] * following[..., 1]
    return np.stack([a, b, c], axis=-1), c.sum(axis=-1)


def _rows(y: NDArray[np.float64], height: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Pairs of a triangle and a row of pixels that it crosses."""
    first = np.clip(np.ceil(y.min(axis=1)), 0, height).astype(np.int64)
    last = np.clip(np.floor(y.max(axis=1)), -1, height - 1).astype(np.int64)
    count = np.maximum(last - first + 1, 0)
    return np.repeat(np.arange(len(y)), count), _ranges(first, count)


def _ranges(first: NDArray[np.int64], count: NDArray[np.int64]) -> NDArray[np.int64]:
    """Runs of whole numbers one after the other, each with its first and how many they are."""
    ends = np.cumsum(count)
    return np.repeat(first - (ends - count), count) + np.arange(count.sum())


def _span(
    edge: NDArray[np.float64], row: NDArray[np.int64], width: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """First and last pixel of a row inside a triangle."""
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
