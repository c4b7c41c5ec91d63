"""All pictures of a chart's tapes."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from bodymeasure.atlas import Axes
from bodymeasure.chart import Chart
from bodymeasure.scene.camera import SIDES, View, body_views
from bodymeasure.scene.drawing import RENDERERS
from bodymeasure.scene.drawing.opengl_check import choose_renderer
from bodymeasure.scene.drawing.picture import Picture
from bodymeasure.scene.drawing.visibility import Sight, sight
from bodymeasure.scene.figures.canvas import png, webp
from bodymeasure.scene.model import TapeLine, TapeScene
from bodymeasure.scene.tapes.build import tapes_scene
from bodymeasure.scene.tapes.camera import best, best_sides, measurements_seen, sights
from bodymeasure.scene.tapes.closeup import closeup
from bodymeasure.scene.tapes.label_layout import Columns
from bodymeasure.scene.tapes.labels import numbered
from bodymeasure.scene.tapes.mesh import forward, tape_mesh
from bodymeasure.scene.tapes.text import column_texts, leaders

# Pictures are shown at half their size in pixels, for displays with twice the usual resolution.
BODY_PIXELS = 1400
LABEL_PIXELS = 26
# Pictures for paper are drawn at this part of it: 80 mm high, they have 320 pixels to the inch.
PAPER = 0.72
# Room beside the body for the labels and their leaders, as a fraction of the body's height.
LABEL_ROOM = 0.065
# Distance of the labels from the silhouette, in heights of a label.
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
        WebP files by group of measurements and side: ``front``, ``back``, and the wearer's ``left``
        and ``right``. The groups with a tape follow in the order of the chart; sides on which none
        of a group's measurements is numbered are left out. All are equally high and to one scale.
        They are to be shown 630 to 700 pixels high, where the widest are 560 wide.
    closeups : mapping of str to bytes
        WebP files, all of one size, by the key of a measurement with a tape; to be shown at half
        their size in pixels.
    numbers : mapping of str to int
        The number by which a picture names a measurement. Measurements with a value are numbered
        from 1 in the order of the chart.
    renderer : str
        The renderer that drew them: ``pyvista`` or ``software``.
    note : str
        Why it was not the usual one, as a sentence; empty if it was.
    """

    body: Mapping[tuple[str, str], bytes]
    closeups: Mapping[str, bytes]
    numbers: Mapping[str, int]
    renderer: str
    note: str


def tape_pictures(
    chart: Chart,
    *,
    few: bool = False,
    renderer: str | None = None,
    advance: Callable[[str], None] | None = None,
) -> TapePictures:
    """Draw a body with the tapes of its measurements, and each measurement from near.

    Parameters
    ----------
    chart : Chart
    few : bool
        Whether only what paper needs is drawn, beside a scene that can be turned: the body from
        the fewest sides on which all measurements of a group are numbered, with fewer pixels, and
        none from near.
    renderer : str, optional
        ``pyvista`` or ``software``; by default as `choose_renderer` says.
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
    advance = advance or (lambda _name: None)
    body, near = {}, {}
    with RENDERERS[choice.renderer]() as draw:
        for name, picture in _body_pictures(scene, chart.atlas.axes, few=few):
            body[name] = webp(draw(picture))
            advance(", ".join(name))
        for key, picture in _closeups(scene, chart.atlas.axes) if not few else ():
            near[key] = webp(draw(picture))
            advance(key)
    groups = list(_groups(scene))
    body = dict(sorted(body.items(), key=lambda item: groups.index(item[0][0])))
    return TapePictures(body, near, scene.numbers, choice.renderer, choice.note)


def tapes_overview(chart: Chart, key: str | None = None, *, renderer: str | None = None) -> bytes:
    """Draw the first group's tapes from four sides, or one measurement from near.

    Parameters
    ----------
    chart : Chart
    key : str, optional
        Key of a measurement with a tape.
    renderer : str, optional
        ``pyvista`` or ``software``; by default as `choose_renderer` says.

    Returns
    -------
    bytes
        A PNG file.

    Raises
    ------
    InputError
        If there is no such renderer.
    MissingExtraError
        If matplotlib is not installed.
    """
    scene, axes = tapes_scene(chart), chart.atlas.axes
    with RENDERERS[choose_renderer(renderer).renderer]() as draw:
        if key is not None:
            around = sights(scene.surface, axes, RADIUS * scene.size)
            return png(draw(closeup(scene, key, best_sides(scene, around)[key])))
        seen = _seen(scene, axes)
        shown = shown_sides(scene, seen)
        lines = _groups(scene)[scene.tapes[0].group]
        images = [
            draw(body_picture(scene, lines, _numbers(lines, shown, side), seen[side]))
            for side in SIDES
        ]
    return png(np.concatenate(images, axis=1))


def _groups(scene: TapeScene) -> dict[str, list[TapeLine]]:
    """Collect the tapes of each group of measurements."""
    groups: dict[str, list[TapeLine]] = {}
    for line in scene.tapes:
        groups.setdefault(line.group, []).append(line)
    return groups


def _body_pictures(
    scene: TapeScene, axes: Axes, *, few: bool
) -> Iterator[tuple[tuple[str, str], Picture]]:
    """Pictures of the body by group and side, those of one side after one another."""
    seen = _seen(scene, axes)
    shown = shown_sides(scene, seen)
    groups = _groups(scene)
    scale = PAPER if few else 1.0
    sides = {group: _fewest(lines, shown) if few else SIDES for group, lines in groups.items()}
    for side in SIDES:
        for group, lines in groups.items():
            if side in sides[group] and (numbers := _numbers(lines, shown, side)):
                yield (group, side), body_picture(scene, lines, numbers, seen[side], scale)


def _fewest(lines: Sequence[TapeLine], shown: Mapping[str, set[str]]) -> list[str]:
    """Choose sides that number all measurements, each time the one that numbers most of the rest.

    That they are the fewest is not proven, and with four sides no matter.
    """
    left = {line.key for line in lines}
    chosen: list[str] = []
    while left:
        counts = [sum(side in shown[key] for key in left) for side in SIDES]
        chosen.append(SIDES[int(np.argmax(counts))])
        left = {key for key in left if chosen[-1] not in shown[key]}
    return chosen


def _numbers(lines: Sequence[TapeLine], shown: Mapping[str, set[str]], side: str) -> list[int]:
    """Numbers of the measurements that are numbered on a side, each once."""
    return list(dict.fromkeys(line.number for line in lines if side in shown[line.key]))


def _closeups(scene: TapeScene, axes: Axes) -> Iterator[tuple[str, Picture]]:
    """Pictures of the measurements from near, by key."""
    around = sights(scene.surface, axes, RADIUS * scene.size)
    for key, side in best_sides(scene, around).items():
        yield key, closeup(scene, key, side)


def _seen(scene: TapeScene, axes: Axes) -> dict[str, Sight]:
    """Find what is seen of the body from each of its four sides."""
    return {side: sight(scene.surface, view) for side, view in roomy_views(scene, axes).items()}


def roomy_views(scene: TapeScene, axes: Axes) -> dict[str, View]:
    """Return the views of a body's four sides with room for labels beside it."""
    return {
        side: replace(view, width=view.width + 2.0 * LABEL_ROOM * view.height)
        for side, view in body_views(scene, axes).items()
    }


def shown_sides(scene: TapeScene, seen: Mapping[str, Sight]) -> dict[str, set[str]]:
    """Choose the sides on which each measurement is numbered, by its key."""
    lengths = {side: measurements_seen(scene, view) for side, view in seen.items()}
    shown = {}
    for key in dict.fromkeys(line.key for line in scene.tapes):
        by_side = {side: by_key[key] for side, by_key in lengths.items()}
        most = list(by_side)[best(list(by_side.values()))]
        enough = SEEN_SHARE * by_side[most]
        shown[key] = {side for side, own in by_side.items() if own > 0.0 and own >= enough}
        shown[key].add(most)
    return shown


def body_picture(
    scene: TapeScene,
    lines: Sequence[TapeLine],
    numbers: Sequence[int],
    side: Sight,
    scale: float = 1.0,
) -> Picture:
    """Describe the picture of one side of a body with some tapes.

    Parameters
    ----------
    scene : TapeScene
    lines : sequence of TapeLine
        The tapes to draw. Those that run through the body are left out if they are not numbered.
    numbers : sequence of int
        Numbers of the measurements that are numbered.
    side : Sight
    scale : float
        Part of the usual number of pixels in each direction.
    """
    view, label = side.view, scale * LABEL_PIXELS
    size = view.size(round(scale * BODY_PIXELS))
    drawn = [line for line in lines if not line.through_body or line.number in numbers]
    low, high = (size[0] * end for end in side.columns)
    columns = Columns(low - GAP * label, high + GAP * label, 0.0, size[1], label)
    found, layout = numbered(drawn, numbers, side, size, columns)
    return Picture(
        side.surface,
        view,
        size,
        tubes=tape_mesh(drawn, RADIUS * scene.size, forward(scene, drawn, view)),
        marks=leaders(layout, columns, layout.label_height),
        texts=column_texts([str(number) for number in found], layout, columns, layout.label_height),
    )
