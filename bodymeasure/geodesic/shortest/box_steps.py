"""Newton steps in the box: minima of the quadratic models of many polygons' energies."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dpbsv

from bodymeasure._typing import Array
from bodymeasure.geodesic.shortest.polygon_energy import PolygonEnergy

# Sets of held coordinates that are tried: nearly always a few are enough, and any step that lowers
# the energy is a good one.
MOST_SETS = 20


class BoxSteps(NamedTuple):
    """Steps, shape (2, k, polygons), and the decreases that the models foretell, doubled.

    Where a Hessian is not positive definite in what is free, the step is zero and the decrease
    infinite: more damping is called for.
    """

    step: Array
    foretold: Array


def box_steps(here: PolygonEnergy, inner: Array, damping: Array) -> BoxSteps:
    """The steps to the minima of damped quadratic models in [0, 1]^2.

    By a primal-dual active set: what would leave the box is put on its bound, and what is on a
    bound and not pressed there is let go, until nothing changes (M. Hintermueller, K. Ito,
    K. Kunisch, SIAM J. Optim. 13 (2002) 865-888). A polygon that comes to lie along an edge does
    so in one step, not vertex by vertex.

    Parameters
    ----------
    here : PolygonEnergy
    inner : ndarray, shape (2, k, polygons)
        The inner points (u, v).
    damping : ndarray, shape (polygons,)
    """
    model = _Model.of(here, inner, damping)
    step, definite = np.zeros_like(model.gradient), np.ones(len(damping), bool)
    bound = np.where(_flat(here.held), model.place, np.nan)
    rows = np.arange(len(damping))
    for _ in range(MOST_SETS):
        part = model.take(rows)
        step[rows], definite[rows] = part.minimum(bound[rows])
        now = part.next_bounds(bound[rows], step[rows])
        same = (now == bound[rows]) | (np.isnan(now) & np.isnan(bound[rows]))
        bound[rows] = now
        rows = rows[definite[rows] & ~same.all(axis=1)]
        if len(rows) == 0:
            break
    foretold = -((2.0 * model.gradient + model.product(step)) * step).sum(axis=1)
    step[~definite] = 0.0
    return BoxSteps(
        np.ascontiguousarray(step.reshape(len(step), -1, 2).transpose(2, 1, 0)),
        np.where(definite, foretold, np.inf),
    )


def _flat(values: NDArray[Any]) -> NDArray[Any]:
    """From (2, k, polygons) to (polygons, 2 k), as the bands of a matrix want it."""
    return np.ascontiguousarray(values.transpose(2, 1, 0)).reshape(values.shape[2], -1)


class _Model(NamedTuple):
    """Quadratic models; bounds are 0 or 1 where a coordinate is held, NaN where it is free.

    Parameters
    ----------
    bands : ndarray, shape (polygons, 4, 2 k)
        The Hessians' diagonals, and what is below them.
    gradient, place : ndarray, shape (polygons, 2 k)
    """

    bands: Array
    gradient: Array
    place: Array

    @classmethod
    def of(cls, here: PolygonEnergy, inner: Array, damping: Array) -> "_Model":
        """With a multiple of the metric added to the Hessian."""
        diagonal, lower = here.bending + (1.0 + damping) * here.metric, here.lower
        bands = np.zeros((diagonal.shape[-1], 4, 2 * diagonal.shape[2]))
        bands[:, 0, 0::2], bands[:, 0, 1::2] = diagonal[0, 0].T, diagonal[1, 1].T
        bands[:, 1, 0::2], bands[:, 1, 1:-1:2] = diagonal[1, 0].T, lower[0, 1].T
        bands[:, 2, 0:-2:2], bands[:, 2, 1:-2:2] = lower[0, 0].T, lower[1, 1].T
        bands[:, 3, 0:-3:2] = lower[1, 0].T
        return cls(bands, _flat(here.gradient), _flat(inner))

    def take(self, rows: NDArray[np.int64]) -> "_Model":
        """The models of some of the polygons."""
        return self if len(rows) == len(self.place) else _Model(*(each[rows] for each in self))

    def minimum(self, bound: Array) -> tuple[Array, NDArray[np.bool_]]:
        """Steps that put what is held on its bound, and whether the rest has a minimum."""
        free = np.isnan(bound)
        fixed = np.where(free, 0.0, bound - self.place)
        bands = self.bands * free[:, None]
        for row in range(1, 4):
            bands[:, row, :-row] *= free[:, row:]
        bands[:, 0][~free] = 1.0
        right = np.where(free, -self.gradient - self.product(fixed), fixed)
        step, definite = np.empty_like(right), np.empty(len(right), bool)
        for number in range(len(right)):
            _, step[number], failed = dpbsv(bands[number], right[number], lower=1)
            definite[number] = failed == 0
        definite &= np.isfinite(step).all(axis=1)
        return step, definite

    def next_bounds(self, bound: Array, step: Array) -> Array:
        """Of what is pressed to its bound there, or would leave the box."""
        slope, there = self.gradient + self.product(step), self.place + step
        # A product with NaN compares as false.
        pressed = (1.0 - 2.0 * bound) * slope > 0.0
        outside = np.isnan(bound) & ((there < 0.0) | (there > 1.0))
        nearest = np.where(there < 0.5, 0.0, 1.0)
        return np.where(pressed, bound, np.where(outside, nearest, np.nan))

    def product(self, vectors: Array) -> Array:
        """The Hessians times vectors."""
        result: Array = self.bands[:, 0] * vectors
        for row in range(1, 4):
            part = self.bands[:, row, :-row]
            result[:, row:] += part * vectors[:, :-row]
            result[:, :-row] += part * vectors[:, row:]
        return result
