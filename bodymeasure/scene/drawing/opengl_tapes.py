"""Pictures of tapes drawn off screen by pyvista."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure.errors import MissingExtraError
from bodymeasure.mesh.tubes import Mesh
from bodymeasure.scene.camera import View
from bodymeasure.scene.colors import BACKGROUND
from bodymeasure.scene.drawing.opengl import averaged, color_bytes, set_camera, surface_mesh
from bodymeasure.scene.drawing.samples import SAMPLES
from bodymeasure.scene.drawing.software_tapes import Drawing
from bodymeasure.scene.lighting import glow, glowing, shade
from bodymeasure.scene.model import Surface


@contextmanager
def session(surface: Surface) -> Iterator[Drawing]:
    """Draw many pictures of one body, with one plotter; see `software_tapes.session`.

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
        # Edges are smooth by our own samples; OpenGL's on top take most of the time.
        plotter.disable_anti_aliasing()
        body = surface_mesh(surface)
        body.point_data["colors"] = np.zeros(surface.points.shape, dtype=np.uint8)
        plotter.add_mesh(body, scalars="colors", rgb=True, lighting=False, render=False)

        def draw(view: View, size: tuple[int, int], mesh: Mesh) -> NDArray[np.uint8]:
            # Setting it draws, even where it stays the same.
            wanted = [SAMPLES * size[0], SAMPLES * size[1]]
            if plotter.window_size != wanted:
                plotter.window_size = wanted
            body.point_data["colors"] = color_bytes(glowing(*glow(surface, view)))
            plotter.remove_actor("tapes", render=False)
            if len(mesh.triangles):
                plotter.add_mesh(
                    tube_mesh(mesh),
                    scalars=color_bytes(shade(mesh.normals, view)[:, None] * mesh.colors),
                    rgb=True,
                    lighting=False,
                    name="tapes",
                    reset_camera=False,
                    render=False,
                )
            set_camera(plotter, surface, view)
            plotter.render()
            image = np.asarray(plotter.screenshot(None, return_img=True))
            return averaged(image[..., :3])

        try:
            yield draw
        finally:
            plotter.close()


def tube_mesh(mesh: Mesh) -> Any:
    """Tubes as pyvista's PolyData."""
    import pyvista

    faces: Any = mesh.triangles
    return pyvista.PolyData.from_regular_faces(mesh.points, faces)
