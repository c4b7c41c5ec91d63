"""Patches that are folded, collapsed, stretched or crumpled, and pairs of points on them."""

from collections.abc import Callable

import numpy as np

from bodymeasure._typing import Array

GRID = np.linspace(0.0, 1.0, 4)
FLAT = np.stack(np.meshgrid(GRID, GRID, [0.0], indexing="ij"), axis=-1)[:, :, 0]

Spoil = Callable[[Array, np.random.Generator], Array]


def collapse_row(net: Array, rng: np.random.Generator) -> Array:
    net[rng.integers(4)] = net[rng.integers(4), rng.integers(4)]
    return net


def collapse_column(net: Array, rng: np.random.Generator) -> Array:
    net[:, rng.integers(4)] = net[rng.integers(4), rng.integers(4)]
    return net


def fold(net: Array, rng: np.random.Generator) -> Array:
    return net[rng.permutation(4)]


def stretch(net: Array, rng: np.random.Generator) -> Array:
    net[..., rng.integers(3)] *= 10.0 ** rng.integers(-9, 7)
    return net


def near_cusp(net: Array, rng: np.random.Generator) -> Array:
    net[1] = net[0] + 10.0 ** -float(rng.integers(1, 12)) * (net[1] - net[0])
    return net


def repeat_a_point(net: Array, rng: np.random.Generator) -> Array:
    i, j, k, m = rng.integers(0, 4, 4)
    net[i, j] = net[k, m]
    return net


def flatten(net: Array, rng: np.random.Generator) -> Array:
    net[..., rng.integers(3)] = 0.0
    return net


def move_away(net: Array, rng: np.random.Generator) -> Array:
    return net + 10.0 ** rng.integers(0, 8)


def throw_a_point(net: Array, rng: np.random.Generator) -> Array:
    net[rng.integers(4), rng.integers(4)] += 10.0 * rng.normal(size=3)
    return net


def crumple(net: Array, rng: np.random.Generator) -> Array:
    return net + 0.4 * rng.normal(size=net.shape)


SPOILS: list[Spoil] = [
    collapse_row,
    collapse_column,
    fold,
    stretch,
    near_cusp,
    repeat_a_point,
    flatten,
    move_away,
    throw_a_point,
    crumple,
]


def adversarial_patch(seed: int, spoils: list[Spoil], size: float) -> Array:
    rng = np.random.default_rng(seed)
    net = FLAT + size * rng.normal(size=FLAT.shape)
    for spoil in spoils:
        net = spoil(net, rng)
    return net


def random_ends(rng: np.random.Generator) -> Array:
    """Start and end, shape (2, 2): corners, edge points and inner points, some very close."""
    start, end = (_random_point(rng) for _ in range(2))
    match rng.integers(8):
        case 0:
            end = np.minimum(1.0, start + 10.0 ** -rng.uniform(1.0, 12.0) * rng.random(2))
        case 1:
            end[0] = start[0]
        case 2 if rng.random() < 0.3:
            end = start
    return np.array([start, end])


def _random_point(rng: np.random.Generator) -> Array:
    point = rng.random(2)
    # Each coordinate is on an edge half of the time, so that a quarter of the points are corners.
    on_edge = rng.random(2) < 0.5
    point[on_edge] = rng.integers(0, 2, 2)[on_edge]
    return point
