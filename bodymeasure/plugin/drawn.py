"""Meshes and paths in a pyvista plotter."""

from typing import Any

import numpy as np
import pyvista as pv

# Radius of a tube, as a part of the mesh's size.
TUBE = 0.003
SKIN = "#d9c7b8"
TAPE = "#0072b2"
# Radius of the ball at the point that was picked first, in radii of a tube.
BALL = 2.5
START = "the picked start"


def shown(plotter: Any, mesh: pv.PolyData) -> Any:
    """Add the mesh, plain and smooth, and return its actor."""
    return plotter.add_mesh(mesh, color=SKIN, smooth_shading=True, name="body", scalars=None)


def drawn_start(plotter: Any, mesh: pv.PolyData, positions: Any) -> None:
    """Mark the points of a path whose end is not picked yet."""
    radius = BALL * TUBE * _size(mesh)
    balls = pv.merge([pv.Sphere(radius=radius, center=position) for position in positions])
    plotter.add_mesh(balls, color=TAPE, name=START, pickable=False, reset_camera=False)


def drawn_path(plotter: Any, mesh: pv.PolyData, path: pv.PolyData) -> None:
    """Add a path as a tube, with its length at its middle."""
    if path.n_points < 2:
        return
    plotter.add_mesh(
        path.tube(radius=TUBE * _size(mesh)), color=TAPE, pickable=False, reset_camera=False
    )
    label = length_words(path, "length", ".4g")
    middle = np.asarray(path.points)[path.n_points // 2]
    plotter.add_point_labels(
        [middle],
        [label],
        always_visible=True,
        shape_color="white",
        text_color="black",
        font_size=14,
        show_points=False,
        pickable=False,
        reset_camera=False,
    )


def length_words(path: pv.PolyData, name: str, form: str) -> str:
    """Return one of the lengths that a path carries, with its unit if that is known."""
    return f"{float(path.field_data[name][0]):{form}} {path.field_data['unit'][0]}".strip()


def _size(mesh: pv.PolyData) -> float:
    return float(np.linalg.norm(np.ptp(np.asarray(mesh.points), axis=0)))
