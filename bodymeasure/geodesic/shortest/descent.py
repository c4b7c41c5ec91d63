"""Shortest piecewise paths inside the patch, by energy descent within the box [0, 1]^2."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.shortest.box_steps import box_steps
from bodymeasure.geodesic.shortest.polygon_energy import polygon_energy
from bodymeasure.geodesic.surfaces.protocol import Surface

# Newton steps at most. Nearly all paths take 6 to 15.
MAX_STEPS = 60
# A path is at rest when a step would lower its energy by less than this part.
REST = 1e-11
# Damping, as a part of the metric: first value, factors after a good and a bad step, and the
# value past which no step helps.
FIRST_DAMPING, LESS, MORE, MOST = 1e-3, 0.2, 8.0, 1e8


def descend(surface: Surface, start: Array) -> Array:
    """Minimize the energy of polygons on patches, their ends fixed, every point in the patch.

    Newton steps with the exact Hessian, damped as by Levenberg and Marquardt, each to the minimum
    of the quadratic model in the box. Polygons that are at rest drop out of the work.

    Parameters
    ----------
    surface : Surface
    start : ndarray, shape (polygons, m + 1, 2)
        Put into [0, 1] if they are not.

    Returns
    -------
    ndarray, shape (polygons, m + 1, 2)
        (u, v), all in [0, 1], and exactly 0 or 1 where an edge of the patch holds them.
    """
    result = np.clip(start, 0.0, 1.0)
    active = np.arange(len(result))
    points, here = result, polygon_energy(surface, result)
    damping = np.full(len(result), FIRST_DAMPING)
    for _ in range(MAX_STEPS):
        if len(active) == 0:
            return result
        step, foretold = box_steps(here, points[:, 1:-1].transpose(2, 1, 0), damping)
        trial = points.copy()
        trial[:, 1:-1] = np.clip(points[:, 1:-1] + step.transpose(2, 1, 0), 0.0, 1.0)
        there = polygon_energy(surface, trial)
        better = there.energy < here.energy
        damping = damping * np.where(better, LESS, MORE)
        points, here = np.where(better[:, None, None], trial, points), here.replaced(better, there)
        rest = (foretold < REST * here.energy) | (damping > MOST)
        if rest.any():
            result[active] = points
            moving = np.flatnonzero(~rest)
            active, points, damping = active[moving], points[moving], damping[moving]
            surface, here = surface.take(moving), here.take(moving)
    result[active] = points
    return result
