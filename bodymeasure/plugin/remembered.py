"""Meshes that remember the atlas they were made of."""

from functools import lru_cache
from typing import Any

import numpy as np
import pyvista as pv

from bodymeasure.atlas import Atlas, tessellate
from bodymeasure.bezier import evaluate
from bodymeasure.errors import InputError
from bodymeasure.formats import atlas_json

# Steps along a patch's side: on a mannequin, the mesh is within a few tenths of a millimeter.
SEGMENTS = 8
# Names of what a mesh carries.
ATLAS, UNIT, PATCH, PARAMETERS = (
    "bodymeasure_atlas",
    "bodymeasure_unit",
    "bodymeasure_patch",
    "bodymeasure_uv",
)
# Part of the atlas's size by which vertices may be off: coordinates may have been through a file of
# single precision.
MOVED = 1e-6
# Vertices whose places are checked at a time, so that large meshes take little memory.
_BLOCK = 1 << 15


def mesh_of(atlas: Atlas, *, unit_known: bool = True, segments: int = SEGMENTS) -> pv.PolyData:
    """Return a mesh of an atlas that remembers it.

    Parameters
    ----------
    atlas : Atlas
    unit_known : bool
        Whether the atlas's unit was given, rather than assumed; see `unit_of`.
    segments : int
        Steps along a patch's side.

    Returns
    -------
    pyvista.PolyData
        It has the patch of each vertex, (u, v) on it, and the atlas itself as text, so that copies
        and files of the mesh keep it.
    """
    found = tessellate(atlas, segments)
    faces: Any = found.faces
    mesh: pv.PolyData = pv.PolyData.from_regular_faces(found.vertices, faces)
    mesh.point_data[PATCH] = found.patch
    mesh.point_data[PARAMETERS] = found.parameters
    mesh.cell_data[PATCH] = found.face_patch
    mesh.field_data[ATLAS] = [atlas_json.write(atlas).decode()]
    mesh.field_data[UNIT] = [atlas.unit.value if unit_known else ""]
    mesh.set_active_scalars(None)
    return mesh


def atlas_of(mesh: pv.PolyData) -> Atlas | None:
    """Return the atlas that a mesh remembers; None if it was made elsewhere.

    Raises
    ------
    InputError
        If the mesh was moved, turned, deformed or cut since, so that the atlas is another surface,
        or does not know its vertices.
    """
    if ATLAS not in mesh.field_data:
        return None
    atlas = _read(str(mesh.field_data[ATLAS][0]))
    if PATCH not in mesh.point_data or PARAMETERS not in mesh.point_data:
        raise InputError(
            f"the mesh has lost the arrays {PATCH!r} and {PARAMETERS!r}, which say where on the "
            "atlas its vertices are; read the atlas again, or measure the mesh itself with "
            "bodymeasure.measure_mesh"
        )
    _check_place(mesh, atlas)
    return atlas


def unit_of(mesh: pv.PolyData) -> str:
    """Return the unit of a mesh that remembers its atlas; empty if its file did not give it."""
    return str(mesh.field_data[UNIT][0]) if UNIT in mesh.field_data else ""


@lru_cache(maxsize=4)
def _read(text: str) -> Atlas:
    return atlas_json.read(text.encode(), "the atlas that the mesh remembers")


def _check_place(mesh: pv.PolyData, atlas: Atlas) -> None:
    patch = np.asarray(mesh.point_data[PATCH])
    parameters = np.asarray(mesh.point_data[PARAMETERS], dtype=np.float64)
    known = parameters.shape == (len(patch), 2) and patch.ndim == 1
    if not known or ((patch < 0) | (patch >= len(atlas))).any():
        raise InputError(
            f"the mesh's arrays {PATCH!r} and {PARAMETERS!r} were changed: they are no places on "
            f"the atlas's {len(atlas)} patches; read the atlas again"
        )
    # All vertices are checked: one may have been moved alone, and a cut adds vertices along it.
    size = float(np.ptp(atlas.points, axis=0).max())
    for first in range(0, len(patch), _BLOCK):
        block = slice(first, first + _BLOCK)
        expected = evaluate(atlas.control_points[patch[block].astype(np.int64)], parameters[block])
        away = np.linalg.norm(np.asarray(mesh.points)[block] - expected, axis=1).max()
        # `not close` rather than `far`, so that NaN is refused too.
        if not away <= MOVED * size:
            raise InputError(
                f"the mesh is {away:.3g} away from the atlas that it remembers: it was moved, "
                "scaled, deformed or cut since it was read; measure it before, or measure the mesh "
                "itself with bodymeasure.measure_mesh"
            )


def lines_of(points: Any) -> pv.PolyData:
    """Return a chain of points as one line."""
    points = np.asarray(points, dtype=np.float64)
    return pv.PolyData(points, lines=np.concatenate([[len(points)], np.arange(len(points))]))
