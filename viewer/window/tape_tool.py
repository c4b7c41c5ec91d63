"""The tape tool of a window: two clicks on the body, and the tape between them with its length."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from bodymeasure.viewer.window.clicks import STILL, picked_at
from bodymeasure.viewer.window.describe import describe_path, length_words
from bodymeasure.viewer.window.places import landmark_at, landmark_places, place_on

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.normals import unit_normals
from bodymeasure.atlas.queries.outside import outward_sign_of_mesh
from bodymeasure.errors import BodymeasureError
from bodymeasure.geodesic import AtlasPath, geodesic_between
from bodymeasure.mesh.tubes import ball, joined, tube
from bodymeasure.scene.drawing.vtk_meshes import set_colors, triangle_mesh
from bodymeasure.scene.model import Surface

# Okabe and Ito's bluish green, which no tape of a chart has.
COLOR = (0.0, 0.62, 0.45)
# Radius of a tape and of the balls at its ends, and the height of its middle above the skin, as
# fractions of the body's size and of the radius.
RADIUS = 0.0022
BALL = 2.0
LIFT = 0.6
# Points along a tape: on a body, one every few millimeters.
POINTS = 300
LABEL_SIZE = 14
START = "click where the tape is to start"
END = "click where the tape is to end"
SLIP = "that is where the tape starts; click its end somewhere else"
BESIDE = "there is no body; click on it"


@dataclass(frozen=True)
class PickedEnd:
    """An end of a tape: the point, its position, and what the words call it."""

    point: AtlasPoint
    position: Array
    name: str


class TapeTool:
    """Tapes that are measured by clicking, in a plotter that shows an atlas.

    Parameters
    ----------
    plotter : pyvista.Plotter
    body : pyvista.Actor
        The body's surface in the plotter.
    atlas : Atlas
    surface : Surface
        The tessellation that `body` shows.

    Attributes
    ----------
    on : bool
        Whether clicks are taken for ends of tapes.
    tapes : list of AtlasPath
        The tapes that were measured, in their order.
    """

    def __init__(self, plotter: Any, body: Any, atlas: Atlas, surface: Surface) -> None:
        self.plotter, self.body, self.atlas, self.surface = plotter, body, atlas, surface
        self.on = False
        self.tapes: list[AtlasPath] = []
        self._start: PickedEnd | None = None
        self._hovered: str | None = None
        self._landmarks = landmark_places(atlas)
        self._size = float(np.ptp(surface.points, axis=0).max())
        self._sign = outward_sign_of_mesh(surface.points, surface.triangles)

    def toggle(self) -> str:
        """Take the tool up, or put it down and drop a tape without an end; return what to do."""
        self.on = not self.on
        self._drop_start()
        self._show_landmark(None)
        return START if self.on else ""

    def click(self, x: float, y: float) -> str:
        """Take the point at a place of the window as the next end of a tape.

        Returns
        -------
        str
            What it is, or, of the second end, the tape in words, or why there is none.
        """
        picked = self._end_at(x, y)
        if picked is None:
            return BESIDE
        if self._start is None:
            self._start = picked
            self._show_ball(picked.position)
            return f"from {picked.name}; {END}"
        start = self._start
        straight = float(np.linalg.norm(picked.position - start.position))
        if straight < STILL * self._pixel():
            return SLIP
        self._drop_start()
        try:
            path = geodesic_between(self.atlas, start.point, picked.point)
        except BodymeasureError as error:
            return f"from {start.name} to {picked.name}: no length.\n{error}"
        self.tapes.append(path)
        self._draw(path)
        title = f"tape {len(self.tapes)}: {start.name} to {picked.name}"
        return f"{title}\n{describe_path(path, straight)}"

    def hover(self, x: float, y: float) -> str | None:
        """Show which landmark a click at a place would take; return its name."""
        if not self.on:
            return None
        picker = picked_at(self.plotter, x, y, self.body)
        skin = np.array(picker.GetPickPosition()) if picker.GetCellId() >= 0 else None
        name: str | None = landmark_at(self.plotter, self._landmarks, x, y, skin)
        self._show_landmark(name)
        return name

    def undo(self) -> str:
        """Take the last tape away, or the start of one; return what is said about it."""
        if self._start is not None:
            self._drop_start()
            return START
        if not self.tapes:
            return "there is no tape to take away"
        number = len(self.tapes)
        self.tapes.pop()
        for part in ("tube", "label"):
            self.plotter.remove_actor(f"tape {number} {part}", render=False)
        return f"tape {number} was taken away"

    def _end_at(self, x: float, y: float) -> PickedEnd | None:
        picker = picked_at(self.plotter, x, y, self.body)
        if picker.GetCellId() < 0:
            return None
        skin = np.array(picker.GetPickPosition())
        name = landmark_at(self.plotter, self._landmarks, x, y, skin)
        if name is not None:
            return PickedEnd(self.atlas.landmarks[name], self._landmarks[name], name)
        point = place_on(self.surface, picker.GetCellId(), skin)
        # The point of the smooth surface, which the triangle that was hit is beside.
        patch = self.atlas.patch_names[point.patch]
        return PickedEnd(point, self.atlas.position(point), f"a point on {patch}")

    def _pixel(self) -> float:
        return 2.0 * float(self.plotter.camera.parallel_scale) / float(self.plotter.window_size[1])

    def _draw(self, path: AtlasPath) -> None:
        times = np.linspace(0.0, 1.0, POINTS)
        patch, parameters = path.path(times)
        nets = self.atlas.control_points[patch]
        normals = self._sign * unit_normals(nets, parameters[:, None])[:, 0]
        radius = RADIUS * self._size
        points = path.position(times) + LIFT * radius * normals
        color = np.array(COLOR)
        parts = [tube(points, radius, np.tile(color, (POINTS, 1)))]
        parts += [ball(points[end], BALL * radius, color, 0) for end in (0, -1)]
        name = f"tape {len(self.tapes)}"
        self._add(joined(parts), f"{name} tube")
        self.plotter.add_point_labels(
            points[POINTS // 2][None],
            [length_words(path.length, self.atlas.unit)],
            name=f"{name} label",
            font_size=LABEL_SIZE,
            text_color="black",
            shape_color="white",
            shape_opacity=0.85,
            show_points=False,
            always_visible=True,
            pickable=False,
            reset_camera=False,
            render=False,
        )

    def _show_ball(self, position: Array) -> None:
        self._add(ball(position, BALL * RADIUS * self._size, np.array(COLOR), 0), "tape start")

    def _drop_start(self) -> None:
        self._start = None
        self.plotter.remove_actor("tape start", render=False)

    def _add(self, mesh: Any, name: str) -> None:
        shown = triangle_mesh(mesh)
        shown.point_data.active_normals = mesh.normals
        set_colors(shown, mesh.colors)
        self.plotter.add_mesh(
            shown, rgb=True, name=name, pickable=False, reset_camera=False, render=False
        )

    def _show_landmark(self, name: str | None) -> None:
        if name == self._hovered:
            return
        self._hovered = name
        if name is None:
            self.plotter.remove_actor("landmark", render=True)
            return
        self.plotter.add_point_labels(
            self._landmarks[name][None],
            [name],
            name="landmark",
            font_size=LABEL_SIZE,
            text_color="black",
            shape_color="white",
            shape_opacity=0.85,
            point_size=12,
            point_color=COLOR,
            render_points_as_spheres=True,
            always_visible=True,
            pickable=False,
            reset_camera=False,
        )
