"""The window of a chart: a body with its tapes as tubes, to turn and to pick."""

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from bodymeasure.viewer.window.base import LIT, BodyWindow, owner
from bodymeasure.viewer.window.describe import describe_measured, value_words
from bodymeasure.viewer.window.texts import EDGE, INK, LETTER, LINE, add_lines, list_lines

from bodymeasure._typing import Array
from bodymeasure.scene import SIDES, TapeLine, tapes_scene
from bodymeasure.scene.drawing.visibility import sight
from bodymeasure.scene.drawing.vtk_meshes import set_camera, set_colors, triangle_mesh
from bodymeasure.scene.tapes.camera import best_sides
from bodymeasure.scene.tapes.mesh import tape_mesh

if TYPE_CHECKING:
    from bodymeasure.chart import Chart

# Radius of a contact tape, as a fraction of the body's size, and by how much a picked one is wider.
RADIUS = 0.0026
PICKED_WIDER = 1.7
PICKED = (0.95, 0.75, 0.05)
NUMBER_SIZE = 16
# Height of numbers above the skin in radii of a tape, so that the tape does not hide them.
NUMBER_LIFT = 4.0
# A closed tape has a number at each quarter, so that one is seen from every side.
QUARTERS = (0.0, 0.25, 0.5, 0.75)
# Where the list of what is shown begins, in pixels below the top; its width, as a part of the
# window's; and how many lines of help it stays clear of.
LIST_TOP = 50
LIST_WIDTH = 0.4
HELP_LINES = 3
# Array of a mesh that says which of the scene's tapes a cell belongs to; -1 on the surface.
TAPE = "tape"
# Shift in depth that draws straight tapes, which run through the body, before everything else.
BEFORE_ALL = -66000.0


class TapeWindow(BodyWindow):
    """The window of a chart.

    Parameters
    ----------
    chart : Chart
    key : str, optional
        The only measurement to show.
    off_screen : bool
        Whether nothing is to appear on a display.
    """

    def __init__(self, chart: "Chart", key: str | None = None, *, off_screen: bool = False) -> None:
        self.chart = chart
        scene = tapes_scene(chart)
        if key is not None:
            scene = replace(scene, tapes=tuple(line for line in scene.tapes if line.key == key))
        self.scene = scene
        owners = {TAPE: np.full(len(scene.surface.triangles), -1)}
        super().__init__(chart.atlas, scene, off_screen=off_screen, owners=owners)
        self.groups = tuple(dict.fromkeys(line.group for line in scene.tapes))
        # The window begins with one group, since all tapes at once would hide one another.
        self.shown = 0
        self.tube_actors: dict[str, list[Any]] = {}
        self.number_actors: dict[str, Any] = {}
        self.numbers_on = True
        for group in self.groups:
            rows = [row for row, line in enumerate(scene.tapes) if line.group == group]
            self.tube_actors[group] = self._add_tubes(rows)
            self.number_actors[group] = self._add_numbers(rows)
        self._update()
        side = SIDES[0]
        if key is not None:
            self._describe(key)
            sights = {sight(scene.surface, self.views[side]): side for side in SIDES}
            side = sights[best_sides(scene, list(sights))[key]]
        elif self.groups:
            self.say(self.groups[self.shown])
        self.listen(
            ("click: which measurement", "g: next group", "n: numbers and names"),
            {"g": self.next_group, "n": self.toggle_numbers},
        )
        set_camera(self.plotter, scene.surface, self.framed(side))

    def next_group(self) -> str:
        """Show the next group of measurements alone; after the last, all of them.

        Returns
        -------
        str
            The name of the group; empty for all.
        """
        self.shown = self.shown + 1 if self.shown + 1 < len(self.groups) else -1
        self._update()
        group = self.groups[self.shown] if self.shown >= 0 else ""
        self.say(group or "all measurements")
        self.plotter.render()
        return group

    def toggle_numbers(self) -> None:
        """Show or hide the numbers, and the list of their names and values."""
        self.numbers_on = not self.numbers_on
        self._update()
        self.plotter.render()

    def pick(self, dataset: Any, cell: int) -> str:
        """Mark the measurement whose tape a cell belongs to, and describe it; see `BodyWindow`."""
        number = owner(dataset, cell, TAPE)
        if number is None or number < 0:
            return ""
        key = self.scene.tapes[number].key
        lines = [line for line in self.scene.tapes if line.key == key]
        mesh = tape_mesh(lines, PICKED_WIDER * RADIUS * self.scene.size, np.zeros(3))
        actor = self.plotter.add_mesh(
            triangle_mesh(mesh), color=PICKED, name="picked", pickable=False, reset_camera=False
        )
        if all(line.through_body for line in lines):
            _draw_before_all(actor)
        return self._describe(key)

    def _describe(self, key: str) -> str:
        words: str = describe_measured(self.chart[key], self.chart.atlas.unit)
        self.say(f"{self.scene.numbers[key]}  {words}")
        return words

    def _add_tubes(self, rows: Sequence[int]) -> list[Any]:
        """Add tubes of some of the scene's tapes: those on the body, and those through it."""
        actors = []
        for through in (False, True):
            some = [row for row in rows if self.scene.tapes[row].through_body == through]
            if not some:
                continue
            lines = [self.scene.tapes[row] for row in some]
            mesh = tape_mesh(lines, RADIUS * self.scene.size, np.zeros(3))
            tubes = triangle_mesh(mesh)
            tubes.point_data.active_normals = mesh.normals
            tubes.cell_data[TAPE] = np.array(some)[mesh.owner]
            set_colors(tubes, mesh.colors)
            actor = self.plotter.add_mesh(tubes, rgb=True, **LIT)
            if through:
                _draw_before_all(actor)
            actors.append(actor)
        return actors

    def _add_numbers(self, rows: Sequence[int]) -> Any:
        """Add numbers of some of the scene's tapes, which face the camera and hide behind it."""
        lift = NUMBER_LIFT * RADIUS * self.scene.size
        # The number stands at a measurement's first tape.
        first = {self.scene.tapes[row].number: self.scene.tapes[row] for row in reversed(rows)}
        places = {number: number_places(line, lift) for number, line in first.items()}
        return self.plotter.add_point_labels(
            np.concatenate(list(places.values())),
            [str(number) for number, some in places.items() for _ in some],
            font_size=NUMBER_SIZE,
            text_color=INK,
            shape=None,
            show_points=False,
            always_visible=False,
            pickable=False,
            reset_camera=False,
        )

    def _update(self) -> None:
        """Show what belongs to the group that is shown."""
        for number, group in enumerate(self.groups):
            on = self.shown in (-1, number)
            for actor in self.tube_actors[group]:
                actor.visibility = on
            self.number_actors[group].visibility = on and self.numbers_on
        self.plotter.remove_actor("picked", render=False)
        self._show_list()

    def fit_texts(self) -> None:
        """Distribute the texts over the window again; see `BodyWindow`."""
        super().fit_texts()
        self._show_list()

    def _show_list(self) -> None:
        add_lines(self.plotter, self.listed() if self.numbers_on else [], name="list", top=LIST_TOP)

    def listed(self) -> list[str]:
        """The lines of the list: numbers, values and names of the measurements that are shown."""
        shown = [
            row for row in self.scene.tapes if self.shown in (-1, self.groups.index(row.group))
        ]
        rows = []
        for number, key in dict.fromkeys((line.number, line.key) for line in shown):
            item = self.chart[key]
            value = value_words(item, self.chart.atlas.unit)
            rows.append(f"{number}   {value}   {item.definition.name}")
        width, height = self.plotter.window_size
        room = height - LIST_TOP - 2 * EDGE - LINE * HELP_LINES
        lines: list[str] = list_lines(rows, int(LIST_WIDTH * width / LETTER), int(room / LINE))
        return lines


def number_places(line: TapeLine, lift: float) -> Array:
    """The places of a tape's number, shape (k, 3), off the skin by a length."""
    closed = np.array_equal(line.points[0], line.points[-1])
    parts = (0.0,) if line.through_body else QUARTERS if closed else (0.5,)
    rows = [int(part * (len(line.points) - 1)) for part in parts]
    return np.asarray(line.points[rows] + lift * line.lift[rows])


def _draw_before_all(actor: Any) -> None:
    """Draw an actor as if it stood before everything else."""
    mapper = actor.mapper
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, BEFORE_ALL)
