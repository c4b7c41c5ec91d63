"""The samples that ship with bodymeasure, and the known lengths that tests lean on."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_bvp
from surfaces import SURFACES, Surface

from bodymeasure.bezier import derivatives


@pytest.mark.parametrize("surface", SURFACES, ids=lambda surface: surface.name)
def test_a_boundary_value_solver_finds_the_known_length(surface: Surface) -> None:
    start, end = np.array(surface.start), np.array(surface.end)

    def flow(_: NDArray[np.float64], state: NDArray[np.float64]) -> NDArray[np.float64]:
        """The geodesic equation for (u, v, u', v')."""
        s = derivatives(surface.control_points, state[:2].T, order=2)
        du, dv = state[2:, :, None]
        bend = s[:, 2, 0] * du**2 + 2.0 * s[:, 1, 1] * du * dv + s[:, 0, 2] * dv**2
        tangents = np.stack([s[:, 1, 0], s[:, 0, 1]], axis=1)
        metric = tangents @ tangents.swapaxes(1, 2)
        second = -np.linalg.solve(metric, tangents @ bend[..., None])[..., 0]
        return np.concatenate([state[2:], second.T])

    def ends(at_start: NDArray[np.float64], at_end: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.concatenate([at_start[:2] - start, at_end[:2] - end])

    t = np.linspace(0.0, 1.0, 33)
    straight = start[:, None] + (end - start)[:, None] * t
    guess = np.concatenate([straight, np.repeat((end - start)[:, None], len(t), axis=1)])
    found = solve_bvp(flow, ends, t, guess, tol=1e-9, max_nodes=20_000)
    assert found.success

    path = found.sol(np.linspace(0.0, 1.0, 1001))[:2]
    assert (path > -1e-9).all(), "the geodesic must stay inside the patch"
    assert (path < 1 + 1e-9).all(), "the geodesic must stay inside the patch"
    nodes, weights = np.polynomial.legendre.leggauss(64)
    state = found.sol((nodes + 1.0) / 2.0)
    s = derivatives(surface.control_points, state[:2].T, order=1)
    velocity = s[:, 1, 0] * state[2][:, None] + s[:, 0, 1] * state[3][:, None]
    length = weights @ np.linalg.norm(velocity, axis=-1) / 2.0
    assert length == pytest.approx(surface.length, rel=1e-11)
