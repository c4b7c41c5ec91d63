"""Shortest polygons in patches, which find paths along edges without the library's solver.

A polygon has vertices (u, v) at equally spaced times, and chords in space. Its energy is minimized
in the box [0, 1]^2 by Newton steps with the exact Hessian, each of which goes to the minimum of the
quadratic model in the box. The chords are shorter than the path by a part that falls with the
square of their number, so that Richardson's extrapolation over several numbers gives the length and
its uncertainty.
"""

from typing import NamedTuple

import numpy as np
from scipy.linalg import LinAlgError, solveh_banded

from bodymeasure._typing import Array, Bools
from bodymeasure.bezier import derivatives, evaluate

EDGES = ("u = 0", "u = 1", "v = 0", "v = 1")
LEVELS = (128, 256, 512, 1024, 2048, 4096)
# The vertices begin this far inside the patch, so that the edges that hold them must be found.
INSET = 1e-3
MOST_STEPS = 300
# The most sets of held coordinates that are tried in each step.
MOST_SETS = 40
# A polygon is at rest when a step would lower its energy by less than this part.
REST = 1e-14
# Damping of the Hessian, in parts of the metric: its first value, the factors after a good and a
# bad step, and its least and greatest value.
DAMPING, LESS, MORE, LEAST, MOST = 1e-2, 0.1, 10.0, 1e-9, 1e10
# The factor by which errors of third order fall from level to level; and a factor of safety, since
# a single change may be small by chance.
FALL, SAFETY = 8.0, 2.0
# Rounding errors of a sum of thousands of chords, relative.
ROUNDING = 1e-13
# A step that raises the energy by less than this part is as good as one that does not raise it.
LEVEL = 1e-15


class Run(NamedTuple):
    """Part of an edge that holds a path, in the parameter along it, and how closely it is known."""

    edge: str
    start: float
    end: float
    spacing: float


class Polygons(NamedTuple):
    """Lengths by number of edges, extrapolated ones beside each but the first, and the finest.

    ``at_rest`` says whether every level came to rest.
    """

    lengths: Array
    extrapolated: Array
    finest: Array
    runs: tuple[Run, ...]
    at_rest: bool

    @property
    def length(self) -> float:
        return float(self.extrapolated[-1])

    @property
    def uncertainty(self) -> float:
        """The largest error that any change between extrapolations leaves, an eighth a level.

        The point at which a path joins an edge lies somewhere between two vertices, which leaves an
        irregular error of third order: the last two extrapolations may be close by chance.
        """
        moves = np.abs(np.diff(self.extrapolated))
        finer = np.arange(len(moves))[::-1]
        return float(SAFETY * (moves / FALL**finer).max() + ROUNDING * self.length)


def shortest_polygons(net: Array, points: Array) -> Polygons:
    """The shortest polygons on all levels, each found from the one before.

    Parameters
    ----------
    net : ndarray, shape (m + 1, n + 1, 3)
        Control points.
    points : ndarray, shape (LEVELS[0] + 1, 2)
        The vertices from which the coarsest polygon begins; the ends stay.
    """
    points = points.copy()
    points[1:-1] = np.clip(points[1:-1], INSET, 1.0 - INSET)
    lengths, at_rest = [], True
    for count in LEVELS:
        old, new = np.linspace(0.0, 1.0, len(points)), np.linspace(0.0, 1.0, count + 1)
        points = np.stack([np.interp(new, old, points[:, axis]) for axis in (0, 1)], axis=1)
        points, held, rest = _minimized(net, points)
        at_rest &= rest
        lengths.append(np.linalg.norm(np.diff(evaluate(net, points), axis=0), axis=1).sum())
    length = np.array(lengths)
    extrapolated = (4.0 * length[1:] - length[:-1]) / 3.0
    return Polygons(length, extrapolated, points, _runs(points, held), at_rest)


class _Energy(NamedTuple):
    """The energy of a polygon, its gradient (k, 2) and Hessian in bands, and the metric's diagonal.

    Derivatives are in the inner vertices.
    """

    energy: float
    gradient: Array
    bands: Array
    metric: Array


def _energy(net: Array, points: Array) -> float:
    chords = np.diff(evaluate(net, points), axis=0)
    return float(len(chords) * (chords * chords).sum())


def _expanded(net: Array, points: Array) -> _Energy:
    jet = derivatives(net, points, order=2)
    chords = np.diff(jet[:, 0, 0], axis=0)
    factor = 2.0 * len(chords)
    pull = chords[:-1] - chords[1:]
    tangents = np.stack([jet[1:-1, 1, 0], jet[1:-1, 0, 1]], axis=1)
    mixed = jet[1:-1, 1, 1]
    second = np.stack([jet[1:-1, 2, 0], mixed, mixed, jet[1:-1, 0, 2]], axis=1)
    metric = 2.0 * np.einsum("kix,kjx->kij", tangents, tangents)
    block = metric + np.einsum("kmx,kx->km", second, pull).reshape(-1, 2, 2)
    beside = -np.einsum("kix,kjx->kij", tangents[:-1], tangents[1:])
    size = 2 * len(tangents)
    bands = np.zeros((4, size))  # lower: bands[i - j, j]
    bands[0] = block[:, [0, 1], [0, 1]].ravel()
    bands[1, 0::2] = block[:, 1, 0]
    bands[1, 1:-1:2], bands[2, 0:-2:2] = beside[:, 1, 0], beside[:, 0, 0]
    bands[2, 1:-1:2], bands[3, 0:-2:2] = beside[:, 1, 1], beside[:, 0, 1]
    gradient = np.einsum("kix,kx->ki", tangents, pull)
    return _Energy(
        float(len(chords) * (chords * chords).sum()),
        factor * gradient,
        factor * bands,
        factor * metric[:, [0, 1], [0, 1]].ravel(),
    )


def _minimized(net: Array, points: Array) -> tuple[Array, Bools, bool]:
    """The polygon at rest, which coordinates of its inner vertices are held, and whether it is."""
    damping, here = DAMPING, _expanded(net, points)
    held = (points[1:-1] <= 0.0) | (points[1:-1] >= 1.0)
    for _ in range(MOST_STEPS):
        found = _step(here, points[1:-1].ravel(), held.ravel(), damping)
        if found is not None:
            step, held, foretold = found[0].reshape(-1, 2), found[1].reshape(-1, 2), found[2]
            trial = points.copy()
            trial[1:-1] = np.clip(points[1:-1] + step, 0.0, 1.0)
            if foretold < REST * here.energy and damping <= DAMPING:
                return trial, held, True
            if _energy(net, trial) <= here.energy * (1.0 + LEVEL):
                points, here = trial, _expanded(net, trial)
                damping = max(damping * LESS, LEAST)
                continue
        damping *= MORE
        if damping > MOST:
            break
    return points, held, False


def _step(
    here: _Energy, place: Array, held: Bools, damping: float
) -> tuple[Array, Bools, float] | None:
    """The minimum of the quadratic model in the box: the step, what is held, the decrease doubled.

    It is found by a primal-dual active set (M. Hintermueller, K. Ito, K. Kunisch, SIAM J. Optim. 13
    (2002) 865-888). Return None where the Hessian is not positive definite in the free coordinates.
    """
    bands, gradient = here.bands.copy(), here.gradient.ravel()
    bands[0] += damping * here.metric
    bound = np.where(place < 0.5, 0.0, 1.0)
    for _ in range(MOST_SETS):
        fixed = np.where(held, bound - place, 0.0)
        matrix = bands.copy()
        matrix[:, held] = 0.0
        for row in range(1, 4):
            matrix[row, :-row][held[row:]] = 0.0
        matrix[0, held] = 1.0
        right = np.where(held, fixed, -gradient - _product(bands, fixed))
        try:
            step = solveh_banded(matrix, right, lower=True)
        except LinAlgError:
            return None
        slope = gradient + _product(bands, step)
        pressed = held & (np.where(bound == 0.0, slope, -slope) > 0.0)
        beyond = ~held & ((place + step < 0.0) | (place + step > 1.0))
        bound = np.where(beyond, np.where(place + step < 0.0, 0.0, 1.0), bound)
        now = pressed | beyond
        if (now == held).all():
            break
        held = now
    return step, held, float(-2.0 * gradient @ step - step @ _product(bands, step))


def _product(bands: Array, vector: Array) -> Array:
    """The product of a symmetric matrix, given by its lower bands, with a vector."""
    result = bands[0] * vector
    for row in range(1, 4):
        result[row:] += bands[row, :-row] * vector[:-row]
        result[:-row] += bands[row, :-row] * vector[row:]
    return np.asarray(result)


def _runs(points: Array, held: Bools) -> tuple[Run, ...]:
    """The edges that hold a polygon, in order; an end belongs to the run that begins beside it."""
    found = []
    for number, name in enumerate(EDGES):
        axis, value = number // 2, float(number % 2)
        on = np.flatnonzero(held[:, axis] & (points[1:-1, axis] == value)) + 1
        for run in np.split(on, np.flatnonzero(np.diff(on) > 1) + 1):
            if len(run):
                first, last = int(run[0]), int(run[-1])
                first -= first == 1 and points[0, axis] == value
                last += last == len(points) - 2 and points[-1, axis] == value
                along = points[:, 1 - axis]
                around = along[max(first - 1, 0) : last + 2]
                spacing = float(np.abs(np.diff(around)).max())
                found.append((first, Run(name, float(along[first]), float(along[last]), spacing)))
    return tuple(run for _, run in sorted(found, key=lambda each: each[0]))
