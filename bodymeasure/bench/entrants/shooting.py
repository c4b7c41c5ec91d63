"""Straightest paths over a mesh, shot at their end: the paper's references [4] and [6].

[4] Polthier and Schmies go straight on over each edge of the triangles; potpourri3d has that. [6]
Ravi Kumar and others bring in the normals of the surface: here the path goes on in the plane of its
direction and the surface's normal, which is interpolated between the vertices. This is written
after what the paper says of both; the articles' own details may differ.
"""

from collections.abc import Callable
from itertools import pairwise

import numpy as np
from scipy.optimize import brentq

from bodymeasure._typing import Array, Ints
from bodymeasure.bench.entrants.meshed_patch import MeshedPatch

# How much longer than the distance of its ends a path is traced.
REACH = 1.5
# The angles that are tried on both sides of the straight line in space, in radians.
SPREAD, TRIED = 0.8, 17
# Shots that come this near the end, relative to the distance, hit it.
HIT = 1e-12
# Shots that pass farther than this from the end, relatively, do not count.
CLOSE = 1e-3
# What a trace may cross, for each row of points.
CROSSINGS_A_ROW = 12

# Takes a direction in space, as long as the trace is to be, and returns points (k, 3).
Trace = Callable[[Array], Array]


def straightest(mesh: MeshedPatch) -> float:
    """Return the length of the straightest path that hits the target, by potpourri3d."""
    from potpourri3d import GeodesicTracer

    tracer = GeodesicTracer(mesh.vertices, mesh.faces)
    return shot(mesh, lambda way: tracer.trace_geodesic_from_vertex(mesh.source, way))


def with_normals(mesh: MeshedPatch) -> float:
    """Return the length of the path that hits the target, in planes of the surface's normals."""
    walker = _Walker(mesh)
    return shot(mesh, walker.trace)


def shot(mesh: MeshedPatch, trace: Trace) -> float:
    """Return the length up to the target of the trace that hits it; NaN if none is found.

    Directions in the tangent plane of the source are tried, and where the target changes sides
    between two of them, the one that hits it is found.
    """
    source, target = mesh.vertices[mesh.source], mesh.vertices[mesh.target]
    normal, last = mesh.normals[mesh.source], mesh.normals[mesh.target]
    way = target - source
    distance = float(np.linalg.norm(way))
    ahead = way - (way @ normal) * normal
    ahead /= np.linalg.norm(ahead)
    aside = np.cross(normal, ahead)

    def path(angle: float) -> Array:
        direction = np.cos(angle) * ahead + np.sin(angle) * aside
        return trace(REACH * distance * direction)

    def miss(angle: float) -> float:
        return _miss(path(angle), target, last)[0] / distance

    angles = np.linspace(-SPREAD, SPREAD, TRIED)
    misses = [miss(angle) for angle in angles]
    found = []
    for (a, b), (left, right) in zip(pairwise(angles), pairwise(misses), strict=True):
        if left * right <= 0.0:
            angle = brentq(miss, a, b, xtol=HIT)
            gap, length = _miss(path(angle), target, last)
            # Behind a saddle's vertex, neighboring shots part, and the target lies between them.
            if abs(gap) < CLOSE * distance:
                found.append(float(np.hypot(length, gap)))
    return min(found, default=np.nan)


def _miss(path: Array, target: Array, normal: Array) -> tuple[float, float]:
    """The distance at which a path passes its target, with the side, and the length up to there."""
    steps = np.diff(path, axis=0)
    sizes = np.linalg.norm(steps, axis=1)
    steps, starts, sizes = steps[sizes > 0.0], path[:-1][sizes > 0.0], sizes[sizes > 0.0]
    if not len(steps):
        return float(np.inf), 0.0
    units = steps / sizes[:, None]
    along = np.clip(((target - starts) * units).sum(axis=1), 0.0, sizes)
    gaps = target - starts - along[:, None] * units
    nearest = int(np.argmin((gaps * gaps).sum(axis=1)))
    side = float(np.cross(units[nearest], gaps[nearest]) @ normal)
    gap = float(np.linalg.norm(gaps[nearest]))
    return np.copysign(gap, side), float(sizes[:nearest].sum() + along[nearest])


class _Walker:
    """Walks over the triangles of a mesh in planes of the surface's normals."""

    def __init__(self, mesh: MeshedPatch) -> None:
        self._mesh = mesh
        # The third vertex of the triangle on the left of each directed edge.
        self._third: dict[tuple[int, int], int] = {}
        for a, b, c in mesh.faces.tolist():
            self._third[a, b], self._third[b, c], self._third[c, a] = c, a, b
        around: Ints = mesh.faces[(mesh.faces == mesh.source).any(axis=1)]
        self._around = [
            tuple(np.roll(face, -int(np.argmax(face == mesh.source)))[1:].tolist())
            for face in around
        ]

    def trace(self, way: Array) -> Array:
        vertices, normals = self._mesh.vertices, self._mesh.normals
        point, left = vertices[self._mesh.source], float(np.linalg.norm(way))
        points, normal, direction = [point], normals[self._mesh.source], way / left
        crossing = self._cut(self._around, point, normal, direction)
        for _ in range(CROSSINGS_A_ROW * int(np.sqrt(len(vertices)))):
            if crossing is None or left <= 0.0:
                break
            (a, b), part = crossing
            point = (1.0 - part) * vertices[a] + part * vertices[b]
            step = point - points[-1]
            left -= float(np.linalg.norm(step))
            points.append(point)
            normal = (1.0 - part) * normals[a] + part * normals[b]
            normal = normal / np.linalg.norm(normal)
            direction = step - (step @ normal) * normal
            third = self._third.get((b, a))
            if third is None:
                break
            crossing = self._cut([(a, third), (third, b)], point, normal, direction)
        return np.array(points)

    def _cut(
        self, edges: list[tuple[int, ...]], point: Array, normal: Array, direction: Array
    ) -> tuple[tuple[int, int], float] | None:
        """The edge that the plane of direction and normal meets ahead, and where."""
        across = np.cross(normal, direction)
        for a, b in edges:
            first, last = self._mesh.vertices[a] - point, self._mesh.vertices[b] - point
            below, above = float(first @ across), float(last @ across)
            if below * above <= 0.0 and below != above:
                part = below / (below - above)
                if ((1.0 - part) * first + part * last) @ direction > 0.0:
                    return (a, b), part
        return None
