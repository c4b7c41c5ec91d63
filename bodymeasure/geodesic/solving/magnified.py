"""Problems between points that are close together, solved in magnified coordinates.

The way from start to end becomes one of unit size. Parameters have rounding errors of 1e-16, which
between points 1e-12 apart would be a ten-thousandth of the way; in the magnified coordinates, which
begin at the start, they are 1e-16 of the way.
"""

from dataclasses import replace

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.solving.protocol import Method, MethodResult, PathBatch
from bodymeasure.geodesic.surfaces.protocol import JET, JET_SIZE, Surface

# Points closer than this in u and v are near; beyond it, no more than two digits are lost.
NEAR = 0.03
# The way from start to end takes up this part of the magnified unit square, and begins in its
# middle, so that paths have room in it.
WAY = 0.25
MIDDLE = 0.5
# The factors of derivatives are powers of 2 with exponents of at most this size: none overflows.
MOST = 1000
_ORDERS = np.array(JET)


class MagnifiedSurface:
    """Surfaces in coordinates (u, v) = center + extent * (q - 1/2), in another unit of length.

    Parameters
    ----------
    surface : Surface
    center : ndarray, shape (problems, 2)
    extent : ndarray of int, shape (problems, 2)
        Exponents of powers of two, so that nothing is rounded.
    unit : ndarray of int, shape (problems,)
        The exponents of the units of length.
    """

    def __init__(
        self,
        surface: Surface,
        center: Array,
        extent: Ints,
        unit: Ints,
    ) -> None:
        self._surface = surface
        self._center = center
        self._extent = extent
        self._unit = unit

    def parameters(self, place: Array) -> Array:
        """Return (u, v) for magnified coordinates, both of shape (problems, k, 2)."""
        moved: Array = np.ldexp(place - MIDDLE, self._extent[:, None])
        return self._center[:, None] + moved

    def jet(self, parameters: Array, order: int) -> Array:
        """Return the derivatives in the order of `JET`; positions are not magnified."""
        jet = self._surface.jet(self.parameters(parameters), order)
        powers = _ORDERS[: JET_SIZE[order]] @ self._extent.T - self._unit
        powers[0] = 0
        jet *= np.ldexp(1.0, np.clip(powers, -MOST, MOST))[:, None, :, None]
        return jet

    def positions(self, parameters: Array) -> Array:
        """Return points, shape (problems, k, 3), in the surface's own unit."""
        return self._surface.positions(self.parameters(parameters))

    def magnitude(self, parameters: Array) -> Array:
        """Return the size of the terms of S_u and S_v, shape (2, problems, k)."""
        magnitude = self._surface.magnitude(self.parameters(parameters))
        powers = np.clip(self._extent.T - self._unit, -MOST, MOST)
        return np.asarray(magnitude * np.ldexp(1.0, powers)[:, :, None])

    def take(self, problems: Ints) -> "MagnifiedSurface":
        """Return the surfaces of some of the problems."""
        return MagnifiedSurface(
            self._surface.take(problems),
            self._center[problems],
            self._extent[problems],
            self._unit[problems],
        )


def solve_near_and_far(method: Method, surface: Surface, start: Array, end: Array) -> MethodResult:
    """Solve by a method, with near problems magnified; start and end of shape (problems, 2)."""
    if len(start) == 0:
        return MethodResult((), np.zeros(0, np.int64))
    move = np.abs(end - start)
    near = np.maximum(move[:, 0], move[:, 1]) < NEAR
    if not near.any():
        return method.solve(surface, start, end)
    batches: list[PathBatch] = []
    iterations = np.zeros(len(start), np.int64)
    for rows in (np.flatnonzero(~near), np.flatnonzero(near)):
        if len(rows) == 0:
            continue
        part = surface.take(rows)
        if near[rows[0]]:
            result = _magnified(method, part, start[rows], end[rows])
        else:
            result = method.solve(part, start[rows], end[rows])
        batches += [batch.renumbered(rows[batch.problems]) for batch in result.batches]
        iterations[rows] = result.iterations
    return MethodResult(tuple(batches), iterations)


def _magnified(method: Method, surface: Surface, start: Array, end: Array) -> MethodResult:
    move = end - start
    extent, unit = _sizes(surface, start, move)
    magnified = MagnifiedSurface(surface, start, extent, unit)
    middle = np.full_like(start, MIDDLE)
    result = method.solve(magnified, middle, MIDDLE + np.ldexp(move, -extent))
    batches = []
    for batch in result.batches:
        rows = batch.problems
        places = magnified.take(rows).parameters(batch.values.transpose(0, 2, 1))
        values = places.transpose(0, 2, 1)
        values[:, :, -1] = end[rows]
        length = batch.length.scaled(np.ldexp(1.0, unit[rows]))
        batches.append(replace(batch, values=values, length=length))
    return MethodResult(tuple(batches), result.iterations)


def _sizes(surface: Surface, start: Array, move: Array) -> tuple[Ints, Ints]:
    """The size of the part of the patch that a way takes up, in u and v and in length.

    The sizes are exponents of powers of two. A short way takes up less of a coordinate in which the
    patch is much longer than in the other.
    """
    with np.errstate(all="ignore"):
        slopes = np.linalg.norm(surface.jet((start + move / 2.0)[:, None], 1)[1:, :, :, 0], axis=1)
        chord = (slopes.T * np.abs(move)).sum(axis=1)
        span = np.abs(move).max(axis=1)
        # Where the surface stands still, or is not finite, only the way itself gives a size.
        extent = np.fmin(chord / slopes, span).T
        length = np.where(np.isfinite(chord) & (chord > 0.0), chord, span)
    room = np.frexp(1.0 / WAY)[1]
    return np.frexp(extent)[1] + room, np.frexp(length)[1].astype(np.int64)
