"""The analysis: each statement of the page "analysis" is fitted here."""

import numpy as np
import pytest
from helpers.speed import quick
from helpers.surfaces.custom_surfaces import Torus

from bodymeasure.bench.problems.patches import mild_patches
from bodymeasure.geodesic import RBFCollocation, RBFRitz
from bodymeasure.paper.analysis.forms import forms_table, path_errors, quadrature_table
from bodymeasure.paper.analysis.linear_model import Form, fitted_order, model_error, solution
from bodymeasure.paper.analysis.orders import KERNELS, expected_orders, native_smoothness, orders
from bodymeasure.paper.analysis.statements import (
    Sphere,
    conjugate_table,
    superconvergence_tables,
)
from bodymeasure.paper.tables.beyond import ANY, Known, known_diagonals


@pytest.fixture(scope="module")
def known() -> Known:
    return known_diagonals("mild", mild_patches(np.random.default_rng(7), 60, 0.3))


def test_the_solution_of_the_model_solves_it() -> None:
    t = np.linspace(0.1, 0.9, 9)
    step = 1e-4
    value, slope, right = solution(t)
    before, after = solution(t - step), solution(t + step)
    np.testing.assert_allclose((after[0] - before[0]) / (2.0 * step), slope, rtol=1e-6, atol=1e-6)
    second = (after[1] - before[1]) / (2.0 * step)
    np.testing.assert_allclose(-second - 2.0 * value, right, rtol=1e-6, atol=1e-6)
    np.testing.assert_allclose(solution(np.array([0.0, 1.0]))[0], 0.0, atol=1e-15)


def test_kernels_have_the_smoothness_of_their_native_spaces() -> None:
    assert [native_smoothness(kernel) for kernel in KERNELS] == [2, 3, 4, 6]


@pytest.mark.parametrize("form", ["weak", "collocation"])
@pytest.mark.parametrize("kernel", quick(KERNELS), ids=str)
def test_orders_are_those_of_theory(kernel: object, form: Form) -> None:
    found, expected = orders(kernel, form), expected_orders(kernel, form)  # type: ignore[arg-type]
    np.testing.assert_allclose(found, expected, atol=0.15)


def test_an_order_is_that_of_a_power() -> None:
    counts = np.array([3, 5, 9])
    assert fitted_order(counts, 7.0 * counts**-2.5) == pytest.approx(2.5)
    errors = [model_error(KERNELS[0], count, "weak") for count in (8, 16)]
    assert errors[1].l2 < errors[0].l2 / 4.0


def test_the_weak_form_is_the_best_of_its_space_and_an_upper_bound(known: Known) -> None:
    rows = forms_table(known, (4, 8)).records
    outside = [row for row in rows if "outside" in row["functions"]]
    assert all(row["weak"] < 0.6 * row["collocation"] for row in outside)
    assert all(row["below"] == 0 for row in rows)
    inside = [row for row in rows if "inside" in row["functions"]]
    assert all(row["weak_solved"] >= 50 > row["collocation_solved"] for row in inside)
    # In the norm of the slopes, too: Cea's estimate with a constant near 1.
    weak, strong = (
        path_errors(known, method)
        for method in (
            RBFRitz(functions=8, tolerance=ANY),
            RBFCollocation(functions=8, tolerance=ANY, form="full"),
        )
    )
    assert np.median(weak.h1) < np.median(strong.h1)


def test_lengths_are_superconvergent_and_corrected_ones_more_so(known: Known) -> None:
    fits, _ = superconvergence_tables(known)
    for row in fits.records:
        assert row["raw"] == pytest.approx(2.0, abs=0.25)
        assert 2.8 < row["corrected"] < 4.2


def test_few_points_of_quadrature_lose_the_upper_bound(known: Known) -> None:
    rows = {row["points"]: row for row in quadrature_table(known).records}
    assert rows[8]["below_by_own"] > 20
    assert rows[24]["below_by_own"] == rows[24]["below_by_fine"] == 0
    assert rows[8]["excess"] > 2.0 * rows[24]["excess"]
    assert rows[16]["excess"] == pytest.approx(rows[24]["excess"], rel=1e-3)


def test_errors_grow_towards_conjugate_points() -> None:
    rows = conjugate_table((0.25, 0.7, 0.84)).records
    raw = [row["raw"] for row in rows]
    assert raw[0] < 1e-11 < raw[1] < 1e-9 < raw[2] < 1e-5
    assert [row["beta"] for row in rows] == pytest.approx([0.9375, 0.51, 0.2944])
    assert all(row["corrected"] < 1e-12 for row in rows)


def test_the_sphere_has_the_derivatives_of_a_sphere(rng: np.random.Generator) -> None:
    parameters = rng.random((5, 2))
    other = Torus(0.0, 1.0, span_u=1.3, span_v=2.0, begin_v=-1.0)
    np.testing.assert_allclose(
        Sphere(1.3).derivatives(parameters), other.derivatives(parameters), atol=1e-14
    )
