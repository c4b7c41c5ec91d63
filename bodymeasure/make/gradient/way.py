"""How a point of a geodesic moves with the skin and with the geodesic's ends."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple, Self

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.bezier import derivatives
from bodymeasure.geodesic import AtlasPath
from bodymeasure.make.gradient.chain import COARSE, FINE
from bodymeasure.make.gradient.pull import Pull

Weigh = Callable[[Array, int], Array]

# The steps of a whole way, about, and the least of a part of it. They are nearly equal: a chain is
# not quite as long wherever its nodes lie, and the less so the more unequal its steps are.
STEPS, LEAST = 512, 4
# A seam is where a node lies on the side of its patch.
ON_SIDE = 1e-9
# A way that meets a seam at a smaller angle runs along it.
TINY = 1e-6


@dataclass(frozen=True, eq=False)
class Way:
    """A geodesic as a chain of nodes, one of which is the point that is looked for.

    Where the way crosses a seam, its node lies on two patches: that which the way leaves, `before`,
    and that which it enters. Anywhere else, both are the same.

    Parameters
    ----------
    patch, before_patch : ndarray of int, shape (n,)
    parameters, before_parameters : ndarray, shape (n, 2)
    velocity, before_velocity : ndarray, shape (n, 3)
        The derivative of the position by the fraction run of the piece.
    aside, before_aside : ndarray, shape (n, 2)
        The direction in parameters square to the way, of length 1 on the surface.
    seam : ndarray, shape (n, 2)
        The direction of the seam in parameters of `patch`, where one is crossed; else 0.
    held : ndarray of bool, shape (n,)
        The nodes at corners of patches, which stay where they are.
    positions : ndarray, shape (n, 3)
    node : int
        The node of the point.
    piece : ndarray of int, shape (n,)
        The piece of the path that each node lies on.
    time : ndarray, shape (n,)
        The fraction run of it.
    coarse : ndarray of bool, shape (n,)
        Every other node, that of the point among them.
    """

    patch: Ints
    before_patch: Ints
    parameters: Array
    before_parameters: Array
    velocity: Array
    before_velocity: Array
    aside: Array
    before_aside: Array
    seam: Array
    held: Bools
    positions: Array
    node: int
    piece: Ints
    time: Array
    coarse: Bools

    @property
    def tangent(self) -> Array:
        """The unit tangent of the way at the point."""
        velocity = self.velocity[self.node]
        return np.asarray(velocity / np.linalg.norm(velocity))


def way_to(path: AtlasPath, number: int, fraction: float) -> Way:
    """Return a path as a way to the point at a fraction of one of its pieces."""
    parts, owner, run, coarse = [], [], [], []
    node, total, starts = 0, 0, []
    whole = sum(piece.length for piece in path.pieces)
    pieces = [k for k, piece in enumerate(path.pieces) if piece.length > 0.0]
    for k in pieces:
        piece = path.pieces[k]
        cuts = [0.0, fraction, 1.0] if k == number and 0.0 < fraction < 1.0 else [0.0, 1.0]
        stretches = list(pairwise(cuts))
        steps = [_even(STEPS * (high - low) * piece.length / whole) for low, high in stretches]
        times = [
            low + (high - low) * np.arange(count) / count
            for (low, high), count in zip(stretches, steps, strict=True)
        ]
        if k == number:
            node = total + (steps[0] if fraction > 0.0 else 0)
        own = np.concatenate([*times, [1.0]])
        parts.append(_on_piece(path, k, own))
        owner.append(np.full(len(own) - 1, k))
        run.append(own[:-1])
        coarse.append(np.arange(len(own) - 1) % 2 == 0)
        starts.append(total)
        total += len(own) - 1
    after = [
        np.concatenate([*(part[i][:-1] for part in parts), parts[-1][i][-1:]]) for i in range(5)
    ]
    before = [array.copy() for array in after]
    for part, start in zip(parts[:-1], starts[1:], strict=True):
        for array, values in zip(before, part, strict=True):
            array[start] = values[-1]
    patch, parameters, velocity, aside, positions = after
    seam, held = np.zeros_like(parameters), np.zeros(len(patch), dtype=np.bool_)
    for start in starts[1:]:
        side = np.minimum(parameters[start], 1.0 - parameters[start]) < ON_SIDE
        seam[start] = np.where(side, 0.0, 1.0)
        held[start] = side.all() or not side.any()
    return Way(
        patch,
        before[0],
        parameters,
        before[1],
        velocity,
        before[2],
        aside,
        before[3],
        seam,
        held,
        positions,
        node,
        np.append(np.concatenate(owner), pieces[-1]),
        np.append(np.concatenate(run), 1.0),
        np.append(np.concatenate(coarse), True),
    )


def _on_piece(
    path: AtlasPath, number: int, times: Array
) -> tuple[Ints, Array, Array, Array, Array]:
    """Return patch, parameters, velocity, direction square to the path, and positions."""
    piece = path.pieces[number]
    at, along = piece.space.matrices(times)[:2] @ piece.values.T
    at = np.clip(at, 0.0, 1.0)
    jet = derivatives(path.atlas.control_points[piece.patch], at, order=1)
    velocity = along[:, :1] * jet[:, 1, 0] + along[:, 1:] * jet[:, 0, 1]
    patch = np.full(len(times), piece.patch)
    return patch, at, velocity, _across(jet, along), jet[:, 0, 0]


def _even(steps: float) -> int:
    return max(2 * round(0.5 * steps), LEAST)


def _across(jet: Array, along: Array) -> Array:
    """Return directions in parameters that are square to others on the surface, of length 1."""
    by_u, by_v = jet[:, 1, 0], jet[:, 0, 1]
    e, f, g = ((a * b).sum(axis=1) for a, b in ((by_u, by_u), (by_u, by_v), (by_v, by_v)))
    across = np.stack(
        [-(f * along[:, 0] + g * along[:, 1]), e * along[:, 0] + f * along[:, 1]], axis=1
    )
    moved = across[:, :1] * by_u + across[:, 1:] * by_v
    return np.asarray(across / np.linalg.norm(moved, axis=1, keepdims=True))


def pull_way(pull: Pull, way: Way, weigh: Weigh, names: tuple[str, str]) -> None:
    """Add the derivatives of what depends on the nodes of a way.

    Parameters
    ----------
    pull : Pull
    way : Way
    weigh : callable
        Gives the derivative with respect to the position of each node of a chain, (n, 3), from
        the positions of its nodes and the number of the point among them.
    names : (str, str)
        The landmarks at the ends.

    Notes
    -----
    Each inner node slides to where the chain bends neither way: a system of equations with one
    unknown for a node, which is linear to first order and is solved backwards. The derivative of
    the chain of double steps shows what the finer one lacks.
    """
    for rows, factor in (
        (np.arange(len(way.patch)), FINE),
        (np.flatnonzero(way.coarse), COARSE),
    ):
        node = int(np.searchsorted(rows, way.node))
        weights = factor * weigh(way.positions[rows], node)
        _pull_chain(pull, way, rows, weights, names)


def _pull_chain(pull: Pull, way: Way, rows: Ints, weights: Array, names: tuple[str, str]) -> None:
    points = way.positions[rows]
    inner = np.arange(1, len(rows) - 1)
    numbers = rows[inner]
    steps = np.diff(points, axis=0)
    size = np.linalg.norm(steps, axis=1)
    chord = steps / size[:, None]
    # How the direction of a chord turns with either end.
    turn = (np.eye(3) - chord[:, :, None] * chord[:, None, :]) / size[:, None, None]
    one = _Side.of(pull, way.before_patch, way.before_parameters, way.before_aside, numbers)
    two = _Side.of(pull, way.patch, way.parameters, way.aside, numbers)
    seam = _Side.of(pull, way.patch, way.parameters, way.seam, numbers)
    into, out_of = (
        velocity[numbers] / np.linalg.norm(velocity[numbers], axis=1, keepdims=True)
        for velocity in (way.before_velocity, way.velocity)
    )
    crosses = np.asarray(way.seam[numbers].any(axis=1))
    # A node on a seam slides along it by 1 / sine for each unit by which the way moves aside.
    sine = np.where(crosses, (seam.slide * two.slide).sum(axis=1), 1.0)
    held = np.asarray(way.held[numbers] | (np.abs(sine) < TINY))
    sine = np.where(held, 1.0, sine)
    moved = np.where(crosses[:, None], seam.slide / sine[:, None], two.slide)
    # Either side has half of the bend of a smooth way, and a kink has its own part.
    first, last = chord[:-1] - into, out_of - chord[1:]
    kink = np.where(crosses[:, None], into - out_of, 0.0)
    diagonal = np.einsum("ni,nij,nj->n", one.slide, turn[:-1], one.slide)
    diagonal += np.einsum("ni,nij,nj->n", two.slide, turn[1:], two.slide)
    diagonal += (first * one.curl).sum(axis=1) + (last * two.curl).sum(axis=1)
    diagonal += (kink * seam.curl).sum(axis=1) / sine**2
    beside = -np.einsum("ni,nij,nj->n", two.slide[:-1], turn[1:-1], one.slide[1:])
    beside[held[:-1] | held[1:]] = 0.0
    diagonal[held] = 1.0
    bands = np.zeros((3, len(inner)))
    bands[0, 1:], bands[1], bands[2, :-1] = beside, diagonal, beside
    wanted = np.where(held, 0.0, (moved * weights[inner]).sum(axis=1))
    lever = -scipy.linalg.solve_banded((1, 1), bands, wanted)[:, None]
    total = weights.copy()
    for near, far, side in ((turn[:-1], inner - 1, one), (turn[1:], inner + 1, two)):
        force = np.einsum("nij,nj->ni", near, lever * side.slide)
        total[inner] += force
        total[far] -= force
    pull.at(names[0], total[0])
    pull.at(names[1], total[-1])
    pull.skin(two.patch, two.parameters, total[inner])
    for side, force in ((one, first), (two, last), (seam, kink / sine[:, None])):
        for axis, order in enumerate(((1, 0), (0, 1))):
            part = side.direction[:, axis, None] * lever * force
            pull.skin(side.patch, side.parameters, part, order)


class _Side(NamedTuple):
    """Directions on one of the patches that nodes lie on.

    Parameters
    ----------
    patch : ndarray of int, shape (n,)
    parameters : ndarray, shape (n, 2)
    direction : ndarray, shape (n, 2)
        In parameters.
    slide, curl : ndarray, shape (n, 3)
        The first and second derivative of the position in that direction.
    """

    patch: Ints
    parameters: Array
    direction: Array
    slide: Array
    curl: Array

    @classmethod
    def of(cls, pull: Pull, patch: Ints, parameters: Array, direction: Array, rows: Ints) -> Self:
        """Return the directions at some nodes."""
        patch, parameters, direction = patch[rows], parameters[rows], direction[rows]
        jet = derivatives(pull.atlas.control_points[patch], parameters[:, None], order=2)[:, 0]
        u, v = direction[:, :1], direction[:, 1:]
        slide = u * jet[:, 1, 0] + v * jet[:, 0, 1]
        curl = u**2 * jet[:, 2, 0] + 2.0 * u * v * jet[:, 1, 1] + v**2 * jet[:, 0, 2]
        return cls(patch, parameters, direction, slide, curl)
