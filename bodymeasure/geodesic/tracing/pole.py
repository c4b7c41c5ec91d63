"""The passage of a geodesic through a pole, where (u, v) are of no use.

So close to a smooth pole the geodesic is a straight line of the tangent plane, up to the square of
the distance.
"""

from collections.abc import Sequence

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES
from bodymeasure.geodesic.tracing.motion import (
    LostError,
    State,
    Surfaces,
    jet_at,
    velocity_along,
)

# Places along a collapsed side from which the one that faces a point is looked for.
RAYS = 17
NEWTON_STEPS = 30
# The last step in (u, v), and how far a place may lie outside its patch by rounding.
LAST_STEP = 1e-14
OUTSIDE = 1e-9
# Rays whose least singular value is larger than this part of the largest do not lie in a plane:
# they run down from the tip of a cone.
FLAT = 1e-3


def pole_normal(patches: Sequence[tuple[Surfaces, int]]) -> Array:
    """Return the normal at a pole, shape (3,), of either sign.

    Parameters
    ----------
    patches : sequence of (Surfaces, int)
        The patches around it, each with its collapsed side.

    Raises
    ------
    LostError
        If there is no tangent plane.
    """
    rays = np.concatenate([_rays(surface, side)[1] for surface, side in patches])
    _, values, axes = np.linalg.svd(rays)
    if not values[-1] <= FLAT * values[0]:
        raise LostError
    return np.asarray(axes[-1])


def _rays(surface: Surfaces, side: int) -> tuple[Array, Array]:
    """Return places on a collapsed side, and the unit directions in which the patch leaves it."""
    edge = EDGES[side]
    parameters = np.empty((RAYS, 2))
    parameters[:, edge.fixed_axis] = edge.fixed_value
    parameters[:, 1 - edge.fixed_axis] = np.linspace(0.0, 1.0, RAYS)
    inward = surface.jet(parameters[None], 1)[1 + edge.fixed_axis, :, 0].T
    rays = inward * (-1.0 if edge.fixed_value else 1.0)
    sizes = np.linalg.norm(rays, axis=1, keepdims=True)
    if not (sizes > 0.0).all():
        raise LostError
    return parameters, rays / sizes


def beside_pole(
    patches: Sequence[tuple[int, Surfaces, int]], pole: Array, offset: Array, direction: Array
) -> State:
    """Return the point of the surface over a point of the tangent plane, with its velocity.

    Parameters
    ----------
    patches : sequence of (int, Surfaces, int)
        The number, the surface and the collapsed side of each patch around the pole.
    pole : ndarray, shape (3,)
    offset : ndarray, shape (3,)
        From the pole to the point, in the tangent plane.
    direction : ndarray, shape (3,)
        A unit vector in the tangent plane.

    Raises
    ------
    LostError
        If no patch has such a point.
    """
    distance = float(np.linalg.norm(offset))
    first = offset / distance
    second = np.cross(np.cross(first, direction), first)
    if not np.linalg.norm(second) > 1e-12:
        normal = pole_normal([(surface, side) for _, surface, side in patches])
        second = np.cross(normal, first)
    plane = np.stack([first, second / np.linalg.norm(second)])
    target = np.array([distance, 0.0])
    for number, surface, side in sorted(patches, key=lambda each: -_facing(each, first)[0]):
        start = _facing((number, surface, side), first)[1]
        parameters = _solved(surface, pole, plane, target, (start, side, distance))
        if parameters is not None:
            return State(number, parameters, velocity_along(surface, parameters, direction))
    raise LostError


def _facing(patch: tuple[int, Surfaces, int], ray: Array) -> tuple[float, Array]:
    """Return the cosine between a ray and that of a patch next to it, and where that begins."""
    _, surface, side = patch
    parameters, rays = _rays(surface, side)
    cosines = rays @ ray
    return float(cosines.max()), parameters[int(cosines.argmax())]


def _solved(
    surface: Surfaces, pole: Array, plane: Array, target: Array, begin: tuple[Array, int, float]
) -> Array | None:
    """Return the place of a patch over a point of the tangent plane, by Newton's method."""
    start, side, distance = begin
    edge = EDGES[side]
    inward = -1.0 if edge.fixed_value else 1.0
    speed = np.linalg.norm(jet_at(surface, start)[1 + edge.fixed_axis])
    x = start.copy()
    x[edge.fixed_axis] += inward * distance / speed
    for _ in range(NEWTON_STEPS):
        jet = jet_at(surface, x)
        matrix = plane @ jet[1:3].T
        if not abs(np.linalg.det(matrix)) > 0.0:
            return None
        here = surface.positions(x[None, None])[0, 0]
        step = np.linalg.solve(matrix, target - plane @ (here - pole))
        x = x + step
        if not np.isfinite(x).all() or np.abs(x - 0.5).max() > 2.0:
            return None
        if np.abs(step).max() <= LAST_STEP:
            break
    if np.abs(x - 0.5).max() > 0.5 + OUTSIDE or x[edge.fixed_axis] == edge.fixed_value:
        return None
    return np.clip(x, 0.0, 1.0)


def place_on_side(number: int, side: int, along: float) -> AtlasPoint:
    """Return a place of a pole on one of its patches."""
    edge = EDGES[side]
    pair = [along, along]
    pair[edge.fixed_axis] = edge.fixed_value
    return AtlasPoint(number, *pair)
