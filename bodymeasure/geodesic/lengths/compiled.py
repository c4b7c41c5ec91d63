"""The lengths of paths on single polynomials, or other smooth functions, compiled."""

from functools import lru_cache

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.lengths import jacobi
from bodymeasure.geodesic.lengths.functionals import path_tables
from bodymeasure.geodesic.lengths.length import TRUSTED_CORRECTION, TRUSTED_RESIDUAL, Length
from bodymeasure.geodesic.spaces.quadrature import FALLS, ROUNDING
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface
from bodymeasure.native import LengthSettings, LengthTables, path_lengths

# On a surface of size 1, derivatives by u and v are at most 6 in size, and more than that times the
# rounding errors that `jacobi.ROUNDING` allows are made by a path that is not this part as long as
# its way in u and v.
STEEP = 0.2
# The rounding error of a derivative, relative to the terms that it is the sum of.
CANCELLATION = 4e-16
# The products of all pairs of modes take too much memory for larger spaces, which are rare.
MOST_SIZE = 32
LENGTH_SETTINGS = {
    "twice_falls": round(2.0 * FALLS),
    "steep": STEEP,
    "cancellation": CANCELLATION,
    "noise": ROUNDING,
    "safety": jacobi.SAFETY,
    "quadrature_safety": jacobi.QUADRATURE_SAFETY,
    "curvature_variation": jacobi.CURVATURE_VARIATION,
    "path_rounding": jacobi.ROUNDING,
    "lyapunov": jacobi.LYAPUNOV_BOUND,
    "eigenvalue_rounding": jacobi.EIGENVALUE_ROUNDING,
    "trusted_correction": TRUSTED_CORRECTION,
    "trusted_residual": TRUSTED_RESIDUAL,
}
_SETTINGS = LengthSettings(**LENGTH_SETTINGS)


def compiled_lengths(surface: Surface, space: TrialSpace, values: Array) -> Length | None:
    """Return what `measure.measure_length` does; None if no kernel serves."""
    if len(space.quadrature.widths) > 1 or space.size > MOST_SIZE:
        return None
    paths = path_tables(surface, space)
    if paths is None:
        return None
    return Length(*path_lengths(paths, _tables(space), _SETTINGS, values))


@lru_cache(maxsize=64)
def _tables(space: TrialSpace) -> LengthTables:
    return length_tables(space, space.at_quadrature)


def length_tables(space: TrialSpace, maps: Array) -> LengthTables:
    """Return the tables of a space for kernels; `maps` are those to values at its quadrature."""
    quadrature = space.quadrature
    modes = jacobi.modes_on(quadrature, space.size)
    return LengthTables(
        size=space.size,
        times=quadrature.points,
        weights=quadrature.weights,
        maps=maps,
        modes=np.stack([modes.values, modes.slopes]),
        coefficients=quadrature.coefficients,
        quarters=quadrature.quarters,
        antiderivative=quadrature.antiderivative if space.size < jacobi.FEW else None,
    )
