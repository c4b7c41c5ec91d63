"""Polygon meshes in Wavefront OBJ files, ``.obj``: one patch for each quad.

Faces (`f`) become the patches of their approximate Catmull-Clark surface; triangles and polygons
are refined to quads first. Groups are the patches' regions. Tags of OpenSubdiv say which edges and
vertices stay sharp and which faces are holes. The surface is smooth where the mesh has hard edges
without one.
"""

import math
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Bools, Ints
from bodymeasure.atlas import Atlas, Axes, FileFaces, Unit
from bodymeasure.atlas.size import require_size
from bodymeasure.errors import InputError, TriangleMeshError
from bodymeasure.formats.obj.approximate import Approximated
from bodymeasure.formats.obj.faces import face_corners
from bodymeasure.formats.obj.statements import ObjFile, Statement, labeled, parse
from bodymeasure.formats.obj.tags import hole_faces, read_tags
from bodymeasure.formats.obj.triangles import is_of_triangles, remedies
from bodymeasure.formats.patches import unique_names
from bodymeasure.subdivision import PolygonMesh


class Faces(NamedTuple):
    """A mesh, and which of its faces are holes, their names and groups, and notes for the user."""

    mesh: PolygonMesh
    holes: Bools
    names: list[str]
    groups: list[str]
    notes: tuple[str, ...]


def read(content: bytes, source: str) -> Faces:
    """The mesh in a file's content; `source` names the file in errors."""
    return from_statements(parse(content, source), source)


def from_statements(file: ObjFile, source: str) -> Faces:
    """The mesh of a file that is parsed already."""
    faces, names, groups, lines = [], [], [], []
    tag_statements: list[Statement] = []
    for statement, labels in labeled(file.statements()):
        if statement.keyword in ("f", "fo"):
            faces.append(statement)
            names.append(labels.name)
            groups.append(labels.groups)
            lines.append(statement.line)
        elif statement.keyword == "t":
            tag_statements.append(statement)
    if not faces:
        raise InputError(f"{source}: holds no face; expected a mesh")
    corners = face_corners(faces, file, source)
    sizes = np.array([len(face.words) for face in faces])
    tags = read_tags(tag_statements, len(file.points), len(faces), source)
    ends = np.array(tags.creases, dtype=np.int64).reshape(-1, 2)
    if len(ends) and ends.max() >= len(file.points):
        raise InputError(f"{source}: a crease refers to vertex {ends.max()}, which is not there")
    called = [f"face {number} (line {line})" for number, line in enumerate(lines, 1)]
    try:
        require_size(file.points[corners])
        mesh = PolygonMesh(
            file.points, corners, sizes, ends, called, tagged=tags.corners, rounded=tags.rounded
        )
    except InputError as error:
        if is_of_triangles(sizes):
            raise TriangleMeshError(f"{source}: {error}; {remedies(source)}") from None
        raise InputError(f"{source}: {error}") from None
    holes = hole_faces(tags, mesh)
    if holes.all():
        raise InputError(f"{source}: the tags make every face a hole; expected a surface")
    return Faces(mesh, holes, names, groups, file.notes)


def assemble(faces: Faces, patches: Approximated, *, unit: Unit, axes: Axes) -> Atlas:
    """The atlas of a mesh's patches, which are called after their faces, counted from 1."""
    face = patches.face
    digits = 1 + int(math.log10(len(faces.names)))
    labels = (f"face {number:0{digits}d}" for number in range(1, len(faces.names) + 1))
    named = [f"{name} {label}".strip() for name, label in zip(faces.names, labels, strict=True)]
    return Atlas(
        patches.nets.points,
        patches.nets.index,
        unit,
        patch_names=unique_names(_each(named, face)),
        regions=tuple(_each(faces.groups, face)),
        axes=axes,
        approximation=patches.approximation,
        faces=_file_faces(faces, patches),
    )


def _file_faces(faces: Faces, patches: Approximated) -> FileFaces:
    """Return the faces by their numbers, and those of other polygons at each of their corners."""
    sizes = faces.mesh.sizes.tolist()
    names = [
        f"face {face + 1}" if sizes[face] == 4 else f"face {face + 1} corner {corner + 1}"
        for face, corner in zip(patches.face.tolist(), patches.at_corner.tolist(), strict=True)
    ]
    without = {
        f"face {face + 1}": f"it has {size} corners, and parameters at each of them, as "
        f"'face {face + 1} corner 1'"
        for face, size in enumerate(sizes)
        if size != 4
    }
    for face in np.flatnonzero(faces.holes).tolist():
        without[f"face {face + 1}"] = "the tags make it a hole"
    return FileFaces(tuple(names), patches.corners, without)


def _each(texts: list[str], numbers: Ints) -> list[str]:
    return [texts[number] for number in numbers.tolist()]
