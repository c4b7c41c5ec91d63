"""Labels and a scale bar over the close-up of a patch."""

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Unit, convert_length
from bodymeasure.scene.camera import View
from bodymeasure.scene.figures.canvas import Text, draw_on
from bodymeasure.scene.model import BodyScene

TEXT_SIZE = 0.026  # of the picture's height
# A label stands outside the patch by so much of the picture's height.
LABEL_OFFSET = 0.03
# The scale bar is the longest of these lengths, in millimetres, under a fifth of the picture.
BAR_MILLIMETRES = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
BAR_PART = 0.2
BAR_MARGIN = 0.05
INK = np.array([[0.15, 0.16, 0.17]])


def annotated(
    image: NDArray[np.uint8], scene: BodyScene, view: View, unit: Unit
) -> NDArray[np.uint8]:
    """A picture with the scene's labels and a bar of a round length.

    Parameters
    ----------
    image : ndarray of uint8, shape (height, width, 3)
    scene : BodyScene
    view : View
    unit : Unit
        Of the scene.
    """
    height, width = image.shape[:2]
    size = TEXT_SIZE * height
    pixels, _ = view.project(np.array([label.position for label in scene.labels]), (width, height))
    outwards = pixels - pixels.mean(axis=0)
    outwards /= np.maximum(np.linalg.norm(outwards, axis=-1, keepdims=True), 1.0)
    places = pixels + LABEL_OFFSET * height * outwards
    texts = [
        Text(x, y, label.text, size, horizontal="right" if leftwards else "left")
        for (x, y), leftwards, label in zip(places, outwards[:, 0] < 0.0, scene.labels, strict=True)
    ]

    length, caption = _bar(view, unit)
    bar = length * height / view.height
    x, y = BAR_MARGIN * width, (1.0 - BAR_MARGIN) * height
    tick = 0.4 * size
    outline = np.array([(x, y - tick), (x, y), (x + bar, y), (x + bar, y - tick)])
    texts.append(Text(x + bar / 2, y - 0.9 * size, caption, size))
    return draw_on(image, lines=[([outline], INK, 0.12 * size)], texts=texts)


def _bar(view: View, unit: Unit) -> tuple[float, str]:
    """The scale bar's length in the scene's unit, and what it says."""
    fitting = [
        length
        for length in BAR_MILLIMETRES
        if convert_length(float(length), Unit.MM, unit) <= BAR_PART * view.width
    ]
    length = fitting[-1] if fitting else BAR_MILLIMETRES[0]
    caption = f"{length / 10:g} cm" if length >= 10 else f"{length} mm"
    return convert_length(float(length), Unit.MM, unit), caption
