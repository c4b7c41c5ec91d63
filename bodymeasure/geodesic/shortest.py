"""The shortest path inside the patch: candidates, descent, polishing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure.geodesic.contact import ContactPath, read_legs, solve_legs
from bodymeasure.geodesic.descent import descend, ways_off
from bodymeasure.geodesic.graph import rough_paths
from bodymeasure.geodesic.surface import Surface
from bodymeasure.geodesic.trial_space import TrialSpace

_Array = NDArray[np.float64]

# Edges of the polygons that compete, and of those whose pattern of contacts is read, in turn.
ROUGH_EDGES = 32
FINE_EDGES = (64, 256)
# A curvature below this, relative to the metric, is a saddle's.
SADDLE = -1e-6
# How far, in u or v, a path steps off a saddle.
STEP_OFF = 0.05
# Polygons within this of the best are polished: closer ones are not told apart by their lengths.
CONTENDERS = 1.01
# Polygons nearer to one another than this everywhere, in (u, v), lead to the same path.
SAME = 0.02


class Found(NamedTuple):
    """What a search found.

    Parameters
    ----------
    path : ContactPath or None
        None if the best candidate could not be polished.
    polygon : float
        Length of the shortest polygon: a little less than the path that it stands for.
    """

    path: ContactPath | None
    polygon: float


NOTHING_FOUND = Found(None, float("inf"))


def shortest_path(
    surface: Surface,
    start: _Array,
    end: _Array,
    known: Sequence[_Array],
    spaces: Sequence[TrialSpace],
    tolerance: float,
) -> Found:
    """The shortest path found between two points of a patch, inside it.

    Candidates are the straight line, paths that are known already, and the graph's; each slides
    down to a path at rest, off saddles too, in the box; those nearly as short as the best are
    polished, and the shortest of them wins. That there is none shorter still is not proven.

    Parameters
    ----------
    surface : Surface
        Of one problem.
    start, end : ndarray, shape (2,)
    known : sequence of ndarray, shape (k, 2)
        Paths from start to end; they may leave the patch.
    spaces : sequence of TrialSpace
        For the polishing, tried in turn.
    tolerance : float
        Relative error asked for.

    Returns
    -------
    Found
    """
    # Overflow and the like on wild surfaces end as candidates that are not finite.
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        return _shortest(surface, (start, end), known, spaces, tolerance)


def _shortest(
    surface: Surface,
    ends: tuple[_Array, _Array],
    known: Sequence[_Array],
    spaces: Sequence[TrialSpace],
    tolerance: float,
) -> Found:
    start, end = ends
    times = np.linspace(0.0, 1.0, ROUGH_EDGES + 1)
    seeds = [start + (end - start) * times[:, None]]
    seeds += [_resampled(path, ROUGH_EDGES) for path in known if np.isfinite(path).all()]
    seeds += rough_paths(surface, start, end, ROUGH_EDGES)
    jets = [surface.jet(seed[None], 2) for seed in seeds]
    # Nothing can be found where the surface is not finite, or all one point.
    if not all(np.isfinite(jet).all() and np.any(jet[1:3]) for jet in jets):
        return NOTHING_FOUND
    points, lengths = _at_rest(surface, np.stack(seeds))
    order = np.argsort(lengths, kind="stable")
    contenders: list[_Array] = []
    for number in order:
        if lengths[number] > CONTENDERS * lengths[order[0]]:
            break
        if all(np.abs(points[number] - other).max() > SAME for other in contenders):
            contenders.append(points[number])
    polished = [_polished(surface, polygon, spaces, tolerance) for polygon in contenders]
    polygon = float(lengths[order[0]])
    if polished[0] is None:
        return Found(None, polygon)
    best = min(
        (path for path in polished if path is not None),
        key=lambda path: float(path.measured.corrected[0]),
    )
    return Found(best, polygon)


def _at_rest(surface: Surface, seeds: _Array) -> tuple[_Array, _Array]:
    """Polygons that the seeds slide down to, those beyond saddles included, and their lengths."""
    same = np.zeros(len(seeds), np.int64)
    points, lengths = descend(surface.take(same), seeds)
    curvature, direction = ways_off(surface.take(same), points)
    saddles = np.flatnonzero(curvature < SADDLE)
    if len(saddles) == 0:
        return points, lengths
    step = STEP_OFF * direction[saddles]
    both = np.concatenate([points[saddles] - step, points[saddles] + step])
    beyond, beyond_lengths = descend(surface.take(np.zeros(len(both), np.int64)), both)
    return np.concatenate([points, beyond]), np.concatenate([lengths, beyond_lengths])


def _polished(
    surface: Surface, polygon: _Array, spaces: Sequence[TrialSpace], tolerance: float
) -> ContactPath | None:
    for edges in FINE_EDGES:
        polygon = descend(surface, _resampled(polygon, edges)[None])[0][0]
        path = solve_legs(surface, polygon, read_legs(polygon), spaces, tolerance)
        if path is not None:
            return path
    return None


def _resampled(path: _Array, edges: int) -> _Array:
    """A polygon with another number of edges, kept in the box."""
    old, new = np.linspace(0.0, 1.0, len(path)), np.linspace(0.0, 1.0, edges + 1)
    polygon = np.stack([np.interp(new, old, path[:, axis]) for axis in (0, 1)], axis=1)
    return np.clip(polygon, 0.0, 1.0)
