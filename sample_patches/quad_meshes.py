"""The quad meshes that the mannequins were fitted to, as one file: ``quad_meshes.npz``.

All bodies have the same quads. Of each mesh, the part that the atlas covers is kept, and a margin,
so that the limit surface is that of the whole mesh up to the atlas's boundary and beyond.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from bodymeasure.subdivision import QuadMesh, part, quads_within

from .control_mesh import ControlMesh

FILE = "quad_meshes.npz"
# Rings of quads round what the atlas covers: two would do for its limit surface; the others leave
# room for shortest paths beside the boundary.
MARGIN = 6
# The meshes' coordinates are whole micrometers, so nothing is lost.
PER_METER = 1_000_000


def write_quad_meshes(meshes: Mapping[str, ControlMesh], covered: str, folder: Path) -> None:
    """Write the meshes of all bodies.

    Parameters
    ----------
    meshes : mapping of str to ControlMesh
        The meshes by body, in meters, with the same quads.
    covered : str
        The group of quads that the atlas covers; they are written first.
    folder : Path
    """
    first = next(iter(meshes.values()))
    if any(not np.array_equal(mesh.quads, first.quads) for mesh in meshes.values()):
        raise ValueError("the bodies' meshes have different quads; expected the same")
    inner = first.groups[covered]
    whole = QuadMesh(first.vertices, first.quads)
    chosen = quads_within(whole, np.unique(inner), MARGIN)
    is_inner = np.isin(np.sort(whole.quads, axis=1) @ _KEY, np.sort(inner, axis=1) @ _KEY)
    order = np.argsort(~is_inner[chosen], kind="stable")
    kept, numbers = part(whole, chosen)
    arrays: dict[str, Any] = {
        "quads": kept.quads[order].astype(np.uint16),
        "covered": np.array(is_inner.sum()),
    }
    for body, mesh in meshes.items():
        scaled = PER_METER * mesh.vertices[numbers]
        arrays[body] = np.round(scaled).astype(np.int32)
        if np.abs(arrays[body] - scaled).max() > 1e-6:
            raise ValueError(f"the mesh of {body} has coordinates below a micrometer")
    np.savez_compressed(folder / FILE, **arrays)


# A number for each set of four vertices: mixed radix, far above the meshes' numbers of vertices.
_KEY = np.array([1, 1 << 15, 1 << 30, 1 << 45])
