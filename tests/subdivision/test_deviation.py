"""How far patches deviate from the Catmull-Clark surface and from the faces of a mesh."""

import numpy as np
import pytest
from helpers.surfaces.quad_grids import grid_mesh, hilly_net
from helpers.surfaces.solids import CUBE, icosphere, quad_mesh

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.bezier import evaluate
from bodymeasure.subdivision import (
    PolygonMesh,
    flat_places,
    irregular_quads,
    limit_deviation,
    loop_schaefer,
    mesh_deviation,
    neighborhood,
    refined,
)

POINTS = hilly_net(8, 7)
GRID = quad_mesh(POINTS.reshape(-1, 3), grid_mesh(POINTS).quads)


def creased(*creases: list[int], tagged: tuple[int, ...] = ()) -> PolygonMesh:
    ends = np.array(creases, dtype=np.int64).reshape(-1, 2)
    return PolygonMesh(GRID.vertices, GRID.corners, GRID.sizes, ends, tagged=tagged)


MESHES = {
    "grid": GRID,
    "cube": CUBE,
    "dart": creased([22, 23], [23, 24]),
    "cusp": creased(tagged=(24,)),
    "crease with a corner": creased([22, 23], [23, 24], [24, 31], [24, 25], [25, 26]),
}


def patches_of(mesh: PolygonMesh) -> Array:
    nets = loop_schaefer(mesh)
    return nets.points[nets.index]


def middles_of(nets: Array) -> Array:
    return evaluate(nets, np.full((len(nets), 2), 0.5))


def off_the_limit(mesh: PolygonMesh) -> Array:
    """How far the middles of patches are from where repeated subdivision brings them."""
    limit = refined(mesh)
    middle = len(mesh.vertices) + len(mesh.ends) + np.arange(len(mesh.sizes))
    ends = loop_schaefer(limit).points[middle]
    return np.asarray(np.linalg.norm(middles_of(patches_of(mesh)) - ends, axis=1))


@pytest.mark.parametrize("name", MESHES)
def test_patches_are_exact_but_at_irregular_quads(name: str) -> None:
    mesh = MESHES[name]
    irregular = irregular_quads(mesh)
    assert off_the_limit(mesh)[~irregular].max(initial=0.0) < 1e-14
    assert irregular.any() == (name != "grid")
    found = limit_deviation(mesh, loop_schaefer(mesh))
    np.testing.assert_array_equal(found.distance > 0.0, irregular)
    np.testing.assert_array_equal(found.stretch > 0.0, irregular)


def chosen(count: int, *numbers: int) -> Bools:
    result = np.zeros(count, dtype=np.bool_)
    result[list(numbers)] = True
    return result


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("numbers", [(0,), (3, 20), (2, 9, 16, 17)])
def test_a_neighborhood_has_the_surface_of_the_whole(name: str, numbers: tuple[int, ...]) -> None:
    mesh = MESHES[name]
    numbers = tuple(number for number in numbers if number < len(mesh.sizes))
    part, within = neighborhood(mesh, chosen(len(mesh.sizes), *numbers))
    for _ in range(2):
        np.testing.assert_allclose(
            patches_of(part)[within], patches_of(mesh)[list(numbers)], rtol=0, atol=1e-14
        )
        mesh, part = refined(mesh), refined(part)
        numbers = tuple(4 * number + k for number in numbers for k in range(4))
        within = (4 * within[:, None] + np.arange(4)).ravel()


def test_a_neighborhood_may_touch_itself_at_a_vertex() -> None:
    part, within = neighborhood(GRID, chosen(42, 7, 28))
    assert (len(part.sizes), len(part.vertices), len(within)) == (9 + 9, 16 + 16, 2)


def test_the_distance_is_that_of_repeated_subdivision() -> None:
    nets = loop_schaefer(CUBE)
    found = limit_deviation(CUBE, nets)
    fine = CUBE
    for _ in range(5):
        fine = refined(fine)
    points = loop_schaefer(fine).points[: len(fine.vertices)]
    side = np.linspace(0.0, 1.0, 65)
    grid = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1)
    patch = evaluate(nets.points[nets.index[0]], grid).reshape(-1, 3)
    here = points[np.unique(fine.corners.reshape(6, -1)[0])]
    distance = max(np.linalg.norm(patch - point, axis=1).min() for point in here[::7])
    # What is added for the part that two steps of subdivision leave is a third of it.
    assert distance < found.distance[0] < 1.5 * distance
    # Refining takes most of it away.
    finer = refined(CUBE)
    assert limit_deviation(finer, loop_schaefer(finer)).distance.max() < found.distance[0] / 5.0


def test_lengths_on_a_sphere_fall_short_of_its_mesh() -> None:
    mesh = icosphere(2)
    quads, places = refined(mesh), flat_places(mesh, mesh.vertices)
    radii = np.linalg.norm(places, axis=1)
    assert radii[: len(mesh.vertices)] == pytest.approx(1.0, abs=1e-15)
    nets = loop_schaefer(quads)
    found = mesh_deviation(places, quads.corners.reshape(-1, 4), nets)
    limits = np.linalg.norm(nets.points[: len(mesh.vertices)], axis=1)
    # The vertices are farthest away; their limits are the closest points.
    assert found.distance == pytest.approx(1.0 - limits.min(), rel=1e-2)
    area = 0.5 * np.linalg.norm(_cross(mesh), axis=1).sum()
    radius = np.linalg.norm(middles_of(nets.points[nets.index]), axis=1).mean()
    assert found.lengths == pytest.approx(np.sqrt(area / (4.0 * np.pi)) / radius - 1.0, rel=0.02)
    assert 0.4 * found.distance < found.rms < 0.5 * found.distance


def _cross(mesh: PolygonMesh) -> Array:
    a, b, c = mesh.vertices[mesh.corners.reshape(-1, 3)].transpose(1, 0, 2)
    return np.cross(b - a, c - a)


def test_the_faces_of_a_flat_mesh_are_its_surface() -> None:
    x, y = np.meshgrid(np.arange(4.0), np.arange(5.0), indexing="ij")
    net = np.stack([x, y, 0.0 * x], axis=-1)
    mesh = quad_mesh(net.reshape(-1, 3), grid_mesh(net).quads)
    quads: Ints = mesh.corners.reshape(-1, 4)
    found = mesh_deviation(mesh.vertices, quads, loop_schaefer(mesh))
    np.testing.assert_allclose(found, 0.0, atol=1e-14)
