"""Orthographic views of a body."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Axes
from bodymeasure.atlas.queries.outside import outward_sign_of_mesh
from bodymeasure.scene.model import BodyScene, TapeScene

SIDES = ("front", "back", "left", "right")
# Room around what is framed, as a fraction of the picture's height.
MARGIN = 0.02
CLOSEUP_MARGIN = 0.18
# A patch is seen from above if its picture would hold less than this of the upward direction.
LYING = 0.2
# The height that surroundings may have above a patch, as a fraction of its picture; what is higher
# is cut away.
CUT_MARGIN = 0.1


@dataclass(frozen=True)
class View:
    """A camera infinitely far away.

    Parameters
    ----------
    center : ndarray, shape (3,)
        The point in the middle of the picture.
    towards : ndarray, shape (3,)
        Unit vector from the body to the viewer.
    up : ndarray, shape (3,)
        Unit vector upwards in the picture, perpendicular to `towards`.
    width, height : float
        Extent of the picture, in the atlas's unit.
    nearest : float
        The largest depth, as of `project`, that is drawn; what is nearer is cut away.
    """

    center: Array
    towards: Array
    up: Array
    width: float
    height: float
    nearest: float = np.inf

    @cached_property
    def right(self) -> Array:
        """Unit vector to the right in the picture, shape (3,)."""
        return np.cross(self.up, self.towards)

    def size(self, pixels: int) -> tuple[int, int]:
        """Width and height in pixels of a picture that is `pixels` high."""
        return max(1, round(pixels * self.width / self.height)), pixels

    def project(self, points: Array, size: tuple[int, int]) -> tuple[Array, Array]:
        """Find where points appear in a picture.

        Parameters
        ----------
        points : ndarray, shape (..., 3)
        size : tuple of int
            Width and height of the picture in pixels.

        Returns
        -------
        pixels : ndarray, shape (..., 2)
            From the left and from the top, in pixels; (0, 0) is the corner of the first pixel.
        depth : ndarray, shape (...,)
            Distance from the plane through `center`, in the atlas's unit: larger for nearer points.
        """
        offset = points - self.center
        scale = size[1] / self.height
        x = size[0] / 2 + scale * (offset @ self.right)
        y = size[1] / 2 - scale * (offset @ self.up)
        return np.stack([x, y], axis=-1), offset @ self.towards


def body_views(scene: BodyScene | TapeScene, axes: Axes) -> dict[str, View]:
    """Return the views of a body's four sides, all to one scale.

    They show all tapes, too: those of heights reach the floor, which a body without feet does not.
    """
    towards = {
        "front": axes.front_vector,
        "back": -axes.front_vector,
        "left": axes.left_vector,
        "right": -axes.left_vector,
    }
    points = scene.surface.points
    if isinstance(scene, TapeScene):
        points = np.concatenate([points, *(line.points for line in scene.tapes)])
    height = float(np.ptp(points @ axes.up_vector))
    # A flat patch may have no height at all; it must not have an empty picture.
    margin = MARGIN * max(height, float(np.ptp(points, axis=0).max()) / 4)
    return {
        side: framed(points, direction, axes.up_vector, margin)
        for side, direction in towards.items()
    }


def patch_view(scene: BodyScene, axes: Axes) -> View:
    """Return a square view straight onto the part of a scene that is not faded.

    It looks from outside the body. Surroundings that stand before what it shows, such as an arm,
    are cut away.
    """
    surface = scene.surface
    points, normals = surface.points[~surface.faded], surface.normals[~surface.faded]
    normal = normals.mean(axis=0)
    length = float(np.linalg.norm(normal))
    sign = outward_sign_of_mesh(surface.points, surface.triangles)
    towards = sign * normal / length if length > 0.0 else axes.front_vector
    # Patches stand upright as on the body, unless they lie flat and are seen from above or below.
    upward = axes.up_vector - (axes.up_vector @ towards) * towards
    if np.linalg.norm(upward) < LYING:
        upward = axes.front_vector - (axes.front_vector @ towards) * towards
    upward /= np.linalg.norm(upward)
    finite = np.isfinite(scene.paths.lines.points).all(axis=-1)
    shown = np.concatenate([points, scene.paths.lines.points[finite]])
    right = np.cross(upward, towards)
    extent = max(float(np.ptp(shown @ upward)), float(np.ptp(shown @ right)))
    view = framed(shown, towards, upward, CLOSEUP_MARGIN * extent)
    side = max(view.width, view.height)
    nearest = float(((points - view.center) @ towards).max()) + CUT_MARGIN * side
    return View(view.center, towards, upward, side, side, nearest)


def framed(points: Array, towards: Array, up: Array, margin: float) -> View:
    """Return the view that holds some points, shape (k, 3), with a margin in the atlas's unit."""
    right = np.cross(up, towards)
    low = np.array([(points @ axis).min() for axis in (right, up, towards)])
    high = np.array([(points @ axis).max() for axis in (right, up, towards)])
    middle = (low + high) / 2
    center = middle[0] * right + middle[1] * up + middle[2] * towards
    width, height = high[:2] - low[:2] + 2 * margin
    return View(center, towards, up, float(width), float(height))
