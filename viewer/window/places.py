"""Places on an atlas under the pointer."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.scene.diagonals.build import BODY_SEGMENTS
from bodymeasure.scene.model import Surface

# The distance in pixels within which a click means a landmark.
SNAP = 9.0
# How far the skin under the pointer may be from that landmark, in multiples of the same distance:
# it is farther where another part of the body stands before the landmark.
SNAP_DEPTH = 4.0


def place_on(surface: Surface, triangle: int, position: Array) -> AtlasPoint:
    """Return the point of the atlas at a position on a triangle of its tessellation.

    Parameters
    ----------
    surface : Surface
        All patches of an atlas in their order, as `tessellate` divides them.
    triangle : int
    position : ndarray, shape (3,)
    """
    corners = surface.triangles[triangle]
    first, second, third = surface.points[corners]
    sides = np.stack([second - first, third - first], axis=1)
    weights, *_ = np.linalg.lstsq(sides, position - first, rcond=None)
    patch, parameters = vertex_places(corners)
    u, v = parameters[0] + weights @ (parameters[1:] - parameters[0])
    return AtlasPoint(int(patch[0]), float(np.clip(u, 0.0, 1.0)), float(np.clip(v, 0.0, 1.0)))


def vertex_places(vertices: Ints) -> tuple[Ints, Array]:
    """Return the patches (k,) and parameters (k, 2) of vertices of a tessellation, by number."""
    side = BODY_SEGMENTS + 1
    patch, within = np.divmod(vertices, side * side)
    return patch, np.stack(np.divmod(within, side), axis=-1) / BODY_SEGMENTS


def landmark_at(
    plotter: Any, places: Mapping[str, Array], x: float, y: float, skin: Array | None
) -> str | None:
    """Return the name of the landmark that is meant by a place in the window.

    Parameters
    ----------
    plotter : pyvista.Plotter
        With a parallel projection.
    places : mapping of str to ndarray
        Positions of the landmarks.
    x, y : float
        Pixels from the left and from the bottom.
    skin : ndarray, shape (3,)
        The position on the body that is seen there; None if there is none.
    """
    if skin is None or not places:
        return None
    renderer = plotter.renderer
    pixel = 2.0 * plotter.camera.parallel_scale / plotter.window_size[1]
    nearest, least = None, SNAP
    for name, position in places.items():
        if np.linalg.norm(position - skin) > SNAP_DEPTH * SNAP * pixel:
            continue
        renderer.SetWorldPoint(*position, 1.0)
        renderer.WorldToDisplay()
        away = float(np.hypot(*(np.array(renderer.GetDisplayPoint()[:2]) - (x, y))))
        if away < least:
            nearest, least = name, away
    return nearest


def landmark_places(atlas: Atlas) -> dict[str, Array]:
    """Return the positions of an atlas's landmarks by name."""
    return {name: atlas.position(point) for name, point in atlas.landmarks.items()}
