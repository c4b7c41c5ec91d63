"""Lines and texts over a picture, drawn by matplotlib's rasterizer without a figure around them."""

import io
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.errors import MissingExtraError

INK = "#26282c"
# At this resolution one of matplotlib's points is one pixel.
DPI = 72
# Distance of baselines, the height of a capital letter, and the width of the white rim around
# letters, as fractions of the size of a text.
LINE_HEIGHT = 1.2
CAPITAL = 0.73
RIM = 0.25
# Pictures of a page are WebP files of this quality, at which letters and tapes look the same. More
# effort takes twice the time for files that are a twentieth smaller.
QUALITY = 80
EFFORT = 2
# PNG files are compressed by runs of equal bytes: on shaded pictures that is as small as zlib's
# fourth of nine levels, in two thirds of its time.
RUNS = 3

Lines = tuple[Sequence[Array], Array, float]
"""Curves (k, 2) in pixels from the top left, their colors (n, 3), and a width in pixels."""


@dataclass(frozen=True)
class Text:
    """A text at a place of a picture.

    Parameters
    ----------
    x, y : float
        In pixels from the top left.
    text : str
        One or more lines.
    size : float
        Size of the font in pixels.
    horizontal : str
        What stands at `x`: the ``left`` or ``right`` end, or the ``center``.
    vertical : str
        What stands at `y`: the ``top``, or the ``center``.
    """

    x: float
    y: float
    text: str
    size: float
    horizontal: str = "center"
    vertical: str = "center"


def draw_on(
    image: NDArray[Any], *, lines: Sequence[Lines] = (), texts: Sequence[Text] = ()
) -> NDArray[np.uint8]:
    """Draw lines, and texts on top of them, over a picture.

    Parameters
    ----------
    image : ndarray of uint8, shape (height, width, 3)
    lines : sequence of (curves, colors, width)
        Curves of shape (k, 2) in pixels from the top left, their colors in [0, 1] of shape (n, 3),
        and a width in pixels.
    texts : sequence of Text

    Returns
    -------
    ndarray of uint8, shape (height, width, 3)

    Raises
    ------
    MissingExtraError
        If matplotlib is not installed.
    """
    if not lines and not texts:
        return image
    try:
        from matplotlib.backends import backend_agg
        from matplotlib.path import Path
        from matplotlib.transforms import Affine2D
    except ImportError:
        raise MissingExtraError("a picture", "matplotlib", "report") from None
    height, width = image.shape[:2]
    agg: Any = backend_agg
    canvas = agg.RendererAgg(width, height, DPI)
    pixels = np.asarray(canvas.buffer_rgba())
    pixels[..., :3] = image
    pixels[..., 3] = 255
    from_top_left = Affine2D().scale(1.0, -1.0).translate(0.0, height)
    for curves, colors, line_width in lines:
        pen = _pen(canvas, line_width)
        for curve, color in zip(curves, colors.tolist(), strict=True):
            pen.set_foreground((*color, 1.0), isRGBA=True)
            canvas.draw_path(pen, Path(curve), from_top_left)
    for text in texts:
        _write(canvas, text, height)
    return pixels[..., :3].copy()


def _pen(canvas: Any, width: float) -> Any:
    pen = canvas.new_gc()
    pen.set_capstyle("round")
    pen.set_joinstyle("round")
    pen.set_linewidth(width)
    return pen


def _write(canvas: Any, text: Text, height: int) -> None:
    """Draw a text with a white rim on a canvas of a height in pixels."""
    from matplotlib.colors import to_rgb
    from matplotlib.transforms import Affine2D

    rows = text.text.split("\n")
    first = CAPITAL if text.vertical == "top" else (CAPITAL - LINE_HEIGHT * (len(rows) - 1)) / 2
    rim, ink = _pen(canvas, RIM * text.size), _pen(canvas, 0.0)
    rim.set_foreground("white")
    placed = []
    for number, row in enumerate(rows):
        outline, width = _outline(row)
        before = {"left": 0.0, "center": width / 2, "right": width}[text.horizontal]
        baseline = text.y + (first + LINE_HEIGHT * number) * text.size
        place = Affine2D().translate(-before, 0.0).scale(text.size)
        placed.append((outline, place.translate(text.x, height - baseline)))
    for outline, place in placed:
        canvas.draw_path(rim, outline, place)
    for outline, place in placed:
        canvas.draw_path(ink, outline, place, to_rgb(INK))


@lru_cache(maxsize=512)
def _outline(row: str) -> tuple[Any, float]:
    """The outline of a line of text of size 1, and its width."""
    from matplotlib.textpath import TextPath

    outline = TextPath((0.0, 0.0), row, size=1.0)
    # Not the exact extents: they take longer than all the drawing, and letters' outlines have their
    # rightmost points among their vertices.
    return outline, float(np.max(np.asarray(outline.vertices)[:, 0], initial=0.0))


def figure_pixels(figure: Any) -> NDArray[np.uint8]:
    """Draw a matplotlib figure as pixels, shape (height, width, 3)."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    canvas: Any = FigureCanvasAgg(figure)
    canvas.draw()
    return np.array(canvas.buffer_rgba())[..., :3]


def png(image: NDArray[np.uint8]) -> bytes:
    """A picture, shape (height, width, 3), as a PNG file.

    Raises
    ------
    MissingExtraError
        If Pillow, which comes with matplotlib, is not installed.
    """
    return _file(image, "PNG", compress_level=4, compress_type=RUNS)


def webp(image: NDArray[np.uint8]) -> bytes:
    """A picture, shape (height, width, 3), as a WebP file, a tenth as large as a PNG file.

    Raises
    ------
    MissingExtraError
        If Pillow, which comes with matplotlib, is not installed.
    """
    return _file(image, "WEBP", quality=QUALITY, method=EFFORT)


def _file(image: NDArray[np.uint8], form: str, **options: int) -> bytes:
    try:
        from PIL import Image
    except ImportError:
        raise MissingExtraError("a picture", "matplotlib", "report") from None
    file = io.BytesIO()
    Image.fromarray(image).save(file, format=form, **options)
    return file.getvalue()
