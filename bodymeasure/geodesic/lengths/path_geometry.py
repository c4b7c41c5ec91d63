"""Speed, geodesic curvature and Gaussian curvature along a path."""

from typing import Any, NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.lengths.equations import acceleration, dot
from bodymeasure.geodesic.surfaces.protocol import Surface


class PathGeometry(NamedTuple):
    """The geometry of paths on their surfaces at k points; arrays of shape (k, problems).

    Parameters
    ----------
    speed : array
        ``|dx/dt|``.
    geodesic_curvature : array
        The curvature of the path within the surface: 0 along a geodesic.
    gaussian_curvature : array
        The Gaussian curvature of the surface.
    """

    speed: Any
    geodesic_curvature: Any
    gaussian_curvature: Any


def path_geometry(surface: Surface, values: Array, velocity: Array, second: Array) -> PathGeometry:
    """Return the geometry of paths given by (u, v) and their two derivatives by t.

    Parameters
    ----------
    surface : Surface
    values, velocity, second : ndarray, shape (problems, 2, k)

    Notes
    -----
    With n the unit normal, ``kappa_g = (x' x x'') . n / |x'|^3`` and
    ``K = (L N - M^2) / (E G - F^2)``: M. do Carmo, *Differential Geometry of Curves and Surfaces*,
    sections 4-4 and 3-3.
    """
    jet = surface.jet(values.transpose(0, 2, 1), 2)
    _, s_u, s_v, s_uu, s_uv, s_vv = jet
    velocity, second = velocity.transpose(1, 0, 2), second.transpose(1, 0, 2)
    du, dv = velocity
    tangent = s_u * du + s_v * dv
    bend = acceleration(jet, velocity, second)
    normal = _cross(s_u, s_v)
    area_squared = dot(normal, normal)
    speed = np.sqrt(dot(tangent, tangent))
    with np.errstate(divide="ignore", invalid="ignore"):
        geodesic_curvature = dot(_cross(tangent, bend), normal) / (speed**3 * np.sqrt(area_squared))
        gaussian_curvature = (
            dot(s_uu, normal) * dot(s_vv, normal) - dot(s_uv, normal) ** 2
        ) / area_squared**2
    return PathGeometry(speed.T, geodesic_curvature.T, gaussian_curvature.T)


def _cross(a: Array, b: Array) -> Array:
    return np.stack(
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    )
