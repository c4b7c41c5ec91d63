"""Enclosures of lengths in ball arithmetic."""

import sys

import numpy as np
import pytest
from flint import arb, fmpq, fmpq_poly
from helpers.speed import quick
from helpers.surfaces.height_fields import bent_plane

import bodymeasure as bm
from bodymeasure.bench.problems.patches import mild_patches
from bodymeasure.bezier import elevate, evaluate
from bodymeasure.geodesic.proofs.curvature import curvature_bounds
from bodymeasure.geodesic.rigorous.bounds import exact_polynomial, integers
from bodymeasure.geodesic.rigorous.curvature import exact_bounds
from bodymeasure.geodesic.rigorous.path import enclose_path, is_inside, path_forms

CLOSED_FORMS = {
    "hyperbolic_paraboloid": (np.sqrt(6.0) + np.arcsinh(np.sqrt(2.0))) / 2.0,
    "enneper": 5.0 * np.sqrt(2.0) / 3.0,
    "ph_cylinder": 5.0,
}


def solved(net: np.ndarray) -> bm.GeodesicSolution:
    return bm.solve_geodesic(net, (0.0, 0.0), (1.0, 1.0))


@pytest.mark.parametrize("name", quick(CLOSED_FORMS))
def test_an_enclosure_contains_the_closed_form(name: str) -> None:
    solution = solved(bm.load_sample(name).control_points[0])
    lower, upper = bm.enclose(solution)
    assert lower <= CLOSED_FORMS[name] <= upper
    assert upper - lower <= 1e-9 * upper
    # Poor paths give wide enclosures, which hold.
    wide = bm.enclose(solution, degree=4)
    assert wide.lower <= CLOSED_FORMS[name] <= wide.upper
    assert wide.upper - wide.lower >= upper - lower


def test_a_patch_that_is_curved_too_much_has_the_distance_in_space() -> None:
    lower, upper = bm.enclose(solved(bm.load_sample("paraboloid").control_points[0]))
    assert lower == pytest.approx(np.sqrt(6.0), rel=1e-14)
    assert 2.562007137069414 <= upper < 2.562007137069415


@pytest.mark.slow
def test_lengths_keep_their_unit_and_failures_have_no_bounds(rng: np.random.Generator) -> None:
    nets = np.stack([mild_patches(rng, 1, 0.3)[0], bent_plane()])
    solution = bm.solve_geodesic(nets * 1000.0, (0, 0), [(1, 1), (0, 1)])
    assert np.asarray(solution.status)[1] is bm.Status.ON_BOUNDARY
    lower, upper = bm.enclose(solution)
    error = solution.error_estimate[0]
    assert lower[0] - error <= solution.length[0] <= upper[0] + error
    assert np.isnan([lower[1], upper[1]]).all()
    single = bm.enclose(bm.solve_geodesic(nets[0], (0, 0), (1, 1)))
    np.testing.assert_allclose(np.array(single) * 1000.0, [lower[0], upper[0]], rtol=1e-9)


def test_points_in_one_place_and_paths_at_an_edge_have_what_is_known(
    rng: np.random.Generator,
) -> None:
    net = mild_patches(rng, 1, 0.3)[0]
    assert [*bm.enclose(bm.solve_geodesic(net, (0.3, 0.3), (0.3, 0.3)))] == [0.0, 0.0]
    # At an edge that is collapsed to a point, no path is shown to be regular.
    net[0] = net[0, :1]
    solution = bm.solve_geodesic(net, (0.0, 0.3), [(0.0, 0.8), (1.0, 1.0)])
    lower, upper = bm.enclose(solution)
    assert np.isposinf(upper).all()
    assert lower[0] == 0.0
    assert lower[1] == pytest.approx(np.linalg.norm(net[3, 3] - net[0, 0]), rel=1e-12)


def test_any_degree_has_the_same_enclosure(rng: np.random.Generator) -> None:
    net = mild_patches(rng, 1, 0.2)[0]
    once = bm.enclose(solved(net), degree=10)
    higher = bm.enclose(solved(elevate(net, 4, 5)), degree=10)
    np.testing.assert_allclose(higher, once, rtol=1e-8)


def test_what_cannot_be_enclosed_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    net = bm.load_sample("hyperbolic_paraboloid").control_points[0]
    rational = solved(bm.homogeneous(net, np.ones((4, 4))))
    with pytest.raises(bm.InputError, match="no polynomial patch"):
        bm.enclose(rational)
    with pytest.raises(bm.InputError, match="degree is 2; expected a whole number from 3 to 40"):
        bm.enclose(solved(net), degree=2)
    with pytest.raises(bm.InputError, match="the patches are of degree 12"):
        bm.enclose(solved(elevate(net, 12, 3)))
    with pytest.raises(bm.InputError, match="what solve_geodesic returns"):
        bm.enclose(net)
    for name in [name for name in sys.modules if "geodesic.rigorous" in name]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "flint", None)
    with pytest.raises(bm.MissingExtraError, match=r"pip install 'bodymeasure\[rigorous\]'"):
        bm.enclose(solved(net))


def test_exact_bounds_of_curvature_are_those_in_double_precision(rng: np.random.Generator) -> None:
    for net in (*mild_patches(rng, 2, 0.4), bm.load_sample("female_average").control_points[9]):
        points, scale = integers(net)
        exact = exact_bounds(points, scale, arb(1e30), arb(1e30))
        assert exact is not None
        limits = np.full(1, 1e30)
        rounded = curvature_bounds(net[None], limits, limits)
        # The exact bound is the smaller one, by the margin for rounding.
        ratio = rounded.curvature[0] / float(exact.curvature)
        assert 1.0 <= ratio < 1.0 + 1e-6
        assert float(exact.positive) <= rounded.positive[0] < 1.000001 * float(exact.positive)


def test_paths_are_enclosed_with_their_curvature(rng: np.random.Generator) -> None:
    net = mild_patches(rng, 1, 0.5)[0]
    times = 0.5 - 0.5 * np.cos(np.pi * np.arange(7) / 6)
    places = np.stack([times + 0.1 * np.sin(np.pi * times), times])
    u, v = (exact_polynomial(values) for values in places)
    points, scale = integers(net)
    found = enclose_path(path_forms(points, u, v))
    assert found is not None
    assert float(found.length.rad()) < 1e-20 * 2.0**scale
    t = np.linspace(0.0, 1.0, 40001)
    assert float(u(fmpq(-1))) == 0.0
    assert float(u(fmpq(1))) == 1.0
    polynomial = np.array([float(u[k]) for k in range(u.degree() + 1)])
    other = np.array([float(v[k]) for k in range(v.degree() + 1)])
    path = np.stack([np.polyval(c[::-1], 2.0 * t - 1.0) for c in (polynomial, other)], axis=-1)
    steps = np.diff(evaluate(net, path), axis=0)
    assert float(found.length) * 2.0**-scale == pytest.approx(
        np.linalg.norm(steps, axis=-1).sum(), rel=1e-8
    )


def test_paths_that_leave_the_square_are_noticed() -> None:
    assert is_inside(fmpq_poly([fmpq(1, 2), fmpq(1, 2)]))
    assert not is_inside(fmpq_poly([fmpq(1, 2), fmpq(1, 2) + fmpq(1, 10**30)]))
    # It dips below 0 inside, by a hundredth.
    assert not is_inside(fmpq_poly([fmpq(-1, 100), 0, fmpq(1, 2)]))


@pytest.mark.slow
def test_ten_diagonals_of_a_body_are_enclosed_closely() -> None:
    body = bm.load_sample("female_average")
    chosen = body.control_points[[0, 20, 40, 76, 114, 152, 190, 266, 342, 370]]
    solution = bm.solve_geodesic(chosen, (0, 0), (1, 1))
    lower, upper = bm.enclose(solution)
    error = solution.error_estimate
    assert ((lower - error <= solution.length) & (solution.length <= upper + error)).all()
    assert (upper / lower - 1.0 <= 1e-9).all()
