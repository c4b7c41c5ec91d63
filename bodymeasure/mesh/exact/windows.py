"""Windows: the parts of sides that straight legs from one root reach through one strip of faces.

A shortest path over a mesh is a chain of straight legs, whose inner ends are vertices with angles
of 360 degrees and more about them, or on the boundary. The legs from a root that cross the same
strip of faces, unfolded into the plane, meet its last side in an interval, the window. Each window
keeps its root in the frame of its own side, so that unfolding only turns it about corners, which
triangles of any shape bear.
"""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Complex, Ints
from bodymeasure.mesh.exact.sides import Sides, after, before

# Legs that pass a corner by less than this angle lead to it. Rounding in some thousand turns is a
# hundredth of it, and a path that is bent by it is longer by its square.
GRAZING = 1e-11
# Lengths that differ by less than this part may be the same, but for rounding.
ROUNDED = 1e-12


class Windows(NamedTuple):
    """Some windows. All arrays have shape (k,).

    Parameters
    ----------
    side : ndarray of int
        The side, in the face that the legs enter.
    root : ndarray of complex
        Where the legs begin, in the frame of the side: below it.
    left, right : ndarray
        The interval, as distances from the side's first vertex.
    way : ndarray
        The length of the path to the root.
    number : ndarray of int
        The number of the root.
    parent : ndarray of int
        The number of the window before; -1 if there is none.
    """

    side: Ints
    root: Complex
    left: Array
    right: Array
    way: Array
    number: Ints
    parent: Ints

    def take(self, which: Ints | Bools) -> "Windows":
        """Return some of them."""
        return Windows(
            self.side[which],
            self.root[which],
            self.left[which],
            self.right[which],
            self.way[which],
            self.number[which],
            self.parent[which],
        )

    @property
    def least(self) -> Array:
        """The length of the shortest path to each."""
        foot = np.clip(self.root.real, self.left, self.right)
        return np.asarray(self.way + np.abs(self.root - foot))

    @classmethod
    def joined(cls, parts: list["Windows"]) -> "Windows":
        """Return the windows of several batches as one."""
        return cls(*(np.concatenate(each) for each in zip(*parts, strict=True)))


class Corners(NamedTuple):
    """How windows see a point of the face that they enter; arrays of shape (k,).

    Parameters
    ----------
    right_of_left, left_of_right : ndarray
        Sines of the angles from the window's left ray to the point, and on to its right ray.
    distance : ndarray
        From the root.
    """

    right_of_left: Array
    left_of_right: Array
    distance: Array

    @property
    def seen(self) -> Bools:
        """Whether a straight leg leads to the point."""
        return (self.right_of_left >= -GRAZING) & (self.left_of_right >= -GRAZING)


def look(windows: Windows, point: Complex) -> Corners:
    """Return how windows see a point each, in the frames of their sides."""
    ray = point - windows.root
    one = _sine(ray, windows.left - windows.root)
    other = _sine(windows.right - windows.root, ray)
    return Corners(one, other, np.abs(ray))


def _sine(one: Complex, other: Complex) -> Array:
    """Return the sines of the angles from rays to others."""
    size = np.abs(one) * np.abs(other)
    cross = one.real * other.imag - one.imag * other.real
    return np.asarray(np.divide(cross, size, out=np.zeros_like(cross), where=size > 0.0))


def unfolded(
    sides: Sides, windows: Windows, corner: Corners, number: Ints
) -> tuple[Windows, Complex, Array]:
    """Return the windows over the other two sides of the faces that windows enter.

    Parameters
    ----------
    sides : Sides
    windows : Windows
    corner : Corners
        How they see the third corner.
    number : ndarray of int
        Their own numbers.

    Returns
    -------
    windows : Windows
    behind : ndarray of complex
        The corner of the face behind each that is not on its side, in the side's frame.
    near : ndarray
        The end of each that is the nearer one to the side by which the legs came: a path from the
        corner behind to that end cuts all legs.
    """
    # Over the side from the third corner to the first vertex, the frame turns about that vertex.
    goes = (corner.right_of_left > GRAZING) & (sides.over[before(windows.side)] >= 0)
    some, whole = windows.take(goes), sides.length[windows.side[goes]]
    side = before(some.side)
    turn, length = sides.turn[some.side].conjugate(), sides.length[side]
    root = some.root * turn
    left = _met(root, some.left * turn, length, length)
    cut = _met(root, some.right * turn, length, length)
    right = np.where(corner.left_of_right[goes] < -GRAZING, cut, length)
    one = Windows(sides.over[side], root, left, right, some.way, some.number, number[goes])
    behind_one = whole * turn
    # Over the side from the last vertex to the third corner, it turns about the last vertex.
    goes = (corner.left_of_right > GRAZING) & (sides.over[after(windows.side)] >= 0)
    some, whole = windows.take(goes), sides.length[windows.side[goes]]
    side = after(some.side)
    turn, length = sides.turn[side], sides.length[side]
    root = (some.root - whole) * turn + length
    cut = _met(root, (some.left - whole) * turn + length, length, 0.0)
    left = np.where(corner.right_of_left[goes] < -GRAZING, cut, 0.0)
    right = _met(root, (some.right - whole) * turn + length, length, 0.0)
    # What ends in the last vertex still does, without rounding.
    right = np.where(some.right == whole, length, right)
    other = Windows(sides.over[side], root, left, right, some.way, some.number, number[goes])
    behind_other = length - whole * turn
    return (
        Windows.joined([one, other]),
        np.concatenate([behind_one, behind_other]),
        np.concatenate([one.left, other.right]),
    )


def _met(root: Complex, through: Complex, length: Array, parallel: Array | float) -> Array:
    """Return where rays from roots through points meet the real axis, from 0 to a length."""
    rise = through.imag - root.imag
    part = np.divide(-root.imag, rise, out=np.zeros_like(rise), where=rise > 0.0)
    met = root.real + (through.real - root.real) * part
    return np.clip(np.where(rise > 0.0, met, parallel), 0.0, length)


def may_be_shortest(
    sides: Sides,
    windows: Windows,
    known: Array,
    room: float,
    behind: Complex | None,
    near: Array | None,
) -> Bools:
    """Return the windows in which no known path is shorter throughout than the windows' own.

    A path by a vertex of the side to the farther end of a window, or by the corner behind to the
    nearer one, is beside all paths to the window or cuts them. If it is shorter than the window's
    own path to that end, it is a shorter way to all of the window.

    Parameters
    ----------
    sides : Sides
    windows : Windows
    known : ndarray, shape (n,)
        Lengths of paths to the vertices.
    room : float
        What is longer by this may be as short.
    behind, near : ndarray or None
        As `unfolded` returns them.
    """
    first, last = known[sides.first[windows.side]], known[sides.last[windows.side]]
    to_left = windows.way + np.abs(windows.root - windows.left)
    to_right = windows.way + np.abs(windows.root - windows.right)
    useful = to_right <= first + windows.right + room
    useful &= to_left <= last + sides.length[windows.side] - windows.left + room
    if behind is not None and near is not None:
        third = known[sides.first[before(sides.over[windows.side])]]
        way = windows.way + np.abs(windows.root - near)
        useful &= way <= third + np.abs(behind - near) + room
    return np.asarray(useful)
