"""Shortest piecewise paths inside the patch, by energy descent within the box [0, 1]^2."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array
from bodymeasure.geodesic.numerics.banded import BoxModels
from bodymeasure.geodesic.shortest.polygon_energy import (
    REGULARIZATION,
    PolygonEnergy,
    polygon_energy,
)
from bodymeasure.geodesic.surfaces.bezier import compiled_patches
from bodymeasure.geodesic.surfaces.protocol import Surface
from bodymeasure.native import DescentSettings, polygons_at_rest

# The most Newton steps; nearly all paths take 6 to 15.
MAX_STEPS = 60
# A path is at rest when a step would lower its energy by less than this part.
REST = 5e-12
# Damping, as a part of the metric: its first value, its factors after a good and a bad step, and
# the value past which no step helps.
FIRST_DAMPING, LESS, MORE, MOST = 1e-3, 0.2, 8.0, 1e8
_SETTINGS = DescentSettings(REGULARIZATION, REST, FIRST_DAMPING, LESS, MORE, MOST)


def descend(surface: Surface, start: Array) -> Array:
    """Minimize the energy of polygons on patches, their ends fixed, every point in the patch.

    Each Newton step leads to the minimum, in the box, of the quadratic model with the exact
    Hessian, damped as by Levenberg and Marquardt. Polygons that are at rest drop out of the work.

    Parameters
    ----------
    surface : Surface
    start : ndarray, shape (polygons, m + 1, 2)
        The polygons, which are put into [0, 1] if they are not.

    Returns
    -------
    ndarray, shape (polygons, m + 1, 2)
        Points (u, v) in [0, 1], with coordinates of exactly 0 or 1 where an edge holds them.
    """
    result = np.clip(start, 0.0, 1.0)
    patches = compiled_patches(surface)
    if patches is not None:
        return polygons_at_rest(patches, result, MAX_STEPS, _SETTINGS)
    active = np.arange(len(result))
    points, here = result, polygon_energy(surface, result)
    damping = np.full(len(result), FIRST_DAMPING)
    for _ in range(MAX_STEPS):
        if len(active) == 0:
            return result
        step, decrease = box_steps(here, points[:, 1:-1].transpose(2, 1, 0), damping)
        trial = points.copy()
        trial[:, 1:-1] = np.clip(points[:, 1:-1] + step.transpose(2, 1, 0), 0.0, 1.0)
        there = polygon_energy(surface, trial)
        better = there.energy < here.energy
        damping = damping * np.where(better, LESS, MORE)
        points, here = np.where(better[:, None, None], trial, points), here.replaced(better, there)
        rest = (decrease < REST * here.energy) | (damping > MOST)
        if rest.any():
            result[active] = points
            moving = np.flatnonzero(~rest)
            active, points, damping = active[moving], points[moving], damping[moving]
            surface, here = surface.take(moving), here.take(moving)
    result[active] = points
    return result


class BoxSteps(NamedTuple):
    """Steps, shape (2, k, polygons), and how much they lower the models of the energies.

    Where a Hessian is not positive definite in what is free, the step is zero and the decrease
    infinite: more damping is called for.
    """

    step: Array
    decrease: Array


def box_steps(here: PolygonEnergy, inner: Array, damping: Array) -> BoxSteps:
    """Return the steps to the minima of damped quadratic models in [0, 1]^2.

    Parameters
    ----------
    here : PolygonEnergy
    inner : ndarray, shape (2, k, polygons)
        The inner points (u, v).
    damping : ndarray, shape (polygons,)
        The multiples of the metric that are added to the Hessians.
    """
    diagonal, lower = here.bending + (1.0 + damping) * here.metric, here.lower
    bands = np.zeros((diagonal.shape[-1], 4, 2 * diagonal.shape[2]))
    bands[:, 0, 0::2], bands[:, 0, 1::2] = diagonal[0, 0].T, diagonal[1, 1].T
    bands[:, 1, 0::2], bands[:, 1, 1:-1:2] = diagonal[1, 0].T, lower[0, 1].T
    bands[:, 2, 0:-2:2], bands[:, 2, 1:-2:2] = lower[0, 0].T, lower[1, 1].T
    bands[:, 3, 0:-3:2] = lower[1, 0].T
    place = _flat(inner)
    models = BoxModels(bands, _flat(here.gradient), place, np.zeros(place.shape, bool))
    step, definite = models.steps()
    return BoxSteps(
        np.ascontiguousarray(step.reshape(len(step), -1, 2).transpose(2, 1, 0)),
        np.where(definite, models.decrease(step), np.inf),
    )


def _flat(values: NDArray[Any]) -> NDArray[Any]:
    """Arrays of shape (2, k, polygons) as (polygons, 2 k), in the order of the matrices' rows."""
    return np.ascontiguousarray(values.transpose(2, 1, 0)).reshape(values.shape[2], -1)
