"""Meshes and paths in a pyvista plotter."""

from typing import Any

import numpy as np
import pyvista as pv

# Radius of a tube, as a part of the mesh's size.
TUBE = 0.003
SKIN = "#d9c7b8"
TAPE = "#0072b2"


def shown(plotter: Any, mesh: pv.PolyData) -> None:
    """Add the mesh, plain and smooth."""
    plotter.add_mesh(mesh, color=SKIN, smooth_shading=True, name="body", scalars=None)


def drawn_path(plotter: Any, mesh: pv.PolyData, path: pv.PolyData) -> None:
    """Add a path as a tube, with its length at its middle."""
    size = float(np.linalg.norm(np.ptp(np.asarray(mesh.points), axis=0)))
    if path.n_points < 2:
        return
    plotter.add_mesh(path.tube(radius=TUBE * size), color=TAPE, pickable=False)
    unit = str(path.field_data["unit"][0])
    label = f"{float(path.field_data['length'][0]):.4g} {unit}".strip()
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
    )
