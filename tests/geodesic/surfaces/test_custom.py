"""The user's own surfaces with known geodesics: sphere, torus and cylinders."""

import math
from typing import Any

import numpy as np
import pytest
from helpers.oracles.straight_line import from_straight_line
from helpers.surfaces.custom_surfaces import Patch, Torus, product, wave
from helpers.surfaces.surfaces import ENNEPER

from bodymeasure import InputError
from bodymeasure._typing import Array
from bodymeasure.geodesic import GeodesicSolution, RBFCollocation, Status, solve_geodesic


def sphere_angle(sphere: Torus, start: Array, end: Array) -> Array:
    a, b = (sphere.derivatives(np.asarray(p))[..., 0, :] / sphere.r for p in (start, end))
    return np.asarray(2.0 * np.arcsin(np.linalg.norm(a - b, axis=-1) / 2.0))


def test_great_circles(rng: np.random.Generator) -> None:
    sphere = Torus(0.0, 2.5, span_u=2.0, span_v=1.6, begin_v=-0.8)
    # The longitudes are so close that great circles do not cross the patch's upper edge.
    start, end = rng.uniform(0.2, 0.8, (2, 40, 2))
    solution = from_straight_line(sphere, start, end, on_failure="status")
    inside = solution.converged
    assert inside.mean() > 0.9
    exact = 2.5 * sphere_angle(sphere, start, end)
    error = np.abs(solution.length - exact)[inside]
    assert (error <= 1e-10 * exact[inside]).all()
    assert (error <= solution.error_estimate[inside]).all()
    assert solution.local_minimum[inside].all()


@pytest.mark.parametrize("angle", [0.5, 0.9, 0.99, 0.999, 1.001, 1.01, 1.1, 1.4])
def test_past_the_antipodal_point_a_great_circle_is_no_shortest_path(angle: float) -> None:
    # The path runs along the equator; `angle` is in units of pi.
    sphere = Torus(0.0, 1.0, span_u=1.5 * math.pi, span_v=2.0, begin_v=-1.0)
    end = (angle / 1.5, 0.5)
    solution = from_straight_line(sphere, (0.0, 0.5), end, on_failure="status")
    assert solution.raw_length == pytest.approx(angle * math.pi, rel=1e-13)
    assert solution.local_minimum == (angle < 1.0)
    if angle < 1.0:
        assert solution.status is Status.CONVERGED
        assert solution.length == pytest.approx(angle * math.pi, rel=1e-13)
    else:
        assert solution.status is Status.NOT_A_MINIMUM
        assert math.isnan(solution.length)


def test_the_antipodal_point_itself_is_not_called_converged() -> None:
    sphere = Torus(0.0, 1.0, span_u=1.5 * math.pi, span_v=2.0, begin_v=-1.0)
    solution = from_straight_line(sphere, (0.0, 0.5), (2 / 3, 0.5), on_failure="status")
    assert not solution.local_minimum or not solution.converged


def equator(ends: Array) -> GeodesicSolution:
    """Arcs of a great circle, to `ends` in units of pi, up to two turns and a half."""
    sphere = Torus(0.0, 1.0, span_u=5.0 * math.pi, span_v=2.0, begin_v=-1.0)
    to = np.stack([ends / 5.0, np.full_like(ends, 0.5)], axis=-1)
    # The geodesic is straight in (u, v); the question is which status it gets.
    return from_straight_line(sphere, (0.0, 0.5), to, on_failure="status")


def test_the_index_counts_the_antipodal_points_on_the_way() -> None:
    ends = np.array([0.01, 0.4, 0.999, 1.001, 1.5, 1.999, 2.001, 2.7, 3.3, 4.9])
    solution = equator(ends)
    np.testing.assert_array_equal(solution.index, [0, 0, 0, 1, 1, 1, 2, 2, 3, 4])
    np.testing.assert_array_equal(solution.local_minimum, solution.index == 0)
    np.testing.assert_allclose(solution.raw_length, ends * math.pi, rtol=1e-12)
    assert (np.asarray(solution.status)[3:] == Status.NOT_A_MINIMUM).all()
    # The result is the same from the other end, and one problem gives a plain number.
    sphere = Torus(0.0, 1.0, span_u=5.0 * math.pi, span_v=2.0, begin_v=-1.0)
    back = from_straight_line(sphere, (0.54, 0.5), (0.0, 0.5), on_failure="status")
    assert back.index == 2
    assert repr(back.index) == "2"


def test_at_a_conjugate_point_the_index_is_not_known() -> None:
    solution = equator(np.array([1.0, 2.0, 3.0]))
    assert (solution.index == -1).all()
    assert not solution.local_minimum.any()
    assert not solution.converged.any()


def test_the_index_on_tori_and_cylinders() -> None:
    # Conjugate points are 2 pi apart on the outer equator (K = 1/4), 4 pi u / 8.5 on the way; none
    # lie on the inner one nor on a cylinder, where K is negative and zero.
    torus = Torus(3.0, 1.0, span_u=5.0, span_v=2 * math.pi, begin_v=-0.5 * math.pi)
    ends = np.array([0.1, 0.31, 0.32, 0.62, 0.64, 0.9])
    outer = from_straight_line(
        torus,
        (0.0, 0.25),
        np.stack([ends, np.full_like(ends, 0.25)], axis=-1),
        on_failure="status",
    )
    np.testing.assert_array_equal(outer.index, np.floor(4.0 * 5.0 * ends / (2.0 * math.pi)))
    inner = solve_geodesic(torus, (0.0, 0.75), (1.0, 0.75))
    assert inner.index == 0
    assert inner.length == pytest.approx(10.0, rel=1e-12)
    assert solve_geodesic(Cylinder(), (0.0, 0.0), (1.0, 1.0)).index == 0


def test_where_no_geodesic_was_found_the_index_is_not_known() -> None:
    method = RBFCollocation(functions=2)
    solution = solve_geodesic(ENNEPER, (0.1, 0.0), (1.0, 0.7), method=method, on_failure="status")
    assert not solution.converged
    assert solution.index == -1
    assert not solution.local_minimum
    # A path from a point to itself cannot be shortened.
    assert solve_geodesic(ENNEPER, (0.1, 0.2), (0.1, 0.2)).index == 0


def test_meridians_and_the_outer_and_inner_equator_of_a_torus() -> None:
    torus = Torus(3.0, 1.0, span_u=1.2, span_v=math.pi, begin_v=0.0)
    meridian = solve_geodesic(torus, (0.3, 0.1), (0.3, 0.9))
    assert meridian.length == pytest.approx(0.8 * math.pi, rel=1e-12)
    inner = solve_geodesic(torus, (0.0, 1.0), (1.0, 1.0))
    assert inner.length == pytest.approx(2.0 * 1.2, rel=1e-12)
    # K = 1 / (r (R + r)) = 1/4 on the outer equator: conjugate points are 2 pi apart, 4 x 1.2 are
    # not as far.
    outer = solve_geodesic(torus, (0.0, 0.0), (1.0, 0.0))
    assert outer.length == pytest.approx(4.0 * 1.2, rel=1e-12)
    longer = Torus(3.0, 1.0, span_u=1.7, span_v=math.pi, begin_v=-0.5 * math.pi)
    beyond = from_straight_line(longer, (0.0, 0.5), (1.0, 0.5), on_failure="status")
    assert beyond.status is Status.NOT_A_MINIMUM
    shorter = Torus(3.0, 1.0, span_u=1.55, span_v=math.pi, begin_v=-0.5 * math.pi)
    assert solve_geodesic(shorter, (0.0, 0.5), (1.0, 0.5)).length == pytest.approx(6.2, rel=1e-12)


class Cylinder:
    """A third of a cylinder of radius 2 and height 3, whose geodesics are helices."""

    def derivatives(self, parameters: Array) -> Array:
        u, v = parameters[..., 0], parameters[..., 1]
        one = [np.ones_like(u), 0 * u, 0 * u, 0 * u]
        height = [3.0 * v, np.full_like(v, 3.0), 0 * v, 0 * v]
        turn = 2 * math.pi / 3
        return np.stack(
            [
                product(wave(2.0, turn, 0.0, u), one),
                product(wave(2.0, turn, -math.pi / 2, u), one),
                product(one, height),
            ],
            axis=-1,
        )


def test_helices() -> None:
    start = np.array([[0.0, 0.0], [0.2, 0.9]])
    end = np.array([[1.0, 1.0], [0.7, 0.1]])
    solution = solve_geodesic(Cylinder(), start[:, None], end)
    step = end - start[:, None]
    exact = np.hypot(step[..., 0] * 4 * math.pi / 3, 3 * step[..., 1])
    np.testing.assert_allclose(solution.length, exact, rtol=1e-13)
    assert solution.shape == (2, 2)


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e4])
def test_a_patch_is_the_same_by_its_derivatives(scale: float) -> None:
    end = np.array([[1.0, 1.0], [0.3, 1.0]])
    own = solve_geodesic(Patch(scale * ENNEPER), (0.1, 0.0), end)
    method = RBFCollocation(form="full")
    given = solve_geodesic(scale * ENNEPER, (0.1, 0.0), end, method=method)
    np.testing.assert_allclose(own.length, given.length, rtol=1e-13)
    np.testing.assert_allclose(own.path(0.5), given.path(0.5), atol=1e-11)
    np.testing.assert_array_equal(own.functions, given.functions)


def test_derivatives_may_be_lists() -> None:
    class Lists(Patch):
        def derivatives(self, parameters: Array) -> Any:
            return super().derivatives(parameters).tolist()

    assert solve_geodesic(Lists(ENNEPER), (0, 0), (1, 1)).length == pytest.approx(
        5 * math.sqrt(2) / 3, rel=1e-13
    )


@pytest.mark.parametrize("shape", [(9, 3), (10, 2), (10,), (3, 10)])
def test_derivatives_of_the_wrong_shape_are_refused(shape: tuple[int, ...]) -> None:
    class Wrong:
        def derivatives(self, parameters: Array) -> Array:
            return np.zeros((*parameters.shape[:-1], *shape))

    with pytest.raises(InputError, match=r"derivatives have shape .* expected \(1, \d+, 10, 3\)"):
        solve_geodesic(Wrong(), (0, 0), (1, 1))


@pytest.mark.parametrize("value", [np.nan, 0.0])
def test_derivatives_that_say_nothing_give_no_length(value: float) -> None:
    class Useless:
        def derivatives(self, parameters: Array) -> Array:
            return np.full((*parameters.shape[:-1], 10, 3), value)

    solution = solve_geodesic(Useless(), (0, 0), (1, 1), on_failure="status")
    assert solution.status is Status.SINGULAR
    assert math.isnan(solution.length)
    assert solution.index == -1


def test_an_error_of_the_users_surface_comes_through() -> None:
    class Broken:
        def derivatives(self, parameters: Array) -> Array:
            raise KeyError(f"mine, of {parameters.ndim} axes")

    with pytest.raises(KeyError, match="mine"):
        solve_geodesic(Broken(), (0, 0), (1, 1), method=RBFCollocation(functions=4))
