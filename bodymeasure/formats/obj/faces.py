"""The faces of a Wavefront OBJ file, of any number of corners, on the vertices as they come."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.formats.obj.statements import ObjFile, Statement, parse, vertex_numbers


class ObjFaces(NamedTuple):
    """Vertices in the order of the file, and faces upon them.

    Parameters
    ----------
    points : ndarray, shape (n, 3)
    corners : ndarray of int
        The vertices of all faces, one face after the other.
    sizes : ndarray of int, shape (faces,)
        How many corners each face has.
    notes : tuple of str
        What was left out.
    """

    points: Array
    corners: Ints
    sizes: Ints
    notes: tuple[str, ...]


def obj_faces(content: bytes, source: str) -> ObjFaces:
    """Return the faces in a file's content, none if it holds vertices only.

    Raises
    ------
    InputError
        If a vertex or a face cannot be read; the message has the line.
    """
    file = parse(content, source)
    faces = [each for each in file.statements() if each.keyword in ("f", "fo")]
    corners = face_corners(faces, file, source)
    sizes = np.array([len(face.words) for face in faces], dtype=np.int64)
    return ObjFaces(file.points, corners, sizes, file.notes)


def face_corners(faces: list[Statement], file: ObjFile, source: str) -> Ints:
    """Return the vertices of all faces, one face after the other.

    Raises
    ------
    InputError
        If a number is not one, or there is no such vertex; the message has the line.
    """
    count = len(file.points)
    if not faces:
        return np.empty(0, dtype=np.int64)
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
