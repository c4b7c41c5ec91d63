"""The equations of a Newton step, and whether it leads to a minimum."""

import numpy as np
import pytest
import scipy

from bodymeasure.pattern.flat.equations import StepEquations


@pytest.mark.parametrize("falling", [0, 1, 3])
def test_a_saddle_along_the_constraints_is_told(falling: int, rng: np.random.Generator) -> None:
    jacobian = rng.normal(size=(4, 12))
    # The null space of the constraints, and a Hessian that falls in some directions of it.
    along = scipy.linalg.null_space(jacobian)
    turn = np.linalg.qr(rng.normal(size=(8, 8)))[0]
    values = np.concatenate([-rng.uniform(0.5, 2.0, falling), rng.uniform(0.5, 2.0, 8 - falling)])
    basis = np.concatenate([along @ turn, np.linalg.pinv(jacobian)], axis=1)
    inverse = np.linalg.inv(basis)
    # Across the constraints it may fall as it likes.
    hessian = inverse.T @ np.diag([*values, -1.0, 2.0, -3.0, 0.5]) @ inverse
    equations = StepEquations(scipy.sparse.csr_array(hessian), scipy.sparse.csr_array(jacobian))
    assert equations.falling == falling
    assert equations.lead_down == (falling == 0)


def test_steps_meet_their_equations_to_rounding(rng: np.random.Generator) -> None:
    root, jacobian = rng.normal(size=(12, 12)), rng.normal(size=(4, 12))
    hessian = root @ root.T + np.eye(12)
    equations = StepEquations(scipy.sparse.csr_array(hessian), scipy.sparse.csr_array(jacobian))
    upper, lower = rng.normal(size=12), rng.normal(size=4)
    step, multipliers = equations.solved(upper, lower)
    assert np.abs(hessian @ step + jacobian.T @ multipliers - upper).max() < 1e-10
    assert np.abs(jacobian @ step - lower).max() < 1e-12
