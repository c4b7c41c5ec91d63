"""Binary PLY files of polygons of several sizes, as Blender writes them, which trimesh refuses."""

import struct
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints

# Types of numbers by their names in PLY files, as the struct module calls them.
_TYPES = {
    "char": "b",
    "int8": "b",
    "uchar": "B",
    "uint8": "B",
    "short": "h",
    "int16": "h",
    "ushort": "H",
    "uint16": "H",
    "int": "i",
    "int32": "i",
    "uint": "I",
    "uint32": "I",
    "float": "f",
    "float32": "f",
    "double": "d",
    "float64": "d",
}


class _Property(NamedTuple):
    name: str
    kind: str
    # The type of the number of items, if it is a list.
    length: str | None


class _Element(NamedTuple):
    name: str
    rows: int
    properties: list[_Property]


def read_polygons(content: bytes) -> tuple[Array, Ints, Ints]:
    """Return the vertices of a binary file, the corners of all its faces, and the faces' sizes.

    Raises
    ------
    ValueError, KeyError, struct.error
        If the content is damaged.
    """
    order, elements, place = _header(content)
    points: Array = np.empty((0, 3))
    corners: list[int] = []
    sizes: list[int] = []
    for element in elements:
        if element.name == "face":
            place = _read_faces(content, place, order, element, corners, sizes)
            break
        if any(each.length for each in element.properties):
            raise ValueError(f"the element {element.name} has lists")
        kinds = [(each.name, order + each.kind) for each in element.properties]
        rows = np.frombuffer(content, np.dtype(kinds), element.rows, place)
        place += rows.nbytes
        if element.name == "vertex":
            points = np.stack([rows[axis].astype(np.float64) for axis in "xyz"], axis=1)
    return points, np.array(corners, dtype=np.int64), np.array(sizes, dtype=np.int64)


def _header(content: bytes) -> tuple[str, list[_Element], int]:
    """Return the order of bytes, the elements, and where they begin."""
    end = content.index(b"\n", content.index(b"end_header")) + 1
    order, elements = "<", list[_Element]()
    for line in content[:end].decode("ascii", "replace").splitlines():
        words = line.split()
        if words[:1] == ["format"]:
            order = {"binary_little_endian": "<", "binary_big_endian": ">"}[words[1]]
        elif words[:1] == ["element"]:
            elements.append(_Element(words[1], int(words[2]), []))
        elif words[:2] == ["property", "list"]:
            length, kind, name = words[2:]
            elements[-1].properties.append(_Property(name, _TYPES[kind], _TYPES[length]))
        elif words[:1] == ["property"]:
            kind, name = words[1:]
            elements[-1].properties.append(_Property(name, _TYPES[kind], None))
    return order, elements, end


def _read_faces(
    content: bytes, place: int, order: str, element: _Element, corners: list[int], sizes: list[int]
) -> int:
    """Append the corners and the sizes of the faces that begin at a place; return where they end.

    Each face takes a step by itself, as only its own length tells where the next one begins.
    """
    for _ in range(element.rows):
        for each in element.properties:
            number = 1
            if each.length is not None:
                (number,) = struct.unpack_from(order + each.length, content, place)
                place += struct.calcsize(each.length)
            values = struct.unpack_from(f"{order}{number}{each.kind}", content, place)
            place += number * struct.calcsize(each.kind)
            if each.length is not None and each.name in ("vertex_indices", "vertex_index"):
                corners.extend(values)
                sizes.append(number)
    return place
