"""The trial space against the paper's equations (5) and (6), evaluated in fractions."""

import math
from fractions import Fraction

import numpy as np
import pytest

from bodymeasure import InputError
from bodymeasure.geodesic import WU_C2, WU_C4, WU_C6, WU_C10, Kernel, RBFCollocation
from bodymeasure.geodesic.methods.rbf_collocation import (
    FUNCTIONS,
    chebyshev_points,
    default_centers,
)
from bodymeasure.geodesic.spaces.rbf import rbf_coefficients, rbf_space
from bodymeasure.geodesic.spaces.trial_space import TrialSpace

KERNELS = [WU_C2, WU_C4, WU_C6, WU_C10]
POINTS = np.concatenate([np.linspace(0.0, 1.0, 33), [1e-12, 0.349999, 0.35, 0.350001]])

# Centers and support radius; the paper's own pair is 1 and 1.5.
LAYOUTS: dict[str, tuple[tuple[float, ...], float]] = {
    "paper": ((1.0, 1.5), 2.0),
    "outside": ((-0.7, -0.45, -0.1, 1.1, 1.3, 1.75), 2.0),
    "ends": (tuple(0.5 - 0.5 * np.cos(np.pi * np.arange(8) / 7)), 2.0),
    "inside and outside": ((-0.5, -0.2, 0.25, 0.75, 1.2, 1.5), 1.0),
    "short supports": ((-0.05, 0.1, 0.3, 0.5, 0.7, 0.9), 0.35),
    "one": ((0.4,), 0.75),
}


def space(kernel: Kernel, centers: tuple[float, ...], radius: float) -> TrialSpace:
    return rbf_space(kernel, centers, tuple(chebyshev_points(len(centers) - 1)), radius)


def expansion(
    kernel: Kernel,
    centers: tuple[float, ...],
    radius: float,
    coefficients: list[Fraction],
    t: float,
    order: int,
) -> Fraction:
    """The exact value of a derivative of a_0 + sum a_i phi(|t - c_i| / r)."""
    polynomial = [Fraction(c) for c in kernel.coefficients]
    for _ in range(order):
        polynomial = [q * c for q, c in enumerate(polynomial)][1:]
    total = coefficients[0] if order == 0 else Fraction(0)
    for center, a in zip(centers, coefficients[1:], strict=True):
        offset = (Fraction(t) - Fraction(center)) / Fraction(radius)
        if abs(offset) < 1:
            side = -1 if offset < 0 and order % 2 else 1
            value = sum(c * abs(offset) ** q for q, c in enumerate(polynomial))
            total += a * side * value / Fraction(radius) ** order
    return total


layouts = pytest.mark.parametrize(("centers", "radius"), LAYOUTS.values(), ids=LAYOUTS.keys())
all_kernels = pytest.mark.parametrize("kernel", KERNELS, ids=lambda kernel: kernel.name)


@all_kernels
@layouts
def test_functions_are_cardinal(kernel: Kernel, centers: tuple[float, ...], radius: float) -> None:
    trial = space(kernel, centers, radius)
    assert trial.size == len(centers)
    assert trial.nodes[0] == 0.0
    assert trial.nodes[-1] == 1.0
    assert (np.diff(trial.nodes) > 0.0).all()
    np.testing.assert_allclose(
        trial.matrices(trial.nodes)[0], np.eye(len(trial.nodes)), rtol=0.0, atol=1e-15
    )


@all_kernels
@layouts
def test_constants_are_reproduced(
    kernel: Kernel, centers: tuple[float, ...], radius: float
) -> None:
    matrices = space(kernel, centers, radius).matrices(POINTS)
    np.testing.assert_allclose(matrices[0].sum(axis=1), 1.0, rtol=1e-14)
    sizes = np.abs(matrices).sum(axis=2)
    assert (np.abs(matrices[1:].sum(axis=2)) <= 1e-14 * sizes[1:]).all()


@all_kernels
@layouts
def test_an_expansion_and_its_derivatives_come_back_from_its_nodal_values(
    kernel: Kernel, centers: tuple[float, ...], radius: float, rng: np.random.Generator
) -> None:
    trial = space(kernel, centers, radius)
    coefficients = [Fraction(int(a), 64) for a in rng.integers(-64, 65, len(centers) + 1)]

    def exact(t: float, order: int) -> float:
        return float(expansion(kernel, centers, radius, coefficients, t, order))

    nodal = np.array([exact(t, 0) for t in trial.nodes.tolist()])
    matrices = trial.matrices(POINTS)
    for order in range(3):
        expected = np.array([exact(t, order) for t in POINTS.tolist()])
        # This is the largest effect of rounding the nodal values.
        reach = 4e-16 * np.abs(matrices[order]) @ np.abs(nodal)
        error = np.abs(matrices[order] @ nodal - expected)
        assert (error <= reach + 1e-14 * np.abs(expected).max()).all()


@pytest.mark.parametrize("count", FUNCTIONS)
def test_the_default_spaces_hold_to_rounding(count: int, rng: np.random.Generator) -> None:
    # Their condition numbers go beyond what double precision could invert.
    centers = tuple(default_centers(WU_C10, count).tolist())
    trial = space(WU_C10, centers, 2.0)
    coefficients = [Fraction(int(a), 64) for a in rng.integers(-64, 65, count + 1)]
    nodal, expected, slopes = (
        np.array(
            [
                float(expansion(WU_C10, centers, 2.0, coefficients, t, order))
                for t in points.tolist()
            ]
        )
        for points, order in ((trial.nodes, 0), (POINTS, 0), (POINTS, 1))
    )
    matrices = trial.matrices(POINTS)
    np.testing.assert_allclose(matrices[0] @ nodal, expected, rtol=0, atol=2e-14 * nodal.max())
    np.testing.assert_allclose(
        matrices[1] @ nodal, slopes, rtol=0, atol=2e-14 * count**2 * nodal.max()
    )
    assert np.abs(matrices[0]).sum(axis=1).max() < 10.0


def test_all_polynomials_up_to_the_kernels_degree_are_in_reach() -> None:
    centers = (-0.1, -0.3, -0.5, -0.7, 1.1, 1.2, 1.4, 1.6, 1.8)
    trial = space(WU_C2, centers, 2.0)
    matrices = trial.matrices(POINTS)
    for degree in range(10):
        nodal = trial.nodes**degree
        for order in range(3):
            scale = math.perm(degree, order)
            expected = scale * POINTS ** max(degree - order, 0)
            np.testing.assert_allclose(
                matrices[order] @ nodal, expected, rtol=0, atol=1e-13 * 40**order
            )


@all_kernels
def test_derivatives_beyond_the_nodes_are_those_of_the_values(kernel: Kernel) -> None:
    trial = space(kernel, *LAYOUTS["short supports"])
    h = 1e-4
    t = np.linspace(0.01, 0.99, 57)
    at = {k: trial.matrices(t + k * h)[0] for k in (-2, -1, 0, 1, 2)}
    _, first, second = trial.matrices(t)
    # A kernel that is twice differentiable has kinks in its third derivative: order h^2 and h.
    scale = np.abs(second).max()
    np.testing.assert_allclose(
        (8 * (at[1] - at[-1]) - (at[2] - at[-2])) / (12 * h), first, atol=1e-6 * scale
    )
    np.testing.assert_allclose(
        (at[1] - 2 * at[0] + at[-1]) / h**2,
        second,
        atol=(1e-2 if kernel is WU_C2 else 1e-4) * scale,
    )


def test_second_derivatives_are_continuous_across_the_ends_of_supports() -> None:
    for kernel in KERNELS:
        centers, radius = LAYOUTS["short supports"]
        trial = space(kernel, centers, radius)
        breaks = trial.functions.edges[1:-1]
        assert {round(b, 12) for b in breaks.tolist()} == {
            round(c + s * radius, 12)
            for c in centers
            for s in (-1, 0, 1)
            if 0.0 < round(c + s * radius, 12) < 1.0
        }
        step = 1e-9
        ahead, behind = trial.matrices(breaks + step), trial.matrices(breaks - step)
        scale = np.abs(ahead).max(axis=(1, 2))
        jump = np.abs(ahead - behind).max(axis=(1, 2))
        assert (jump < 1e-6 * scale).all()


def test_quadrature_of_a_space_keeps_to_its_pieces() -> None:
    trial = space(WU_C2, *LAYOUTS["short supports"])
    # Piecewise polynomials are integrated exactly only if no piece is cut across.
    integral = trial.quadrature.integrate(trial.at_quadrature[1])
    ends = trial.matrices([0.0, 1.0])[0]
    np.testing.assert_allclose(integral, ends[1] - ends[0], atol=1e-13)


def test_short_supports_are_compact() -> None:
    # A function whose support ends at 0.3 does not know what is done at nodes beyond: a change
    # of its coefficient moves nothing there.
    centers, radius = LAYOUTS["short supports"]
    trial = space(WU_C4, centers, radius)
    only_first = [Fraction(0), Fraction(1)] + 5 * [Fraction(0)]
    nodal = np.array(
        [float(expansion(WU_C4, centers, radius, only_first, t, 0)) for t in trial.nodes.tolist()]
    )
    beyond = np.linspace(0.3001, 1.0, 50)
    assert np.abs(trial.matrices(beyond)[0] @ nodal).max() < 1e-15 * np.abs(nodal).max() * 1e3
    assert (trial.matrices([0.2])[0] @ nodal)[0] > 1e-2


@layouts
def test_coefficients_are_those_of_the_papers_equations(
    centers: tuple[float, ...], radius: float, rng: np.random.Generator
) -> None:
    trial = space(WU_C2, centers, radius)
    nodal = np.stack([trial.nodes + 0.1 * np.sin(3 * trial.nodes), rng.random(len(trial.nodes))], 1)
    coefficients = rbf_coefficients(WU_C2, centers, radius, trial.nodes, nodal)
    assert coefficients.shape == nodal.shape
    for column in range(2):
        a = [Fraction(c) for c in coefficients[:, column].tolist()]
        size = max(abs(float(c)) for c in a) * WU_C2.coefficients[0]
        for t in (0.0, 0.17, 0.5, 0.93, 1.0):
            expected = (trial.matrices([t])[0] @ nodal[:, column])[0]
            value = float(expansion(WU_C2, centers, radius, a, t, 0))
            # The coefficients are exact to rounding, but their terms may cancel.
            assert value == pytest.approx(expected, abs=2e-15 * size + 1e-14)


def test_coefficients_of_a_known_expansion_come_back_exactly() -> None:
    centers, radius = LAYOUTS["paper"]
    known = [Fraction(3, 8), Fraction(-5, 16), Fraction(7, 32)]
    nodes = np.array([0.0, 0.5, 1.0])
    nodal = np.array(
        [float(expansion(WU_C2, centers, radius, known, t, 0)) for t in nodes.tolist()]
    )
    np.testing.assert_allclose(
        rbf_coefficients(WU_C2, centers, radius, nodes, nodal), np.array(known, float), rtol=1e-13
    )


def test_breaks_that_differ_by_rounding_are_one() -> None:
    # -1.7 + 2 is not 0.3 in binary.
    trial = space(WU_C2, (-1.7, 0.3, 0.6, 1.5), 2.0)
    np.testing.assert_allclose(trial.functions.edges, [0.0, 0.3, 0.6, 1.0])


def test_singular_systems_have_no_coefficients() -> None:
    with pytest.raises(InputError, match="singular"):
        rbf_coefficients(WU_C2, (0.2, 0.2), 2.0, np.array([0.0, 0.5, 1.0]), np.zeros(3))


@pytest.mark.parametrize("kernel", [WU_C2, WU_C10], ids=lambda kernel: kernel.name)
def test_lines_can_be_put_into_a_space(kernel: Kernel, rng: np.random.Generator) -> None:
    (space,) = RBFCollocation(kernel, 5).spaces
    t = np.linspace(0.0, 1.0, 41)
    line = 0.3 - 1.7 * t
    values = 0.3 - 1.7 * space.nodes
    here, there = space.matrices(t), space.with_lines.matrices(t)
    assert np.abs(here[0] @ values - line).max() > 1e-9
    np.testing.assert_allclose(there[0] @ values, line, rtol=0.0, atol=1e-14)
    np.testing.assert_allclose(there[1] @ values, -1.7, rtol=1e-12)
    np.testing.assert_allclose(there[2] @ values, 0.0, atol=1e-10)
    # Functions that vanish at the ends are unchanged.
    offset = rng.normal(size=len(space.nodes))
    offset[[0, -1]] = 0.0
    np.testing.assert_allclose(there @ offset, here @ offset, rtol=1e-12, atol=1e-12)
