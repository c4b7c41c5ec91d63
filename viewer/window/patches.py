"""The window of a survey: patches, their edges and all diagonals, to turn and to pick."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from bodymeasure.viewer.window.base import TEXT_SIZE, BodyWindow, owner
from bodymeasure.viewer.window.describe import describe
from bodymeasure.viewer.window.texts import INK

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.queries.outside import outward_sign_of_mesh
from bodymeasure.scene import SIDES, ColorScale, PathKind, body_scene
from bodymeasure.scene.colors import EDGE, NO_LENGTH, NOT_COMPARED, color_map
from bodymeasure.scene.diagonals.strokes import dashed
from bodymeasure.scene.drawing.vtk_meshes import curve_mesh, set_camera
from bodymeasure.scene.model import Polylines

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
# What the colors beside the scale mean, and where the window says so.
KEYS = (
    (PathKind.NO_LENGTH, (0.03, 0.10), NO_LENGTH),
    (PathKind.NOT_COMPARED, (0.03, 0.07), NOT_COMPARED),
)
# Layout of the color bar.
BAR: Mapping[str, Any] = {
    "n_labels": 0,
    "vertical": False,
    "color": INK,
    "title_font_size": 16,
    "label_font_size": 14,
    "position_x": 0.2,
    "position_y": 0.055,
    "width": 0.6,
    "height": 0.06,
}


class Window(BodyWindow):
    """The window of a survey.

    Parameters
    ----------
    survey : Survey
    off_screen : bool
        Whether nothing is to appear on a display.
    """

    ROOM = 1.22
    RAISED = 0.05

    def __init__(self, survey: "Survey", *, off_screen: bool = False) -> None:
        self.survey = survey
        self.scene = scene = body_scene(survey)
        surface = scene.surface
        on_surface = np.full(len(surface.triangles), -1)
        owners = {PATCH: surface.patch, DIAGONAL: on_surface}
        super().__init__(survey.atlas, scene, off_screen=off_screen, owners=owners)
        self._lift = LIFT * float(np.ptp(surface.points, axis=0).max())
        self._lift *= outward_sign_of_mesh(surface.points, surface.triangles)
        mesh, _ = curve_mesh(self._lifted(scene.edges))
        self.edge_actors = [
            self.plotter.add_mesh(mesh, color=EDGE, line_width=EDGE_WIDTH, pickable=False, **LINES)
        ]
        scale = ColorScale.of(scene.paths)
        found = [kind for kind in PathKind if (scene.paths.kind == kind).any()]
        self.path_actors = [self._add_paths(kind, scale) for kind in found]
        for kind, place, color in KEYS:
            if kind in found:
                self.plotter.add_text(
                    kind.value, position=place, viewport=True, font_size=TEXT_SIZE - 2, color=color
                )
        self.listen(
            ("click: what is there", "n: patch edges", "d: diagonals"),
            {"n": self.toggle_edges, "d": self.toggle_paths},
        )
        set_camera(self.plotter, surface, self.framed(SIDES[0]))

    def toggle_edges(self) -> None:
        """Show or hide the patches' edges."""
        self._toggle(self.edge_actors)

    def toggle_paths(self) -> None:
        """Show or hide the diagonals."""
        self._toggle(self.path_actors)

    def _toggle(self, actors: list[Any]) -> None:
        for actor in actors:
            actor.visibility = not actor.visibility
        self.plotter.render()

    def pick(self, dataset: Any, cell: int) -> str:
        """Mark the patch or diagonal that a cell belongs to, and describe it; see `BodyWindow`."""
        patch, diagonal = owner(dataset, cell, PATCH), owner(dataset, cell, DIAGONAL)
        if patch is None or diagonal is None:
            return ""
        words: str = describe(self.survey, patch, diagonal if diagonal >= 0 else None)
        paths = self.scene.paths
        picked = (paths.patch == patch) & ((diagonal < 0) | (paths.diagonal == diagonal))
        mesh, _ = curve_mesh(self._lifted(paths.lines, np.flatnonzero(picked), 2.0))
        self.plotter.add_mesh(
            mesh,
            color=PICKED,
            line_width=PICKED_WIDTH,
            **LINES,
            name="picked",
            pickable=False,
            reset_camera=False,
        )
        self.say(words)
        return words

    def _lifted(self, lines: Polylines, rows: Ints | None = None, times: float = 1.0) -> Array:
        """Some curves, lifted off the surface."""
        wanted = slice(None) if rows is None else rows
        return lines.points[wanted] + times * self._lift * lines.normals[wanted]

    def _add_paths(self, kind: PathKind, scale: ColorScale | None) -> Any:
        """Add the paths of one kind; those compared are colored on a scale, with its bar."""
        paths = self.scene.paths
        rows = np.flatnonzero(paths.kind == kind)
        points = self._lifted(paths.lines, rows)
        if kind is PathKind.NO_LENGTH:
            points = dashed(points)
        mesh, curve = curve_mesh(points)
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
                "scalar_bar_args": {"title": f"relative {kind.value}\n", **BAR},
            }
        return self.plotter.add_mesh(mesh, line_width=PATH_WIDTH, **LINES, **looks)
