"""The light that both renderers use: fixed to the camera, from above and the left."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.scene.camera import View
from bodymeasure.scene.colors import BODY
from bodymeasure.scene.model import Surface

# Direction towards the light: right, up and towards the viewer.
LIGHT = (-0.45, 0.55, 1.0)
AMBIENT = 0.42
DIFFUSE = 0.62
# The share of its color that a faded vertex keeps; the rest is white.
FADED = 0.45


def light_direction(view: View) -> Array:
    """Return the unit vector towards the light, shape (3,)."""
    direction = LIGHT[0] * view.right + LIGHT[1] * view.up + LIGHT[2] * view.towards
    return np.asarray(direction / np.linalg.norm(direction))


def shade(normals: Array, view: View) -> Array:
    """Return the brightness in [0, 1], shape (n,), at normals, (n, 3), of any orientation."""
    length = np.linalg.norm(normals, axis=-1)
    facing = np.where(normals @ view.towards >= 0.0, 1.0, -1.0)
    cosine = np.divide(
        facing * (normals @ light_direction(view)),
        length,
        out=np.zeros_like(length),
        where=length > 0.0,
    )
    return np.asarray(np.minimum(AMBIENT + DIFFUSE * np.maximum(cosine, 0.0), 1.0))


def glow(surface: Surface, view: View) -> tuple[Array, Array]:
    """Return the light from a surface's vertices, as shares of white and of the body's color.

    Returns
    -------
    white, body : ndarray, shape (n,)
        The color is ``white + body * BODY``.
    """
    gain = np.where(surface.faded, FADED, 1.0)
    return 1.0 - gain, gain * shade(surface.normals, view)


def glowing(white: Array, body: Array) -> Array:
    """Return the colors in [0, 1], shape (..., 3), of light as `glow` returns it."""
    return np.asarray(white[..., None] + body[..., None] * np.array(BODY))
