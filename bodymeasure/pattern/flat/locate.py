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
    for row, (patch, place) in enumerate(zip(*places, strict=True)):
        candidates = np.flatnonzero(region.patch == patch)
        if len(candidates):
            part = barycentric(region.parameters[candidates], place)
            best = int(part.min(axis=1).argmax())
            least[row] = part[best].min()
            positions[row] = part[best] @ flat[region.triangles[candidates[best]]]
    return positions, least


def on_skin(region: Region, flat: Array, points: Array) -> tuple[SkinPlaces, Bools]:
    """Return the places on the skin of points of a layout (n, 2), and which of them lie in it."""
    corners = flat[region.triangles]
    closed = np.concatenate([corners, corners[:, :1]], axis=1)
    tree = shapely.STRtree(shapely.polygons(closed))
    row, triangle = tree.query(shapely.points(points), predicate="intersects")
    found = np.full(len(points), -1, dtype=np.int64)
    found[row] = triangle
    there = found >= 0
    part = barycentric(corners[found[there]], points[there])
    parameters = np.full((len(points), 2), np.nan)
    parameters[there] = np.einsum("kc,kcd->kd", part, region.parameters[found[there]])
    return SkinPlaces(region.patch[found], parameters.clip(0.0, 1.0)), there
