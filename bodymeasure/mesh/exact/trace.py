"""The points in which a shortest path crosses the sides of a mesh."""

from bisect import bisect_right

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.mesh.exact.roots import Arrivals
from bodymeasure.mesh.exact.search import Search
from bodymeasure.mesh.exact.sides import Sides, after, before
from bodymeasure.mesh.exact.windows import Windows


def traced(search: Search) -> Array:
    """Return the points of the path that a search has found, shape (k, 3)."""
    if search.last is None:
        raise ValueError("the search has found no path")
    sides, mesh, roots = search.sides, search.sides.mesh, Arrivals.joined(search.roots)
    begins = np.cumsum([0, *(len(each.side) for each in search.windows)])
    points = [search.goal]
    number, window = search.last
    first = True
    while number >= 0:
        chain = _chain(search.windows, begins.tolist(), window)
        if chain:
            # A leg ends in the place, or in the third corner of the last face that it enters.
            side = int(chain[0].side[0])
            end = complex(search.goals[side % 3] if first else sides.third[side])
            points += _crossings(sides, chain, end)
        vertex = int(roots.vertex[number])
        points.append(search.start.position(mesh) if vertex < 0 else mesh.vertices[vertex])
        window, number = int(roots.parent[number]), int(roots.number[number])
        first = False
    return np.array(points[::-1])


def _chain(windows: list[Windows], begins: list[int], window: int) -> list[Windows]:
    """Return the windows of a leg one by one, the last first."""
    chain = []
    while window >= 0:
        batch = bisect_right(begins, window) - 1
        chain.append(windows[batch].take(np.array([window - begins[batch]])))
        window = int(chain[-1].parent[0])
    return chain


def _crossings(sides: Sides, chain: list[Windows], to: complex) -> list[Array]:
    """Return the points in which a leg crosses the sides of its windows.

    Each follows from the one behind it in the frame of its own side, so that on thin faces, too,
    the legs' pieces lie in one line.
    """
    points = []
    behind = -1
    met = 0.0
    for window in chain:
        side, root = int(window.side[0]), complex(window.root[0])
        if behind >= 0:
            # The point behind, in the frame of this side.
            if int(sides.over[before(np.array(side))]) == behind:
                to = met * complex(sides.turn[side])
            else:
                turn = complex(sides.turn[after(np.array(side))])
                to = complex(sides.length[side] - (sides.length[behind] - met) * turn.conjugate())
        rise = to.imag - root.imag
        met = root.real - (to.real - root.real) * root.imag / rise if rise > 0.0 else to.real
        met = min(max(met, float(window.left[0])), float(window.right[0]))
        first, last = sides.mesh.vertices[[sides.first[side], sides.last[side]]]
        points.append(first + met / float(sides.length[side]) * (last - first))
        behind = side
    return points
