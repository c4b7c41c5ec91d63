"""Nodes that move straight in space, however the surface is parametrized."""

import numpy as np
import pytest

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.elements.retraction import bending, metric_at, moved_along
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces

LINE = np.linspace(0.0, 1.0, 4)


def uneven_plane() -> Array:
    """A flat parallelogram, a thousand times as long as wide, whose lines are bent and crowd."""
    net = np.zeros((4, 4, 3))
    u, v = np.meshgrid(np.array([0.0, 0.1, 0.3, 1.0]), LINE, indexing="ij")
    net[..., 0], net[..., 1] = 1000.0 * (u + 0.2 * v * v), v
    return net


def test_in_a_plane_nodes_move_straight(rng: np.random.Generator) -> None:
    surface = BezierSurfaces(uneven_plane()[None])
    begin = rng.uniform(0.3, 0.7, (9, 2))
    step = rng.uniform(-0.05, 0.05, (9, 2))
    there = moved_along(surface, begin.ravel(), step.ravel()).reshape(-1, 2)
    _, s_u, s_v = surface.jet(begin[None], 1)[:, :, 0]
    tip = evaluate(uneven_plane(), begin) + (s_u * step[:, 0] + s_v * step[:, 1]).T
    assert evaluate(uneven_plane(), there) == pytest.approx(tip, rel=0.0, abs=1e-9)


def test_what_is_fixed_or_on_a_bound_stays_there() -> None:
    surface = BezierSurfaces(uneven_plane()[None])
    begin = np.array([0.0, 0.4, 0.9, 0.5, 0.5, 0.5])
    step = np.array([0.0, 0.1, 0.3, 0.1, 0.0, 0.0])
    there = moved_along(surface, begin, step)
    assert there[0] == 0.0
    assert there[2] == 1.0
    assert there[4:].tolist() == [0.5, 0.5]
    assert ((there >= 0.0) & (there <= 1.0)).all()


def test_where_the_surface_is_a_point_steps_are_straight() -> None:
    surface = BezierSurfaces(np.zeros((1, 4, 4, 3)))
    step = np.array([0.1, -0.2, 0.7, 0.0])
    begin = np.array([0.5, 0.5, 0.6, 0.5])
    there = moved_along(surface, begin, step)
    assert there == pytest.approx([0.6, 0.3, 1.0, 0.5])


def test_second_derivatives_along_the_moves(rng: np.random.Generator) -> None:
    # The function is the squared distance in space from a point, along moves of one node; its
    # derivatives are compared with differences.
    net = rng.normal(size=(4, 4, 3))
    surface, target = BezierSurfaces(net[None]), rng.normal(size=3)
    place = np.array([0.4, 0.6])

    def value(step: Array) -> float:
        there = moved_along(surface, place, step)
        off = surface.positions(there[None, None])[0, 0] - target
        return float(off @ off)

    jet = surface.jet(place[None, None], 2)[:, :, 0, 0]
    off = surface.positions(place[None, None])[0, 0] - target
    gradient = 2.0 * np.array([off @ jet[1], off @ jet[2]])
    in_uv = 2.0 * (metric_at(surface, place)[:, 0] + jet[3:] @ off)
    change = bending(surface, place, gradient, np.zeros(2, bool))[:, 0]
    second = in_uv + change
    # A coordinate that does not move at all would be held.
    for step in 1e-4 * np.array([(1.0, 0.5), (0.5, 1.0), (1.0, -1.0)]):
        along = value(step) - 2.0 * value(0.0 * step) + value(-step)
        expected = second @ [step[0] ** 2, 2.0 * step[0] * step[1], step[1] ** 2]
        assert along == pytest.approx(expected, rel=1e-3)


def test_a_bent_strip_a_thousand_times_as_long_as_wide() -> None:
    # In (u, v) the valley of least energy is bent, and a thousandth as wide as it is long.
    net = uneven_plane()
    start, end = (0.1, 0.95), (0.6, 0.05)
    solution = bm.solve_geodesic(net, start, end)
    chord = np.linalg.norm(np.diff(evaluate(net, np.array([start, end])), axis=0))
    assert abs(solution.length - chord) <= solution.error_estimate
    assert solution.error_estimate <= 1e-9 * chord
