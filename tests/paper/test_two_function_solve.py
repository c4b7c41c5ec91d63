import numpy as np
import pytest
from helpers.surfaces.random_patches import wild_patches
from helpers.surfaces.surfaces import HYPERBOLIC_PARABOLOID, PH_CYLINDER, ph_cylinder_length
from scipy.optimize import brentq

from bodymeasure import InputError, RBFCollocation, solve_geodesic
from bodymeasure._typing import Array
from bodymeasure.geodesic import WU_C2
from bodymeasure.geodesic.lengths.equations import residual_and_jacobian
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.paper.method.arc_length import arc_lengths, inside_patch
from bodymeasure.paper.method.system_roots import system_roots
from bodymeasure.paper.method.two_function_solve import (
    COLLOCATION_POINTS,
    RULES,
    Rule,
    nodal_values,
    solve_two_functions,
)
from bodymeasure.paper.method.two_functions import even_points, paper_centers, paper_space


def pyramid(height: float) -> Array:
    """A patch that is symmetric about both diagonals."""
    x, y = np.meshgrid(np.arange(4) / 3, np.arange(4) / 3, indexing="ij")
    z = np.zeros((4, 4))
    z[1:3, 1:3] = height
    return np.stack([x, y, z], axis=-1)


def symmetric_root(height: float, t: float) -> tuple[Array, Array]:
    """The root on the diagonal that is nearest to the middle, and the Jacobian there."""
    net, space = pyramid(height)[None], paper_space((t,))
    (roots,) = system_roots(net, space).real
    roots = roots[np.abs(roots[:, 0] - roots[:, 1]) < 1e-7]
    root = roots[np.abs(roots[:, 0] - 0.5).argmin()]
    _, jacobian = residual_and_jacobian(BezierSurfaces(net), space, nodal_values(root[None]))
    return root, jacobian[0, :, 0, :, 0]


def determinant_across(height: float) -> float:
    """The change of the equations across the diagonal, which is zero where the determinant is."""
    jacobian = symmetric_root(height, 0.5)[1]
    return float(jacobian[0, 0] - jacobian[0, 1])


def test_a_symmetric_patch_with_a_zero_determinant_moves_the_collocation_point() -> None:
    # From this height on, the path over the top is not the shortest; just there, the symmetric
    # solution becomes three.
    critical = float(brentq(determinant_across, 0.3, 0.42, xtol=1e-15))
    net = pyramid(critical)[None]
    solution = solve_two_functions(net, "all")
    assert solution.degenerate[0] >= 1
    assert solution.collocation_point[0] in COLLOCATION_POINTS[1:]
    assert np.isfinite(solution.length[0])
    # A little lower, the middle point serves.
    lower = solve_two_functions(pyramid(0.9 * critical)[None], "all")
    assert (lower.degenerate[0], lower.collocation_point[0]) == (0, 0.5)
    # Without another collocation point there is no length.
    only = solve_two_functions(net, "all", collocation_points=(0.5,))
    assert np.isnan(only.length[0])
    assert np.isnan(only.collocation_point[0])


def test_where_no_path_stays_inside_the_collocation_point_moves() -> None:
    net = pyramid(0.39)[None]
    solution = solve_two_functions(net, "inside")
    assert (solution.inside[0], solution.degenerate[0]) == (0, 0)
    assert solution.collocation_point[0] in COLLOCATION_POINTS[1:]
    assert np.isnan(solve_two_functions(net, "inside", collocation_points=(0.5,)).length[0])


@pytest.mark.parametrize("rule", RULES)
def test_the_solution_meets_the_solvers_equations(rule: Rule, rng: np.random.Generator) -> None:
    nets = wild_patches(rng, 12)
    solution = solve_two_functions(nets, rule)
    for net, place, t in zip(nets, solution.place, solution.collocation_point, strict=True):
        if np.isnan(t):
            continue
        values = nodal_values(place[None])
        residual, jacobian = residual_and_jacobian(
            BezierSurfaces(net[None]), paper_space((t,)), values
        )
        assert np.abs(residual).max() < 1e-8 * np.abs(jacobian).max()


def test_newtons_method_finds_one_of_the_solutions(rng: np.random.Generator) -> None:
    # The solution is that of the general solver on the same trial space.
    nets = wild_patches(rng, 20, 1.0)
    method = RBFCollocation(
        WU_C2,
        centers=paper_centers(2),
        collocation_points=even_points(2),
        tolerance=1.0,
        form="full",
    )
    solution = solve_geodesic(nets, (0.0, 0.0), (1.0, 1.0), method=method, on_failure="status")
    matched = 0
    for batch in solution.batches:
        for problem, values in zip(batch.problems, batch.values, strict=True):
            (roots,) = system_roots(nets[problem][None], paper_space()).real
            matched += bool(np.abs(roots - values[:, 1]).max(axis=1).min() < 1e-8)
    assert matched >= 5


def test_paths_inside_are_no_shorter_than_the_shortest(rng: np.random.Generator) -> None:
    nets = wild_patches(rng, 30)
    truth = solve_geodesic(
        nets, (0.0, 0.0), (1.0, 1.0), search="thorough", on_failure="status"
    ).length
    length = solve_two_functions(nets, "inside").length
    known = np.isfinite(truth) & np.isfinite(length)
    assert known.sum() > 20
    assert (length[known] >= truth[known] * (1.0 - 1e-9)).all()


def test_the_shortest_of_all_is_no_longer_than_the_shortest_inside(
    rng: np.random.Generator,
) -> None:
    nets = wild_patches(rng, 30)
    every, inner = (solve_two_functions(nets, rule, (0.5,)) for rule in RULES)
    known = np.isfinite(inner.length)
    assert known.any()
    assert (every.length[known] <= inner.length[known]).all()
    np.testing.assert_array_equal(known, inner.inside > 0)
    np.testing.assert_array_equal(every.roots, inner.roots)
    assert (every.inside <= every.roots).all()


def test_lengths_scale_with_the_patch(rng: np.random.Generator) -> None:
    nets = wild_patches(rng, 8)
    here, there = (solve_two_functions(n, "inside") for n in (nets, 300.0 * nets + 7.0))
    np.testing.assert_allclose(there.length, 300.0 * here.length, rtol=1e-8)
    np.testing.assert_array_equal(there.roots, here.roots)


def test_an_unknown_rule_is_refused() -> None:
    rule: object = "longest"
    with pytest.raises(InputError, match="rule is 'longest'; expected one of all, inside"):
        solve_two_functions(pyramid(0.1)[None], rule)  # type: ignore[arg-type]


def test_lengths_of_curves_known_in_closed_form() -> None:
    nets = np.stack([PH_CYLINDER, HYPERBOLIC_PARABOLOID])
    # The path (u, v) = (t^2, 0) has a speed that changes.
    space = polynomial_space(4)
    values = np.stack([space.nodes**2, 0.0 * space.nodes])[None].repeat(2, axis=0)
    lengths = arc_lengths(BezierSurfaces(nets), space, values)
    expected = [ph_cylinder_length((0.0, 0.0), (1.0, 0.0)), 1.0]
    np.testing.assert_allclose(lengths, expected, rtol=1e-13)


def test_curves_that_leave_the_patch_between_nodes_are_seen() -> None:
    space = polynomial_space(2)
    values = np.array([[[0.0, 0.9, 1.0], [0.0, 0.5, 1.0]], [[0.0, 0.6, 1.0], [0.0, 0.5, 1.0]]])
    # 2.6 t - 1.6 t^2 has a maximum above 1.
    np.testing.assert_array_equal(inside_patch(space, values), [False, True])
