"""Lines and texts drawn over a picture by matplotlib, without pyplot and its global state."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure.errors import MissingExtraError

# Only relates the widths of lines, which are said in pixels, to matplotlib's points.
DPI = 72
INK = "#26282c"

Lines = tuple[Sequence[NDArray[np.float64]], NDArray[np.float64], float]


@dataclass(frozen=True)
class Text:
    """A text at a place in pixels from the top left; alignments are matplotlib's."""

    x: float
    y: float
    text: str
    size: float
    horizontal: str = "center"
    vertical: str = "center"


def draw_on(
    image: NDArray[Any], *, lines: Sequence[Lines] = (), texts: Sequence[Text] = ()
) -> NDArray[np.uint8]:
    """Draw over a picture.

    Parameters
    ----------
    image : ndarray, shape (height, width, 3)
        Of uint8, or of floats in [0, 1].
    lines : sequence of (curves, colors, width)
        n curves of shape (k, 2) in pixels from the top left, their colors in [0, 1] of shape
        (n, 3), and a width in pixels.
    texts : sequence of Text

    Returns
    -------
    ndarray of uint8, shape (height, width, 3)
    """
    try:
        from matplotlib.collections import LineCollection
        from matplotlib.figure import Figure
        from matplotlib.patheffects import withStroke
        from matplotlib.transforms import Affine2D
    except ImportError:
        raise MissingExtraError("a picture", "matplotlib", "report") from None
    height, width = image.shape[:2]
    figure = Figure(figsize=(width / DPI, height / DPI), dpi=DPI)
    figure.patch.set_alpha(0.0)
    # Without axes, whose ticks take longer than all that is drawn.
    from_top_left = Affine2D().scale(1.0, -1.0).translate(0.0, height)
    for curves, colors, line_width in lines:
        figure.add_artist(
            LineCollection(
                list(curves),
                colors=np.insert(colors, 3, 1.0, axis=1),
                linewidths=line_width,
                capstyle="round",
                transform=from_top_left,
            )
        )
    for text in texts:
        figure.text(
            text.x,
            text.y,
            text.text,
            size=text.size,
            ha=text.horizontal,
            va=text.vertical,
            transform=from_top_left,
            color=INK,
            path_effects=[withStroke(linewidth=text.size / 4, foreground="white")],
        )
    return _over(image, _rgba(figure))


def _over(image: NDArray[Any], drawn: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """What was drawn with some opacity, (height, width, 4), over a picture."""
    if image.dtype == np.uint8:
        result = np.array(image)
    else:
        result = np.asarray(np.round(255.0 * np.clip(image, 0.0, 1.0)), dtype=np.uint8)
    touched = np.nonzero(drawn[..., 3])
    ink = drawn[touched].astype(np.float64)
    opacity = ink[:, 3:] / 255.0
    mixed = opacity * ink[:, :3] + (1.0 - opacity) * result[touched]
    result[touched] = np.round(mixed).astype(np.uint8)
    return result


def figure_pixels(figure: Any) -> NDArray[np.uint8]:
    """A matplotlib figure drawn, shape (height, width, 3)."""
    return _rgba(figure)[..., :3]


def _rgba(figure: Any) -> NDArray[np.uint8]:
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    canvas: Any = FigureCanvasAgg(figure)
    canvas.draw()
    return np.array(canvas.buffer_rgba())
