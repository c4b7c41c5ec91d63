"""A fitted body over its scan from three sides, colored by the distance between the two."""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Axes
from bodymeasure.mesh.tubes import Mesh
from bodymeasure.scene.camera import MARGIN, View, framed
from bodymeasure.scene.drawing.picture import Picture
from bodymeasure.scene.drawing.sides import SidePictures, side_pictures
from bodymeasure.scene.model import Surface

SIDES = ("front", "left", "back")
# Shown at half their size, for displays with twice the usual resolution.
PIXELS = 1100
# In meters: the distance that has the full color, ten times what a good fit leaves.
FULL = 0.005
# In meters: the body is drawn so far in front of the scan, which shows where it lies higher. Less
# would speckle where the two interlace, as they do all over a good fit.
LIFT = 0.003
# Colors from the body inside the scan over a good fit to the body outside, safe for color-blind
# readers, and the color of what the scan does not show.
SCALE = np.array([[0.13, 0.40, 0.67], [0.94, 0.93, 0.91], [0.70, 0.09, 0.17]])
NO_SCAN = np.array([0.45, 0.45, 0.47])


class Triangles(NamedTuple):
    """A triangle mesh.

    Parameters
    ----------
    points : ndarray, shape (n, 3)
    triangles : ndarray of int, shape (m, 3)
    """

    points: Array
    triangles: Ints


def fit_pictures(
    body: Triangles,
    distance: Array,
    scan: Triangles,
    *,
    renderer: str | None = None,
    advance: Callable[[str], None] | None = None,
) -> SidePictures:
    """Draw a fitted body over its scan.

    Parameters
    ----------
    body : Triangles
        In meters, z up, front = -y.
    distance : ndarray, shape (n,)
        Signed distance of each point of the body from the scan in meters, positive outside; NaN
        where the scan shows nothing.
    scan : Triangles
        In the same frame.
    renderer : str, optional
        ``pyvista`` or ``software``; by default as `choose_renderer` says.
    advance : callable, optional
        Called after each picture with its name.

    Raises
    ------
    InputError
        If there is no such renderer.
    MissingExtraError
        If matplotlib is not installed.
    """
    return side_pictures(_pictures(body, distance, scan), renderer=renderer, advance=advance)


def _pictures(body: Triangles, distance: Array, scan: Triangles) -> Iterator[tuple[str, Picture]]:
    """Yield what is seen from each side."""
    axes, colors = Axes(), distance_colors(distance)
    surface, normals = surface_of(scan), vertex_normals(body)
    owner = np.zeros(len(body.triangles), dtype=np.int64)
    for side, towards in _directions(axes).items():
        lifted = body.points + LIFT * towards
        mesh = Mesh(lifted, normals, body.triangles, colors, owner)
        view = _view(np.concatenate([surface.points, lifted]), towards, axes.up_vector)
        yield side, Picture(surface, view, view.size(PIXELS), mesh)


def distance_colors(distance: Array) -> Array:
    """Return the colors in [0, 1], shape (n, 3), of signed distances (n,) in meters."""
    place = np.clip(distance / FULL, -1.0, 1.0)
    known = np.stack([np.interp(place, [-1.0, 0.0, 1.0], part) for part in SCALE.T], axis=-1)
    return np.asarray(np.where(np.isfinite(distance)[:, None], known, NO_SCAN))


def vertex_normals(mesh: Triangles) -> Array:
    """Return unit normals at the points of a mesh, shape (n, 3), weighted by area."""
    corners = mesh.points[mesh.triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = np.zeros_like(mesh.points)
    for corner in mesh.triangles.T:
        np.add.at(normals, corner, across)
    size = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.asarray(np.divide(normals, size, out=np.zeros_like(normals), where=size > 0.0))


def surface_of(scan: Triangles) -> Surface:
    """Return a mesh as what pictures show in the color of skin."""
    count = len(scan.points)
    none = np.zeros(len(scan.triangles), dtype=np.int64)
    return Surface(
        scan.points, vertex_normals(scan), scan.triangles, none, np.zeros(count, dtype=np.bool_)
    )


def _directions(axes: Axes) -> dict[str, Array]:
    front = axes.front_vector
    return dict(zip(SIDES, (front, axes.left_vector, -front), strict=True))


def _view(points: Array, towards: Array, up: Array) -> View:
    return framed(points, towards, up, MARGIN * float(np.ptp(points @ up)))
