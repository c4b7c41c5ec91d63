"""The window of a chart: a body with its tapes as tubes, to turn and to pick."""

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from bodymeasure.viewer.controls import INK, TEXT_SIZE, WINDOW_SIZE, listen, say
from bodymeasure.viewer.describe import describe_measured
from numpy.typing import NDArray

from bodymeasure.scene import SIDES, TapeLine, View, body_views, tapes_scene
from bodymeasure.scene.colors import BACKGROUND, BODY
from bodymeasure.scene.drawing.opengl import color_bytes, set_camera, surface_mesh
from bodymeasure.scene.drawing.opengl_tapes import tube_mesh
from bodymeasure.scene.drawing.visibility import sight
from bodymeasure.scene.lighting import AMBIENT, DIFFUSE, LIGHT
from bodymeasure.scene.tapes.camera import best, measurement_seen
from bodymeasure.scene.tapes.mesh import tape_mesh

if TYPE_CHECKING:
    from bodymeasure.chart import Chart

# Radius of a contact tape, as a fraction of the body's size, and by how much a picked one is wider.
RADIUS = 0.0026
PICKED_WIDER = 1.7
PICKED = (0.95, 0.75, 0.05)
NUMBER_SIZE = 16
# Numbers stand off the skin by so many radii of a tape, so that it does not hide them.
NUMBER_LIFT = 4.0
# A closed tape has a number at each quarter: from every side one is seen.
QUARTERS = (0.0, 0.25, 0.5, 0.75)
# Array of a mesh that says which of the scene's tapes a cell belongs to; -1 on the surface.
TAPE = "tape"
# Straight tapes run through the body, and are drawn before it: by so much in depth.
BEFORE_ALL = -66000.0
HELP = (
    "click: which measurement    g: next group    n: numbers    "
    "F1 front  F2 back  F3 left  F4 right    q: close"
)


class TapeWindow:
    """What is in the window, and what its keys and clicks do.

    Parameters
    ----------
    chart : Chart
    plotter : pyvista.Plotter
        Empty; it is filled.
    key : str, optional
        The only measurement to show.
    """

    def __init__(self, chart: "Chart", plotter: Any, key: str | None = None) -> None:
        self.chart = chart
        self.plotter = plotter
        scene = tapes_scene(chart)
        if key is not None:
            scene = replace(scene, tapes=tuple(line for line in scene.tapes if line.key == key))
        self.scene = scene
        self.views = body_views(scene, chart.atlas.axes)
        self.groups = tuple(dict.fromkeys(line.group for line in scene.tapes))
        # All at once would be a thicket.
        self.shown = 0
        self.tube_actors: dict[str, list[Any]] = {}
        self.number_actors: dict[str, list[Any]] = {}
        self.numbers_on = True
        self._fill(key)

    def look_from(self, side: str) -> None:
        """Turn the camera to one of `SIDES`."""
        set_camera(self.plotter, self.scene.surface, self.framed(side))
        self.plotter.render()

    def next_group(self) -> str:
        """Show the next group of measurements alone; after the last, all of them.

        Returns
        -------
        str
            Its name; empty for all.
        """
        self.shown = self.shown + 1 if self.shown + 1 < len(self.groups) else -1
        self._update()
        group = self.groups[self.shown] if self.shown >= 0 else ""
        say(self.plotter, group or "all measurements")
        self.plotter.render()
        return group

    def toggle_numbers(self) -> None:
        """Show or hide the numbers."""
        self.numbers_on = not self.numbers_on
        self._update()
        self.plotter.render()

    def pick(self, dataset: Any, cell: int) -> str:
        """Mark the measurement whose tape a cell belongs to, and describe it.

        Returns
        -------
        str
            What the window now says; empty if there is no tape there.
        """
        arrays = None if dataset is None or cell < 0 else dataset.GetCellData()
        if arrays is None or not arrays.HasArray(TAPE):
            return ""
        number = int(arrays.GetArray(TAPE).GetValue(cell))
        if number < 0:
            return ""
        key = self.scene.tapes[number].key
        lines = [line for line in self.scene.tapes if line.key == key]
        mesh = tape_mesh(lines, PICKED_WIDER * RADIUS * self.scene.size, np.zeros(3))
        actor = self.plotter.add_mesh(
            tube_mesh(mesh), color=PICKED, name="picked", pickable=False, reset_camera=False
        )
        if all(line.through_body for line in lines):
            _draw_before_all(actor)
        words: str = describe_measured(self.chart[key], self.chart.atlas.unit)
        say(self.plotter, f"{self.scene.numbers[key]}  {words}")
        return words

    def framed(self, side: str) -> View:
        """A view of a side with room for the texts above and below, whatever the window's shape."""
        width, height = self.plotter.window_size
        framed = self.views[side]
        return replace(framed, height=1.15 * max(framed.height, framed.width * height / width))

    def _fill(self, key: str | None) -> None:
        import pyvista

        plotter = self.plotter
        plotter.background_color = BACKGROUND
        plotter.add_light(pyvista.Light(position=LIGHT, light_type="camera light"))
        surface = surface_mesh(self.scene.surface)
        surface.point_data.active_normals = self.scene.surface.normals
        surface.cell_data[TAPE] = np.full(surface.n_cells, -1)
        plotter.add_mesh(surface, color=BODY, smooth_shading=True, ambient=AMBIENT, diffuse=DIFFUSE)
        for group in self.groups:
            rows = [row for row, line in enumerate(self.scene.tapes) if line.group == group]
            self.tube_actors[group] = self._add_tubes(rows)
            self.number_actors[group] = [self._add_numbers(rows)]
        title = self.chart.atlas.name
        plotter.add_text(title, position="upper_left", font_size=TEXT_SIZE + 2, color=INK)
        plotter.enable_anti_aliasing("msaa", multi_samples=8)
        self._update()
        set_camera(plotter, self.scene.surface, self.framed(self._first_side(key)))
        if key is not None:
            words = describe_measured(self.chart[key], self.chart.atlas.unit)
            say(self.plotter, f"{self.scene.numbers[key]}  {words}")
        elif self.groups:
            say(self.plotter, self.groups[self.shown])
        if not plotter.off_screen:
            listen(
                self.plotter,
                HELP,
                {"g": self.next_group, "n": self.toggle_numbers},
                self.look_from,
                self.pick,
            )

    def _first_side(self, key: str | None) -> str:
        """The side to begin with: of one measurement, that which sees most of it."""
        if key is None:
            return SIDES[0]
        sights = [sight(self.scene.surface, self.views[side]) for side in SIDES]
        return SIDES[best([measurement_seen(self.scene, key, seen) for seen in sights])]

    def _add_tubes(self, rows: Sequence[int]) -> list[Any]:
        """Tubes of some of the scene's tapes: those on the body, and those through it."""
        actors = []
        for through in (False, True):
            some = [row for row in rows if self.scene.tapes[row].through_body == through]
            if not some:
                continue
            lines = [self.scene.tapes[row] for row in some]
            mesh = tape_mesh(lines, RADIUS * self.scene.size, np.zeros(3))
            tubes = tube_mesh(mesh)
            tubes.point_data.active_normals = mesh.normals
            tubes.cell_data[TAPE] = np.array(some)[mesh.owner]
            actor = self.plotter.add_mesh(
                tubes,
                scalars=color_bytes(mesh.colors),
                rgb=True,
                smooth_shading=True,
                ambient=AMBIENT,
                diffuse=DIFFUSE,
            )
            if through:
                _draw_before_all(actor)
            actors.append(actor)
        return actors

    def _add_numbers(self, rows: Sequence[int]) -> Any:
        """Numbers of some of the scene's tapes, that face the camera and hide behind the body."""
        places, texts = [], []
        lift = NUMBER_LIFT * RADIUS * self.scene.size
        told = set()
        for line in (self.scene.tapes[row] for row in rows):
            if line.number not in told:
                told.add(line.number)
                some = number_places(line, lift)
                places.append(some)
                texts += [str(line.number)] * len(some)
        return self.plotter.add_point_labels(
            np.concatenate(places),
            texts,
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
            for actor in self.number_actors[group]:
                actor.visibility = on and self.numbers_on
        self.plotter.remove_actor("picked", render=False)


def number_places(line: TapeLine, lift: float) -> NDArray[np.float64]:
    """Where a tape's number stands, shape (k, 3), off the skin by a length."""
    closed = np.array_equal(line.points[0], line.points[-1])
    parts = (0.0,) if line.through_body else QUARTERS if closed else (0.5,)
    rows = [int(part * (len(line.points) - 1)) for part in parts]
    return np.asarray(line.points[rows] + lift * line.lift[rows])


def _draw_before_all(actor: Any) -> None:
    """Draw an actor as if it stood before everything else."""
    mapper = actor.mapper
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, BEFORE_ALL)


def build_tapes(chart: "Chart", key: str | None = None, *, off_screen: bool = False) -> TapeWindow:
    """The filled window, not yet shown."""
    import pyvista

    title = f"bodymeasure: {chart.atlas.name}" if chart.atlas.name else "bodymeasure"
    plotter = pyvista.Plotter(
        off_screen=off_screen, window_size=list(WINDOW_SIZE), title=title, lighting="none"
    )
    return TapeWindow(chart, plotter, key)
