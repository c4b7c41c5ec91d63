r"""The error of a length because a free leg meets an edge of its patch not quite tangentially.

A leg ends on an edge where the computed path is tangential to it; but the geodesic between the ends
of the leg, whose length is taken, lies a little beside that path and meets the edge at a small
angle :math:`\theta`. If the joint moves along the edge by s, the length of leg and arc together
changes by :math:`(1 - \cos \theta) \, ds`, and the angle by :math:`\kappa \, ds`, with
:math:`\kappa` the geodesic curvature of the edge. It is stationary where :math:`\theta = 0`; so the
length is off by

.. math:: \int \tfrac12 \theta^2 \, ds = \frac{|\theta|^3}{6 \kappa},

and never by more than :math:`\tfrac12 \theta^2` of the leg. The angle is the slope, at the
joint, of the Jacobi field of `lengths.measure`. By Green's formula that is
:math:`\int \kappa_g w \, ds`, with :math:`-w'' - K w = 0`, w = 1 at the joint and 0 at the other
end.
"""

from collections.abc import Sequence

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.contact.edge_arc import edge_curvatures
from bodymeasure.geodesic.contact.legs import Ends, Pole
from bodymeasure.geodesic.lengths.path_geometry import PathGeometry, path_geometry
from bodymeasure.geodesic.numerics.linear_systems import solved
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

# Where joints make most of the error, on wild patches, the formula gave at most 1 % too little; but
# it is of leading order, and its curvatures vary.
SAFETY = 3.0


def tangency_errors(
    surface: Surface, space: TrialSpace, values: Array, ends: Sequence[Ends]
) -> Array:
    """Return the estimated errors of legs and their arcs together that their joints cause.

    Parameters
    ----------
    surface : Surface
        The patch of each leg.
    space : TrialSpace
    values : ndarray, shape (legs, 2, n + 1)
        The legs' u and v at the nodes.
    ends : sequence of pairs of End

    Returns
    -------
    ndarray, shape (legs,)
    """
    errors = np.zeros(len(values))
    joints = [
        (row, number, end)
        for row, pair in enumerate(ends)
        for number, end in enumerate(pair)
        if end is not None and not isinstance(end, Pole)
    ]
    if joints:
        rows, numbers = (np.array(each) for each in list(zip(*joints, strict=True))[:2])
        surface, joined = surface.take(rows), values[rows]
        geometry = path_geometry(surface, *(joined @ maps.T for maps in space.at_quadrature))
        angle, length = _angles(space, geometry, numbers), space.quadrature.weights @ geometry.speed
        places = joined[np.arange(len(rows)), :, -numbers]
        curvature = edge_curvatures(surface, [contact for _, _, contact in joints], places)
        # Half the angle's square, over the distance by which the joint is off, at most the leg.
        with np.errstate(divide="ignore"):
            off = np.minimum(np.divide(angle, 3.0 * curvature), length)
        np.add.at(errors, rows, SAFETY * 0.5 * angle**2 * off)
    return errors


def _angles(space: TrialSpace, geometry: PathGeometry, numbers: Ints) -> Array:
    """The angles between geodesics and computed paths at their starts (0) or ends (1); or inf."""
    speed, kappa, curvature = (each.T for each in geometry)
    way = space.quadrature.weights * speed
    steps = np.concatenate([way[:, :1], way[:, :-1] + way[:, 1:], way[:, -1:]], axis=1) / 2.0
    # The Jacobi equation by finite differences at the quadrature's points, of which there are few.
    matrix, point = np.zeros((*way.shape, way.shape[1])), np.arange(way.shape[1])
    matrix[:, point, point] = 1.0 / steps[:, 1:] + 1.0 / steps[:, :-1] - curvature * way
    beside = -1.0 / steps[:, 1:-1]
    matrix[:, point[:-1], point[1:]] = matrix[:, point[1:], point[:-1]] = beside
    right, row = np.zeros_like(way), np.arange(len(way))
    right[row, -numbers] = 1.0 / steps[row, -numbers]
    angle = np.abs((way * kappa * solved(matrix, right)).sum(axis=1))
    return np.where(np.isfinite(angle), angle, np.inf)
