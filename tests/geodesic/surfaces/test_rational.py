"""Rational patches of quadrics and tori, whose geodesics are known."""

import numpy as np
import pytest
import scipy
from helpers.surfaces.quadrics import (
    arc_parameter,
    joined,
    line,
    octant,
    quarter_arc,
    revolved,
    sphere_nets,
    stretched,
    torus_nets,
)

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.geodesic.surfaces.protocol import JET
from bodymeasure.geodesic.surfaces.rational import RationalSurfaces
from bodymeasure.section import plane_section


def angle_between(first: Array, second: Array) -> Array:
    cross = np.linalg.norm(np.cross(first, second), axis=-1)
    return np.asarray(np.arctan2(cross, (first * second).sum(axis=-1)))


def test_great_circles(rng: np.random.Generator) -> None:
    start, end = rng.uniform(0.0, 0.9, (2, 100, 2))
    found = bm.solve_geodesic(octant(2.5), start, end)
    first, second = (evaluate(octant(), points) for points in (start, end))
    exact = 2.5 * angle_between(first, second)
    np.testing.assert_allclose(found.length, exact, rtol=1e-10)
    assert (np.abs(found.length - exact) <= found.error_estimate).all()


def near_the_equator(rng: np.random.Generator) -> bm.AtlasPoint:
    patch, (u, v) = int(rng.integers(8)), rng.uniform(0.0, 0.5, 2)
    # The southern octants begin at the pole.
    return bm.AtlasPoint(patch, float(u), float(v if patch < 4 else 1.0 - v))


def test_great_circles_over_the_seams_of_a_whole_sphere(
    rng: np.random.Generator,
) -> None:
    sphere = joined(sphere_nets())
    for _ in range(20):
        ends = [near_the_equator(rng) for _ in range(2)]
        exact = float(angle_between(*(sphere.position(point) for point in ends)))
        # The points are not so far apart that the path comes near a pole.
        if exact < 1.5:
            assert bm.geodesic_between(sphere, ends[0], ends[1]).length == pytest.approx(
                exact, rel=1e-10
            )


@pytest.mark.parametrize("degree", [3, 4, 5])
def test_a_meridian_from_the_pole_is_left_in_any_direction(degree: int) -> None:
    sphere = joined(sphere_nets(), degree)
    # The pole is given at another longitude than that of the path from it.
    pole, end = bm.AtlasPoint(0, 0.2, 1.0), bm.AtlasPoint(0, 0.7, 0.3)
    exact = float(angle_between(sphere.position(pole), sphere.position(end)))
    assert bm.geodesic_between(sphere, pole, end).length == pytest.approx(exact, rel=1e-10)


@pytest.mark.slow
def test_great_circles_past_the_poles(rng: np.random.Generator) -> None:
    sphere = joined(sphere_nets())
    converged = 0
    for _ in range(60):
        ends = [bm.AtlasPoint(int(rng.integers(8)), *rng.uniform(size=2)) for _ in range(2)]
        path = bm.geodesic_between(sphere, ends[0], ends[1], on_failure="status")
        if path.converged:
            converged += 1
            exact = float(angle_between(*(sphere.position(point) for point in ends)))
            assert path.length == pytest.approx(exact, rel=1e-10)
    assert converged >= 54


def test_helices_on_a_cylinder(rng: np.random.Generator) -> None:
    start, end = rng.uniform(0.0, 1.0, (2, 50, 2))
    found = bm.solve_geodesic(revolved(line((1.5, 0.0), (1.5, 4.0))), start, end)
    turn = arc_angle(end[:, 0]) - arc_angle(start[:, 0])
    exact = np.hypot(1.5 * turn, 4.0 * (end - start)[:, 1])
    np.testing.assert_allclose(found.length, exact, rtol=1e-10)


def arc_angle(t: Array) -> Array:
    """The inverse of `arc_parameter`."""
    return np.asarray(2.0 * np.arctan(t / (np.sqrt(2.0) * (1.0 - t) + t)))


def test_a_cone_unrolls(rng: np.random.Generator) -> None:
    # Half the angle at the tip has the tangent 1/2.
    start, end = rng.uniform(0.0, 1.0, (2, 50, 2))
    found = bm.solve_geodesic(revolved(line((1.0, 2.0), (2.0, 4.0))), start, end)
    turn = (arc_angle(end[:, 0]) - arc_angle(start[:, 0])) / np.sqrt(5.0)
    first, second = (np.sqrt(5.0) * (1.0 + points[:, 1]) for points in (start, end))
    exact = np.sqrt(first**2 + second**2 - 2.0 * first * second * np.cos(turn))
    np.testing.assert_allclose(found.length, exact, rtol=1e-10)


def test_clairauts_relation_on_a_torus() -> None:
    patch = revolved(quarter_arc(3.0, 1.0))
    # There are so many functions that the path is as accurate as its length.
    method = bm.RBFCollocation(functions=20)
    found = bm.solve_geodesic(patch, (0.3, 0.1), (0.7, 0.8), method=method)
    t = 0.5 - 0.5 * np.cos(np.pi * np.arange(31) / 30)
    parameters = found.path(t)
    positions = evaluate(patch, parameters)
    radius = np.hypot(positions[:, 0], positions[:, 1])
    turn = np.arctan2(positions[:, 1], positions[:, 0])
    # By Clairaut the radius times the cosine of the angle to the parallel, r^2 dphi/ds, is
    # constant.
    slope = scipy.interpolate.BarycentricInterpolator(t, turn).derivative(t[5:25])
    constant = radius[5:25] ** 2 * slope / found.length
    np.testing.assert_allclose(constant, constant.mean(), rtol=1e-7)
    assert found.error_estimate < 1e-9


def test_the_length_on_a_torus_by_clairauts_integrals() -> None:
    """Turn and length of the geodesic with Clairaut's constant c, as integrals over the profile."""
    large, small, c = 3.0, 1.0, 2.2
    low, high = 0.2, 1.3

    def speed(theta: float) -> float:
        radius = large + small * np.cos(theta)
        return float(small / np.sqrt(radius**2 - c**2))

    def radius(theta: float) -> float:
        return float(large + small * np.cos(theta))

    turn, _ = scipy.integrate.quad(
        lambda theta: c * speed(theta) / radius(theta), low, high, epsabs=1e-14, epsrel=1e-13
    )
    length, _ = scipy.integrate.quad(
        lambda theta: radius(theta) * speed(theta), low, high, epsabs=1e-14, epsrel=1e-13
    )
    ends = [
        (arc_parameter(np.array(phi)), arc_parameter(np.array(theta)))
        for phi, theta in ((0.1, low), (0.1 + turn, high))
    ]
    found = bm.solve_geodesic(revolved(quarter_arc(large, small)), *ends)
    assert found.length == pytest.approx(length, rel=1e-10)


def test_karneys_geodesic_on_the_earths_ellipsoid() -> None:
    """Agree with C. Karney, Algorithms for geodesics, J. Geodesy 87 (2013), table 2, on WGS84."""
    semi_major, flattening = 6378137.0, 1.0 / 298.257223563
    semi_minor = semi_major * (1.0 - flattening)
    earth = joined(stretched(sphere_nets(), (1.0, 1.0, 1.0 - flattening)))
    # The unit is the semi-major axis, so that nine digits distinguish control points.
    ends: list[bm.AtlasPoint] = []
    for latitude, longitude in ((40.0, 0.0), (41.79331020506, 137.84490004377)):
        reduced = np.arctan(semi_minor / semi_major * np.tan(np.radians(latitude)))
        quarter, rest = divmod(longitude, 90.0)
        u = arc_parameter(np.radians(np.array(rest)))
        ends.append(bm.AtlasPoint(int(quarter), float(u), float(arc_parameter(reduced))))
    path = bm.geodesic_between(earth, ends[0], ends[1])
    # The table gives angles to 1e-11 degrees, which are a micrometer on the ground.
    assert path.length * semi_major == pytest.approx(10_000_000.0, abs=2e-5)


def test_weights_that_are_all_equal_change_nothing(rng: np.random.Generator) -> None:
    net = bm.load_sample("paraboloid").control_points[0]
    start, end = rng.uniform(0.0, 1.0, (2, 20, 2))
    plain = bm.solve_geodesic(net, start, end)
    rational = bm.solve_geodesic(bm.homogeneous(net, np.full((4, 4), 7.0)), start, end)
    np.testing.assert_allclose(rational.length, plain.length, rtol=1e-12)


def test_derivatives_by_differences(rng: np.random.Generator) -> None:
    net = bm.homogeneous(rng.uniform(-1.0, 1.0, (4, 5, 3)), rng.uniform(0.5, 2.0, (4, 5)))
    surface, at, h = RationalSurfaces(net[None]), np.array([[[0.3, 0.6]]]), 1e-4
    jet = surface.jet(at, 3)[..., 0, 0]

    def difference(number: int, axis: int) -> Array:
        step = h * np.eye(2)[axis]
        ahead, behind = (surface.jet(at + sign * step, 3)[number, :, 0, 0] for sign in (1, -1))
        return np.asarray((ahead - behind) / (2.0 * h))

    for number, (i, j) in enumerate(JET):
        for axis, higher in enumerate(((i + 1, j), (i, j + 1))):
            if higher in JET:
                expected = jet[JET.index(higher)]
                np.testing.assert_allclose(difference(number, axis), expected, rtol=0, atol=1e-4)


@pytest.mark.parametrize("weight", [0.0, -1.0, np.nan, np.inf])
def test_weights_that_are_not_positive_are_refused(weight: float) -> None:
    net = octant()
    net[1, 1, 3] = weight
    with pytest.raises(bm.InputError, match=r"patch 0 .*weight.*expected positive weights"):
        bm.solve_geodesic(net, (0.1, 0.1), (0.9, 0.8))


def test_a_whole_torus_is_sound_and_its_sections_are_circles() -> None:
    torus = joined(torus_nets(3.0, 1.0))
    assert bm.check_atlas(torus) == ()
    loops = plane_section(
        torus, bm.Plane(np.array([0.0, 0.0, 0.25]), np.array([0.0, 0.0, 1.0]))
    ).loops
    radii = 3.0 + np.sqrt(1.0 - 0.25**2), 3.0 - np.sqrt(1.0 - 0.25**2)
    np.testing.assert_allclose([loop.length / (2.0 * np.pi) for loop in loops], radii, rtol=1e-12)


def test_a_rational_atlas_is_written_and_read_without_loss() -> None:
    from bodymeasure.formats import atlas_json

    torus = joined(torus_nets(3.0, 1.0))
    back = atlas_json.read(atlas_json.write(torus), "torus.atlas")
    np.testing.assert_array_equal(back.control_points, torus.control_points)
    assert back.is_rational


def test_an_atlas_whose_seam_has_two_kinds_of_weights_is_refused() -> None:
    torus = joined(torus_nets(3.0, 1.0))
    assert torus.weights is not None
    weights = torus.weights.copy()
    weights[3, 0, 1] *= 1.5
    with pytest.raises(bm.InputError, match=r"share the control points of an edge, but not"):
        bm.Atlas(torus.points, torus.index, bm.Unit.M, weights=weights)


@pytest.mark.parametrize("ratio", [1.5, 10.0])
def test_an_edge_that_is_run_along_at_two_speeds_is_told(ratio: float) -> None:
    from bodymeasure.atlas import weld
    from bodymeasure.bezier import elevate, project

    nets = elevate(sphere_nets(), 3, 3)
    # The same points, anywhere on the patch and on its edges, have other parameters.
    nets[0] *= (ratio ** np.arange(4))[:, None, None]
    points, index = weld(project(nets), weights=nets[..., 3])
    atlas = bm.Atlas(points, index, bm.Unit.M, weights=nets[..., 3])
    told = {finding.kind.name for finding in bm.check_atlas(atlas)} - {"COLLAPSED_EDGE"}
    assert "UNJOINED_SEAM" in told


def test_patches_of_degree_five_measure_as_the_same_ones_of_degree_three() -> None:
    from bodymeasure.bezier import elevate

    net = bm.load_sample("enneper").control_points
    plain = bm.diagonals(bm.Atlas.from_control_points(net, "cm"))
    higher = bm.Atlas.from_control_points(elevate(net, 5, 5), "cm")
    np.testing.assert_allclose(bm.diagonals(higher).length, plain.length, rtol=1e-12)
    assert bm.check_atlas(higher) == ()


@pytest.mark.slow
def test_the_mesh_agrees_with_rational_diagonals() -> None:
    pytest.importorskip("igl")
    survey = bm.measure_atlas(joined(torus_nets(3.0, 1.0)))
    assert survey.cross_check is not None
    assert {verdict.name for verdict in survey.cross_check.verdict.ravel()} == {"AGREES"}
