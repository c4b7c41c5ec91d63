"""The search for the shortest path over a mesh between two places."""

import numpy as np

from bodymeasure._typing import Array, Complex, Ints
from bodymeasure.errors import ConvergenceError
from bodymeasure.mesh.exact.places import MeshPoint
from bodymeasure.mesh.exact.roots import Arrivals, arrived, from_place, from_vertices
from bodymeasure.mesh.exact.sides import Sides, after, before
from bodymeasure.mesh.exact.windows import ROUNDED, Windows, look, may_be_shortest, unfolded

# The windows that are unfolded at once, those with the least bound on their paths first: enough
# that the calls of numpy cost less than their work, and few enough that most come in their order.
BATCH = 2048
# The most windows that are unfolded, of 64 bytes each, in some 2 microseconds. A path over all of a
# body of 50,000 triangles takes 800,000, and their number grows with the power 1.5 of theirs.
MOST_WINDOWS = 10_000_000
# The part of the coordinates by which the places of the ends are rounded.
ROUND_OFF = 1e-15


class Search:
    """The search for the shortest path from one place to another.

    It is that of J. Chen and Y. Han, "Shortest paths on a polyhedron", Int. J. Comput. Geom. Appl.
    6 (1996), with the filter of S. Xin and G. Wang, "Improving Chen and Han's algorithm on the
    discrete geodesic problem", ACM Trans. Graph. 28 (2009), and in batches as X. Ying, S. Xin and
    Y. He, "Parallel Chen-Han (PCH) algorithm for discrete geodesics", ACM Trans. Graph. 33 (2014).
    Windows whose paths are longer than the shortest known one, with the straight line to the end
    through the air, are left out.

    Parameters
    ----------
    sides : Sides
    start, end : MeshPoint
        Places on different faces.
    along : ndarray, shape (n,)
        Lengths of some paths from the start to the vertices, such as those along edges.

    Attributes
    ----------
    shortest : float
        The length of the shortest path that is known.
    last : tuple of int or None
        The root of the last leg of that path, and the last window that it crosses; None until legs
        to the end are found.
    roots, windows : list of Arrivals and of Windows
        Those that legs went on from, in the order of their numbers.
    """

    def __init__(self, sides: Sides, start: MeshPoint, end: MeshPoint, along: Array) -> None:
        mesh = sides.mesh
        self.sides, self.start, self.end = sides, start, end
        self.goal = end.position(mesh)
        # The distances of vertices from the end through the air, and of the corners of its face.
        self.air = np.linalg.norm(mesh.vertices - self.goal, axis=1)
        self.corners = mesh.faces[end.face]
        side = 3 * end.face + np.arange(3)
        # Where the end lies, in the frames of its face's sides.
        self.goals = (
            end.weights[after(side) % 3] * sides.length[side]
            + end.weights[before(side) % 3] * sides.third[side]
        )
        # Lengths of paths to the vertices, and of those that end in a leg which was found.
        self.known = along.copy()
        self.reached = np.full(len(along), np.inf)
        self.shortest = float((along + self.air)[self.corners].min())
        self.last: tuple[int, int] | None = None
        # A path that is longer by this may be as short, but for rounding.
        self.room = ROUNDED * self.shortest + ROUND_OFF * float(np.abs(mesh.vertices).max())
        self.roots: list[Arrivals] = []
        self.root_vertex = np.empty(0, np.int64)
        self.windows: list[Windows] = []
        self.unfolded = 0
        self.queue: list[tuple[Array, Windows]] = []

    def run(self) -> None:
        """Find the shortest path.

        Raises
        ------
        ConvergenceError
            If the budget is spent before.
        """
        one, none = np.zeros(1), np.full(1, -1)
        vertex = self.start.vertex(self.sides.mesh)
        begin = Arrivals(np.array([vertex]), one, none, one, none, none)
        if vertex >= 0:
            self._turn(begin)
        else:
            self._number(begin)
            windows, arrivals = from_place(self.sides, self.start)
            self._put(windows)
            self._turn(arrivals)
        while self.queue:
            self._unfold(self._next())
            if self.unfolded > MOST_WINDOWS:
                break
        if self.queue or self.last is None:
            raise ConvergenceError(
                f"the path over the mesh is not known to be the shortest after {self.unfolded} "
                f"windows on {len(self.sides.mesh.faces)} triangles; measure a coarser mesh, or "
                "lead the path through places on its way (via)"
            )

    def _number(self, arrivals: Arrivals) -> Ints:
        """Make arrivals roots, and return their numbers."""
        numbers = len(self.root_vertex) + np.arange(len(arrivals.vertex))
        self.roots.append(arrivals)
        self.root_vertex = np.concatenate([self.root_vertex, arrivals.vertex])
        return numbers

    def _next(self) -> Windows:
        """Take the windows with the least bounds from the queue, and drop what is too long."""
        keys = np.concatenate([key for key, _ in self.queue])
        windows = Windows.joined([each for _, each in self.queue])
        vertex = self.root_vertex[windows.number]
        # A shorter path to the root may have been found since.
        live = (vertex < 0) | (windows.way <= self.reached[vertex] + self.room)
        live &= keys <= self.shortest + self.room
        keys, windows = keys[live], windows.take(live)
        if len(keys) <= BATCH:
            self.queue = []
            return windows
        order = np.argpartition(keys, BATCH)
        first, rest = order[:BATCH], order[BATCH:]
        self.queue = [(keys[rest], windows.take(rest))]
        return windows.take(first)

    def _unfold(self, batch: Windows) -> None:
        """Go on with windows into the faces that they enter."""
        number = self.unfolded + np.arange(len(batch.side))
        self.windows.append(batch)
        self.unfolded += len(number)
        there = np.flatnonzero(batch.side // 3 == self.end.face)
        if len(there):
            some = batch.take(there)
            goal = look(some, self.goals[some.side % 3])
            way = np.where(goal.seen, some.way + goal.distance, np.inf)
            self._found(way, some.number, number[there])
        corner = look(batch, self.sides.third[batch.side])
        self._turn(arrived(self.sides, batch, corner, number))
        windows, behind, near = unfolded(self.sides, batch, corner, number)
        self._put(windows, behind, near)

    def _found(self, way: Array, root: Ints, window: Ints) -> None:
        """Note the shortest of some paths, if no other is shorter."""
        best = int(np.argmin(way))
        if way[best] < self.shortest + (self.room if self.last is None else 0.0):
            self.shortest = min(float(way[best]), self.shortest)
            self.last = int(root[best]), int(window[best])

    def _turn(self, arrivals: Arrivals) -> None:
        """Note the legs that lead to vertices, and go on about them."""
        while len(arrivals.vertex):
            at, way = arrivals.vertex, arrivals.way
            # Legs that are no shorter than others to the same vertex are not worth going on with.
            useful = way < self.reached[at] - 0.1 * self.room
            useful &= way <= self.known[at] + self.room
            useful &= way + self.air[at] <= self.shortest + self.room
            arrivals = arrivals.take(useful)
            arrivals = arrivals.take(np.lexsort((arrivals.way, arrivals.vertex)))
            arrivals = arrivals.take(np.diff(arrivals.vertex, prepend=-1) > 0)
            at, way = arrivals.vertex, arrivals.way
            self.reached[at] = way
            self.known[at] = np.minimum(self.known[at], way)
            numbers = self._number(arrivals)
            there = np.flatnonzero(np.isin(at, self.corners))
            if len(there):
                whole = way[there] + self.air[at[there]]
                self._found(whole, numbers[there], np.full(len(there), -1))
            windows, arrivals = from_vertices(self.sides, arrivals, numbers)
            self._put(windows)

    def _put(
        self, windows: Windows, behind: Complex | None = None, near: Array | None = None
    ) -> None:
        """Queue the windows through which the shortest path may lead."""
        sides, mesh = self.sides, self.sides.mesh
        useful = may_be_shortest(sides, windows, self.known, self.room, behind, near)
        windows = windows.take(useful)
        first = mesh.vertices[sides.first[windows.side]]
        along = mesh.vertices[sides.last[windows.side]] - first
        along /= sides.length[windows.side][:, None]
        off = self.goal - first
        foot = np.clip((off * along).sum(axis=1), windows.left, windows.right)
        key = windows.least + np.linalg.norm(off - foot[:, None] * along, axis=1)
        live = key <= self.shortest + self.room
        if live.any():
            self.queue.append((key[live], windows.take(live)))
