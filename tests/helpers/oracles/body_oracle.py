"""Libigl's exact distance between points of a whole atlas, extrapolated from tessellations."""

import numpy as np

from bodymeasure.atlas import Atlas, AtlasPoint, tessellate
from bodymeasure.oracle.extrapolate import richardson
from bodymeasure.oracle.libigl import exact_distance

# The segments of a patch edge in each tessellation. Points whose parameters are quarters are
# vertices of all three.
LEVELS = (4, 8, 12)
# Libigl is given the part of the mesh that a path can reach which is this many times as long as the
# one to be checked.
ROOM = 1.02


def quarter_point(rng: np.random.Generator, atlas: Atlas) -> AtlasPoint:
    """A random point that is a vertex of every tessellation."""
    u, v = (rng.integers(1, 4, 2) / 4.0).tolist()
    return AtlasPoint(int(rng.integers(len(atlas))), u, v)


def mesh_distance(
    atlas: Atlas,
    start: AtlasPoint,
    end: AtlasPoint,
    longest: float,
    levels: tuple[int, ...] = LEVELS,
) -> tuple[float, float]:
    """The exact distance and its uncertainty, among paths not much longer than `longest`."""
    by_level = []
    ends = np.array([atlas.position(start), atlas.position(end)])
    for segments in levels:
        mesh = tessellate(atlas, segments)
        way = sum(np.linalg.norm(mesh.vertices - point, axis=1) for point in ends)
        faces = mesh.faces[(way < ROOM * longest)[mesh.faces].any(axis=1)]
        used, faces = np.unique(faces, return_inverse=True)
        vertices = mesh.vertices[used]
        source, target = (
            int(np.argmin(np.linalg.norm(vertices - point, axis=1))) for point in ends
        )
        assert np.linalg.norm(vertices[[source, target]] - ends) < 1e-12
        by_level.append(exact_distance(vertices, faces.reshape(-1, 3), source, target))
    exact, doubt = richardson(np.array(by_level), levels)
    return float(exact), float(doubt)
