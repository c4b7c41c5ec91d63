import numpy as np
import pytest

from bodymeasure._typing import Array, Ints
from bodymeasure.oracle import validate_mesh
from bodymeasure.oracle.libigl import exact_distance
from bodymeasure.paper.surface.insertion import insert_point
from bodymeasure.subdivision import triangles

# Four by four squares of side 1 in a plane, each cut in two along its diagonal.
VERTICES = np.array([(i, j, 0.0) for i in range(5) for j in range(5)])
FACES = triangles(
    np.array(
        [
            [5 * i + j, 5 * i + j + 5, 5 * i + j + 6, 5 * i + j + 1]
            for i in range(4)
            for j in range(4)
        ]
    )
)


def area(vertices: Array, faces: Ints) -> float:
    a, b, c = vertices[faces].swapaxes(0, 1)
    return float(np.cross(b - a, c - a)[:, 2].sum() / 2.0)


@pytest.mark.parametrize(
    ("point", "added"),
    [
        pytest.param((1.3, 1.2, 0.0), (1, 2), id="inside a face"),
        pytest.param((1.3, 1.3, 0.0), (1, 2), id="on a diagonal"),
        pytest.param((1.3, 1.301, 0.0), (1, 2), id="near a diagonal"),
        pytest.param((1.0, 2.4, 0.0), (1, 2), id="on a side"),
        pytest.param((0.0, 2.4, 0.0), (1, 1), id="on the boundary"),
        pytest.param((2.0, 1.0, 0.0), (0, 0), id="at a vertex"),
        pytest.param((2.01, 1.02, 0.0), (0, 0), id="near a vertex"),
    ],
)
def test_the_point_is_a_vertex_of_a_sound_mesh(
    point: tuple[float, float, float], added: tuple[int, int]
) -> None:
    vertices, faces, number = insert_point(VERTICES, FACES, np.array(point))
    np.testing.assert_array_equal(vertices[number], point)
    assert (len(vertices) - len(VERTICES), len(faces) - len(FACES)) == added
    validate_mesh(vertices, faces)
    assert area(vertices, faces) == pytest.approx(16.0, rel=1e-15)
    sides = vertices[np.roll(faces, -1, axis=1)] - vertices[faces]
    doubled = np.cross(sides[:, 0], sides[:, 1])[:, 2]
    assert (doubled > 0.02 * (sides**2).sum(axis=-1).max(axis=-1)).all()


def test_the_mesh_given_is_left_alone() -> None:
    before = VERTICES.copy(), FACES.copy()
    insert_point(VERTICES, FACES, np.array([2.01, 1.0, 0.1]))
    np.testing.assert_array_equal(VERTICES, before[0])
    np.testing.assert_array_equal(FACES, before[1])


def test_distances_between_points_anywhere_are_exact_in_a_plane(rng: np.random.Generator) -> None:
    for start, end in rng.random((20, 2, 3)) * [4.0, 4.0, 0.0]:
        vertices, faces, first = insert_point(VERTICES, FACES, start)
        vertices, faces, second = insert_point(vertices, faces, end)
        if (vertices[first] == start).all() and first != second:
            distance = exact_distance(vertices, faces, first, second)
            assert distance == pytest.approx(float(np.linalg.norm(end - start)), rel=1e-9)
