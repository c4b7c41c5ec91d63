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
    edge : ndarray, shape (3, 3, m)
        Coefficients (a, b, c) of the three barycentric coordinates a column + b row + c of each
        triangle.
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
            _at(_planes(self.edge, channel[self.triangles.T]), shown, column, row)
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
    # Triangles come last, so that what is taken over their corners is taken of whole rows of them.
    # Pixel centers now lie at whole numbers.
    x, y = (pixels.T - 0.5).take(triangles.T, axis=1)
    low, high = y.min(axis=0), y.max(axis=0)
    edge, area = _edge_functions(x, y)
    broad = np.abs(area) > EDGE_ON
    edge = np.divide(edge, area, out=np.zeros_like(edge), where=broad)
    plane = _planes(edge, depth[triangles.T])
    inside = (x.max(axis=0) >= 0) & (x.min(axis=0) < width) & (high >= 0) & (low < height)
    seen = np.flatnonzero(inside & broad)
    begins, ends = _sides(edge)
    for chunk in np.array_split(seen, max(1, -(-len(seen) // CHUNK))):
        which, row = _rows(low[chunk], high[chunk], height)
        which = chunk[which]
        sides = begins.take(which, axis=2), ends.take(which, axis=2)
        first, last = _span(*sides, row, width)
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
    """Coefficients, shape (3, m), of the linear functions with given values (3, m) at corners."""
    return np.asarray((edge * values).sum(axis=1))


def _at(plane: Array, triangle: Ints, column: Ints, row: Ints) -> Array:
    a, b, c = plane.take(triangle, axis=1)
    return np.asarray(a * column + b * row + c)


def _edge_functions(x: Array, y: Array) -> tuple[Array, Array]:
    """Coefficients (a, b, c), shape (3, 3, m), of a x + b y + c = area times the barycentrics.

    The corners' coordinates have shape (3, m).
    """
    following, last = [1, 2, 0], [2, 0, 1]
    a = y[following] - y[last]
    b = x[last] - x[following]
    c = x[following] * y[last] - x[last] * y[following]
    return np.stack([a, b, c]), c.sum(axis=0)


def _rows(low: Array, high: Array, height: int) -> tuple[Ints, Ints]:
    """Find all pairs of a triangle and a row of pixels that it crosses, from its extent."""
    first = np.clip(np.ceil(low), 0, height).astype(np.int64)
    last = np.clip(np.floor(high), -1, height - 1).astype(np.int64)
    count = np.maximum(last - first + 1, 0)
    return np.repeat(np.arange(len(low)), count), _ranges(first, count)


def _ranges(first: Ints, count: Ints) -> Ints:
    """Join runs of consecutive whole numbers, given by their first numbers and their lengths."""
    ends = np.cumsum(count)
    return np.repeat(first - (ends - count), count) + np.arange(count.sum())


def _sides(edge: Array) -> tuple[Array, Array]:
    """Coefficients (p, q), shape (2, 3, m), of the columns p row + q where triangles begin and end.

    Those of a side that does not bound them there are 0 and infinite. The rows that a triangle
    crosses are within a level side anyway.
    """
    slope = edge[0]
    crossing = np.divide(-edge[1:], slope, out=np.zeros_like(edge[1:]), where=slope != 0.0)
    unbounded = np.array([0.0, np.inf]).reshape(2, 1, 1)
    begins = np.where(slope > 0.0, crossing, -unbounded)
    return begins, np.where(slope < 0.0, crossing, unbounded)


def _span(begins: Array, ends: Array, row: Ints, width: int) -> tuple[Ints, Ints]:
    """The first and the last pixel of a row inside a triangle, from its sides, (2, 3, n)."""
    first = (begins[0] * row + begins[1]).max(axis=0)
    last = (ends[0] * row + ends[1]).min(axis=0)
    return (
        np.ceil(np.clip(first - CRACK, 0, width)).astype(np.int64),
        np.floor(np.clip(last + CRACK, -1, width - 1)).astype(np.int64),
    )
