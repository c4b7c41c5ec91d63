"""The correction of a length, its error estimate, and the proof that a path is a minimum."""

import numpy as np
import pytest
from helpers.oracles.straight_line import from_straight_line
from helpers.speed import quick
from helpers.surfaces.surfaces import (
    ENNEPER,
    PH_CYLINDER,
    SURFACES,
    TANGENT_DEVELOPABLE,
    Surface,
    bicubic,
)

from bodymeasure._typing import Array
from bodymeasure.geodesic import WU_C2, WU_C4, Kernel, RBFCollocation, solve_geodesic
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.lengths.measure import measure_length
from bodymeasure.geodesic.lengths.path_geometry import path_geometry
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces

FINE = RBFCollocation(functions=20, tolerance=1e-9)
(SPACE,) = FINE.spaces


def geodesic(surface: Surface) -> Array:
    """The nodal values of a geodesic that is resolved to rounding."""
    (batch,) = solve_geodesic(
        surface.control_points, surface.start, surface.end, method=FINE
    ).batches
    return np.asarray(batch.values[0])


def bows(count: int, rng: np.random.Generator) -> Array:
    """Smooth variations of size one that keep the ends, shape (count, 2, nodes)."""
    t = SPACE.nodes
    shapes = np.stack([np.sin(k * np.pi * t) / k for k in range(1, 4)])
    random = rng.normal(size=(count, 2, 3)) @ shapes
    return np.asarray(random / np.abs(random).max(axis=(1, 2), keepdims=True))


def measured(net: Array, values: Array, space: TrialSpace = SPACE) -> Length:
    return measure_length(
        BezierSurfaces(np.broadcast_to(net, (len(values), *net.shape))), space, values
    )


CURVED = [
    s
    for s in SURFACES
    if s.name in ("enneper", "ph_cylinder, oblique", "tangent_developable", "plane, oblique")
]
SIZES = np.array([0.04, 0.028, 0.02, 0.014, 0.01])


@pytest.mark.parametrize("surface", CURVED, ids=lambda surface: surface.name)
def test_the_correction_takes_the_second_order_away(
    surface: Surface, rng: np.random.Generator
) -> None:
    values = geodesic(surface)
    for bow in bows(4, rng):
        result = measured(surface.control_points, values + SIZES[:, None, None] * bow)
        raw = result.raw - surface.length
        left = np.abs(raw - result.correction)
        # A detour is longer, and by the square of its size.
        assert (raw > 0.0).all()
        assert np.polyfit(np.log(SIZES), np.log(raw), 1)[0] == pytest.approx(2.0, abs=0.1)
        assert np.polyfit(np.log(SIZES), np.log(left), 1)[0] > 2.8
        assert (left < 0.1 * raw).all()
        assert (left <= result.error).all()
        assert (result.error < raw).all()


@pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
def test_a_geodesic_needs_no_correction(surface: Surface) -> None:
    result = measured(surface.control_points, geodesic(surface)[None])
    assert abs(result.correction[0]) < 1e-15 * surface.length
    assert abs(result.raw[0] - surface.length) <= result.error[0] < 1e-12 * surface.length
    assert result.residual[0] < 1e-5
    assert result.minimal[0]


def test_the_residual_is_geodesic_curvature_times_length() -> None:
    # The path is an arc in a plane, of radius 1/2 over an angle of one radian.
    plane = bicubic({(1, 0): 1}, {(0, 1): 1}, {})
    angle = 0.3 + SPACE.nodes
    arc = 0.5 + 0.5 * np.stack([np.cos(angle), np.sin(angle)])
    result = measured(plane, arc[None])
    assert result.residual[0] == pytest.approx(1.0, rel=1e-6)
    assert result.raw[0] == pytest.approx(0.5, rel=1e-10)
    # The chord is 2 r sin(1/2); to leading order the arc is too long by r / 24.
    assert result.correction[0] == pytest.approx(0.5 / 24, rel=1e-6)
    assert abs(result.raw[0] - result.correction[0] - np.sin(0.5)) <= result.error[0]


def test_running_along_a_geodesic_at_uneven_speed_changes_no_length() -> None:
    t = SPACE.nodes
    uneven = t + 0.1 * t * (1 - t) * (1 + t)
    result = measured(ENNEPER, np.stack([uneven, uneven])[None])
    assert result.raw[0] == pytest.approx(5 * np.sqrt(2) / 3, rel=1e-14)
    assert abs(result.correction[0]) < 1e-15
    assert abs(result.raw[0] - 5 * np.sqrt(2) / 3) <= result.error[0] < 1e-11


def test_the_estimate_has_the_unit_of_the_length(rng: np.random.Generator) -> None:
    t = SPACE.nodes
    values = np.stack([t, t])[None] + 0.01 * bows(5, rng)
    one, thousand = measured(ENNEPER, values), measured(1e3 * ENNEPER, values)
    for name in ("raw", "correction", "error"):
        np.testing.assert_allclose(getattr(thousand, name), 1e3 * getattr(one, name), rtol=1e-9)
    np.testing.assert_allclose(thousand.residual, one.residual, rtol=1e-9)


def test_a_path_that_stands_still_has_an_infinite_error() -> None:
    t = SPACE.nodes
    values = np.stack([np.full((2, len(t)), 0.5), np.stack([t, t])])
    result = measured(ENNEPER, values)
    assert np.isinf(result.error[0])
    assert not result.minimal[0]
    # The other problem of the batch is not affected.
    assert result.error[1] < 1e-10
    assert result.minimal[1]


def test_a_path_of_nans_has_an_infinite_error() -> None:
    t = SPACE.nodes
    values = np.stack([np.full((2, len(t)), np.nan), np.stack([t, t])])
    result = measured(ENNEPER, values)
    assert np.isinf(result.error[0])
    assert np.isfinite(result.error[1])


def jacobi_eigenvalue(net: Array, values: Array) -> tuple[float, float]:
    """Smallest eigenvalue of -psi'' - K psi with zero ends, by differences, in units of (pi / L)^2.

    The second value is L times the integral of the positive part of K.
    """
    n = 150
    t = (np.arange(1, n)) / n
    place, velocity, second = (values @ rows.T for rows in SPACE.matrices(t))
    geometry = path_geometry(BezierSurfaces(net[None]), place[None], velocity[None], second[None])
    speed, curvature = geometry.speed[:, 0], geometry.gaussian_curvature[:, 0]
    # The speed is nearly constant, so that s = t L.
    length = float(speed.mean())
    matrix = np.diag(2.0 * n * n / length**2 - curvature)
    off = -n * n / length**2 * np.ones(n - 2)
    matrix += np.diag(off, 1) + np.diag(off, -1)
    positive = length * length * float(np.maximum(curvature, 0.0).mean())
    return float(np.linalg.eigvalsh(matrix)[0] * (length / np.pi) ** 2), positive


def test_a_minimum_is_what_the_second_variation_says() -> None:
    # Over a hill that rises: from a slope on which every test passes to where only the
    # eigenvalues tell, to where the way over the top is no minimum any more.
    seen = set()
    for height in np.linspace(0.2, 3.0, 29):
        net = bicubic(
            {(1, 0): 2},
            {(0, 1): 2},
            {(i, j): height * a * b for i, a in ((1, 4), (2, -4)) for j, b in ((1, 4), (2, -4))},
        )
        solution = from_straight_line(net, (0.0, 0.5), (1.0, 0.5), method=FINE, on_failure="status")
        (batch,) = solution.batches
        if not np.isfinite(solution.error_estimate) or solution.residual > 1e-3:
            continue
        # By symmetry the path straight over the top is a geodesic.
        assert np.abs(batch.values[0, 1] - 0.5).max() < 1e-9
        eigenvalue, positive = jacobi_eigenvalue(net, batch.values[0])
        if abs(eigenvalue) < 0.02:
            continue
        assert solution.local_minimum == (eigenvalue > 0.0)
        if positive < 3.9:
            # Lyapunov's inequality
            assert eigenvalue > 0.0
        seen.add((positive < 4.0, bool(eigenvalue > 0.0)))
    assert seen == {(True, True), (False, True), (False, False)}


def test_a_saddle_is_a_minimum_however_long(rng: np.random.Generator) -> None:
    saddle = bicubic({(1, 0): 9, (0, 0): -4}, {(0, 1): 9, (0, 0): -4}, {(1, 1): 30})
    solution = from_straight_line(
        saddle, rng.random((20, 2)), rng.random((20, 2)), on_failure="status"
    )
    assert solution.converged.sum() > 10
    assert solution.local_minimum[solution.converged].all()


def test_what_is_cut_off_is_counted() -> None:
    # With few functions, the shift that would lead to the geodesic has parts beyond the modes.
    for functions in (3, 4, 5, 6, 7, 8):
        for net, start, end in (
            (TANGENT_DEVELOPABLE, (0.0, 1.0), (1.0, 0.3)),
            (PH_CYLINDER, (0.0, 0.0), (1.0, 1.0)),
        ):
            exact = next(s.length for s in SURFACES if s.control_points is net and s.start == start)
            solution = from_straight_line(
                net,
                start,
                end,
                method=RBFCollocation(functions=functions, tolerance=1e-1),
                on_failure="status",
            )
            if solution.converged:
                assert abs(solution.length - exact) <= solution.error_estimate


def test_many_modes_are_assembled_as_few_are(
    monkeypatch: pytest.MonkeyPatch, rng: np.random.Generator
) -> None:
    # With many modes the products of all pairs are not kept; the systems are the same.
    values = geodesic(CURVED[0]) + 0.01 * bows(3, rng)
    few = measured(CURVED[0].control_points, values)
    monkeypatch.setattr("bodymeasure.geodesic.lengths.jacobi.MOST_IN_ONE_PRODUCT", 1)
    many = measured(CURVED[0].control_points, values)
    np.testing.assert_allclose(many.correction, few.correction, rtol=1e-11)
    np.testing.assert_allclose(many.error, few.error, rtol=1e-6)
    np.testing.assert_array_equal(many.index, few.index)


@pytest.mark.parametrize("functions", quick([14, 20, 16, 24], first=2))
@pytest.mark.parametrize("kernel", [WU_C2, WU_C4], ids=lambda kernel: kernel.name)
def test_what_kinks_cost_is_counted(
    kernel: Kernel, functions: int, rng: np.random.Generator
) -> None:
    # With centers inside (0, 1) the second derivative of a path has kinks there, and the shift to
    # the geodesic is no sum of the first modes.
    nets = ENNEPER + 0.3 * rng.normal(size=(40, 4, 4, 3))
    ends = ((0.1, 0.2), (0.8, 0.9))
    exact = from_straight_line(nets, *ends, method=FINE, on_failure="status")
    rough = RBFCollocation(kernel, functions, tolerance=1e-4)
    solution = from_straight_line(nets, *ends, method=rough, on_failure="status")
    known = exact.converged & solution.converged
    assert known.sum() > 20
    off = np.abs(solution.length - exact.length)[known]
    assert (off <= (solution.error_estimate + exact.error_estimate)[known]).all()
    assert np.median(off / exact.length[known]) < 1e-8
