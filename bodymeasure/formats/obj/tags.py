"""The tags of subdivision surfaces, ``t name ints/floats/strings ...``, as OpenSubdiv writes them.

Infinitely sharp creases and corners, holes and the rule for the boundary are read. Tags that have
no bearing on the shape are passed over, and all others are refused: without them, the surface would
be another.
"""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Bools
from bodymeasure.errors import InputError
from bodymeasure.formats.obj.statements import Statement
from bodymeasure.formats.text import decoded, few_numbers, quoted, whole_number
from bodymeasure.subdivision import PolygonMesh

# Sharpness from which OpenSubdiv takes an edge or a vertex for infinitely sharp.
SHARP = 10.0
# The rules for the boundary: faces beside it are holes; edges and corners stay sharp; edges alone.
NO_BOUNDARY, EDGES_AND_CORNERS, EDGES = range(3)
# They concern texture coordinates.
_PASSED_OVER = frozenset({"facevaryinginterpolateboundary", "facevaryingpropagatecorners"})
# Methods that change nothing of a surface: the first kind tells only of creases that fade out.
_METHODS = {"creasemethod": ("normal", "chaikin"), "smoothtriangles": ("catmark", "normal")}
_READ = "crease, corner, hole and interpolateboundary"


class Tags(NamedTuple):
    """The content of the tags of a file, with vertices and faces from 0.

    Parameters
    ----------
    creases : list of list of int
        The ends of sharp edges.
    corners, holes : list of int
        Sharp vertices, and faces that are left out.
    boundary : int
        The rule for the boundary.
    """

    creases: list[list[int]]
    corners: list[int]
    holes: list[int]
    boundary: int = EDGES_AND_CORNERS

    @property
    def rounded(self) -> bool:
        """Whether the boundary is smooth at vertices with one face."""
        return self.boundary == EDGES


def read_tags(statements: list[Statement], vertices: int, faces: int, source: str) -> Tags:
    """Read the tags of a mesh of so many vertices and faces.

    Raises
    ------
    InputError
        If a tag is malformed, refers to what is not there, or would change the surface in a way
        that cannot be read; the message has the line.
    """
    creases: list[list[int]] = []
    corners: list[int] = []
    holes: list[int] = []
    boundary = EDGES_AND_CORNERS
    for statement in statements:
        place = f"{source}, line {statement.line}"
        name = decoded(statement.words[0]) if statement.words else ""
        if name == "crease":
            creases += _crease(statement, place)
        elif name == "corner":
            corners += _corners(statement, vertices, place)
        elif name == "hole":
            expected = f"t hole, n/0/0 and n faces, counted from 0 to {faces - 1}"
            holes += _within(_integers(statement, expected, place), faces, expected, place)
        elif name == "interpolateboundary":
            expected = (
                "t interpolateboundary 1/0/0 and 0 (none), 1 (edges and corners) or 2 (edges)"
            )
            boundary = _within(_integers(statement, expected, place), 3, expected, place)[-1]
        elif name not in _PASSED_OVER:
            _check_method(statement, name, place)
    return Tags(creases, corners, holes, boundary)


def hole_faces(tags: Tags, mesh: PolygonMesh) -> Bools:
    """Return which faces of a mesh carry no surface, shape (faces,).

    If the boundary is not interpolated, these are also the faces that have a vertex at which an
    edge of the boundary is no crease.
    """
    result = np.zeros(len(mesh.sizes), dtype=np.bool_)
    result[tags.holes] = True
    if tags.boundary == NO_BOUNDARY:
        creases = {tuple(sorted(ends)) for ends in tags.creases}
        edges = mesh.ends[mesh.sides == 1]
        plain = [tuple(ends) not in creases for ends in edges.tolist()]
        free = np.zeros(len(mesh.vertices), dtype=np.bool_)
        free[edges[plain]] = True
        result[mesh.face[free[mesh.corners]]] = True
    return result


def _crease(statement: Statement, place: str) -> list[list[int]]:
    """The edge of a tag ``t crease 2/1/0 first second sharpness``."""
    expected = "t crease 2/1/0, two vertices counted from 0, and a sharpness"
    if len(statement.words) != 5 or statement.words[1] != b"2/1/0":
        raise InputError(f"{place}: expected {expected}")
    first, second = (whole_number(word, expected, place) for word in statement.words[2:4])
    if min(first, second) < 0 or first == second:
        raise InputError(f"{place}: a crease from {first} to {second}; expected {expected}")
    return [[first, second]] if _is_sharp(statement.words[4], "crease", place) else []


def _corners(statement: Statement, vertices: int, place: str) -> list[int]:
    """The sharp vertices of a tag ``t corner n/n/0 vertices sharpnesses``, or with one for all."""
    expected = f"t corner 1/1/0, a vertex counted from 0 to {vertices - 1}, and a sharpness"
    integers, floats, strings = _counts(statement, expected, place)
    if integers < 1 or floats not in (1, integers) or strings:
        raise InputError(f"{place}: expected {expected}")
    words = statement.words[2:]
    numbers = [whole_number(word, expected, place) for word in words[:integers]]
    sharp = [_is_sharp(word, "corner", place) for word in words[integers:]]
    _within(numbers, vertices, expected, place)
    given = zip(numbers, sharp * integers if floats == 1 else sharp, strict=False)
    return [number for number, is_sharp in given if is_sharp]


def _is_sharp(word: bytes, what: str, place: str) -> bool:
    """Return whether a sharpness is infinite rather than none."""
    sharpness = few_numbers([word], place)[0]
    if 0.0 < sharpness < SHARP:
        raise InputError(
            f"{place}: a {what} of sharpness {quoted(word)}; only those of 0 and of "
            f"{SHARP:g} and more, which stay sharp, can be read; change it, or subdivide the mesh "
            "where it was made until the sharpness is used up"
        )
    return sharpness > 0.0


def _integers(statement: Statement, expected: str, place: str) -> list[int]:
    count = _counts(statement, expected, place)
    if count[0] < 1 or any(count[1:]):
        raise InputError(f"{place}: expected {expected}")
    return [whole_number(word, expected, place) for word in statement.words[2:]]


def _counts(statement: Statement, expected: str, place: str) -> list[int]:
    """Return how many integers, floats and strings a tag announces, and how many it has."""
    parts = b"".join(statement.words[1:2]).split(b"/")
    counts = [whole_number(part, expected, place) for part in parts]
    if len(counts) != 3 or min(counts) < 0 or sum(counts) != len(statement.words) - 2:
        raise InputError(f"{place}: expected {expected}")
    return counts


def _within(numbers: list[int], count: int, expected: str, place: str) -> list[int]:
    outside = [number for number in numbers if not 0 <= number < count]
    if outside:
        raise InputError(f"{place}: refers to {outside[0]}; expected {expected}")
    return numbers


def _check_method(statement: Statement, name: str, place: str) -> None:
    """Refuse what is none of the methods that leave the surface as it is."""
    methods = _METHODS.get(name, ())
    if not statement.words[2:] or decoded(statement.words[-1]) not in methods:
        only = f" but with {' or '.join(methods)}" if methods else ""
        raise InputError(
            f"{place}: t {name} is not read{only}, and the surface depends on it; expected "
            f"{_READ}; subdivide the mesh where it was made, or remove the line to have the "
            "surface without it"
        )
