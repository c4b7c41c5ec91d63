"""The light that both renderers use: fixed to the camera, from above and the left."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bodymeasure.scene.camera import View
from bodymeasure.scene.colors import BODY

# Direction towards the light: right, up and towards the viewer.
LIGHT = (-0.45, 0.55, 1.0)
AMBIENT = 0.42
DIFFUSE = 0.62
# How much is left of the color of what is faded; the rest is white.
FADED = 0.45


def light_direction(view: View) -> NDArray[np.float64]:
    """Unit vector towards the light, shape (3,)."""
    direction = LIGHT[0] * view.right + LIGHT[1] * view.up + LIGHT[2] * view.towards
    return np.asarray(direction / np.linalg.norm(direction))


def shade(normals: NDArray[np.float64], view: View) -> NDArray[np.float64]:
    """Brightness in [0, 1], shape (n,), at normals of any length and orientation, (n, 3)."""
    length = np.linalg.norm(normals, axis=-1)
    facing = np.where(normals @ view.towards >= 0.0, 1.0, -1.0)
    cosine = np.divide(
        facing * (normals @ light_direction(view)),
        length,
        out=np.zeros_like(length),
        where=length > 0.0,
    )
    return np.minimum(AMBIENT + DIFFUSE * np.maximum(cosine, 0.0), 1.0)


def shaded(
    normals: NDArray[np.float64], faded: NDArray[np.bool_], view: View
) -> NDArray[np.float64]:
    """Colors in [0, 1], shape (n, 3), of the body's surface.

    Parameters
    ----------
    normals : ndarray, shape (n, 3)
    faded : ndarray of bool, shape (n,)
    view : View
    """
    color = np.array(BODY) * shade(normals, view)[:, None]
    return np.where(faded[:, None], 1.0 - FADED * (1.0 - color), color)
