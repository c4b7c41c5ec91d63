"""Meshes and the camera of pyvista, for pictures and windows."""

from typing import Any

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.mesh.tubes import Mesh
from bodymeasure.scene.camera import View
from bodymeasure.scene.drawing.picture import runs
from bodymeasure.scene.model import Surface

# Name of the array of colors at the points of a mesh.
COLORS = "colors"


def triangle_mesh(mesh: Surface | Mesh) -> Any:
    """Make pyvista's PolyData of triangles, without normals."""
    import pyvista

    faces: Any = mesh.triangles
    return pyvista.PolyData.from_regular_faces(mesh.points, faces)


def curve_mesh(curves: Array) -> tuple[Any, Ints]:
    """Make pyvista's PolyData of curves, shape (n, k, 3), that have gaps where they are NaN.

    Returns
    -------
    mesh : pyvista.PolyData
        One line for each piece of a curve.
    curve : ndarray of int
        Which curve each of its lines is part of.
    """
    import pyvista

    found = runs(np.isfinite(curves[..., 0]))
    count = found.end - found.first
    offsets = np.concatenate([[0], np.cumsum(count)])
    within = np.arange(offsets[-1]) - np.repeat(offsets[:-1] - found.first, count)
    points = curves[np.repeat(found.curve, count), within]
    mesh = pyvista.PolyData()
    if len(points):
        mesh.points = points
        cells: Any = pyvista.CellArray
        mesh.lines = cells.from_arrays(offsets, np.arange(len(points)))
    return mesh, found.curve


def set_colors(mesh: Any, colors: Array) -> None:
    """Give a mesh colors in [0, 1], shape (n, 3), at its points."""
    mesh.point_data.set_scalars(np.round(255.0 * colors).astype(np.uint8), COLORS)


def set_camera(plotter: Any, surface: Surface, view: View) -> None:
    """Let a plotter look at a surface as a view says."""
    distance = 2.0 * float(np.ptp(surface.points, axis=0).max()) + view.height
    camera = plotter.camera
    camera.SetParallelProjection(True)
    camera.SetFocalPoint(view.center)
    camera.SetPosition(view.center + distance * view.towards)
    camera.SetViewUp(view.up)
    camera.SetParallelScale(view.height / 2)
    plotter.renderer.ResetCameraClippingRange()
    near, far = camera.GetClippingRange()
    camera.SetClippingRange(max(near, distance - view.nearest), far)
