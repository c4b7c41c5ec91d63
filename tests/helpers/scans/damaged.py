"""Mesh files of all kinds, and what becomes of them when they are damaged."""

from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from helpers.scans.meshes import ellipsoid

from bodymeasure import InputError, Unit
from bodymeasure.fit.scan import Scan
from bodymeasure.fit.scan.load import load
from bodymeasure.fit.scan.read import made

MESH = ellipsoid((0.2, -0.1, 0.9), (0.3, 0.2, 0.85), rows=8)


def mesh_files() -> dict[str, tuple[str, bytes]]:
    """The same mesh in files of all kinds by name, each with its extension."""
    body: Any = trimesh.Trimesh(*MESH, process=False)
    kinds = {
        "binary STL": ("stl", {}),
        "text STL": ("stl_ascii", {}),
        "binary PLY": ("ply", {}),
        "text PLY": ("ply", {"encoding": "ascii"}),
        "OBJ": ("obj", {}),
        "OFF": ("off", {}),
        "GLB": ("glb", {}),
    }
    files = {}
    for name, (kind, options) in kinds.items():
        content = body.export(file_type=kind, **options)
        extension = f".{kind.removesuffix('_ascii')}"
        files[name] = (extension, content if isinstance(content, bytes) else content.encode())
    return files


def scan_or_refused(content: bytes, extension: str) -> Scan | None:
    """The scan of a file's content, or None if it is refused as it should be.

    Raises
    ------
    AssertionError
        If the scan holds a number that is not finite, has lost much of the mesh in silence, or the
        error does not name the file.
    """
    path = Path(f"file{extension}")
    try:
        scan = made(load(content, path), str(path), Unit.M, None, None, "file")
    except InputError as error:
        message = str(error)
        if not message.startswith(str(path)):
            raise AssertionError(f"which file? {message}") from error
        return None
    assert np.isfinite(scan.vertices).all()
    assert scan.triangles.min() == 0
    assert scan.triangles.max() == len(scan.vertices) - 1
    lost = len(MESH[1]) - len(scan.triangles)
    # An OBJ file says nowhere how much it should hold.
    said = extension == ".obj" or any("Dropped" in note for note in scan.notes)
    assert said or lost < 0.1 * len(MESH[1]), lost
    return scan
