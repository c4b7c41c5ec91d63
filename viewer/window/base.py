"""The window of a body: its surface and light, the camera, keys, clicks and words."""

import textwrap
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from bodymeasure._typing import Ints
from bodymeasure.atlas import Atlas
from bodymeasure.scene import SIDES, BodyScene, TapeScene, View, body_views
from bodymeasure.scene.colors import BACKGROUND, BODY
from bodymeasure.scene.drawing.vtk_meshes import set_camera, triangle_mesh
from bodymeasure.scene.lighting import AMBIENT, DIFFUSE, LIGHT

WINDOW_SIZE = (1000, 1100)
INK = (0.15, 0.16, 0.17)
TEXT_SIZE = 10
TEXT_COLUMNS = 60
# The distance within which a click picks a thing, as a fraction of the window's diagonal.
PICK_TOLERANCE = 0.003
# Surfaces and tubes are lit as in the pictures.
LIT: Mapping[str, Any] = {"smooth_shading": True, "ambient": AMBIENT, "diffuse": DIFFUSE}
TURNS = "F1 front  F2 back  F3 left  F4 right    q: close"


class BodyWindow:
    """A window that shows a body; its subclasses add what is measured on it.

    Parameters
    ----------
    atlas : Atlas
    scene : BodyScene or TapeScene
    off_screen : bool
        Whether nothing is to appear on a display.
    owners : mapping of str to ndarray
        Arrays over the triangles of the surface, by name, which identify what is picked there.

    Attributes
    ----------
    plotter : pyvista.Plotter
    """

    # Height of the view around the body, as a multiple of the body's, and how far the body stands
    # above the middle, as a fraction of the view's height: room for the texts above and below.
    ROOM = 1.15
    RAISED = 0.0

    def __init__(
        self,
        atlas: Atlas,
        scene: BodyScene | TapeScene,
        *,
        off_screen: bool,
        owners: Mapping[str, Ints],
    ) -> None:
        import pyvista

        title = f"bodymeasure: {atlas.name}" if atlas.name else "bodymeasure"
        plotter: Any = pyvista.Plotter(
            off_screen=off_screen, window_size=list(WINDOW_SIZE), title=title, lighting="none"
        )
        self.plotter = plotter
        self.surface = scene.surface
        self.views = body_views(scene, atlas.axes)
        plotter.background_color = BACKGROUND
        plotter.add_light(pyvista.Light(position=LIGHT, light_type="camera light"))
        mesh = triangle_mesh(scene.surface)
        mesh.point_data.active_normals = scene.surface.normals
        for name, numbers in owners.items():
            mesh.cell_data[name] = numbers
        plotter.add_mesh(mesh, color=BODY, **LIT)
        plotter.add_text(atlas.name, position="upper_left", font_size=TEXT_SIZE + 2, color=INK)
        plotter.enable_anti_aliasing("msaa", multi_samples=8)

    def framed(self, side: str) -> View:
        """The view of one of `SIDES` that leaves room for the texts, in any shape of window."""
        width, height = self.plotter.window_size
        view = self.views[side]
        extent = self.ROOM * max(view.height, view.width * height / width)
        return replace(view, center=view.center - self.RAISED * extent * view.up, height=extent)

    def look_from(self, side: str) -> None:
        """Turn the camera to one of `SIDES`."""
        set_camera(self.plotter, self.surface, self.framed(side))
        self.plotter.render()

    def pick(self, dataset: Any, cell: int) -> str:
        """Mark what a cell of one of the window's meshes belongs to, and describe it.

        Returns
        -------
        str
            The words that the window now shows; empty if there is nothing at that place.
        """
        raise NotImplementedError

    def say(self, words: str) -> None:
        """Show words in the upper right corner, in place of those that were there."""
        lines = [line for part in words.splitlines() for line in textwrap.wrap(part, TEXT_COLUMNS)]
        self.plotter.add_text(
            "\n".join(lines),
            position="upper_right",
            font_size=TEXT_SIZE,
            color=INK,
            name="words",
            render=not self.plotter.off_screen,
        )

    def listen(self, help_text: str, keys: Mapping[str, Callable[[], object]]) -> None:
        """Let keys and clicks act if there is a display, and name the keys in a line at the bottom.

        Parameters
        ----------
        help_text : str
        keys : mapping of str to callable
            The action of each key, beside F1 to F4, which turn to the four sides.
        """
        plotter = self.plotter
        if plotter.off_screen:
            return
        plotter.add_text(
            f"{help_text}    {TURNS}", position=(10, 10), font_size=TEXT_SIZE - 2, color=INK
        )
        for key, action in keys.items():
            plotter.add_key_event(key, action)
        for number, side in enumerate(SIDES, start=1):
            plotter.add_key_event(f"F{number}", lambda side=side: self.look_from(side))
        plotter.enable_surface_point_picking(
            lambda _, picker: self.pick(picker.GetDataSet(), picker.GetCellId()),
            show_message=False,
            show_point=False,
            left_clicking=True,
            use_picker=True,
            tolerance=PICK_TOLERANCE,
        )


def owner(dataset: Any, cell: int, name: str) -> int | None:
    """The number that a cell of a mesh holds in one of the mesh's arrays; None without one."""
    arrays = None if dataset is None or cell < 0 else dataset.GetCellData()
    if arrays is None or not arrays.HasArray(name):
        return None
    return int(arrays.GetArray(name).GetValue(cell))
