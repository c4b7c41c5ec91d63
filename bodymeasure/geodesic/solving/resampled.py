"""Paths that a method found in a form of its own, as polynomials that are measured like others."""

from collections.abc import Callable

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.lengths.measure import measure_length
from bodymeasure.geodesic.solving.on_spaces import straight
from bodymeasure.geodesic.solving.protocol import PathBatch
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.protocol import Surface

# The degrees that are tried in turn.
DEGREES = (8, 12, 16, 20, 28, 40)

Path = Callable[[Array], Array]
"""A function from k parameters t in [0, 1] to (u, v), shape (2, k)."""


def resampled(
    surface: Surface,
    paths: list[Path | None],
    ends: tuple[Array, Array],
    *,
    tolerance: float,
) -> tuple[PathBatch, ...]:
    """Return polynomials through paths, of the degree at which the length is best known.

    The lowest degree whose length is known to the tolerance is taken, and if there is none, that
    with the least estimated error.

    Parameters
    ----------
    surface : Surface
    paths : list of callable
        The paths; None where the method failed, for which a straight line that is not converged
        stands in the result.
    ends : tuple of ndarray
        The starts and the ends, both of shape (problems, 2); the polynomials meet them exactly.
    tolerance : float
        The relative error of the length that is asked for.
    """
    start, end = ends
    failed = np.array([path is None for path in paths], bool)
    least = np.full(len(paths), np.inf)
    chosen = np.zeros(len(paths), np.int64)
    is_open = np.ones(len(paths), bool)
    batches: list[PathBatch] = []
    for number, degree in enumerate(DEGREES):
        rest = np.flatnonzero(is_open)
        if len(rest) == 0:
            break
        space = polynomial_space(degree)
        values = straight(start[rest], end[rest], space.nodes)
        for row, problem in enumerate(rest):
            path = paths[problem]
            if path is not None:
                values[row] = path(space.nodes)
        # The ends are off by so little that the path can be moved linearly along it.
        for place, target in ((0, start), (-1, end)):
            weights = 1.0 - space.nodes if place == 0 else space.nodes
            values += (target[rest] - values[:, :, place])[:, :, None] * weights
            values[:, :, place] = target[rest]
        part = surface.take(rest)
        length = measure_length(part, space, values)
        good = length.is_known_to(tolerance) & ~failed[rest]
        batches.append(PathBatch(rest, space, values, length, good, np.zeros(len(rest), bool)))
        relative = length.error / length.raw
        better = good | (relative < least[rest]) | (number == 0)
        chosen[rest[better]] = number
        least[rest[better]] = relative[better]
        is_open[rest[good]] = False
        is_open[failed] = False
    picked = (
        batch.take(np.flatnonzero(chosen[batch.problems] == number))
        for number, batch in enumerate(batches)
    )
    return tuple(batch for batch in picked if len(batch.problems))
