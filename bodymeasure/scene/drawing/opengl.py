"""Pictures drawn off screen by VTK, all of them in one window."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.errors import MissingExtraError
from bodymeasure.mesh.tubes import Mesh
from bodymeasure.scene.colors import BACKGROUND
from bodymeasure.scene.drawing.picture import SAMPLES, Draw, Picture, finished
from bodymeasure.scene.drawing.vtk_meshes import set_camera
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
        from vtkmodules.vtkCommonCore import vtkLogger
    except ImportError:
        raise MissingExtraError("OpenGL rendering", "pyvista", "viewer") from None
    verbosity = vtkLogger.GetCurrentVerbosityCutoff()
    # Off screen, VTK first tries a display, and complains in the log if there is none.
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    drawn = _Session()
    try:
        yield drawn.draw
    finally:
        drawn.window.Finalize()
        vtkLogger.SetStderrVerbosity(verbosity)


class _Session:
    """A window off screen with one actor for the surface and one for tubes."""

    def __init__(self) -> None:
        # This makes windows those of OpenGL.
        import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
        from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

        self.window, self.renderer = vtkRenderWindow(), vtkRenderer()
        self.window.SetOffScreenRendering(True)
        # Edges are smooth by our own samples; OpenGL's on top would take most of the time.
        self.window.SetMultiSamples(0)
        self.window.AddRenderer(self.renderer)
        self.renderer.SetBackground(*BACKGROUND)
        self.surface: Surface | None = None
        self.actors = [_unlit(self.renderer) for _ in range(2)]
        # Tubes are closed, and their triangles face outwards: half of them are hidden.
        self.actors[1].GetProperty().BackfaceCullingOn()

    def draw(self, picture: Picture) -> NDArray[np.uint8]:
        """Draw a picture; the mesh of the surface is kept for the next one."""
        surface, tubes, view = picture.surface, picture.tubes, picture.view
        shown, over = (actor.GetMapper() for actor in self.actors)
        if self.surface is not surface:
            self.surface = surface
            shown.SetInputData(_triangles(surface))
        _set_colors(shown.GetInput(), glowing(*glow(surface, view)))
        self.actors[1].SetVisibility(len(tubes.triangles) > 0)
        if len(tubes.triangles):
            mesh = _triangles(tubes)
            _set_colors(mesh, shade(tubes.normals, view)[:, None] * tubes.colors)
            over.SetInputData(mesh)
        set_camera(self.renderer, surface, view)
        self.window.SetSize(*picture.samples)
        self.window.Render()
        depth = self._depth(picture) if picture.strokes else None
        return finished(picture, self._image(picture), depth)

    def _image(self, picture: Picture) -> NDArray[np.uint8]:
        """Read what the window shows, and average the samples of each pixel."""
        from PIL import Image
        from vtkmodules.vtkCommonCore import vtkUnsignedCharArray

        width, height = picture.samples
        found = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, width - 1, height - 1, 0, found, 0)
        samples = Image.fromarray(_support().vtk_to_numpy(found).reshape(height, width, 3))
        # OpenGL's first row is the lowest.
        return np.asarray(samples.reduce(SAMPLES))[::-1]

    def _depth(self, picture: Picture) -> Array:
        """Read the depth of what the samples show, as `View.project` defines it."""
        from vtkmodules.vtkCommonCore import vtkFloatArray

        width, height = picture.samples
        found = vtkFloatArray()
        self.window.GetZbufferData(0, 0, width - 1, height - 1, found)
        share = _support().vtk_to_numpy(found).reshape(height, width)[::-1].astype(np.float64)
        camera = self.renderer.GetActiveCamera()
        near, far = camera.GetClippingRange()
        depth = camera.GetDistance() - (near + share * (far - near))
        return np.where(share < 1.0, depth, -np.inf)


def _unlit(renderer: Any) -> Any:
    """Add an actor that shows the colors of its mesh as they are."""
    from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

    actor = vtkActor()
    actor.SetMapper(vtkPolyDataMapper())
    actor.GetProperty().LightingOff()
    renderer.AddActor(actor)
    return actor


def _triangles(mesh: Surface | Mesh) -> Any:
    """Make VTK's mesh of triangles; `vtk_meshes` makes pyvista's, whose import takes a second."""
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    points, cells, result = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(_support().numpy_to_vtk(mesh.points, deep=True))
    faces = mesh.triangles.astype(np.int64).ravel()
    cells.SetData(3, _support().numpy_to_vtkIdTypeArray(faces, deep=True))
    result.SetPoints(points)
    result.SetPolys(cells)
    return result


def _set_colors(mesh: Any, colors: Array) -> None:
    """Give a mesh colors in [0, 1], shape (n, 3), at its points."""
    values = np.round(255.0 * colors).astype(np.uint8)
    mesh.GetPointData().SetScalars(_support().numpy_to_vtk(values, deep=True))


def _support() -> Any:
    """Return VTK's functions for arrays of NumPy, which have no types."""
    from vtkmodules.util import numpy_support

    return numpy_support
