import numpy as np
import pytest

from bodymeasure._typing import Array, Ints
from bodymeasure.errors import InputError
from bodymeasure.oracle import validate_mesh

# A square pyramid without its base, the apex being vertex 4.
SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=np.float64)
PYRAMID = np.vstack([SQUARE, [[0.5, 0.5, 1.0]]])
ROOF = np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])


def refuse(vertices: Array, faces: Ints, message: str) -> None:
    with pytest.raises(InputError, match=message):
        validate_mesh(vertices, faces)


def test_open_and_closed_meshes_pass() -> None:
    validate_mesh(PYRAMID, ROOF)
    validate_mesh(PYRAMID, np.vstack([ROOF, [[0, 2, 1], [0, 3, 2]]]))


@pytest.mark.parametrize("scale", [1e-6, 1e6])
def test_size_does_not_matter(scale: float) -> None:
    validate_mesh(PYRAMID * scale, ROOF)


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_vertices_that_are_not_finite(value: float) -> None:
    vertices = PYRAMID.copy()
    vertices[2, 1] = value
    refuse(vertices, ROOF, r"vertex 2 is \[1\.0, (nan|inf), 0\.0\]; expected finite")


@pytest.mark.parametrize("number", [-1, 5])
def test_numbers_out_of_range(number: int) -> None:
    faces = ROOF.copy()
    faces[1, 2] = number
    refuse(PYRAMID, faces, rf"face 1 is \[1, 2, {number}\], but the vertices are numbered 0 to 4")


def test_vertices_of_no_face() -> None:
    refuse(np.vstack([PYRAMID, [[9, 9, 9]]]), ROOF, "vertex 5 belongs to no face")


@pytest.mark.parametrize("face", [[4, 0, 0], [0, 5, 1]])
def test_faces_without_area(face: list[int]) -> None:
    vertices = np.vstack([PYRAMID, [[0.25, 0, 0]]])
    refuse(vertices, np.vstack([ROOF, [face], [[5, 2, 3]]]), "face 4 .* has no area")


def test_edges_of_three_faces() -> None:
    # This mesh makes libigl end the process.
    vertices = np.vstack([PYRAMID, [[0.5, -1, 0]]])
    refuse(vertices, np.vstack([ROOF, [[1, 0, 5], [0, 1, 5]]]), r"edge \(0, 1\) belongs to 3 faces")


def test_faces_that_turn_against_each_other() -> None:
    faces = ROOF.copy()
    faces[2] = faces[2, ::-1]
    refuse(PYRAMID, faces, r"faces \d and 2 run along their edge \(\d, \d\) in the same direction")


def test_two_fans_at_one_vertex() -> None:
    vertices = np.vstack([PYRAMID, PYRAMID[:4] + np.array([0, 0, 2])])
    upper = np.array([[6, 5, 4], [7, 6, 4], [8, 7, 4], [5, 8, 4]])
    refuse(vertices, np.vstack([ROOF, upper]), "vertex 4 form more than one fan")


def test_two_fans_within_one_piece() -> None:
    # A strip of four triangles that is bent until its ends meet in vertex 0 alone.
    angle = np.linspace(0, 2 * np.pi, 8, endpoint=False)
    vertices = np.stack([np.cos(angle), np.sin(angle), np.sin(3 * angle)], axis=-1)
    strip = np.array([[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5], [4, 5, 0]])
    refuse(vertices[:6], strip, "vertex 0 form more than one fan")


def test_two_pieces() -> None:
    # Between them libigl returns zero without a warning.
    vertices = np.vstack([PYRAMID, PYRAMID + np.array([3, 0, 0])])
    refuse(vertices, np.vstack([ROOF, ROOF + 5]), "2 pieces: no path leads from face 0 to face 4")


def test_shapes_and_types() -> None:
    refuse(PYRAMID[:, :2], ROOF, r"vertices have shape \(5, 2\)")
    refuse(PYRAMID, ROOF[:, :2], r"faces have shape \(4, 2\)")
    refuse(PYRAMID, ROOF[:0], r"at least one face")
    with pytest.raises(InputError, match="whole numbers"):
        validate_mesh(PYRAMID, ROOF.astype(float))
