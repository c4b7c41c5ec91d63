import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bodymeasure._typing import Array
from bodymeasure.mesh.tubes import SIDES, Mesh, ball, frames, joined, tangents, tube

WHITE = np.ones(3)
coordinates = st.integers(-5, 5)
curves = st.lists(st.tuples(coordinates, coordinates, coordinates), min_size=2, max_size=12)


def helix(count: int) -> Array:
    angle = np.linspace(0.0, 4.0 * np.pi, count)
    return np.stack([np.cos(angle), np.sin(angle), 0.2 * angle], axis=1)


def area(mesh: Mesh) -> float:
    corner = mesh.points[mesh.triangles]
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    return float(np.linalg.norm(normal, axis=1).sum() / 2)


@settings(deadline=None)
@given(curves)
def test_frames_are_orthonormal_on_any_polygon(drawn: list[tuple[int, int, int]]) -> None:
    points = np.array(drawn, dtype=np.float64)
    tangent = tangents(points)
    first, second = frames(points)
    matrix = np.stack([tangent, first, second], axis=1)
    identity = np.broadcast_to(np.eye(3), matrix.shape)
    np.testing.assert_allclose(matrix @ matrix.swapaxes(1, 2), identity, atol=1e-12)


def test_frames_do_not_turn_about_a_flat_curve() -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 200)
    circle = np.stack([np.cos(angle), np.sin(angle), 0.0 * angle], axis=1)
    circle[-1] = circle[0]
    first, _ = frames(circle)
    # The height above the plane is kept, and the frame closes.
    np.testing.assert_allclose(first[:, 2], first[0, 2], atol=1e-12)
    np.testing.assert_allclose(first[-1], first[0], atol=1e-12)


@pytest.mark.parametrize("count", [200, 400])
def test_a_tube_has_its_radius_and_nearly_its_area(count: int) -> None:
    points = helix(count)
    mesh = tube(points, 0.1, np.tile(WHITE, (count, 1)), owner=7)
    center = np.repeat(points, SIDES, axis=0)
    np.testing.assert_allclose(np.linalg.norm(mesh.points - center, axis=1), 0.1, atol=1e-12)
    assert (mesh.owner == 7).all()
    length = 4.0 * np.pi * np.hypot(1.0, 0.2)
    girth = 2.0 * SIDES * np.sin(np.pi / SIDES) * 0.1
    assert area(mesh) == pytest.approx(length * girth, rel=0.01)


def test_triangles_of_a_tube_face_outwards() -> None:
    mesh = tube(helix(100), 0.05, np.tile(WHITE, (100, 1)))
    corner = mesh.points[mesh.triangles]
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    assert (np.einsum("ti,ti->t", normal, mesh.normals[mesh.triangles].mean(axis=1)) > 0).all()


def test_a_ball_is_round() -> None:
    center = np.array([1.0, 2.0, 3.0])
    mesh = ball(center, 0.5, WHITE, 3)
    np.testing.assert_allclose(np.linalg.norm(mesh.points - center, axis=1), 0.5)
    np.testing.assert_allclose(mesh.points - center, 0.5 * mesh.normals, atol=1e-15)
    assert (mesh.owner == 3).all()


def test_meshes_are_joined_in_order() -> None:
    one = tube(helix(5), 0.1, np.tile(WHITE, (5, 1)), owner=0)
    two = ball(np.zeros(3), 0.2, WHITE, 1)
    both = joined([one, two])
    corners = both.points[both.triangles]
    np.testing.assert_array_equal(corners[both.owner == 0], one.points[one.triangles])
    np.testing.assert_array_equal(corners[both.owner == 1], two.points[two.triangles])
    assert len(joined([]).triangles) == 0


def test_repeated_points_have_the_direction_before_them() -> None:
    points = np.array([(0, 0, 0), (0, 0, 0), (1, 0, 0), (1, 0, 0), (1, 1, 0)], dtype=np.float64)
    found = tangents(points)
    assert np.isfinite(found).all()
    np.testing.assert_allclose(found[0], [1.0, 0.0, 0.0])
    np.testing.assert_allclose(found[-1], [0.0, 1.0, 0.0])
