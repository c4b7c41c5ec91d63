"""Colors for values, as text that SVG files have."""

import numpy as np

from bodymeasure._typing import Array

# The color map viridis at five places, which people who confuse red and green can read, too.
STOPS = np.array([[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]])


def color_of(part: float) -> str:
    """Return the color of a part of the scale, from 0 to 1."""
    (rgb,) = colors_of(np.array([part]))
    return "#" + "".join(f"{round(255.0 * float(value)):02x}" for value in rgb)


def colors_of(parts: Array) -> Array:
    """Return the colors of parts of the scale as red, green and blue in [0, 1], shape (n, 3)."""
    places = np.clip(parts, 0.0, 1.0) * (len(STOPS) - 1)
    every = np.arange(len(STOPS))
    return np.stack([np.interp(places, every, channel) for channel in STOPS.T], axis=1) / 255.0
