"""Places on the skin and in the first flat layout of a region, from one to the other."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.pattern.cutting.region import Region, barycentric
from bodymeasure.pattern.planar import shapely


class SkinPlaces(NamedTuple):
    """Places on the skin.

    Parameters
    ----------
    patch : ndarray of int, shape (n,)
    parameters : ndarray, shape (n, 2)
    """

    patch: Ints
    parameters: Array

    def take(self, rows: Ints | Bools) -> "SkinPlaces":
        """Return some of the places."""
        return SkinPlaces(self.patch[rows], self.parameters[rows])


def in_layout(region: Region, flat: Array, places: SkinPlaces) -> tuple[Array, Array]:
    """Return where places on the skin lie in a layout of the region.

    Returns
    -------
    positions : ndarray, shape (n, 2)
    inside : ndarray, shape (n,)
        The least barycentric coordinate of each place in its triangle: below 0 outside the region,
        -inf on patches that it does not have.
    """
    positions = np.full((len(places.patch), 2), np.nan)
    least = np.full(len(places.patch), -np.inf)
    for patch in np.intersect1d(places.patch, region.patch).tolist():
        rows, candidates = np.flatnonzero(places.patch == patch), region.patch == patch
        corners, layout = region.parameters[candidates], flat[region.triangles[candidates]]
        part = barycentric(corners, places.parameters[rows, None])
        best = part.min(axis=2).argmax(axis=1)
        part = np.take_along_axis(part, best[:, None, None], axis=1)[:, 0]
        least[rows] = part.min(axis=1)
        positions[rows] = np.einsum("nc,ncd->nd", part, layout[best])
    return positions, least


def triangles_at(corners: Array, points: Array) -> Ints:
    """Return which of some triangles (k, 3, 2) each point (n, 2) lies in, -1 for none, (n,)."""
    closed = np.concatenate([corners, corners[:, :1]], axis=1)
    tree = shapely.STRtree(shapely.polygons(closed))
    row, triangle = tree.query(shapely.points(points), predicate="intersects")
    found = np.full(len(points), -1, dtype=np.int64)
    found[row] = triangle
    return found


def on_skin(region: Region, flat: Array, points: Array) -> tuple[SkinPlaces, Bools]:
    """Return the places on the skin of points of a layout (n, 2), and which of them lie in it."""
    corners = flat[region.triangles]
    found = triangles_at(corners, points)
    there = found >= 0
    part = barycentric(corners[found[there]], points[there])
    parameters = np.full((len(points), 2), np.nan)
    parameters[there] = np.einsum("kc,kcd->kd", part, region.parameters[found[there]])
    return SkinPlaces(region.patch[found], parameters.clip(0.0, 1.0)), there
