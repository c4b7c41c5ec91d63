"""Changes that must not affect a path along edges, or must affect it in a known way."""

from functools import cache

import numpy as np
import pytest
from helpers.speed import quick
from scipy.spatial.transform import Rotation

import bodymeasure as bm
from bodymeasure._typing import Array

# The axis and value of an edge, and the parameters at which the arc begins and ends along it.
Arc = tuple[int, float, float, float]

# Heights in fifths, over a square of side 0.6: an arc on each of two edges, one of them between
# free legs, one alone, one into the far corner, one shorter than a thousandth of its edge.
LEVELS = {
    "two arcs": [[0, 4, 0, 0], [4, 5, 4, 5], [0, 5, 1, 1], [4, 1, 3, 5]],
    "between free legs": [[0, 1, 4, 1], [3, 5, 5, 3], [5, 5, 1, 1], [1, 3, 0, 5]],
    "a long arc": [[0, 2, 2, 2], [1, 5, 4, 0], [4, 5, 4, 0], [1, 0, 0, 5]],
    "into the corner": [[0, 2, 5, 3], [5, 3, 3, 2], [5, 3, 0, 3], [1, 0, 0, 5]],
    "too short for polygons": [[0, 2, 2, 5], [1, 0, 4, 5], [0, 2, 3, 2], [0, 5, 0, 5]],
}


def patch(name: str) -> Array:
    line = np.linspace(0.0, 0.6, 4)
    x, y = np.meshgrid(line, line, indexing="ij")
    return np.stack([x, y, np.array(LEVELS[name]) / 5.0], axis=-1)


@cache
def known(name: str) -> bm.GeodesicSolution:
    return bm.solve_geodesic(patch(name), (0.0, 0.0), (1.0, 1.0))


def arcs(solution: bm.GeodesicSolution) -> list[Arc]:
    return [
        ("uv".index(each.edge[0]), float(each.edge[-1]), each.start, each.end)
        for each in solution.contacts
    ]


def agrees(found: bm.GeodesicSolution, name: str, moved: list[Arc], scale: float = 1.0) -> None:
    """Check that lengths agree to their estimates, and that arcs are the same in the same order."""
    before = known(name)
    assert found.status is bm.Status.ON_BOUNDARY
    estimates = before.error_estimate + found.error_estimate / scale
    assert abs(found.length / scale - before.length) <= estimates
    assert estimates <= 2e-10 * before.length
    assert [arc[:2] for arc in arcs(found)] == [arc[:2] for arc in moved]
    # The length depends on the joints by a third power: if it is known to 1e-10, they are to 1e-3.
    places = [arc[2:] for arc in arcs(found)]
    np.testing.assert_allclose(places, [arc[2:] for arc in moved], atol=1e-3)


@pytest.mark.parametrize("name", LEVELS)
def test_swapping_the_ends(name: str) -> None:
    back = bm.solve_geodesic(patch(name), (1.0, 1.0), (0.0, 0.0))
    agrees(
        back,
        name,
        [(axis, value, end, start) for axis, value, start, end in arcs(known(name))][::-1],
    )


@pytest.mark.parametrize("name", LEVELS)
def test_swapping_u_and_v(name: str) -> None:
    found = bm.solve_geodesic(patch(name).swapaxes(0, 1), (0.0, 0.0), (1.0, 1.0))
    agrees(found, name, [(1 - axis, *rest) for axis, *rest in arcs(known(name))])  # type: ignore[misc]


@pytest.mark.parametrize("turned", quick([(0, 1), (0,), (1,)]))
@pytest.mark.parametrize("name", LEVELS)
def test_turning_parameters_round(name: str, turned: tuple[int, ...]) -> None:
    start = np.array([float(axis in turned) for axis in (0, 1)])
    found = bm.solve_geodesic(np.flip(patch(name), turned), start, 1.0 - start)
    moved = []
    for axis, value, begin, end in arcs(known(name)):
        if 1 - axis in turned:
            begin, end = 1.0 - begin, 1.0 - end
        moved.append((axis, 1.0 - value if axis in turned else value, begin, end))
    agrees(found, name, moved)


@pytest.mark.parametrize("scale", quick([1e6, 1e-3]))
@pytest.mark.parametrize("name", LEVELS)
def test_scale(name: str, scale: float) -> None:
    found = bm.solve_geodesic(scale * patch(name), (0.0, 0.0), (1.0, 1.0))
    agrees(found, name, arcs(known(name)), scale)


@pytest.mark.parametrize("name", LEVELS)
def test_rigid_motion(name: str, rng: np.random.Generator) -> None:
    rotation = Rotation.from_rotvec(rng.normal(size=3)).as_matrix()
    net = patch(name) @ rotation.T + rng.normal(size=3)
    agrees(bm.solve_geodesic(net, (0.0, 0.0), (1.0, 1.0)), name, arcs(known(name)))


def test_paths_are_the_same_alone_and_together() -> None:
    together = bm.solve_geodesic(np.stack([patch(name) for name in LEVELS]), (0.0, 0.0), (1.0, 1.0))
    alone = [known(name) for name in LEVELS]
    np.testing.assert_array_equal(together.status, [each.status for each in alone])
    np.testing.assert_allclose(together.length, [each.length for each in alone], rtol=1e-14)
    for number, name in enumerate(LEVELS):
        agrees(together[number], name, arcs(known(name)))
