"""Sections of triangle meshes, against which sections of smooth patches are checked.

Only the plane is taken from `bodymeasure.section`.
"""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.bezier import bernstein, evaluate
from bodymeasure.section import Plane

LEVELS = (64, 128, 256)


def richardson_length(atlas: Atlas, plane: Plane) -> tuple[float, float]:
    """The total length of a section, extrapolated over tessellations, and its last change."""
    length = np.array([mesh_length(atlas, plane, segments) for segments in LEVELS])
    extrapolated = (4.0 * length[1:] - length[:-1]) / 3.0
    return float(extrapolated[-1]), float(abs(extrapolated[-1] - extrapolated[-2]))


def mesh_length(atlas: Atlas, plane: Plane, segments: int) -> float:
    """The total length in which a plane cuts a tessellation, triangle by triangle."""
    distance = (atlas.control_points - plane.point) @ plane.normal
    cut = (distance.min(axis=(1, 2)) < 0.0) & (distance.max(axis=(1, 2)) > 0.0)
    side = np.arange(segments + 1) / segments
    basis = bernstein(3, side)[:, 0]
    total = 0.0
    for net, patch_distance in zip(atlas.control_points[cut], distance[cut], strict=True):
        above = basis @ patch_distance @ basis.T > 0.0
        for steps in (((0, 0), (1, 0), (1, 1)), ((0, 0), (1, 1), (0, 1))):
            corner = [above[i : i + segments, j : j + segments] for i, j in steps]
            mixed = np.argwhere((corner[0] != corner[1]) | (corner[1] != corner[2]))
            corners = mixed[:, None] + np.array(steps)
            total += _triangles_length(evaluate(net, corners / segments), plane)
    return total


def _triangles_length(triangles: Array, plane: Plane) -> float:
    height = (triangles - plane.point) @ plane.normal
    above = height > 0.0
    cut = (above.any(axis=1)) & ~above.all(axis=1)
    triangles, height, above = triangles[cut], height[cut], above[cut]
    # The corner that is alone on its side; the section crosses the two edges from it.
    alone = np.argmax(above == (above.sum(axis=1) == 1)[:, None], axis=1)
    rows = np.arange(len(triangles))
    ends = []
    for step in (1, 2):
        other = (alone + step) % 3
        start, end = height[rows, alone], height[rows, other]
        t = (start / (start - end))[:, None]
        ends.append((1.0 - t) * triangles[rows, alone] + t * triangles[rows, other])
    return float(np.linalg.norm(ends[1] - ends[0], axis=1).sum())
