"""Labels and a scale bar over the close-up of a patch."""

from dataclasses import replace

import numpy as np

from bodymeasure.atlas import Unit, convert_length
from bodymeasure.scene.camera import View
from bodymeasure.scene.drawing.picture import Picture
from bodymeasure.scene.figures.canvas import Text
from bodymeasure.scene.model import Label

TEXT_SIZE = 0.026  # of the picture's height
# Distance of a label from the corner that it labels, as a fraction of the picture's height.
LABEL_OFFSET = 0.03
# The scale bar is the longest of these lengths, in millimeters, under a fifth of the picture.
BAR_MILLIMETERS = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
BAR_PART = 0.2
BAR_MARGIN = 0.05
INK = np.array([[0.15, 0.16, 0.17]])


def annotated(picture: Picture, labels: tuple[Label, ...], unit: Unit) -> Picture:
    """Add labels and a bar of a round length to a picture.

    Parameters
    ----------
    picture : Picture
    labels : tuple of Label
        Labels of the corners of what is shown.
    unit : Unit
        Unit of the coordinates.
    """
    view, (width, height) = picture.view, picture.size
    size = TEXT_SIZE * height
    pixels, _ = view.project(np.array([label.position for label in labels]), (width, height))
    outwards = pixels - pixels.mean(axis=0)
    outwards /= np.maximum(np.linalg.norm(outwards, axis=-1, keepdims=True), 1.0)
    places = pixels + LABEL_OFFSET * height * outwards
    texts = [
        Text(x, y, label.text, size, horizontal="right" if leftwards else "left")
        for (x, y), leftwards, label in zip(places, outwards[:, 0] < 0.0, labels, strict=True)
    ]

    length, caption = _bar(view, unit)
    bar = length * height / view.height
    x, y = BAR_MARGIN * width, (1.0 - BAR_MARGIN) * height
    tick = 0.4 * size
    outline = np.array([(x, y - tick), (x, y), (x + bar, y), (x + bar, y - tick)])
    texts.append(Text(x + bar / 2, y - size, caption, size))
    return replace(picture, marks=[([outline], INK, 0.12 * size)], texts=texts)


def _bar(view: View, unit: Unit) -> tuple[float, str]:
    """The scale bar's length in the scene's unit, and its caption."""
    fitting = [
        length
        for length in BAR_MILLIMETERS
        if convert_length(float(length), Unit.MM, unit) <= BAR_PART * view.width
    ]
    length = fitting[-1] if fitting else BAR_MILLIMETERS[0]
    caption = f"{length / 10:g} cm" if length >= 10 else f"{length} mm"
    return convert_length(float(length), Unit.MM, unit), caption
