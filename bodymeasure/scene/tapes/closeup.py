"""One measurement from near: its tapes, its landmarks by name, its number in the corner."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from bodymeasure.scene.camera import View
from bodymeasure.scene.drawing.software_tapes import Drawing
from bodymeasure.scene.drawing.strokes import runs
from bodymeasure.scene.drawing.visibility import Sight
from bodymeasure.scene.figures.canvas import Lines, Text, draw_on
from bodymeasure.scene.model import Label, TapeLine, TapeScene
from bodymeasure.scene.tapes.camera import best, closeup_view, measurement_seen
from bodymeasure.scene.tapes.label_layout import Columns, place_labels
from bodymeasure.scene.tapes.mesh import COLORS, forward, tape_mesh
from bodymeasure.scene.tapes.text import column_texts, leaders, wrapped

SIZE = (600, 500)
NUMBER_PIXELS = 36
NAME_PIXELS = 20
NAME_COLUMNS = 12
# Room for the names at either side, in pixels.
NAME_ROOM = 132
# Radius of a contact tape, as a fraction of the picture's height, and at most so much of the body.
RADIUS = 0.0075
# Hidden parts are dashed, this far apart along the curve, and paler.
DASH_POINTS = 2
HIDDEN_WIDTH = 2.8
HIDDEN_PALER = 0.3


def closeup(
    scene: TapeScene, key: str, around: Sequence[Sight], draw: Drawing
) -> NDArray[np.uint8]:
    """A picture of one measurement, from the side where most of it is seen.

    Parameters
    ----------
    scene : TapeScene
    key : str
        Of a measurement with a tape.
    around : sequence of Sight
        The sides to choose from.
    draw : callable
    """
    lines = [line for line in scene.tapes if line.key == key]
    side = around[best([measurement_seen(scene, key, view) for view in around])]
    marks = scene.landmarks[key]
    shown = np.concatenate([line.points for line in lines])
    view = closeup_view(scene, shown, side, SIZE[0] / SIZE[1])
    mesh = tape_mesh(lines, RADIUS * view.height, forward(scene, lines, view))
    image = draw(view, SIZE, mesh)
    number = Text(16.0, 12.0, str(lines[0].number), NUMBER_PIXELS, "left", "top")
    drawn, texts = _names(marks, view)
    return draw_on(image, lines=[*_hidden(lines, side, view), *drawn], texts=[*texts, number])


def _names(marks: Sequence[Label], view: View) -> tuple[list[Lines], list[Text]]:
    """Leaders and names of landmarks, at the picture's edges."""
    every = np.array([mark.position for mark in marks]).reshape(-1, 3)
    places, _ = view.project(every, SIZE)
    inside = np.flatnonzero(((places > 0.0) & (places < SIZE)).all(axis=1))
    if len(inside) == 0:
        return [], []
    places = places[inside]
    names = [wrapped(marks[number].text, NAME_COLUMNS) for number in inside.tolist()]
    rows = max(name.count("\n") + 1 for name in names)
    height = 1.2 * rows * NAME_PIXELS
    columns = Columns(NAME_ROOM, SIZE[0] - NAME_ROOM, 1.4 * NUMBER_PIXELS, SIZE[1], height)
    layout = place_labels(places, places, columns)
    scale = layout.label_height / height
    texts = column_texts(names, layout, columns, scale * NAME_PIXELS)
    return leaders(layout, columns, NAME_PIXELS), texts


def _hidden(lines: Sequence[TapeLine], side: Sight, view: View) -> list[Lines]:
    """Dashes where the body hides a tape."""
    drawn: list[Lines] = []
    for line in lines:
        if line.through_body:
            continue
        places, _ = view.project(line.points, SIZE)
        dash = np.arange(len(places)) // DASH_POINTS % 2 == 0
        hidden = ~side.seen(line.points, line.normals) & dash
        pieces = runs(np.where(hidden[:, None], places, np.nan))
        color = np.array(COLORS[line.kind]) * (1 - HIDDEN_PALER) + HIDDEN_PALER
        if pieces:
            drawn.append((pieces, np.tile(color, (len(pieces), 1)), HIDDEN_WIDTH))
    return drawn
