"""Pseudo-geodesics by subdivision and unfolding: the paper's reference [5].

A strip of triangles along the path is unfolded into the plane, where the shortest path between the
ends is straight. Where the line leaves the strip, the strip is led round the vertex on that side.
The mesh is subdivided, and the same is done from the path so far. This is written after what the
paper says of Pham-Trong, Szafran and Biard; their own details may differ.
"""

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bench.entrants.meshed_patch import MeshedPatch
from bodymeasure.bezier import evaluate

FIRST_SEGMENTS = 4
MOST_ROUNDS = 40
# How far beyond the end of an edge, as a part of it, a strip is led at once.
BEYOND = 0.6
# The first path is bent a little, so that it does not run through vertices.
BEND = 1e-3


# In segments of the grid: what keeps points off its lines, and within the patch.
ASIDE, INSIDE = np.array([1.3e-8, -0.7e-8]), 1e-7
# A strip is unfolded into the plane of complex numbers.
_Vertex = tuple[int, int]


class Edge(NamedTuple):
    """An edge that a path crosses: its ends on the left and on the right, by place on the grid."""

    left: _Vertex
    right: _Vertex


def unfolded(mesh: MeshedPatch) -> float:
    """Return the length of the path that is straight in its unfolded strip.

    Raises
    ------
    ArithmeticError
        If the path runs along the boundary, where it has no strip.
    """
    counts = [mesh.points - 1]
    while counts[-1] % 2 == 0 and counts[-1] > FIRST_SEGMENTS:
        counts.append(counts[-1] // 2)
    start, end = mesh.parameters[mesh.source], mesh.parameters[mesh.target]
    t = np.linspace(0.0, 1.0, 9)[:, None]
    path = start + (end - start) * t + BEND * np.sin(np.pi * t) * np.array([1.0, -0.7])
    length = np.nan
    for count in reversed(counts):
        path, length = _straightened(mesh.net, path, count)
    return length


def _straightened(net: Array, path: Array, count: int) -> tuple[Array, float]:
    """The path on a mesh with so many segments a side, and the least length that it had."""
    best, least, before = path, np.inf, None
    for _ in range(MOST_ROUNDS):
        edges = _crossed(np.clip(path, 0.0, 1.0), count)
        if edges == before or not edges:
            break
        before = edges
        ends = np.array(edges, dtype=np.float64) / count
        points = evaluate(net, ends.reshape(-1, 2)).reshape(-1, 2, 3)
        first, last = evaluate(net, path[[0, -1]])
        parts = _parts(edges, first, points, last)
        course = np.concatenate([[first], _between(points, np.clip(parts, 0.0, 1.0)), [last]])
        length = float(np.linalg.norm(np.diff(course, axis=0), axis=1).sum())
        led = _between(ends, np.clip(parts, -BEYOND, 1.0 + BEYOND))
        path = np.clip(np.concatenate([path[:1], led, path[-1:]]), 0.0, 1.0)
        if length < least:
            best, least = path, length
    return best, least


def _between(ends: Array, parts: Array) -> Array:
    part = parts[:, None]
    return np.asarray((1.0 - part) * ends[:, 0] + part * ends[:, 1])


def _crossed(path: Array, count: int) -> list[Edge]:
    """The edges of the grid that a path crosses, one after the other."""
    found: list[tuple[float, Edge]] = []
    # No point lies on a line of the grid, so that each step crosses what lies between its ends.
    places = path * count
    places[1:-1] = np.clip(places[1:-1] + ASIDE, INSIDE, count - INSIDE)
    places[0] += INSIDE * (places[1] - places[0])
    places[-1] += INSIDE * (places[-2] - places[-1])
    for number, (a, b) in enumerate(pairwise(places)):
        values = np.array([[a[0], a[1], a[0] - a[1]], [b[0], b[1], b[0] - b[1]]])
        for family, (x0, x1) in enumerate(values.T.tolist()):
            low, high = (x0, x1) if x0 < x1 else (x1, x0)
            for line in range(math.floor(low) + 1, math.floor(high) + 1):
                t = (line - x0) / (x1 - x0)
                ends = _edge(family, line, a + t * (b - a), count)
                if ends is not None:
                    (p, q), way = ends, b - a
                    turn = way[0] * (q[1] - p[1]) - way[1] * (q[0] - p[0])
                    found.append((number + t, Edge(q, p) if turn > 0.0 else Edge(p, q)))
    result: list[Edge] = []
    for _, edge in sorted(found):
        # A path that comes back over an edge does not cross it.
        if result and {*result[-1]} == {*edge}:
            result.pop()
        else:
            result.append(edge)
    return result


def _edge(family: int, line: int, place: Array, count: int) -> tuple[_Vertex, _Vertex] | None:
    """The edge at a point of a line of u, of v or of diagonals; None on the boundary."""
    i, j = (min(max(int(value), 0), count - 1) for value in place)
    if family == 0:
        return ((line, j), (line, j + 1)) if 0 < line < count else None
    if family == 1:
        return ((i, line), (i + 1, line)) if 0 < line < count else None
    j = i - line
    return ((i, j), (i + 1, j + 1)) if 0 <= j < count else None


def _parts(edges: list[Edge], first: Array, points: Array, last: Array) -> Array:
    """Where the straight line in the unfolded strip meets the line of each edge, as its part."""
    flat = np.empty((len(edges), 2), complex)
    left, right = points[0]
    flat[0, 0] = np.linalg.norm(left - first)
    # The right end lies clockwise of the left one, as seen from the start.
    flat[0, 1] = _laid(first, left, 0.0, flat[0, 0], right, side=-1.0)
    for number in range(1, len(edges)):
        before, here = edges[number - 1], edges[number]
        (left, right), (a, b) = points[number - 1], flat[number - 1]
        if here.left == before.left:
            flat[number] = a, _laid(left, right, a, b, points[number, 1], side=1.0)
        elif here.right == before.right:
            flat[number] = _laid(left, right, a, b, points[number, 0], side=1.0), b
        else:
            raise ArithmeticError("the path does not run through a strip of triangles")
    (left, right), (a, b) = points[-1], flat[-1]
    end = _laid(left, right, a, b, last, side=1.0)
    # The line from 0 to the end meets the line of an edge where both have the same side.
    sides = (flat * np.conj(end)).imag
    return np.asarray(sides[:, 0] / (sides[:, 0] - sides[:, 1]))


def _laid(
    a: Array, b: Array, at_a: complex, at_b: complex, point: Array, *, side: float
) -> complex:
    """The place in the plane of a triangle's third corner, from those of the two others."""
    base, arm = b - a, point - a
    length = float(np.linalg.norm(base))
    along = float(arm @ base) / length
    across = float(np.linalg.norm(np.cross(base, arm))) / length
    return at_a + (at_b - at_a) / length * (along + 1j * side * across)
