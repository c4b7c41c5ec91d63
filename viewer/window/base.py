"""The window of a body: its surface and light, the camera, keys, clicks and words."""

import textwrap
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from bodymeasure.viewer.window.clicks import listen_for_clicks, picked_at
from bodymeasure.viewer.window.tape_tool import START, TapeTool
from bodymeasure.viewer.window.texts import INK, LINE, add_lines, help_lines

from bodymeasure._typing import Ints
from bodymeasure.atlas import Atlas
from bodymeasure.scene import SIDES, BodyScene, TapeScene, View, body_views
from bodymeasure.scene.colors import BACKGROUND, BODY
from bodymeasure.scene.drawing.vtk_meshes import set_camera, triangle_mesh
from bodymeasure.scene.lighting import AMBIENT, DIFFUSE, LIGHT

WINDOW_SIZE = (1000, 1100)
# Room that a window leaves on the screen for its own frame and for the desktop's bars, in pixels.
SCREEN_ROOM = 90
TEXT_SIZE = 10
TEXT_COLUMNS = 60
# Surfaces and tubes are lit as in the pictures.
LIT: Mapping[str, Any] = {"smooth_shading": True, "ambient": AMBIENT, "diffuse": DIFFUSE}
HELP = ("t: tape", "z: take the tape away", "F1 front  F2 back  F3 left  F4 right", "q: close")


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
    tool : TapeTool
    help : tuple of str
        What the line at the bottom names; nothing where nobody can press a key.
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
        self.help: tuple[str, ...] = ()
        self._fitted: tuple[int, ...] = ()
        if not off_screen:
            plotter.window_size = list(_fitting(plotter))
        self.views = body_views(scene, atlas.axes)
        plotter.background_color = BACKGROUND
        plotter.add_light(pyvista.Light(position=LIGHT, light_type="camera light"))
        mesh = triangle_mesh(scene.surface)
        mesh.point_data.active_normals = scene.surface.normals
        for name, numbers in owners.items():
            mesh.cell_data[name] = numbers
        body = plotter.add_mesh(mesh, color=BODY, **LIT)
        self.tool = TapeTool(plotter, body, atlas, scene.surface)
        plotter.add_text(atlas.name, position="upper_left", font_size=TEXT_SIZE + 2, color=INK)
        plotter.enable_anti_aliasing("msaa", multi_samples=8)

    def framed(self, side: str) -> View:
        """The view of one of `SIDES` that leaves room for the texts, in any shape of window."""
        width, height = self.plotter.window_size
        view = self.views[side]
        extent = self.ROOM * max(view.height, view.width * height / width)
        below = LINE * len(self._help_lines()) / height
        extent /= 1.0 - below
        raised = self.RAISED + below / 2.0
        return replace(view, center=view.center - raised * extent * view.up, height=extent)

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

    def toggle_tape_tool(self) -> None:
        """Take the tape tool up or put it down; meanwhile clicks are ends of tapes."""
        self.tool.toggle()
        self.say(START if self.tool.on else "")
        self.plotter.render()

    def undo_tape(self) -> None:
        """Take the last tape away that was measured by clicking."""
        self.say(self.tool.undo())
        self.plotter.render()

    def clicked(self, x: float, y: float) -> str:
        """Act on a click at a place of the window, and return the words that are shown then."""
        if self.tool.on:
            words: str = self.tool.click(x, y)
            self.say(words)
            self.plotter.render()
            return words
        picker = picked_at(self.plotter, x, y)
        return self.pick(picker.GetDataSet(), picker.GetCellId())

    def listen(self, entries: Sequence[str], keys: Mapping[str, Callable[[], object]]) -> None:
        """Let keys and clicks act, and name the keys at the bottom if there is a display.

        Parameters
        ----------
        entries : sequence of str
            What clicks and keys do, beside what they do in every window.
        keys : mapping of str to callable
            The action of each key, beside those of every window.
        """
        plotter = self.plotter
        listen_for_clicks(plotter, self.clicked)
        plotter.iren.add_observer("MouseMoveEvent", self._moved)
        own = {"t": self.toggle_tape_tool, "z": self.undo_tape}
        for key, action in {**own, **keys}.items():
            plotter.add_key_event(key, action)
        for number, side in enumerate(SIDES, start=1):
            plotter.add_key_event(f"F{number}", lambda side=side: self.look_from(side))
        if not plotter.off_screen:
            self.show_help((*entries, *HELP))
            plotter.iren.add_observer("ConfigureEvent", self._resized)

    def show_help(self, entries: Sequence[str]) -> None:
        """Name clicks and keys in as many lines at the bottom as the window's width asks for."""
        self.help = tuple(entries)
        add_lines(self.plotter, self._help_lines(), name="help")

    def fit_texts(self) -> None:
        """Distribute the texts over the window again, whose size has changed."""
        self.show_help(self.help)

    def _resized(self, *_event: Any) -> None:
        size = tuple(self.plotter.window_size)
        if size != self._fitted:
            self._fitted = size
            self.fit_texts()

    def _help_lines(self) -> list[str]:
        lines: list[str] = help_lines(self.help, self.plotter.window_size[0])
        return lines

    def _moved(self, *_event: Any) -> None:
        self.tool.hover(*self.plotter.iren.get_event_position())


def _fitting(plotter: Any) -> tuple[int, int]:
    """The size of a window that fits the screen."""
    screen = plotter.render_window.GetScreenSize()
    width, height = (
        min(own, size - SCREEN_ROOM) if size > 2 * SCREEN_ROOM else own
        for own, size in zip(WINDOW_SIZE, screen, strict=True)
    )
    return width, height


def owner(dataset: Any, cell: int, name: str) -> int | None:
    """The number that a cell of a mesh holds in one of the mesh's arrays; None without one."""
    arrays = None if dataset is None or cell < 0 else dataset.GetCellData()
    if arrays is None or not arrays.HasArray(name):
        return None
    return int(arrays.GetArray(name).GetValue(cell))
