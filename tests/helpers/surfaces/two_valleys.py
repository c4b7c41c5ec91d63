"""Surfaces with two valleys (upside down, two legs) and a known saddle between them."""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from helpers.surfaces.grids import grid_index

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, Unit


class Knot(NamedTuple):
    """A point of a profile: its abscissa, its height, and the slopes before and after it."""

    at: float
    height: float
    before: float
    after: float


def smooth(at: float, height: float, slope: float = 0.0) -> Knot:
    return Knot(at, height, slope, slope)


def cubics(knots: Sequence[Knot]) -> Array:
    """Bernstein coefficients of the cubics between knots, shape (knots - 1, 4)."""
    rows = []
    for start, stop in pairwise(knots):
        third = (stop.at - start.at) / 3.0
        rows.append(
            [
                start.height,
                start.height + third * start.after,
                stop.height - third * stop.before,
                stop.height,
            ]
        )
    return np.array(rows)


def valleys(across: Sequence[Knot], along: Sequence[Knot]) -> Atlas:
    """The surface z = f(x) + g(y); its regions are the legs to the left and to the right of 0."""
    xs, ys = (np.array([knot.at for knot in knots]) for knots in (across, along))
    f, g = cubics(across), cubics(along)
    rows, columns = len(f), len(g)
    lattice = np.empty((3 * rows + 1, 3 * columns + 1, 3))
    steps = np.arange(4) / 3.0
    for i in range(rows):
        for j in range(columns):
            part = lattice[3 * i : 3 * i + 4, 3 * j : 3 * j + 4]
            part[..., 0] = (xs[i] + steps * (xs[i + 1] - xs[i]))[:, None]
            part[..., 1] = ys[j] + steps * (ys[j + 1] - ys[j])
            part[..., 2] = f[i][:, None] + g[j]
    sides = ["leg left" if xs[i] + xs[i + 1] > 0.0 else "leg right" for i in range(rows)]
    return Atlas(
        lattice.reshape(-1, 3),
        grid_index(rows, columns),
        Unit.CM,
        regions=tuple(side for side in sides for _ in range(columns)),
    )
