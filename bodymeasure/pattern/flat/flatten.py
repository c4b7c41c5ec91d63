"""A piece laid flat: its border keeps its lengths, its fold and the legs of darts are straight."""

from dataclasses import dataclass

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.pattern.flat.conformal import flat_conformally
from bodymeasure.pattern.flat.constraints import Constraints
from bodymeasure.pattern.flat.energy import Energy, Stretch
from bodymeasure.pattern.flat.level_line import LevelLine
from bodymeasure.pattern.flat.mesh import Chain, PieceMesh
from bodymeasure.pattern.flat.newton import Goal, Stationary, stationary

# Lengths as parts of the piece's size: rounding, at which the last layout ends, and a tenth of a
# per mill, at which those on the way do.
EXACT, ROUGH = 1e-14, 1e-4
# The last step, as parts of the same size.
LAST_STEP, ROUGH_STEP = 1e-9, 1e-3
# Newton's steps for the last layout, and for those on the way.
MOST_STEPS, FEW_STEPS = 60, 12
# Parts of the way from a free fold and free legs to straight ones, at first and at least.
FIRST_PART, LEAST_PART = 0.5, 1.0 / 64.0
# A linear equation: the columns of its coordinates, and their weights.
_Row = tuple[list[int], list[float]]


@dataclass(frozen=True, eq=False)
class Flat:
    """A piece laid flat.

    Parameters
    ----------
    mesh : PieceMesh
    positions : ndarray, shape (n, 2)
        In the atlas's unit.
    missed : float
        The most by which the length of a side on the border differs from that on the skin.
    converged : bool
    steps : int
        Newton's steps, all together.
    """

    mesh: PieceMesh
    positions: Array
    missed: float
    converged: bool
    steps: int

    @property
    def stretch(self) -> Stretch:
        """The deformation of the triangles."""
        return Stretch(self.mesh.triangles, self.mesh.sides)


def flattened(
    mesh: PieceMesh,
    *,
    fold: int | None = None,
    downwards: bool = False,
    straight: tuple[bool, ...] = (),
    lines: tuple[LevelLine, ...] = (),
) -> Flat:
    """Lay a piece flat.

    Parameters
    ----------
    mesh : PieceMesh
    fold : int, optional
        The edge that becomes straight, on the second axis.
    downwards : bool
        Whether that edge runs down the axis, counterclockwise round the piece.
    straight : tuple of bool
        Whether the legs of each dart become straight.
    lines : tuple of LevelLine
        Lines inside of it that keep their lengths.
    """
    border = _border(mesh)
    start = flat_conformally(mesh.triangles, mesh.sides, border)
    stretch = Stretch(mesh.triangles, mesh.sides)
    energy = Energy(stretch, _smooth_chains(mesh), len(start))
    if stretch.flipped(start).any():
        start = _repaired(mesh, border, stretch, start)
    task = _Task(mesh, fold, downwards, straight, lines)
    size = float(np.ptp(start, axis=0).max())
    rough = Goal(ROUGH * size, ROUGH_STEP * size, FEW_STEPS)
    exact = Goal(EXACT * size, LAST_STEP * size, MOST_STEPS)
    if fold is None and not any(straight):
        return _result(mesh, stationary(energy, task.free(start), start, exact), exact, 0)
    free = stationary(energy, task.free(start), start, rough)
    flat, steps = task.upright(free.flat), free.steps
    shape = task.deviations(flat)
    done, part = 0.0, FIRST_PART
    while True:
        part = min(part, 1.0 - done)
        left = 1.0 - done - part
        found = stationary(energy, task.towards(shape, left, flat), flat, rough)
        steps += found.steps
        reached = found.missed <= rough.missed
        if left == 0.0:
            # From near the end anew, with sides under tension only; from elsewhere it goes on.
            last = stationary(
                energy,
                task.towards(shape, 0.0, found.flat if reached else flat),
                found.flat,
                exact,
                None if reached else found.multipliers,
            )
            steps += last.steps
            if last.missed <= exact.missed or part <= LEAST_PART:
                return _result(mesh, last, exact, steps - last.steps)
            reached = False
        if reached or part <= LEAST_PART:
            flat, done = found.flat, done + part
            part *= 2.0
        else:
            part *= 0.5


def _result(mesh: PieceMesh, found: Stationary, goal: Goal, before: int) -> Flat:
    converged = found.missed <= 10.0 * goal.missed and found.step <= goal.step
    return Flat(mesh, found.flat, found.missed, converged, before + found.steps)


def _border(mesh: PieceMesh) -> Ints:
    """Return the vertices of the border counterclockwise, legs of darts included."""
    legs = {int(leg.before.vertices[0]): leg for leg in mesh.darts}
    parts = []
    for edge in mesh.edges:
        for number, chain in enumerate(edge):
            parts.append(chain.vertices[:-1])
            if number < len(edge) - 1:
                leg = legs[int(chain.vertices[-1])]
                parts += [leg.before.vertices[:-1], leg.after.vertices[:0:-1]]
    return np.concatenate(parts)


def _smooth_chains(mesh: PieceMesh) -> list[Ints]:
    legs = [chain for leg in mesh.darts for chain in (leg.before, leg.after)]
    return [chain.vertices for chain in (*mesh.chains, *legs)]


def _repaired(mesh: PieceMesh, border: Ints, stretch: Stretch, start: Array) -> Array:
    """Return a layout without flipped triangles: the border of one, filled with convex weights."""
    for outline in (start, mesh.start):
        filled = _filled(mesh.triangles, border, outline)
        if not stretch.flipped(filled).any():
            return filled
    return mesh.start


def _filled(triangles: Ints, border: Ints, flat: Array) -> Array:
    count = len(flat)
    pairs = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    both = np.concatenate([pairs, pairs[:, ::-1]])
    links = scipy.sparse.coo_array((np.ones(len(both)), both.T), shape=(count, count)).tocsr()
    laplacian = (scipy.sparse.diags_array(links.sum(axis=1)) - links).tocsr()
    inner = np.setdiff1d(np.arange(count), border)
    result = flat.copy()
    solve = scipy.sparse.linalg.splu(laplacian[inner][:, inner].tocsc()).solve
    result[inner] = solve(-(laplacian[inner][:, border] @ flat[border]))
    return result


class _Task:
    """The constraints of a piece, from a free border to a straight fold and straight legs."""

    def __init__(
        self,
        mesh: PieceMesh,
        fold: int | None,
        downwards: bool,
        straight: tuple[bool, ...],
        lines: tuple[LevelLine, ...],
    ) -> None:
        self.mesh, self.downwards, self.lines = mesh, downwards, lines
        self.fold = None if fold is None else mesh.edges[fold]
        self.legs = [
            chain
            for leg, is_straight in zip(mesh.darts, straight, strict=True)
            if is_straight
            for chain in (leg.before, leg.after)
        ]
        self.curved = [
            chain
            for leg, is_straight in zip(mesh.darts, straight, strict=True)
            if not is_straight
            for chain in (leg.before, leg.after)
        ]
        self.count = int(mesh.triangles.max()) + 1

    def free(self, flat: Array) -> Constraints:
        """Return the constraints that keep each side of the border, and the piece in its place."""
        chains = [*self.mesh.chains, *self.curved, *self.legs]
        first, last = self.mesh.edges[0][0].vertices[[0, -1]].tolist()
        way = flat[last] - flat[first]
        axis = int(np.argmin(np.abs(way)))
        fixed = [2 * first, 2 * first + 1, 2 * last + axis]
        return self._of(chains, [([index], [1.0]) for index in fixed], flat.ravel()[fixed])

    def upright(self, flat: Array) -> Array:
        """Return the layout turned so that the fold points up the second axis."""
        if self.fold is None:
            return flat
        start, stop = flat[self.fold[0].vertices[0]], flat[self.fold[-1].vertices[-1]]
        if self.downwards:
            start, stop = stop, start
        up = (stop - start) / np.linalg.norm(stop - start)
        return np.asarray((flat - start) @ np.array([[up[1], up[0]], [-up[0], up[1]]]))

    def _fold_targets(self) -> tuple[Ints, Array]:
        assert self.fold is not None
        vertices = np.concatenate(
            [self.fold[0].vertices[:1], *(chain.vertices[1:] for chain in self.fold)]
        )
        steps = np.concatenate([chain.steps for chain in self.fold])
        height = np.concatenate([[0.0], np.cumsum(steps)])
        if self.downwards:
            height = height[-1] - height
        return vertices, np.stack([np.zeros_like(height), height], axis=1)

    def deviations(self, flat: Array) -> list[Array]:
        """Return how far the fold and the legs are from straight: the fold, then each leg."""
        result = []
        if self.fold is not None:
            vertices, targets = self._fold_targets()
            result.append(flat[vertices] - targets)
        return [*result, *(self._in_frame(flat, leg) for leg in self.legs)]

    @staticmethod
    def _in_frame(flat: Array, leg: Chain) -> Array:
        """Return how far a leg's vertices are from its chord, in the frame of the chord."""
        foot, tip = flat[leg.vertices[0]], flat[leg.vertices[-1]]
        part = leg.parts[:, None]
        along = (tip - foot) / np.linalg.norm(tip - foot)
        frame = np.stack([along, [-along[1], along[0]]], axis=1)
        away = (flat[leg.vertices] - foot - part * (tip - foot)) @ frame
        # The last row, whose deviation is none, keeps by how much the chord is shorter.
        away[-1, 0] = leg.length - np.linalg.norm(tip - foot)
        return np.asarray(away)

    def towards(self, shape: list[Array], left: float, flat: Array) -> Constraints:
        """Return the constraints with a part of the deviations left."""
        shape = [*shape]
        chains = [chain for edge in self.mesh.edges for chain in edge if edge is not self.fold]
        chains += self.curved
        rows: list[_Row] = []
        right: list[float] = []
        if self.fold is not None:
            vertices, targets = self._fold_targets()
            for vertex, place in zip(
                vertices.tolist(), (targets + left * shape.pop(0)).tolist(), strict=True
            ):
                for axis in range(2):
                    rows.append(([2 * vertex + axis], [1.0]))
                    right.append(place[axis])
        else:
            first, last = self.mesh.edges[0][0].vertices[[0, -1]].tolist()
            axis = int(np.argmin(np.abs(flat[last] - flat[first])))
            for index in (2 * first, 2 * first + 1, 2 * last + axis):
                rows.append(([index], [1.0]))
                right.append(float(flat.ravel()[index]))
        pairs, lengths = [], []
        for leg, deviation in zip(self.legs, shape, strict=True):
            foot, tip = leg.vertices[[0, -1]].tolist()
            way = flat[tip] - flat[foot]
            along = way / np.linalg.norm(way)
            free_chord = leg.length - float(deviation[-1, 0])
            offset = left * deviation @ np.stack([along, [-along[1], along[0]]])
            inner = zip(leg.vertices[1:-1].tolist(), leg.parts[1:-1].tolist(), strict=True)
            for number, (vertex, part) in enumerate(inner, start=1):
                for axis in range(2):
                    columns = [2 * vertex + axis, 2 * foot + axis, 2 * tip + axis]
                    rows.append((columns, [1.0, part - 1.0, -part]))
                    right.append(float(offset[number, axis]))
            pairs.append((foot, tip))
            lengths.append(left * free_chord + (1.0 - left) * leg.length)
        return self._of(chains, rows, np.array(right), pairs, lengths)

    def _of(
        self,
        chains: list[Chain],
        rows: list[_Row],
        right: Array,
        pairs: list[tuple[int, int]] | None = None,
        lengths: list[float] | None = None,
    ) -> Constraints:
        every = [np.stack([c.vertices[:-1], c.vertices[1:]], axis=1) for c in chains]
        sizes = [chain.steps for chain in chains]
        every.append(np.array(pairs or [], dtype=np.int64).reshape(-1, 2))
        sizes.append(np.array(lengths or [], dtype=np.float64))
        row = np.repeat(np.arange(len(rows)), [len(columns) for columns, _ in rows])
        columns = np.concatenate([columns for columns, _ in rows])
        weights = np.concatenate([weights for _, weights in rows])
        linear = scipy.sparse.coo_array(
            (weights, (row, columns)), shape=(len(rows), 2 * self.count)
        ).tocsr()
        pairs_of, sizes_of = np.concatenate(every), np.concatenate(sizes)
        return Constraints(pairs_of, sizes_of, linear, right, self.lines)
