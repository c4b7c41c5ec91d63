"""One measurement from near: its tapes, its landmarks by name, its number in the corner."""

import textwrap
from collections.abc import Sequence

import numpy as np

from bodymeasure.scene.camera import View
from bodymeasure.scene.drawing.picture import Picture, pieces
from bodymeasure.scene.drawing.visibility import Sight
from bodymeasure.scene.figures.canvas import Lines, Text
from bodymeasure.scene.model import Label, TapeLine, TapeScene
from bodymeasure.scene.tapes.camera import closeup_view
from bodymeasure.scene.tapes.label_layout import Columns, place_labels
from bodymeasure.scene.tapes.mesh import COLORS, forward, tape_mesh
from bodymeasure.scene.tapes.text import column_texts, leaders

SIZE = (600, 500)
NUMBER_PIXELS = 36
NAME_PIXELS = 20
NAME_COLUMNS = 12
# Room for the names at either side, in pixels.
NAME_ROOM = 132
# Radius of a contact tape, as a fraction of the picture's height.
RADIUS = 0.0075
# Hidden parts are dashed, this many points on and this many off, in a paler color.
DASH_POINTS = 2
HIDDEN_WIDTH = 2.8
HIDDEN_PALER = 0.3


def closeup(scene: TapeScene, key: str, side: Sight) -> Picture:
    """Describe the picture of one measurement from near.

    Parameters
    ----------
    scene : TapeScene
    key : str
        Key of a measurement with a tape.
    side : Sight
        The side to look from.
    """
    lines = [line for line in scene.tapes if line.key == key]
    shown = np.concatenate([line.points for line in lines])
    view = closeup_view(scene, shown, side, SIZE[0] / SIZE[1])
    number = Text(16.0, 12.0, str(lines[0].number), NUMBER_PIXELS, "left", "top")
    marks, texts = _names(scene.landmarks[key], view)
    return Picture(
        side.surface,
        view,
        SIZE,
        tubes=tape_mesh(lines, RADIUS * view.height, forward(scene, lines, view)),
        marks=[*_hidden(lines, side, view), *marks],
        texts=[*texts, number],
    )


def _names(landmarks: Sequence[Label], view: View) -> tuple[list[Lines], list[Text]]:
    """Leaders and names of landmarks, at the picture's edges."""
    every = np.array([landmark.position for landmark in landmarks]).reshape(-1, 3)
    places, _ = view.project(every, SIZE)
    inside = np.flatnonzero(((places > 0.0) & (places < SIZE)).all(axis=1))
    if len(inside) == 0:
        return [], []
    places = places[inside]
    names = [textwrap.fill(landmarks[number].text, NAME_COLUMNS) for number in inside.tolist()]
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
        dashes, _ = pieces(np.where(hidden[:, None], places, np.nan)[None])
        color = np.array(COLORS[line.kind]) * (1 - HIDDEN_PALER) + HIDDEN_PALER
        drawn.append((dashes, np.tile(color, (len(dashes), 1)), HIDDEN_WIDTH))
    return drawn
