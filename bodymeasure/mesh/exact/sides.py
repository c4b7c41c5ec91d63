"""The directed sides of a mesh's triangles, their shapes, and the fans of triangles about vertices.

Side k of face f has number 3 f + k and leads from corner k to corner k + 1; the face lies to its
left. In the frame of a side, it leads from 0 along the real axis, and the face lies above it.
"""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Bools, Complex, Ints
from bodymeasure.mesh.arrays import TriangleMesh


@dataclass(frozen=True, eq=False)
class Sides:
    """The directed sides of an oriented mesh: arrays of shape (3 f,) but for the last two.

    Parameters
    ----------
    mesh : TriangleMesh
    first, last : ndarray of int
        The vertices that a side joins.
    over : ndarray of int
        The same side in the face beyond it; -1 on the boundary.
    length : ndarray
    angle : ndarray
        The angle at the first vertex, between the side and the one before it.
    turn : ndarray of complex
        The angle as a number on the unit circle.
    third : ndarray of complex
        The corner opposite to a side, in its frame.
    place : ndarray
        Where a side stands in the fan about its first vertex: the angle to it from the fan's first.
    fan : ndarray of int
        A number for each fan; a vertex has several where faces touch in it alone.
    total : ndarray
        The sum of the angles of a side's fan.
    closed : ndarray of bool
        Whether the fan leads all round its vertex.
    begins, about : ndarray of int
        `about[begins[v] : begins[v + 1]]` are the sides that lead away from vertex v.
    """

    mesh: TriangleMesh
    first: Ints
    last: Ints
    over: Ints
    length: Array
    angle: Array
    turn: Complex
    third: Complex
    place: Array
    fan: Ints
    total: Array
    closed: Bools
    begins: Ints
    about: Ints

    @classmethod
    def of(cls, mesh: TriangleMesh) -> "Sides":
        """Return the sides of a mesh."""
        first, last = mesh.faces.ravel(), np.roll(mesh.faces, -1, axis=1).ravel()
        ahead = mesh.vertices[last] - mesh.vertices[first]
        behind = -ahead[before(np.arange(len(first)))]
        length = np.linalg.norm(ahead, axis=1)
        sine = np.linalg.norm(np.cross(ahead, behind), axis=1)
        angle = np.arctan2(sine, (ahead * behind).sum(axis=1))
        turn = np.exp(1j * angle)
        over = _over(first, last, len(mesh.vertices))
        about = np.argsort(first, kind="stable")
        begins = np.searchsorted(first[about], np.arange(len(mesh.vertices) + 1))
        third = turn * length[before(np.arange(len(first)))]
        fans = _fans(first, over, angle)
        return cls(mesh, first, last, over, length, angle, turn, third, *fans, begins, about)


def after(side: Ints) -> Ints:
    """Return the side of the same face that follows."""
    return side + np.where(side % 3 == 2, -2, 1)


def before(side: Ints) -> Ints:
    """Return the side of the same face that comes before."""
    return side + np.where(side % 3 == 0, 2, -1)


def _over(first: Ints, last: Ints, count: int) -> Ints:
    """Return for each side the same side in the face beyond it."""
    edge = np.minimum(first, last) * count + np.maximum(first, last)
    order = np.argsort(edge, kind="stable")
    same = np.flatnonzero(edge[order[1:]] == edge[order[:-1]])
    over = np.full(len(first), -1)
    one, other = order[same], order[same + 1]
    over[one], over[other] = other, one
    return over


def _fans(first: Ints, over: Ints, angle: Array) -> tuple[Array, Ints, Array, Bools]:
    """Return each side's place in its fan, the fan's number, its total, and if it is closed."""
    place = np.zeros(len(first))
    fan, closed = np.full(len(first), -1), np.zeros(len(first), bool)
    total = np.zeros(len(first))
    # Open fans begin at the side that has no face to its right; closed ones anywhere.
    heads = np.flatnonzero(over < 0)
    while len(heads):
        fan[heads] = heads
        here, lead = heads, heads
        angles = np.zeros(len(heads))
        while len(here):
            angles = angles + angle[here]
            total[lead] = angles
            there = over[before(here)]
            goes_on = (there >= 0) & (there != lead)
            closed[lead] = there == lead
            here, lead, angles = there[goes_on], lead[goes_on], angles[goes_on]
            place[here], fan[here] = angles, lead
        left = np.flatnonzero(fan < 0)
        _, once = np.unique(first[left], return_index=True)
        heads = left[once]
    return place, fan, total[fan], closed[fan]
