"""Pictures drawn off screen by pyvista."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure.errors import MissingExtraError
from bodymeasure.scene.camera import View
from bodymeasure.scene.colors import BACKGROUND, ColorScale
from bodymeasure.scene.drawing.samples import SAMPLES, downsampled
from bodymeasure.scene.drawing.strokes import Style, runs, strokes
from bodymeasure.scene.lighting import glow, glowing
from bodymeasure.scene.model import BodyScene, Surface


def render(
    scene: BodyScene, view: View, size: tuple[int, int], scale: ColorScale | None, style: Style
) -> NDArray[np.uint8]:
    """A picture of a scene; see `software.render`.

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
        window_size = [SAMPLES * size[0], SAMPLES * size[1]]
        plotter = pyvista.Plotter(off_screen=True, window_size=window_size, lighting="none")
        try:
            _fill(plotter, scene, view, scale, style)
            image = np.asarray(plotter.screenshot(None, return_img=True))
        finally:
            plotter.close()
    return averaged(image[..., :3])


def _fill(
    plotter: Any, scene: BodyScene, view: View, scale: ColorScale | None, style: Style
) -> None:
    plotter.background_color = BACKGROUND
    colors = glowing(*glow(scene.surface, view))
    mesh = surface_mesh(scene.surface)
    plotter.add_mesh(mesh, scalars=color_bytes(colors), rgb=True, lighting=False)
    for stroke in strokes(scene, view, scale, style):
        mesh, curve = stroke_mesh(stroke.points)
        if mesh.n_points:
            plotter.add_mesh(
                mesh,
                scalars=color_bytes(stroke.colors[curve]),
                rgb=True,
                lighting=False,
                line_width=SAMPLES * stroke.width,
            )
    set_camera(plotter, scene.surface, view)


def averaged(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """A picture drawn with `SAMPLES` times as many pixels either way, in the finished size."""
    mean = downsampled(image.astype(np.float32))
    return np.asarray(np.round(mean), dtype=np.uint8)


def surface_mesh(surface: Surface) -> Any:
    """A surface as pyvista's PolyData."""
    import pyvista

    faces: Any = surface.triangles
    return pyvista.PolyData.from_regular_faces(surface.points, faces)


def stroke_mesh(curves: NDArray[np.float64]) -> tuple[Any, NDArray[np.int64]]:
    """Curves, shape (n, k, 3), as pyvista's PolyData; and which of them each of its lines is of."""
    import pyvista

    pieces, curve = [], []
    for number, points in enumerate(curves):
        for piece in runs(points):
            pieces.append(piece)
            curve.append(number)
    mesh = pyvista.PolyData()
    if pieces:
        ends = np.cumsum([len(piece) for piece in pieces])
        cells = [
            np.concatenate([[len(piece)], np.arange(end - len(piece), end)])
            for piece, end in zip(pieces, ends, strict=True)
        ]
        mesh = pyvista.PolyData(np.concatenate(pieces), lines=np.concatenate(cells))
    return mesh, np.array(curve, dtype=np.int64)


def set_camera(plotter: Any, surface: Surface, view: View) -> None:
    """Make a plotter look at a surface as a view says."""
    camera = plotter.camera
    distance = 2.0 * float(np.ptp(surface.points, axis=0).max()) + view.height
    camera.enable_parallel_projection()
    camera.focal_point = view.center
    camera.position = view.center + distance * view.towards
    camera.up = view.up
    camera.parallel_scale = view.height / 2
    plotter.reset_camera_clipping_range()


def color_bytes(colors: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Colors in [0, 1] in 0 to 255."""
    return np.asarray(np.round(255.0 * colors), dtype=np.uint8)
