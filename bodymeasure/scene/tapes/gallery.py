"""All pictures of a chart's tapes."""

from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from bodymeasure.chart import Chart
from bodymeasure.scene.camera import SIDES, View, body_views
from bodymeasure.scene.diagonals.gallery import png
from bodymeasure.scene.drawing import opengl_tapes, software_tapes
from bodymeasure.scene.drawing.opengl_check import PYVISTA, SOFTWARE, choose_renderer
from bodymeasure.scene.drawing.software_tapes import Drawing
from bodymeasure.scene.drawing.visibility import Sight, sight
from bodymeasure.scene.model import Surface, TapeLine, TapeScene
from bodymeasure.scene.tapes.build import tapes_scene
from bodymeasure.scene.tapes.camera import best, measurement_seen, sights
from bodymeasure.scene.tapes.closeup import closeup
from bodymeasure.scene.tapes.label_layout import Columns
from bodymeasure.scene.tapes.labels import numbered
from bodymeasure.scene.tapes.mesh import forward, tape_mesh
from bodymeasure.scene.tapes.text import with_numbers

# Pictures are shown at half their size in pixels, for displays with twice the usual resolution.
BODY_PIXELS = 1400
LABEL_PIXELS = 26
# Room beside the body for the labels and their leaders, as a fraction of the body's height.
LABEL_ROOM = 0.065
# Between the labels and the silhouette, in heights of a label.
GAP = 0.6
# Radius of a contact tape, as a fraction of the body's height.
RADIUS = 0.0026
# A measurement is numbered on the side that sees most of it, and on those that see nearly as much.
SEEN_SHARE = 0.5


@dataclass(frozen=True)
class TapePictures:
    """The pictures of a chart.

    Parameters
    ----------
    body : mapping of (str, str) to bytes
        PNG files by group of measurements and side: ``front``, ``back``, and the wearer's ``left``
        and ``right``. Groups are in the order of the chart, and are those with a tape; sides on
        which none of the group's measurements is numbered are left out. All are equally high and
        to one scale; to be shown at half their size in pixels, where the widest are 560 wide.
    closeups : mapping of str to bytes
        PNG files, all of one size, by the key of a measurement with a tape; to be shown at half
        their size in pixels.
    numbers : mapping of str to int
        The number by which a picture names a measurement: from 1, in the order of the chart, of all
        that have a value.
    renderer : str
        What drew them: ``pyvista`` or ``software``.
    note : str
        A sentence for the user if it had to be another than usual, otherwise empty.
    """

    body: Mapping[tuple[str, str], bytes]
    closeups: Mapping[str, bytes]
    numbers: Mapping[str, int]
    renderer: str
    note: str


SESSIONS: Mapping[str, Callable[[Surface], AbstractContextManager[Drawing]]] = {
    PYVISTA: opengl_tapes.session,
    SOFTWARE: software_tapes.session,
}


def tape_pictures(
    chart: Chart,
    *,
    renderer: str | None = None,
    advance: Callable[[str], None] | None = None,
) -> TapePictures:
    """Draw a body with the tapes of its measurements, and each measurement from near.

    Parameters
    ----------
    chart : Chart
    renderer : str, optional
        ``pyvista`` or ``software``; see `choose_renderer` for what is taken by default.
    advance : callable, optional
        Called after each picture with its name.

    Raises
    ------
    InputError
        If there is no such renderer.
    MissingExtraError
        If matplotlib is not installed.
    """
    choice = choose_renderer(renderer)
    scene = tapes_scene(chart)
    told = advance or _ignore
    with SESSIONS[choice.renderer](scene.surface) as draw:
        body = _bodies(scene, chart, draw, told)
        closeups = _closeups(scene, chart, draw, told)
    return TapePictures(body, closeups, scene.numbers, choice.renderer, choice.note)


def _ignore(_: str) -> None:
    pass


def _bodies(
    scene: TapeScene, chart: Chart, draw: Drawing, advance: Callable[[str], None]
) -> dict[tuple[str, str], bytes]:
    views = roomy_views(scene, chart)
    seen = {side: sight(scene.surface, view) for side, view in views.items()}
    shown = shown_sides(scene, seen)
    pictures = {}
    for side in SIDES:
        for group in dict.fromkeys(line.group for line in scene.tapes):
            lines = [line for line in scene.tapes if line.group == group]
            labeled = [line.number for line in lines if side in shown[line.key]]
            if labeled:
                image = body_picture(scene, lines, dict.fromkeys(labeled), seen[side], draw)
                pictures[group, side] = png(image)
                advance(f"{group}, {side}")
    groups = list(dict.fromkeys(line.group for line in scene.tapes))
    return dict(sorted(pictures.items(), key=lambda item: groups.index(item[0][0])))


def roomy_views(scene: TapeScene, chart: Chart) -> dict[str, View]:
    """The four sides of a body with room for labels beside it."""
    views = body_views(scene, chart.atlas.axes)
    return {
        side: replace(view, width=view.width + 2.0 * LABEL_ROOM * view.height)
        for side, view in views.items()
    }


def shown_sides(scene: TapeScene, seen: Mapping[str, Sight]) -> dict[str, set[str]]:
    """On which sides each measurement is numbered, by its key."""
    length = {
        key: {side: measurement_seen(scene, key, view) for side, view in seen.items()}
        for key in dict.fromkeys(line.key for line in scene.tapes)
    }
    shown = {}
    for key, by_side in length.items():
        most = list(by_side)[best(list(by_side.values()))]
        enough = SEEN_SHARE * by_side[most]
        shown[key] = {side for side, own in by_side.items() if own > 0.0 and own >= enough}
        shown[key].add(most)
    return shown


def body_picture(
    scene: TapeScene,
    lines: list[TapeLine],
    labeled: Mapping[int, None],
    seen: Sight,
    draw: Drawing,
) -> NDArray[np.uint8]:
    """One side of a body with some tapes, and the numbers of some of them."""
    view = seen.view
    size = view.size(BODY_PIXELS)
    drawn = [line for line in lines if not line.through_body or line.number in labeled]
    mesh = tape_mesh(drawn, RADIUS * scene.size, forward(scene, drawn, view))
    image = draw(view, size, mesh)
    low, high = (size[0] * end for end in seen.columns)
    gap = GAP * LABEL_PIXELS
    columns = Columns(low - gap, high + gap, 0.0, size[1], LABEL_PIXELS)
    return with_numbers(image, numbered(drawn, list(labeled), seen, size, columns))


def _closeups(
    scene: TapeScene, chart: Chart, draw: Drawing, advance: Callable[[str], None]
) -> dict[str, bytes]:
    around = sights(scene.surface, chart.atlas.axes, RADIUS * scene.size)
    pictures = {}
    for key in dict.fromkeys(line.key for line in scene.tapes):
        pictures[key] = png(closeup(scene, key, around, draw))
        advance(key)
    return pictures


def tapes_overview(chart: Chart, key: str | None = None, *, renderer: str | None = None) -> bytes:
    """One picture of the first group's tapes from four sides, or of one measurement from near.

    Parameters
    ----------
    chart : Chart
    key : str, optional
        Of a measurement with a tape.
    renderer : str, optional
        As for `tape_pictures`.

    Returns
    -------
    bytes
        A PNG file.
    """
    scene = tapes_scene(chart)
    with SESSIONS[choose_renderer(renderer).renderer](scene.surface) as draw:
        if key is not None:
            around = sights(scene.surface, chart.atlas.axes, RADIUS * scene.size)
            return png(closeup(scene, key, around, draw))
        views = roomy_views(scene, chart)
        seen = {side: sight(scene.surface, view) for side, view in views.items()}
        shown = shown_sides(scene, seen)
        lines = [line for line in scene.tapes if line.group == scene.tapes[0].group]
        images = []
        for side in SIDES:
            labeled = [line.number for line in lines if side in shown[line.key]]
            images.append(body_picture(scene, lines, dict.fromkeys(labeled), seen[side], draw))
    return png(np.concatenate(images, axis=1))
