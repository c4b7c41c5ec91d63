"""Curves of an atlas laid on the surface to which it was fitted, each point on the closest one."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.oracle.extrapolate import richardson
from bodymeasure.oracle.libigl import closest_on_mesh
from bodymeasure.paper.surface.fine_surface import FineSurface

# Bends are measured over so many points each way, 5 mm on the diagonals of a mannequin. Over fewer,
# the faces of the mesh would matter.
REACH = 4


class LaidCurves(NamedTuple):
    """Curves laid on a surface.

    Parameters
    ----------
    points : ndarray, shape (k, p, 3)
        Points on the finest mesh.
    length : ndarray, shape (k,)
        Length of the laid curve on the smooth surface.
    uncertainty : ndarray, shape (k,)
    distance : ndarray, shape (k,)
        Largest distance of the curve from the surface.
    offset : ndarray, shape (k,)
        Mean distance along the curve, negative where the curve is inside.
    bend, own_bend : ndarray, shape (k,)
        Radii of the laid curve at its sharpest bend, and of the curve itself at the same point.
    """

    points: Array
    length: Array
    uncertainty: Array
    distance: Array
    offset: Array
    bend: Array
    own_bend: Array


def lay_curves(surface: FineSurface, curves: Array, ends: Array, lengths: Array) -> LaidCurves:
    """Return curves laid on a surface.

    Parameters
    ----------
    surface : FineSurface
    curves : ndarray, shape (k, p, 3)
        Points of each curve; p is odd.
    ends : ndarray, shape (k, 2, 3)
        The points of the limit surface closest to the ends. These count in full, while an error of
        other points along the curve, by the angle of a face, hardly changes its length.
    lengths : ndarray, shape (k,)
        The lengths of the curves themselves. The points only give the change of a polygon's length
        by laying it, since a polygon differs from its curve by the same amount before and after.
    """
    by_level, by_half = [], []
    for step, mesh in enumerate(surface.meshes):
        faces = surface.faces(step)
        flat, face = closest_on_mesh(mesh.vertices, faces, curves.reshape(-1, 3))
        laid = flat.reshape(curves.shape)
        laid[:, [0, -1]] = ends
        by_level.append(_polygon(laid) - _polygon(curves) + lengths)
        by_half.append(_polygon(laid[:, ::2]) - _polygon(curves[:, ::2]) + lengths)
    length, uncertainty = richardson(np.stack(by_level, axis=-1), surface.segments)
    # The mesh and the closest points of the last step are those of the finest mesh.
    corners = mesh.vertices[faces[face]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    away = curves - laid
    outside = np.einsum("kpc,kpc->kp", away, normals.reshape(curves.shape))
    distance = np.linalg.norm(away, axis=-1)
    radius = _bends(laid)
    sharpest = radius.argmin(axis=-1)[:, None]
    return LaidCurves(
        points=laid,
        length=length,
        uncertainty=uncertainty + np.abs(by_level[-1] - by_half[-1]),
        distance=distance.max(axis=-1),
        offset=(np.sign(outside) * distance).mean(axis=-1),
        bend=np.take_along_axis(radius, sharpest, axis=-1)[:, 0],
        own_bend=np.take_along_axis(_bends(curves), sharpest, axis=-1)[:, 0],
    )


def _polygon(points: Array) -> Array:
    """Return the lengths of polygons (k, p, 3)."""
    return np.asarray(np.linalg.norm(np.diff(points, axis=1), axis=-1).sum(axis=-1))


def _bends(points: Array) -> Array:
    """Return the radii of circles through points of polygons (k, p, 3) and one on each side."""
    back = points[:, REACH:-REACH] - points[:, : -2 * REACH]
    ahead = points[:, 2 * REACH :] - points[:, REACH:-REACH]
    doubled = np.linalg.norm(np.cross(back, ahead), axis=-1)
    sides = np.linalg.norm(back, axis=-1) * np.linalg.norm(ahead, axis=-1)
    sides *= np.linalg.norm(back + ahead, axis=-1)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(np.where(doubled > 0.0, sides / (2.0 * doubled), np.inf))
