"""Lengths of computed curves on patches, and which of the curves leave their patch."""

from functools import lru_cache

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.spaces.quadrature import Quadrature
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

# Gauss points. On the paper's patches, which are strongly curved, twice as many change the lengths
# of curves inside by less than 1e-8.
POINTS = 64
# The number of points at which a curve is examined, and the distance outside that is rounding.
LOOKS = 513
OUTSIDE = 1e-9


def arc_lengths(surface: Surface, space: TrialSpace, values: Array) -> Array:
    """Return lengths of curves given by u and v at a space's nodes, shape (curves, 2, n + 1).

    A length is infinite where a curve goes so far away that it is no number.
    """
    place, slopes, weights = _maps(space)
    with np.errstate(over="ignore", invalid="ignore"):
        du, dv = (values @ slopes.T).transpose(1, 0, 2)
        _, s_u, s_v = surface.jet((values @ place.T).transpose(0, 2, 1), 1)
        speed = np.linalg.norm(s_u * du + s_v * dv, axis=0)
        length = speed @ weights
    return np.asarray(np.where(np.isfinite(length), length, np.inf))


@lru_cache(maxsize=64)
def _maps(space: TrialSpace) -> tuple[Array, Array, Array]:
    quadrature = Quadrature(space.functions.edges, POINTS)
    place, slopes, _ = space.matrices(quadrature.points)
    return place, slopes, quadrature.weights


def inside_patch(space: TrialSpace, values: Array) -> Bools:
    """Return which curves, given as for `arc_lengths`, stay in [0, 1] x [0, 1]."""
    curves = values @ _looks(space).T
    return np.asarray(((curves >= -OUTSIDE) & (curves <= 1.0 + OUTSIDE)).all(axis=(1, 2)))


@lru_cache(maxsize=64)
def _looks(space: TrialSpace) -> Array:
    values: Array = space.matrices(np.linspace(0.0, 1.0, LOOKS))[0]
    return values
