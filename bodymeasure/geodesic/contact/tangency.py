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

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.contact.edge_arc import edge_curvature
from bodymeasure.geodesic.contact.legs import End, Pole
from bodymeasure.geodesic.lengths.path_geometry import PathGeometry, path_geometry
from bodymeasure.geodesic.spaces.trial_space import TrialSpace
from bodymeasure.geodesic.surfaces.protocol import Surface

# Where joints make most of the error, on wild patches, the formula gave at most 1 % too little; but
# it is of leading order, and its curvatures vary.
SAFETY = 3.0


def tangency_error(
    surface: Surface, space: TrialSpace, values: Array, ends: tuple[End, End]
) -> float:
    """Return the estimated error of a leg and its arcs together that their joints cause.

    Parameters
    ----------
    surface : Surface
        The surface of one problem.
    space : TrialSpace
    values : ndarray, shape (2, n + 1)
        The leg's u and v at the nodes.
    ends : pair of End
    """
    error = 0.0
    joints = [(n, end) for n, end in enumerate(ends) if end and not isinstance(end, Pole)]
    if joints:
        maps = space.at_quadrature
        geometry = path_geometry(surface, *(values[None] @ rows.T for rows in maps))
        length = float(space.quadrature.weights @ geometry.speed[:, 0])
        for number, contact in joints:
            angle = _angle(space, geometry, number)
            curvature = edge_curvature(surface, contact, values[:, -number])
            # Half the angle's square, over the distance by which the joint is off, at most the leg.
            with np.errstate(divide="ignore"):
                off = np.minimum(np.divide(angle, 3.0 * curvature), length)
            error += SAFETY * 0.5 * angle**2 * float(off)
    return error


def _angle(space: TrialSpace, geometry: PathGeometry, joint: int) -> float:
    """The angle between geodesic and computed path at its start (0) or end (1); may be inf."""
    speed, kappa, curvature = (each[:, 0] for each in geometry)
    way = space.quadrature.weights * speed
    steps = np.concatenate([[way[0]], way[:-1] + way[1:], [way[-1]]]) / 2.0
    # The Jacobi equation by finite differences at the quadrature's points, of which there are few.
    matrix = np.diag(1.0 / steps[1:] + 1.0 / steps[:-1] - curvature * way)
    row = np.arange(len(way) - 1)
    matrix[row, row + 1] = matrix[row + 1, row] = -1.0 / steps[1:-1]
    right = np.zeros(len(way))
    right[-joint] = 1.0 / steps[-joint]
    try:
        field = np.linalg.solve(matrix, right)
    except np.linalg.LinAlgError:
        return np.inf
    angle = float(abs((way * kappa) @ field))
    return angle if np.isfinite(angle) else np.inf
