"""Colors for values, as text that SVG files have."""

import numpy as np

# The color map viridis at five places, which people who confuse red and green can read, too.
STOPS = np.array([[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]])


def color_of(part: float) -> str:
    """Return the color of a part of the scale, from 0 to 1."""
    place = float(np.clip(part, 0.0, 1.0)) * (len(STOPS) - 1)
    rgb = [np.interp(place, np.arange(len(STOPS)), STOPS[:, channel]) for channel in range(3)]
    return "#" + "".join(f"{round(float(value)):02x}" for value in rgb)
