"""The triangles in a mesh file's content, as they are there."""

import io
import struct
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.fit.scan import announced, ply, stl
from bodymeasure.formats.obj.faces import obj_faces
from bodymeasure.wording import counted

# Extensions of the files that are read.
MESHES = (".stl", ".ply", ".obj", ".off", ".glb", ".gltf")
# A scan of a whole body is good to a millimeter with a tenth of these; more take gigabytes.
MOST_TRIANGLES = 2_000_000
# Text of so many triangles takes less.
MOST_BYTES = 800_000_000
_FEWER = (
    "reduce it to 500,000 triangles, for example with MeshLab's Quadric Edge Collapse Decimation"
)
_NO_SURFACE = (
    "it is a cloud of points; make a surface of it first, for example with MeshLab's Screened "
    "Poisson Surface Reconstruction, or export the scanner's mesh"
)


class Triangles(NamedTuple):
    """Triangles as a file has them.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
    triangles : ndarray of int, shape (m, 3)
    notes : tuple of str
        Sentences that say what was done to have them.
    """

    vertices: Array
    triangles: Ints
    notes: tuple[str, ...] = ()


def load(content: bytes, path: Path) -> Triangles:
    """Return the triangles in a file's content; the path names the file, and its kind.

    Polygons are cut into triangles that share their first corner. Scenes are one mesh, each part at
    its place.

    Raises
    ------
    InputError
        If the content is not of that kind, damaged, too large, or holds no triangle.
    MissingExtraError
        If trimesh is needed and not installed.
    """
    kind = path.suffix.lower()
    if kind not in MESHES:
        raise InputError(
            f"{path}: unknown kind of mesh {path.suffix!r}; expected one of {', '.join(MESHES)}"
        )
    if not content.strip():
        raise InputError(f"{path}: is empty; expected a triangle mesh, export it again")
    result = _READERS[kind](content, path)
    if not len(result.vertices):
        raise InputError(f"{path}: holds no vertex; expected a triangle mesh, export it again")
    if not len(result.triangles):
        raise InputError(
            f"{path}: holds {counted(len(result.vertices), 'vertex', 'vertices')} and no triangle; "
            f"{_NO_SURFACE}"
        )
    require_few(path, len(result.triangles))
    outside = (result.triangles < 0) | (result.triangles >= len(result.vertices))
    if outside.any():
        row = int(np.flatnonzero(outside.any(axis=1))[0])
        raise InputError(
            f"{path}: triangle {row + 1} refers to vertex {result.triangles[outside][0]}, but "
            f"there are {len(result.vertices):,}, counted from 0; it is damaged, export it again"
        )
    return result


def require_bytes(path: Path) -> None:
    """Refuse a file before it is read that would take too much memory.

    Raises
    ------
    InputError
        The message says how to have a smaller one.
    """
    try:
        size = path.stat().st_size
    except OSError:  # reading it raises the error that says why
        return
    if size > MOST_BYTES:
        raise InputError(
            f"{path}: has {size / 1e6:,.0f} MB; expected {MOST_BYTES / 1e6:,.0f} MB at most; "
            f"{_FEWER}"
        )


def require_few(path: Path, triangles: int) -> None:
    """Refuse so many triangles that they would take too much memory and time.

    Raises
    ------
    InputError
        The message says how to have fewer.
    """
    if triangles > MOST_TRIANGLES:
        raise InputError(
            f"{path}: has {triangles:,} triangles; expected {MOST_TRIANGLES:,} at most; {_FEWER}"
        )


def _obj(content: bytes, path: Path) -> Triangles:
    require_few(path, content.count(b"\nf "))
    found = obj_faces(content, str(path))
    return _fans(found.points, found.corners, found.sizes, path, found.notes)


def _fans(
    points: Array, corners: Ints, sizes: Ints, path: Path, notes: tuple[str, ...] = ()
) -> Triangles:
    """Cut polygons, whose corners follow each other, into triangles with their first corners."""
    if (sizes < 3).any():
        face = int(np.argmax(sizes < 3))
        raise InputError(
            f"{path}: face {face + 1} has {counted(int(sizes[face]), 'corner')}; expected "
            "three or more; correct it, or export the file again"
        )
    first = np.cumsum(sizes) - sizes
    each = sizes - 2
    start = np.repeat(first, each)
    step = np.arange(each.sum()) - np.repeat(np.cumsum(each) - each, each)
    triangles = np.stack(
        [corners[start], corners[start + step + 1], corners[start + step + 2]], axis=1
    )
    polygons = int((sizes > 3).sum())
    if polygons:
        notes = (*notes, f"Cut {counted(polygons, 'polygon')} into triangles.")
    return Triangles(points, triangles, notes)


def _stl(content: bytes, path: Path) -> Triangles:
    if stl.is_text(content):
        require_few(path, content.count(b"endfacet"))
        corners = stl.read_text(content, str(path))
        return Triangles(corners, np.arange(len(corners)).reshape(-1, 3))
    if len(content) != stl.binary_length(content):
        raise InputError(
            f"{path}: is no STL file, or cut off: as a binary one of {stl.binary_count(content):,} "
            f"triangles it would have {stl.binary_length(content):,} bytes, and it has "
            f"{len(content):,}; export it again"
        )
    require_few(path, stl.binary_count(content))
    return _by_trimesh(content, path)


def _ply(content: bytes, path: Path) -> Triangles:
    require_few(path, announced.require_ply(content, path))
    try:
        return _by_trimesh(content, path)
    except InputError as error:
        try:
            points, corners, sizes = ply.read_polygons(content)
        except (ArithmeticError, LookupError, TypeError, ValueError, struct.error):
            raise error from None
    return _fans(points, corners, sizes, path)


def _off(content: bytes, path: Path) -> Triangles:
    require_few(path, announced.require_off(content, path))
    return _by_trimesh(content, path)


def _gltf(content: bytes, path: Path) -> Triangles:
    notes = announced.require_gltf(content, path, 3 * MOST_TRIANGLES)
    found = _by_trimesh(content, path)
    return found._replace(notes=(*found.notes, *notes))


def _by_trimesh(content: bytes, path: Path) -> Triangles:
    try:
        import trimesh
    except ImportError:
        raise MissingExtraError(f"reading {path.suffix} files", "trimesh", "fit") from None
    kind = path.suffix.lower().removeprefix(".")
    resolver: Any = trimesh.resolvers.FilePathResolver(str(path)) if kind == "gltf" else None
    try:
        # numpy warns where text is no number, and gives the numbers before it.
        with warnings.catch_warnings(action="error"):
            scene: Any = trimesh.load(
                io.BytesIO(content),
                file_type=kind,
                force="scene",
                resolver=resolver,
                process=False,
                skip_materials=True,
            )
            return _of_scene(scene)
    except Exception as error:  # whatever the reader of that kind of file stumbles over
        raise InputError(
            f"{path}: cannot be read as {kind.upper()} ({_first_line(error)}); export it again"
        ) from None


def _of_scene(scene: Any) -> Triangles:
    """Join the meshes of a scene, each at its place; points and curves give vertices only."""
    vertices: list[Array] = []
    triangles: list[Ints] = []
    before = 0
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph[node]
        part = scene.geometry[name]
        places = np.asarray(part.vertices, dtype=np.float64).reshape(-1, 3)
        corners = np.asarray(getattr(part, "faces", ()), dtype=np.int64).reshape(-1, 3)
        vertices.append(places @ matrix[:3, :3].T + matrix[:3, 3])
        # A mirrored part shows its inner side.
        if np.linalg.det(matrix[:3, :3]) < 0.0:
            corners = corners[:, ::-1]
        outside = (corners < 0) | (corners >= len(places))
        if outside.any():
            raise ValueError(f"a triangle refers to vertex {corners[outside][0]}")
        triangles.append(corners + before)
        before += len(places)
    if not vertices:
        return Triangles(np.empty((0, 3)), np.empty((0, 3), dtype=np.int64))
    return Triangles(np.concatenate(vertices), np.concatenate(triangles))


def _first_line(error: Exception) -> str:
    words = str(error).strip().splitlines()
    return f"{type(error).__name__}: {words[0][:120]}" if words else type(error).__name__


_READERS: dict[str, Callable[[bytes, Path], Triangles]] = {
    ".stl": _stl,
    ".ply": _ply,
    ".obj": _obj,
    ".off": _off,
    ".glb": _gltf,
    ".gltf": _gltf,
}
