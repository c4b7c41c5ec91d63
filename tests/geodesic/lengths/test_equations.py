"""The equations, their Jacobian and the geometry of paths against differences and closed forms."""

import numpy as np
import pytest
from helpers.surfaces.surfaces import ENNEPER, PLANE, TANGENT_DEVELOPABLE

from bodymeasure.bezier import derivatives, evaluate
from bodymeasure.geodesic import WU_C2
from bodymeasure.geodesic.lengths.equations import acceleration, residual_and_jacobian
from bodymeasure.geodesic.lengths.path_geometry import path_geometry
from bodymeasure.geodesic.methods.rbf_collocation import RBFCollocation
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.bezier import BezierSurfaces
from bodymeasure.geodesic.surfaces.protocol import JET, JET_SIZE

NETS = np.stack([ENNEPER, PLANE, TANGENT_DEVELOPABLE])
SURFACES = BezierSurfaces(NETS)


def space(functions: int = 8) -> TrialSpace:
    return next(iter(RBFCollocation(functions=functions).spaces))


def wavy(trial: TrialSpace, rng: np.random.Generator) -> np.ndarray:
    t = trial.nodes
    bows = rng.uniform(-0.3, 0.3, (3, 2, 2))
    line = 0.1 + 0.8 * t
    return np.asarray(
        line + bows[..., :1] * t * (1 - t) + bows[..., 1:] * t * (1 - t) * (1 - 2 * t)
    )


def test_the_jacobian_is_the_derivative_of_the_residual(rng: np.random.Generator) -> None:
    trial = space()
    values = wavy(trial, rng)
    residual, jacobian = residual_and_jacobian(SURFACES, trial, values)
    points = len(trial.nodes) - 2
    assert residual.shape == (3, 2, points)
    assert jacobian.shape == (3, 2, points, 2, points)
    h = 1e-4
    for coordinate in range(2):
        for node in range(points):
            by_step = []
            for step in (h, 2 * h):
                moved = np.array([values, values])
                moved[0, :, coordinate, node + 1] += step
                moved[1, :, coordinate, node + 1] -= step
                ahead, behind = (residual_and_jacobian(SURFACES, trial, m)[0] for m in moved)
                by_step.append((ahead - behind) / (2 * step))
            # Richardson extrapolation gives fourth order
            difference = (4 * by_step[0] - by_step[1]) / 3
            scale = np.abs(jacobian).max(axis=(1, 2, 3, 4))[:, None, None]
            error = np.abs(jacobian[:, :, :, coordinate, node] - difference) / scale
            assert error.max() < 1e-9


def test_acceleration_is_the_second_derivative_of_the_curve(rng: np.random.Generator) -> None:
    trial = space()
    values = wavy(trial, rng)
    t = np.array([0.31, 0.62])
    place, velocity, second = (values @ rows.T for rows in trial.matrices(t))
    jet = SURFACES.jet(place.transpose(0, 2, 1), 2)
    bend = acceleration(jet, velocity.transpose(1, 0, 2), second.transpose(1, 0, 2))

    def position(at: np.ndarray) -> np.ndarray:
        return evaluate(NETS, (values @ trial.matrices(at)[0].T).transpose(0, 2, 1))

    h = 1e-3
    differences = (
        -position(t - 2 * h) + 16 * position(t - h) - 30 * position(t) + 16 * position(t + h)
        - position(t + 2 * h)
    ) / (12 * h * h)  # fmt: skip
    scale = np.abs(differences).max()
    np.testing.assert_allclose(bend.transpose(1, 2, 0), differences, atol=1e-7 * scale)


def test_a_straight_line_in_a_flat_plane_solves_the_equations() -> None:
    u, v = np.meshgrid(np.linspace(0, 3, 4), np.linspace(0, 2, 4), indexing="ij")
    flat = BezierSurfaces(np.stack([u, v, 0.5 * u - v], axis=-1)[None])
    # Nine kernels of degree 9 outside [0, 1] and the constant span all polynomials up to it; fewer
    # functions do not reproduce even straight lines.
    centers = (-0.1, -0.3, -0.5, -0.7, 1.1, 1.2, 1.4, 1.6, 1.8)
    trial = next(iter(RBFCollocation(WU_C2, centers=centers).spaces))
    line = np.array([0.2, 0.9])[:, None] + np.array([0.7, -0.6])[:, None] * trial.nodes
    residual, _ = residual_and_jacobian(flat, trial, line[None])
    assert np.abs(residual).max() < 1e-10


@pytest.mark.parametrize("radius", [0.5, 2.0])
def test_geodesic_curvature_of_a_circle_in_a_plane(radius: float) -> None:
    u, v = np.meshgrid(np.linspace(-1, 1, 4), np.linspace(-1, 1, 4), indexing="ij")
    flat = BezierSurfaces(np.stack([4 * u, 4 * v, 0 * u], axis=-1)[None])
    angle = np.linspace(0.3, 1.1, 5)
    # 4 (2u - 1) = radius cos(angle)
    circle = np.array([np.cos(angle), np.sin(angle)]) * radius / 8
    geometry = path_geometry(
        flat, 0.5 + circle[None], circle[None][:, ::-1] * [[-1], [1]], -circle[None]
    )
    np.testing.assert_allclose(geometry.speed[:, 0], radius, rtol=1e-14)
    np.testing.assert_allclose(np.abs(geometry.geodesic_curvature[:, 0]), 1 / radius, rtol=1e-13)
    np.testing.assert_allclose(geometry.gaussian_curvature[:, 0], 0.0, atol=1e-14)


def test_gaussian_curvature_of_ennepers_surface() -> None:
    # K = -4 / (1 + u^2 + v^2)^4
    points = np.array([[0.0, 0.0], [0.3, 0.8], [1.0, 1.0]])
    ones = np.ones((1, 2, 3))
    geometry = path_geometry(BezierSurfaces(ENNEPER[None]), points.T[None], ones, 0 * ones)
    exact = -4 / (1 + (points**2).sum(axis=1)) ** 4
    np.testing.assert_allclose(geometry.gaussian_curvature[:, 0], exact, rtol=1e-12)
    # |S_u| = |S_v| = 1 + u^2 + v^2
    np.testing.assert_allclose(
        geometry.speed[:, 0], np.sqrt(2) * (1 + (points**2).sum(axis=1)), rtol=1e-14
    )


@pytest.mark.parametrize("degrees", [(1, 1), (3, 3), (2, 5)])
def test_the_jet_is_made_of_all_derivatives(
    degrees: tuple[int, int], rng: np.random.Generator
) -> None:
    nets = rng.normal(size=(4, degrees[0] + 1, degrees[1] + 1, 3))
    # Positions are those from the middle of the net.
    nets -= nets.mean(axis=(1, 2), keepdims=True)
    points = rng.uniform(-0.2, 1.2, (4, 5, 2))
    expected = derivatives(nets, points, order=3)
    for order in range(4):
        jet = BezierSurfaces(nets).jet(points, order)
        assert jet.shape == (JET_SIZE[order], 3, 4, 5)
        for found, (i, j) in zip(jet, JET, strict=False):
            np.testing.assert_allclose(
                found.transpose(1, 2, 0), expected[..., i, j, :], rtol=1e-9, atol=1e-10
            )
    some = BezierSurfaces(nets).take(np.array([2, 0]))
    np.testing.assert_array_equal(
        some.jet(points[[2, 0]], 1), BezierSurfaces(nets).jet(points, 1)[:, :, [2, 0]]
    )
