"""The smooth surface of a part of a quad mesh: its farthest points, and girths round it."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools
from bodymeasure.subdivision import (
    QuadMesh,
    children,
    limit_positions,
    part,
    quads_within,
    subdivide,
)

# Rings of quads round a part, on which its limit surface depends.
MARGIN = 3
# Steps of subdivision: the girths of two steps are extrapolated to the limit, to which they
# converge with the square of the quads' size.
STEPS = 2
# Further steps round a farthest point, so that it is known to some micrometers.
CLOSER = 3
# Where a vertex is the farthest point, subdivision gains nothing, which does not prove that nothing
# was to be gained. This part of a height is a fraction of a micrometer.
LEAST_ERROR = 1e-7


class Length(NamedTuple):
    """A length and its estimated error from the computation, both in the mesh's unit."""

    value: float
    error: float


@dataclass(frozen=True, eq=False)
class Patchwork:
    """A part of a quad mesh, subdivided, with points of its limit surface.

    Parameters
    ----------
    mesh : QuadMesh
        With a margin round the part, so that the limit is that of the whole mesh.
    limit : ndarray, shape (n, 3)
        The limits of its vertices.
    inside : ndarray of bool, shape (m,)
        Which quads are the part.
    """

    mesh: QuadMesh
    limit: Array
    inside: Bools

    def farthest(self, far: Callable[[Array], Array]) -> tuple[int, float]:
        """Return the vertex of the part at whose limit a function is the largest, and its value."""
        numbers = np.unique(self.mesh.quads[self.inside])
        values = far(self.limit[numbers])
        top = int(np.argmax(values))
        return int(numbers[top]), float(values[top])


def patchworks(whole: QuadMesh, vertices: Bools) -> tuple[Patchwork, ...]:
    """Return the quads that have only some vertices, at each step of subdivision from 0 on."""
    chosen = np.asarray(vertices[whole.quads].all(axis=1))
    wide = quads_within(whole, np.unique(whole.quads[chosen]), MARGIN)
    mesh, _ = part(whole, wide)
    inside = chosen[wide]
    made = [Patchwork(mesh, limit_positions(mesh), inside)]
    for step in range(1, STEPS + 1):
        mesh = subdivide(mesh)
        made.append(Patchwork(mesh, limit_positions(mesh), children(inside, step)))
    return tuple(made)


def farthest(steps: Sequence[Patchwork], far: Callable[[Array], Array]) -> tuple[Array, Length]:
    """Return the point of a part where a function is the largest, and its value there.

    Parameters
    ----------
    steps : sequence of Patchwork
    far : callable
        Gives a value for each point, from an array (n, 3).
    """
    finest = steps[-1]
    best, value = finest.farthest(far)
    closer = closer_to(finest, best)
    top, last = closer.farthest(far)
    # The last steps have gained 63 of 64 parts of what was lacking, if they converge as squares do.
    error = max(abs(last - value) / 21.0, LEAST_ERROR * abs(value))
    return closer.limit[top], Length(last, error)


def closer_to(patchwork: Patchwork, vertex: int) -> Patchwork:
    """Return the quads of a part about one of its vertices, subdivided further."""
    near = quads_within(patchwork.mesh, np.array([vertex]), 1 + MARGIN)
    mesh, old = part(patchwork.mesh, near)
    inside = np.asarray((mesh.quads == np.searchsorted(old, vertex)).any(axis=1))
    inside &= patchwork.inside[near]
    for _ in range(CLOSER):
        mesh, inside = subdivide(mesh), children(inside, 1)
    return Patchwork(mesh, limit_positions(mesh), inside)


def girth(steps: Sequence[Patchwork], at: Array, normal: Array) -> Length:
    """Return the length of a tape that is drawn taut round a part in a plane.

    It is the perimeter of the convex hull of the section, of all its loops.
    """
    return _extrapolated([_hull(patchwork, at, normal) for patchwork in steps])


def breadth(steps: Sequence[Patchwork], at: Array, normal: Array) -> Length:
    """Return the largest distance of two points of the section of a part with a plane."""
    return _extrapolated([_diameter(_section(each, at, normal)) for each in steps])


def _extrapolated(values: list[float]) -> Length:
    """Return the limit of what converges with the square of the quads' size, from its steps.

    The error of the last step is a third of what it gained; where the section runs along the sides
    of quads, the steps are less even, and the one before may tell more.
    """
    before, last = np.diff(values)[-2:]
    return Length(values[-1] + last / 3.0, max(abs(last), abs(before) / 4.0) / 3.0)


def _diameter(points: Array) -> float:
    return float(scipy.spatial.distance.pdist(points).max())


def _hull(patchwork: Patchwork, at: Array, normal: Array) -> float:
    points = _section(patchwork, at, normal)
    first = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    first /= np.linalg.norm(first)
    flat = points @ np.stack([first, np.cross(normal, first)], axis=1)
    # The area of a plane hull is its perimeter.
    return float(scipy.spatial.ConvexHull(flat).area)


def _section(patchwork: Patchwork, at: Array, normal: Array) -> Array:
    """Return the points where sides of quads cross a plane."""
    quads = patchwork.mesh.quads[patchwork.inside]
    ends = np.stack([quads, np.roll(quads, -1, axis=1)], axis=-1).reshape(-1, 2)
    side = (patchwork.limit - at) @ normal
    # An end on the plane is an end of other sides that cross it.
    ends = ends[(side[ends[:, 0]] <= 0.0) & (side[ends[:, 1]] > 0.0)]
    low, high = side[ends].T
    share = (low / (low - high))[:, None]
    first, second = patchwork.limit[ends].swapaxes(0, 1)
    return np.asarray((1.0 - share) * first + share * second)
