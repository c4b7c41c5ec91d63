"""The linear equations of a Newton step under constraints, and whether it leads to a minimum."""

import numpy as np
import scipy

from bodymeasure._typing import Array

# What stands on the diagonal beside the constraints, so that the matrix has pivots in any order. A
# step misses the constraints by this part of their multipliers until it is refined.
COMPLIANCE = 1e-7
# Rounds of refinement: each takes that part off by as much again, down to rounding.
REFINED = 2


class StepEquations:
    """The equations of a step: ``H step + J^T multipliers = upper`` and ``J step = lower``.

    Parameters
    ----------
    hessian : csr_array, shape (n, n)
    jacobian : csr_array, shape (m, n)

    Notes
    -----
    The matrix is factored with pivots on its diagonal in an order that keeps it sparse, which a
    small negative diagonal beside the constraints allows (Vanderbei, *Symmetric quasidefinite
    matrices*, 1995). The signs of the pivots then are those of its eigenvalues (Sylvester): as many
    negative ones as there are constraints if the Hessian is positive along them, and more where
    the energy falls away from a saddle.
    """

    def __init__(self, hessian: scipy.sparse.csr_array, jacobian: scipy.sparse.csr_array) -> None:
        count = jacobian.shape[0]
        compliance = COMPLIANCE * scipy.sparse.eye_array(count)
        self._count = hessian.shape[0]
        self._matrix = scipy.sparse.block_array([[hessian, jacobian.T], [jacobian, None]]).tocsr()
        self._factors = scipy.sparse.linalg.splu(
            scipy.sparse.block_array([[hessian, jacobian.T], [jacobian, -compliance]]).tocsc(),
            permc_spec="MMD_AT_PLUS_A",
            diag_pivot_thresh=0.0,
            options={"SymmetricMode": True},
        )
        self.falling: int = int((self._factors.U.diagonal() < 0.0).sum()) - count

    @property
    def lead_down(self) -> bool:
        """Whether the energy has a minimum along the constraints, to which the step leads."""
        return self.falling <= 0

    def solved(self, upper: Array, lower: Array) -> tuple[Array, Array]:
        """Return the step and the multipliers."""
        right = np.concatenate([upper, lower])
        found = self._factors.solve(right)
        for _ in range(REFINED):
            found += self._factors.solve(right - self._matrix @ found)
        return found[: self._count], found[self._count :]
