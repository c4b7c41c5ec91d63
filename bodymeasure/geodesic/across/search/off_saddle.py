"""Steps off a saddle: paths to both sides of one that is at rest, but not the shortest near it.

On a symmetric surface the path in the plane of symmetry is at rest, even where it leads over a
ridge. Newton's method does not leave it, and no seam need be near over which another route leads.
"""

from collections.abc import Iterator

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.across.pieces.refine import RefinedPath, measured, sharpened

# How far the middle of a path steps aside, as a part of its length.
ASIDE = 0.02


def beside_saddle(saddle: RefinedPath) -> Iterator[RefinedPath]:
    """Yield the paths along the route of a saddle that are at rest on either side of it."""
    problem, aside = saddle.problem, _aside(saddle)
    for sign in (-1.0, 1.0):
        guess = np.where(problem.idle, saddle.minimum.unknowns, 0.0)
        moved = (saddle.values + sign * aside).reshape(len(aside), -1)
        unknown = np.take_along_axis(moved, problem.local, axis=1)
        # Along a seam that runs the other way the unknown is the rest to 1.
        unknown = np.where(problem.sign < 0.0, 1.0 - unknown, unknown)
        moves = problem.sign != 0.0
        guess[problem.rows[moves]] = unknown[moves]
        minimum = problem.minimized(np.clip(guess, 0.0, 1.0))
        yield sharpened(measured(problem, minimum), problem.idle)


def _aside(path: RefinedPath) -> Array:
    """Steps in (u, v) of all nodes across a path, longest in its middle, as `values`."""
    problem, values = path.problem, path.values
    _, s_u, s_v = problem.surface.jet(np.ascontiguousarray(values.transpose(0, 2, 1)), 1)
    slopes = problem.space.matrices(problem.space.nodes)[1]
    du, dv = ((values - values[:, :, :1]) @ slopes.T).transpose(1, 0, 2)
    along, normal = s_u * du + s_v * dv, np.cross(s_u, s_v, axis=0)
    across = np.cross(normal, along, axis=0)
    size = np.linalg.norm(across, axis=0)
    across = across / np.where(size > 0.0, size, 1.0)
    ends = np.cumsum(path.lengths)
    begins = ends - path.lengths
    way = begins[:, None] + path.lengths[:, None] * problem.space.nodes
    across *= ASIDE * ends[-1] * np.sin(np.pi * way / ends[-1])
    # The step in (u, v) whose image is the one across: least squares with the metric.
    e, f, g = (s_u * s_u).sum(axis=0), (s_u * s_v).sum(axis=0), (s_v * s_v).sum(axis=0)
    by_u, by_v = (s_u * across).sum(axis=0), (s_v * across).sum(axis=0)
    area = e * g - f * f
    area = np.where(area > 0.0, area, np.inf)
    return np.stack([(g * by_u - f * by_v) / area, (e * by_v - f * by_u) / area], axis=1)
