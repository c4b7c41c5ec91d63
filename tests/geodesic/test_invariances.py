"""Changes that must not affect a length, and changes that must affect it in a known way."""

import numpy as np
import pytest
from helpers.oracles.straight_line import from_straight_line
from helpers.surfaces.surfaces import ENNEPER, PARABOLOID, PLANE, SURFACES
from scipy.spatial.transform import Rotation

from bodymeasure._typing import Array
from bodymeasure.bezier import elevate, restrict
from bodymeasure.geodesic import GeodesicSolution, RBFCollocation, solve_geodesic

NETS = np.stack([surface.control_points for surface in SURFACES])
STARTS = np.array([surface.start for surface in SURFACES])
ENDS = np.array([surface.end for surface in SURFACES])
T = np.linspace(0.0, 1.0, 7)


@pytest.fixture(scope="module")
def known() -> GeodesicSolution:
    return solve_geodesic(NETS, STARTS, ENDS)


def agrees(solution: GeodesicSolution, known: GeodesicSolution, scale: float = 1.0) -> None:
    """Check that lengths agree to rounding and to their two estimates."""
    np.testing.assert_allclose(solution.length / scale, known.length, rtol=2e-14)
    assert solution.converged.all()


def test_swapping_the_ends(known: GeodesicSolution) -> None:
    back = solve_geodesic(NETS, ENDS, STARTS)
    agrees(back, known)
    np.testing.assert_allclose(back.path(T), known.path(1.0 - T), atol=1e-12)


def test_rigid_motion(known: GeodesicSolution, rng: np.random.Generator) -> None:
    rotation = _rotation(rng)
    agrees(solve_geodesic(NETS @ rotation.T + rng.normal(size=3), STARTS, ENDS), known)


def _rotation(rng: np.random.Generator) -> Array:
    return np.asarray(Rotation.from_rotvec(rng.normal(size=3)).as_matrix())


def test_reflection(known: GeodesicSolution) -> None:
    agrees(solve_geodesic(NETS * [1.0, -1.0, 1.0], STARTS, ENDS), known)


@pytest.mark.parametrize("scale", [1e-200, 1e-3, 1.0 / 3.0, 1e3, 1e6, 1e200])
def test_scale(known: GeodesicSolution, scale: float) -> None:
    solution = solve_geodesic(NETS * scale, STARTS, ENDS)
    agrees(solution, known, scale)
    np.testing.assert_allclose(solution.raw_length / scale, known.raw_length, rtol=1e-13)
    # Estimates are rough, but scale with the length; their parts due to rounding scale with the
    # patch's size, which is only known to a factor of 2.
    np.testing.assert_allclose(solution.error_estimate / scale, known.error_estimate, rtol=0.5)
    np.testing.assert_allclose(solution.residual, known.residual, rtol=1e-3, atol=1e-12)


@pytest.mark.parametrize("turned", [(True, False), (False, True), (True, True)])
def test_turning_parameters_round(known: GeodesicSolution, turned: tuple[bool, bool]) -> None:
    nets, starts, ends = NETS, STARTS.copy(), ENDS.copy()
    for axis in range(2):
        if turned[axis]:
            nets = np.flip(nets, axis=1 + axis)
            starts[:, axis], ends[:, axis] = 1.0 - starts[:, axis], 1.0 - ends[:, axis]
    solution = solve_geodesic(nets, starts, ends)
    agrees(solution, known)
    expected = np.where(turned, 1.0 - known.path(T), known.path(T))
    np.testing.assert_allclose(solution.path(T), expected, atol=1e-12)


def test_swapping_u_and_v(known: GeodesicSolution) -> None:
    solution = solve_geodesic(NETS.swapaxes(1, 2), STARTS[:, ::-1], ENDS[:, ::-1])
    agrees(solution, known)
    np.testing.assert_allclose(solution.path(T), known.path(T)[..., ::-1], atol=1e-12)


def test_a_part_of_a_patch(known: GeodesicSolution) -> None:
    paths = known.path(np.linspace(0.0, 1.0, 101))
    lower, upper = paths.min(axis=1), paths.max(axis=1)
    lower, upper = lower - 0.3 * lower, upper + 0.3 * (1.0 - upper)
    starts, ends = (np.clip((p - lower) / (upper - lower), 0.0, 1.0) for p in (STARTS, ENDS))
    agrees(solve_geodesic(restrict(NETS, lower, upper), starts, ends), known)


def test_pieces_of_a_geodesic_add_up(known: GeodesicSolution) -> None:
    # The geodesic between points on a geodesic is a part of it, so that the lengths add up.
    middle = np.clip(known.path(0.37), 0.0, 1.0)
    first = solve_geodesic(NETS, STARTS, middle)
    second = solve_geodesic(NETS, middle, ENDS)
    # A path is found to some 1e-6; a point beside the geodesic makes a detour of its square.
    np.testing.assert_allclose(first.length + second.length, known.length, rtol=1e-8)
    np.testing.assert_allclose(first.length, 0.37 * known.length, rtol=1e-3)


def test_two_parts_across_a_seam() -> None:
    # Enneper's diagonal crosses the line u = 0.4 at (0.4, 0.4).
    left = restrict(ENNEPER, (0.0, 0.0), (0.4, 1.0))
    right = restrict(ENNEPER, (0.4, 0.0), (1.0, 1.0))
    whole = solve_geodesic(ENNEPER, (0.0, 0.0), (1.0, 1.0)).length
    parts = solve_geodesic(
        np.stack([left, right]), [(0.0, 0.0), (0.0, 0.4)], [(1.0, 0.4), (1.0, 1.0)]
    )
    assert parts.length.sum() == pytest.approx(whole, rel=1e-14)


@pytest.mark.parametrize("degrees", [(4, 3), (5, 4), (3, 9)])
def test_degree_elevation(known: GeodesicSolution, degrees: tuple[int, int]) -> None:
    agrees(solve_geodesic(elevate(NETS, *degrees), STARTS, ENDS), known)


def test_lower_degrees_are_taken_as_they_are() -> None:
    bilinear = np.array([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]])
    start, end = np.array([[0.0, 0.0], [0.3, 1.0]]), np.array([[1.0, 1.0], [0.8, 0.1]])
    low = solve_geodesic(bilinear, start, end)
    assert low.length[0] == pytest.approx(np.sqrt(6) / 2 + np.arcsinh(np.sqrt(2)) / 2, rel=1e-14)
    for degrees in ((1, 2), (2, 1), (3, 3)):
        raised = solve_geodesic(elevate(bilinear, *degrees), start, end)
        np.testing.assert_allclose(raised.length, low.length, rtol=1e-14)


def test_a_batch_is_its_problems_one_by_one(known: GeodesicSolution) -> None:
    for i, surface in enumerate(SURFACES):
        one = solve_geodesic(surface.control_points, surface.start, surface.end)
        assert one.length == pytest.approx(known.length[i], rel=1e-15)
        assert one.functions == known.functions[i]
        assert one.iterations == known.iterations[i]
        np.testing.assert_allclose(one.path(T), known.path(T)[i], atol=1e-14)


def test_more_problems_than_are_solved_at_once(known: GeodesicSolution) -> None:
    # With three numbers of functions each problem moves through several batches.
    count = 1203
    which = np.arange(count) % len(NETS)
    method = RBFCollocation(functions=(5, 8, 12))
    many = solve_geodesic(NETS[which], STARTS[which], ENDS[which], method=method)
    few = solve_geodesic(NETS, STARTS, ENDS, method=method)
    assert len(set(few.functions)) > 1
    np.testing.assert_allclose(many.length, few.length[which], rtol=1e-14)
    np.testing.assert_array_equal(many.functions, few.functions[which])
    np.testing.assert_allclose(many.path(T), few.path(T)[which], atol=1e-13)
    np.testing.assert_allclose(many.length, known.length[which], rtol=1e-10)
    # Every problem is in exactly one batch.
    listed = np.concatenate([batch.problems for batch in many.batches])
    np.testing.assert_array_equal(np.sort(listed), np.arange(count))


def test_each_of_many_problems_gets_its_own_answer() -> None:
    count = 1000
    ends = np.stack([np.linspace(0.2, 1.0, count), np.linspace(1.0, 0.3, count)], axis=1)
    many = solve_geodesic(PARABOLOID, (0.0, 0.0), ends)
    np.testing.assert_array_equal(many.end, ends)
    np.testing.assert_allclose(many.path(1.0), ends, atol=1e-16)
    # From the apex, geodesics are meridians of the surface of revolution.
    r = np.hypot(*ends.T)
    meridian = r * np.sqrt(1 + 4 * r * r) / 2 + np.arcsinh(2 * r) / 4
    np.testing.assert_allclose(many.length, meridian, rtol=1e-10)
    assert (np.abs(many.length - meridian) <= many.error_estimate).all()


def test_shapes_broadcast() -> None:
    starts = np.array([[0.0, 0.0], [0.1, 0.3], [0.2, 0.2]])
    ends = np.array([[1.0, 1.0], [0.9, 0.8]])
    nets = np.stack([ENNEPER, PARABOLOID, PLANE, 2.0 * PLANE])
    solution = solve_geodesic(nets[:, None, None], starts[:, None], ends)
    assert solution.shape == (4, 3, 2)
    assert solution.start.shape == solution.end.shape == (4, 3, 2, 2)
    np.testing.assert_array_equal(solution.start[2, 1, 0], starts[1])
    np.testing.assert_array_equal(solution.end[2, 1, 1], ends[1])
    for i, j, k in np.ndindex(4, 3, 2):
        one = solve_geodesic(nets[i], starts[j], ends[k])
        assert solution.length[i, j, k] == pytest.approx(one.length, rel=1e-14)
    np.testing.assert_allclose(solution.length[3], 2.0 * solution.length[2], rtol=1e-14)
    # One patch with many points, given as lists.
    assert solve_geodesic(PLANE.tolist(), [0, 0], [[1, 1], [1, 0]]).shape == (2,)


def test_arguments_stay_as_they_are() -> None:
    nets, starts, ends = NETS.copy(), STARTS.copy(), ENDS.copy()
    for array in (nets, starts, ends):
        array.flags.writeable = False
    solution = solve_geodesic(nets, starts, ends)
    starts_given = np.array([0.0, 0.0])
    other = solve_geodesic(ENNEPER, starts_given, (1.0, 1.0))
    starts_given[:] = 0.5
    np.testing.assert_array_equal(other.start, 0.0)
    np.testing.assert_array_equal(nets, NETS)
    np.testing.assert_array_equal(solution.start, STARTS)


def test_numpys_error_state_stays_as_it_is() -> None:
    fold = PLANE.copy()
    fold[1:3] = fold[2:0:-1] * [3.0, 1.0, -1.0]
    for state in ("raise", "warn"):
        with np.errstate(divide=state, invalid=state):
            before = np.geterr()
            from_straight_line(fold, (0.0, 0.0), (1.0, 1.0), on_failure="status")
            assert np.geterr() == before
