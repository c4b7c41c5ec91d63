"""Colors of a picture, the same for every renderer."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import MissingExtraError
from bodymeasure.scene.model import PathKind, Paths

BACKGROUND = (1.0, 1.0, 1.0)
BODY = (0.90, 0.88, 0.85)
EDGE = (0.38, 0.38, 0.40)
FADED_EDGE = (0.66, 0.66, 0.68)
NO_LENGTH = (0.86, 0.08, 0.24)
NOT_COMPARED = (0.90, 0.45, 0.05)
# Perceptually uniform and safe for color-blind readers. Large differences are dark, since dark
# stands out on a pale body; the palest tenth would vanish on it.
COLOR_MAP = "viridis_r"
MAP_START = 0.12
# With more decades than this, a reader could not distinguish neighboring ones; smaller differences
# take the first color.
MOST_DECADES = 8
SMALLEST = 1e-12


@dataclass(frozen=True)
class ColorScale:
    """A logarithmic scale of relative differences.

    Parameters
    ----------
    low, high : float
        Its ends, powers of ten.
    """

    low: float
    high: float

    @classmethod
    def of(cls, paths: Paths) -> "ColorScale | None":
        """Return the scale that holds all compared paths, or None if there are none."""
        value = paths.value[np.isfinite(paths.value)]
        return cls.spanning(value) if len(value) else None

    @classmethod
    def spanning(cls, value: Array) -> "ColorScale":
        """Return the scale that holds some differences, except for the smallest hundredth."""
        value = np.maximum(value, SMALLEST)
        # A power of ten must not open a decade of its own because of round-off.
        high = int(np.ceil(np.log10(value.max()) - 1e-9))
        low = int(np.floor(np.log10(np.quantile(value, 0.01, method="lower")) + 1e-9))
        low = min(max(low, high - MOST_DECADES), high - 1)
        return cls(10.0**low, 10.0**high)

    def rgb(self, value: Array) -> Array:
        """Return the colors in [0, 1], shape (..., 3), of relative differences, shape (...,)."""
        low, high = np.log10([self.low, self.high])
        place = (np.log10(np.maximum(value, SMALLEST)) - low) / (high - low)
        return color_map(np.clip(place, 0.0, 1.0))


def color_map(place: Array) -> Array:
    """Return the colors in [0, 1], shape (..., 3), at places in [0, 1] along the color map."""
    try:
        from matplotlib import colormaps
    except ImportError:
        raise MissingExtraError("a picture", "matplotlib", "report") from None
    return np.asarray(colormaps[COLOR_MAP](MAP_START + (1.0 - MAP_START) * place))[..., :3]


def path_colors(paths: Paths, scale: ColorScale | None) -> Array:
    """Return the color in [0, 1] of each path, shape (n, 3)."""
    colors = np.empty((len(paths.value), 3))
    colors[:] = NOT_COMPARED
    colors[paths.kind == PathKind.NO_LENGTH] = NO_LENGTH
    compared = paths.kind == PathKind.COMPARED
    if scale is not None:
        colors[compared] = scale.rgb(paths.value[compared])
    return colors
