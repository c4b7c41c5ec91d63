"""Pictures drawn off screen by pyvista, all of them by one plotter."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.errors import MissingExtraError
from bodymeasure.scene.colors import BACKGROUND
from bodymeasure.scene.drawing.picture import SAMPLES, Draw, Picture, finished
from bodymeasure.scene.drawing.vtk_meshes import set_camera, set_colors, triangle_mesh
from bodymeasure.scene.lighting import glow, glowing, shade
from bodymeasure.scene.model import Surface


@contextmanager
def session() -> Iterator[Draw]:
    """Draw many pictures.

    Yields
    ------
    Draw

    Raises
    ------
    MissingExtraError
        If pyvista is not installed.
    """
    try:
        import pyvista
    except ImportError:
        raise MissingExtraError("OpenGL rendering", "pyvista", "viewer") from None
    # Off screen, VTK first tries a display, and complains in the log if there is none.
    with pyvista.vtk_verbosity("off"):
        plotter: Any = pyvista.Plotter(off_screen=True, lighting="none")
        plotter.background_color = BACKGROUND
        # Edges are smooth by our own samples; OpenGL's on top would take most of the time.
        plotter.disable_anti_aliasing()
        try:
            yield _Session(plotter).draw
        finally:
            plotter.close()


class _Session:
    """A plotter with one actor for the surface and one for tubes."""

    def __init__(self, plotter: Any) -> None:
        self.plotter = plotter
        self.window = plotter.render_window
        self.surface: Surface | None = None
        self.actors = [_unlit(plotter) for _ in range(2)]
        # Tubes are closed, and their triangles face outwards: half of them are hidden.
        self.actors[1].prop.culling = "back"

    def draw(self, picture: Picture) -> NDArray[np.uint8]:
        """Draw a picture; the mesh of the surface is kept for the next one."""
        surface, tubes, view = picture.surface, picture.tubes, picture.view
        shown, over = self.actors
        if self.surface is not surface:
            self.surface = surface
            shown.mapper.SetInputData(triangle_mesh(surface))
        set_colors(shown.mapper.GetInput(), glowing(*glow(surface, view)))
        over.SetVisibility(len(tubes.triangles) > 0)
        if len(tubes.triangles):
            mesh = triangle_mesh(tubes)
            set_colors(mesh, shade(tubes.normals, view)[:, None] * tubes.colors)
            over.mapper.SetInputData(mesh)
        set_camera(self.plotter, surface, view)
        self.window.SetSize(*picture.samples)
        self.window.Render()
        depth = self._depth(picture) if picture.strokes else None
        return finished(picture, self._image(picture), depth)

    def _image(self, picture: Picture) -> NDArray[np.uint8]:
        """Read what the window shows, and average the samples of each pixel."""
        from PIL import Image
        from pyvista import convert_array
        from vtkmodules.vtkCommonCore import vtkUnsignedCharArray

        width, height = picture.samples
        found = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, width - 1, height - 1, 0, found, 0)
        samples = Image.fromarray(convert_array(found).reshape(height, width, 3))
        # OpenGL's first row is the lowest.
        return np.asarray(samples.reduce(SAMPLES))[::-1]

    def _depth(self, picture: Picture) -> Array:
        """Read the depth of what the samples show, as `View.project` defines it."""
        from pyvista import convert_array
        from vtkmodules.vtkCommonCore import vtkFloatArray

        width, height = picture.samples
        found = vtkFloatArray()
        self.window.GetZbufferData(0, 0, width - 1, height - 1, found)
        share = convert_array(found).reshape(height, width)[::-1].astype(np.float64)
        camera = self.plotter.camera
        near, far = camera.GetClippingRange()
        depth = camera.GetDistance() - (near + share * (far - near))
        return np.where(share < 1.0, depth, -np.inf)


def _unlit(plotter: Any) -> Any:
    """Add an actor that shows the colors of its mesh as they are."""
    import pyvista

    actor = pyvista.Actor(mapper=pyvista.DataSetMapper())
    actor.prop.lighting = False
    plotter.add_actor(actor, reset_camera=False, render=False)
    return actor
