"""Surfaces with known lengths that are cut into atlases of several patches."""

from collections.abc import Sequence

import numpy as np
from helpers.surfaces.grids import grid_index
from helpers.surfaces.surfaces import PH_CYLINDER

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint, Unit
from bodymeasure.bezier import bernstein, evaluate, restrict


def cut(net: Array, us: Sequence[float], vs: Sequence[float], *, turn: bool = True) -> Atlas:
    """One patch that is cut along parameter lines; every other part is turned around.

    Patches are numbered row by row; u runs along the rows.
    """
    u, v = np.array([0.0, *us, 1.0]), np.array([0.0, *vs, 1.0])
    rows, columns = len(u) - 1, len(v) - 1
    lattice = np.empty((3 * rows + 1, 3 * columns + 1, 3))
    for i in range(rows):
        for j in range(columns):
            part = restrict(net, (u[i], v[j]), (u[i + 1], v[j + 1]))
            lattice[3 * i : 3 * i + 4, 3 * j : 3 * j + 4] = part
    index = grid_index(rows, columns)
    if turn:
        index[1::2] = np.rot90(index[1::2], axes=(1, 2))
        index[2::3] = index[2::3].transpose(0, 2, 1)
    return Atlas(lattice.reshape(-1, 3), index, Unit.CM)


def on_cut(cuts: Sequence[Sequence[float]], uv: Sequence[float]) -> AtlasPoint:
    """A point of the whole patch, on an atlas that is cut without turns."""
    place, number = [], []
    for value, lines in zip(uv, cuts, strict=True):
        bounds = np.array([0.0, *lines, 1.0])
        part = int(np.clip(np.searchsorted(bounds, value, side="right") - 1, 0, len(lines)))
        number.append(part)
        place.append((value - bounds[part]) / (bounds[part + 1] - bounds[part]))
    return AtlasPoint(number[0] * (len(cuts[1]) + 1) + number[1], place[0], place[1])


def slant_cut(net: Array, rng: np.random.Generator) -> tuple[Atlas, Array]:
    """One patch of total degree 3 in u and v cut into nine along lines that are slanted in (u, v).

    The seams are curves that meet at kinks. Such a surface over a bilinearly parametrized
    quadrilateral is bicubic. Return also (u, v) of each part's corners, shape (9, 2, 2, 2).
    """
    thirds = np.arange(4) / 3
    grid = np.stack(np.meshgrid(thirds, thirds, indexing="ij"), axis=-1)
    moves = rng.uniform(-0.1, 0.1, grid.shape)
    # Points on the patch's edges stay on them.
    grid += np.where((grid > 0.0) & (grid < 1.0), moves, 0.0)
    from_values = np.linalg.inv(bernstein(3, thirds)[:, 0])
    lattice, corners = np.empty((10, 10, 3)), np.empty((9, 2, 2, 2))
    for i in range(3):
        for j in range(3):
            part = corners[3 * i + j] = grid[i : i + 2, j : j + 2]
            values = evaluate(net, on_part(part, *np.meshgrid(thirds, thirds, indexing="ij")))
            lattice[3 * i : 3 * i + 4, 3 * j : 3 * j + 4] = np.einsum(
                "ai,bj,ijc->abc", from_values, from_values, values
            )
    return Atlas(lattice.reshape(-1, 3), grid_index(3, 3), Unit.CM), corners


def on_part(corners: Array, u: Array | float, v: Array | float) -> Array:
    """The (u, v) on the whole patch of points of a part, given its corners, shape (2, 2, 2)."""
    us, vs = (np.stack([1.0 - np.asarray(w), np.asarray(w)]) for w in (u, v))
    return np.asarray(np.einsum("i...,j...,ijc->...c", us, vs, corners))


def corner_of(atlas: Atlas, position: Sequence[float]) -> AtlasPoint:
    """The patch corner at a position."""
    corners = atlas.control_points[:, ::3, ::3]
    apart = np.linalg.norm(corners - np.array(position), axis=-1)
    patch, i, j = np.unravel_index(np.argmin(apart), apart.shape)
    assert apart.min() < 1e-12
    return AtlasPoint(int(patch), float(i), float(j))


def wavy_plane(rng: np.random.Generator, side: int = 3) -> Atlas:
    """The square [0, side]^2 as side x side patches with curved seams that meet at kinks."""
    grid = np.arange(3 * side + 1) / 3
    lattice = np.stack([*np.meshgrid(grid, grid, indexing="ij"), np.zeros((len(grid),) * 2)], -1)
    lattice[1:-1, 1:-1, :2] += rng.uniform(-0.12, 0.12, (len(grid) - 2, len(grid) - 2, 2))
    return Atlas(lattice.reshape(-1, 3), grid_index(side, side), Unit.CM)


def wavy_cylinder(rng: np.random.Generator) -> tuple[Atlas, float]:
    """`PH_CYLINDER` as nine patches whose seams run up and down, and its height."""
    cylinder = cut(PH_CYLINDER, (0.3, 0.65), (1 / 3, 2 / 3), turn=False)
    points = cylinder.points.reshape(10, 10, 3).copy()
    points[1:-1, 1:-1, 2] += rng.uniform(-0.12, 0.12, (8, 8))
    return Atlas(points.reshape(-1, 3), cylinder.index, Unit.CM), 3.0


def random_point(rng: np.random.Generator, atlas: Atlas) -> AtlasPoint:
    """A random point anywhere on an atlas."""
    return AtlasPoint(int(rng.integers(len(atlas))), *rng.random(2).tolist())
