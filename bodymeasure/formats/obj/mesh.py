"""Polygon meshes in Wavefront OBJ files, ``.obj``: one patch for each quad.

Faces (`f`) become the patches of their approximate Catmull-Clark surface; triangles and polygons
are refined to quads first. Groups are the patches' regions. Edges with ``t crease`` tags, as
OpenSubdiv writes them, stay sharp. The surface is smooth where the mesh has hard edges without one.
"""

import math
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Ints
from bodymeasure.atlas import Atlas, Axes, Unit
from bodymeasure.atlas.size import require_size
from bodymeasure.errors import InputError
from bodymeasure.formats.obj.statements import (
    ObjFile,
    Statement,
    labelled,
    parse,
    vertex_numbers,
)
from bodymeasure.formats.patches import unique_names
from bodymeasure.formats.text import few_numbers, quoted, whole_number
from bodymeasure.subdivision import PolygonMesh, loop_schaefer, quads_of

# Sharpness from which OpenSubdiv takes an edge for infinitely sharp.
SHARP = 10.0


class Faces(NamedTuple):
    """A mesh, the name and group of each of its faces, and notes on what was left out."""

    mesh: PolygonMesh
    names: list[str]
    groups: list[str]
    notes: tuple[str, ...]


def read(content: bytes, source: str) -> Faces:
    """The mesh in a file's content; `source` names the file in errors."""
    return from_statements(parse(content, source), source)


def from_statements(file: ObjFile, source: str) -> Faces:
    """The mesh of a file that is parsed already."""
    faces, names, groups, lines = [], [], [], []
    creases: list[list[int]] = []
    for statement, labels in labelled(file.statements()):
        if statement.keyword in ("f", "fo"):
            faces.append(statement)
            names.append(labels.name)
            groups.append(labels.groups)
            lines.append(statement.line)
        elif statement.keyword == "t":
            creases += _crease(statement, source)
    if not faces:
        raise InputError(f"{source}: holds no face; expected a mesh")
    corners = _corners(faces, len(file.points), source)
    sizes = np.array([len(face.words) for face in faces])
    ends = np.array(creases, dtype=np.int64).reshape(-1, 2)
    if len(ends) and ends.max() >= len(file.points):
        raise InputError(f"{source}: a crease refers to vertex {ends.max()}, which is not there")
    called = [f"face {number} (line {line})" for number, line in enumerate(lines, 1)]
    try:
        require_size(file.points[corners])
        mesh = PolygonMesh(file.points, corners, sizes, ends, called)
    except InputError as error:
        raise InputError(f"{source}: {error}") from None
    return Faces(mesh, names, groups, file.notes)


def _corners(faces: list[Statement], count: int, source: str) -> Ints:
    """The vertices of all faces, one after the other."""
    try:
        # Nearly always all numbers are positive, and may be read at once.
        words = [word.partition(b"/")[0] for face in faces for word in face.words]
        numbers = np.fromiter(map(int, words), np.int64, len(words)) - 1
        before = np.repeat([face.vertices for face in faces], [len(face.words) for face in faces])
        numbers = np.where(numbers < -1, numbers + 1 + before, numbers)
        if numbers.min() >= 0 and numbers.max() < count and not any(b"_" in w for w in words):
            return numbers
    except (ValueError, OverflowError):
        pass
    return np.concatenate([vertex_numbers(face, face.words, count, source) for face in faces])


def _crease(statement: Statement, source: str) -> list[list[int]]:
    """The edge of a tag ``t crease 2/1/0 first second sharpness``, with vertices from 0."""
    place = f"{source}, line {statement.line}"
    if statement.words[:1] != [b"crease"]:
        return []
    expected = "t crease 2/1/0, two vertices counted from 0, and a sharpness"
    if len(statement.words) != 5 or statement.words[1] != b"2/1/0":
        raise InputError(f"{place}: expected {expected}")
    first, second = (whole_number(word, expected, place) for word in statement.words[2:4])
    if min(first, second) < 0 or first == second:
        raise InputError(f"{place}: a crease from {first} to {second}; expected {expected}")
    sharpness = few_numbers(statement.words[4:], place)[0]
    if 0.0 < sharpness < SHARP:
        raise InputError(
            f"{place}: a crease of sharpness {quoted(statement.words[4])}; only those of 0 and of "
            f"{SHARP:g} and more, which stay sharp, can be read"
        )
    return [[first, second]] if sharpness > 0.0 else []


def assemble(faces: Faces, *, unit: Unit, axes: Axes) -> Atlas:
    """The atlas of a mesh: patches are called after their faces, counted from 1."""
    quads, face = quads_of(faces.mesh)
    nets = loop_schaefer(quads)
    used, index = np.unique(nets.index, return_inverse=True)
    digits = 1 + int(math.log10(len(faces.names)))
    labels = (f"face {number:0{digits}d}" for number in range(1, len(faces.names) + 1))
    named = [f"{name} {label}".strip() for name, label in zip(faces.names, labels, strict=True)]
    return Atlas(
        nets.points[used],
        index.reshape(nets.index.shape),
        unit,
        patch_names=unique_names(_each(named, face)),
        regions=tuple(_each(faces.groups, face)),
        axes=axes,
    )


def _each(texts: list[str], numbers: Ints) -> list[str]:
    return [texts[number] for number in numbers.tolist()]
