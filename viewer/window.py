"""The window: a body's surface, its patches' edges and all diagonals, to turn and to pick."""

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from bodymeasure.viewer.controls import INK, TEXT_SIZE, WINDOW_SIZE, listen, say
from bodymeasure.viewer.describe import describe

from bodymeasure.atlas.queries.outside import outward_sign_of_mesh
from bodymeasure.scene import (
    SIDES,
    ColorScale,
    PathKind,
    View,
    body_scene,
    body_views,
)
from bodymeasure.scene.colors import (
    BACKGROUND,
    BODY,
    EDGE,
    NO_LENGTH,
    NOT_COMPARED,
    color_map,
)
from bodymeasure.scene.drawing.opengl import set_camera, stroke_mesh, surface_mesh
from bodymeasure.scene.drawing.strokes import dashed
from bodymeasure.scene.lighting import AMBIENT, DIFFUSE, LIGHT

if TYPE_CHECKING:
    from bodymeasure.measure import Survey

# How far curves stand off the surface, as a fraction of the body's size: above the tessellation's
# distance from the curved surface, below a line's width.
LIFT = 0.001
# Drawn as tubes in their plain color, lines have no gaps where they bend.
LINES: Mapping[str, Any] = {"render_lines_as_tubes": True, "ambient": 1.0, "diffuse": 0.0}
EDGE_WIDTH = 1.2
PATH_WIDTH = 3.0
PICKED_WIDTH = 6.0
PICKED = (0.05, 0.05, 0.05)
# Arrays of the window's meshes that say what a cell belongs to; the diagonal is -1 on the surface.
PATCH = "patch"
DIAGONAL = "diagonal"
# What the colors beside the scale mean, and where that stands in the window.
KEYS = (
    (PathKind.NO_LENGTH, (0.03, 0.10), NO_LENGTH),
    (PathKind.NOT_COMPARED, (0.03, 0.07), NOT_COMPARED),
)
HELP = (
    "click: what is there    n: patch edges    d: diagonals    "
    "F1 front  F2 back  F3 left  F4 right    q: close"
)


class Window:
    """What is in the window, and what its keys and clicks do.

    Parameters
    ----------
    survey : Survey
    plotter : pyvista.Plotter
        Empty; it is filled.
    """

    def __init__(self, survey: "Survey", plotter: Any) -> None:
        self.survey = survey
        self.plotter = plotter
        self.scene = body_scene(survey)
        self.views = body_views(self.scene, survey.atlas.axes)
        self.edge_actors: list[Any] = []
        self.path_actors: list[Any] = []
        points = self.scene.surface.points
        self._lift = LIFT * float(np.ptp(points, axis=0).max())
        self._lift *= outward_sign_of_mesh(points, self.scene.surface.triangles)
        self._fill()

    def look_from(self, side: str) -> None:
        """Turn the camera to one of `SIDES`."""
        set_camera(self.plotter, self.scene.surface, self.framed(side))
        self.plotter.render()

    def toggle_edges(self) -> None:
        """Show or hide the patches' edges."""
        self._toggle(self.edge_actors)

    def toggle_paths(self) -> None:
        """Show or hide the diagonals."""
        self._toggle(self.path_actors)

    def pick(self, dataset: Any, cell: int) -> str:
        """Mark the patch that a cell of one of the window's meshes lies on, and describe it.

        Returns
        -------
        str
            What the window now says; empty if there is nothing there.
        """
        arrays = None if dataset is None or cell < 0 else dataset.GetCellData()
        if arrays is None or not arrays.HasArray(PATCH):
            return ""
        patch = int(arrays.GetArray(PATCH).GetValue(cell))
        diagonal = int(arrays.GetArray(DIAGONAL).GetValue(cell))
        words: str = describe(self.survey, patch, diagonal if diagonal >= 0 else None)
        rows = np.flatnonzero(self.scene.paths.patch == patch)
        if diagonal >= 0:
            rows = rows[self.scene.paths.diagonal[rows] == diagonal]
        lines = self.scene.paths.lines
        mesh, _ = stroke_mesh(lines.points[rows] + 2 * self._lift * lines.normals[rows])
        self.plotter.add_mesh(
            mesh,
            color=PICKED,
            line_width=PICKED_WIDTH,
            **LINES,
            name="picked",
            pickable=False,
            reset_camera=False,
        )
        say(self.plotter, words)
        return words

    def _fill(self) -> None:
        plotter = self.plotter
        import pyvista

        plotter.background_color = BACKGROUND
        plotter.add_light(pyvista.Light(position=LIGHT, light_type="camera light"))
        surface = surface_mesh(self.scene.surface)
        surface.point_data.active_normals = self.scene.surface.normals
        surface.cell_data[PATCH] = self.scene.surface.patch
        surface.cell_data[DIAGONAL] = np.full(surface.n_cells, -1)
        plotter.add_mesh(surface, color=BODY, smooth_shading=True, ambient=AMBIENT, diffuse=DIFFUSE)
        lines = self.scene.edges
        mesh, _ = stroke_mesh(lines.points + self._lift * lines.normals)
        self.edge_actors.append(
            plotter.add_mesh(mesh, color=EDGE, line_width=EDGE_WIDTH, pickable=False, **LINES)
        )
        scale = ColorScale.of(self.scene.paths)
        for kind in PathKind:
            self._add_paths(kind, scale)
        for kind, place, color in KEYS:
            if (self.scene.paths.kind == kind).any():
                plotter.add_text(
                    kind.value, position=place, viewport=True, font_size=TEXT_SIZE - 2, color=color
                )
        atlas = self.survey.atlas
        plotter.add_text(atlas.name, position="upper_left", font_size=TEXT_SIZE + 2, color=INK)
        plotter.enable_anti_aliasing("msaa", multi_samples=8)
        set_camera(plotter, self.scene.surface, self.framed(SIDES[0]))
        if not plotter.off_screen:
            listen(
                self.plotter,
                HELP,
                {"n": self.toggle_edges, "d": self.toggle_paths},
                self.look_from,
                self.pick,
            )

    def _add_paths(self, kind: PathKind, scale: ColorScale | None) -> None:
        """Add the paths of one kind; those compared are colored on a scale, with its bar."""
        paths = self.scene.paths
        rows = np.flatnonzero(paths.kind == kind)
        if len(rows) == 0:
            return
        points = paths.lines.points[rows] + self._lift * paths.lines.normals[rows]
        if kind is PathKind.NO_LENGTH:
            points = dashed(points)
        mesh, curve = stroke_mesh(points)
        mesh.cell_data[PATCH] = paths.patch[rows][curve]
        mesh.cell_data[DIAGONAL] = paths.diagonal[rows][curve]
        looks: dict[str, Any] = {"color": NO_LENGTH if kind is PathKind.NO_LENGTH else NOT_COMPARED}
        if kind is PathKind.COMPARED and scale is not None:
            low, high = np.log10([scale.low, scale.high])
            from matplotlib.colors import ListedColormap

            powers = np.arange(round(low), round(high) + 1)
            looks = {
                "scalars": np.log10(np.maximum(paths.value[rows][curve], scale.low)),
                "clim": (low, high),
                "cmap": ListedColormap(color_map(np.linspace(0.0, 1.0, 256))),
                "annotations": {float(power): f"1e{power}" for power in powers},
                "scalar_bar_args": {
                    "title": f"relative {kind.value}\n",
                    "n_labels": 0,
                    "vertical": False,
                    "color": INK,
                    "title_font_size": 16,
                    "label_font_size": 14,
                    "position_x": 0.2,
                    "position_y": 0.055,
                    "width": 0.6,
                    "height": 0.06,
                },
            }
        actor = self.plotter.add_mesh(mesh, line_width=PATH_WIDTH, **LINES, **looks)
        self.path_actors.append(actor)

    def _toggle(self, actors: list[Any]) -> None:
        for actor in actors:
            actor.visibility = not actor.visibility
        self.plotter.render()

    def framed(self, side: str) -> View:
        """A view of a side with room for the texts above and below, whatever the window's shape."""
        width, height = self.plotter.window_size
        framed = self.views[side]
        height = 1.22 * max(framed.height, framed.width * height / width)
        center = framed.center - 0.05 * height * framed.up
        return replace(framed, center=center, height=height)


def build(survey: "Survey", *, off_screen: bool = False) -> Window:
    """The filled window, not yet shown."""
    import pyvista

    title = f"bodymeasure: {survey.atlas.name}" if survey.atlas.name else "bodymeasure"
    plotter = pyvista.Plotter(
        off_screen=off_screen, window_size=list(WINDOW_SIZE), title=title, lighting="none"
    )
    return Window(survey, plotter)
