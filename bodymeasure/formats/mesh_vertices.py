"""Vertices of mesh files, in the order in which the file numbers them."""

from pathlib import Path
from typing import Any

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.files import read_bytes
from bodymeasure.formats.obj.statements import vertices

# The kinds of files that number their vertices; others, such as STL, do not.
NUMBERED = (".obj", ".off", ".ply")


def mesh_vertices(path: Path) -> Array:
    """Return the positions of a mesh file's vertices, shape (k, 3), in the file's unit.

    Parameters
    ----------
    path : Path
        A Wavefront OBJ file, or, given trimesh, OFF or PLY.

    Raises
    ------
    InputError
        If the file cannot be read, is of another kind, or has no vertices.
    MissingExtraError
        If trimesh is needed and not installed.
    """
    kind = path.suffix.lower()
    content = read_bytes(path)
    if kind not in NUMBERED:
        raise InputError(
            f"{path}: unknown kind of mesh {path.suffix!r}; expected one of {', '.join(NUMBERED)}, "
            "which number their vertices"
        )
    found = vertices(content, str(path)) if kind == ".obj" else _by_trimesh(path)
    if not len(found):
        raise InputError(f"{path}: holds no vertex; expected a mesh")
    return found


def _by_trimesh(path: Path) -> Array:
    try:
        import trimesh
    except ImportError:
        raise MissingExtraError(f"reading {path.suffix} files", "trimesh", "oracle") from None
    try:
        # Unprocessed, so that no vertices are merged or dropped.
        mesh: Any = trimesh.load(path, process=False, maintain_order=True, force="mesh")
    except Exception as error:  # whatever the reader of that kind of file stumbles over
        raise InputError(f"{path}: cannot be read as a mesh ({error})") from None
    return np.asarray(mesh.vertices, dtype=np.float64).reshape(-1, 3)
