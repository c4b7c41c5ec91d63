"""Saddles of the height over an atlas: where horizontal loops merge."""

from collections.abc import Iterator, Sequence

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas import EDGES, Atlas, AtlasPoint, sides_of
from bodymeasure.atlas.seams import AXIS, parameters_on_sides
from bodymeasure.atlas.topology.neighbors import on_side
from bodymeasure.bezier import derivatives, project
from bodymeasure.geodesic.across.routes.topology import topology
from bodymeasure.section.places import roots_between

# Points along a side of each patch from which Newton's method starts.
STARTS = 5
# Steps along each seam that separate the places where it is level; a cubic has two.
SAMPLES = 16
STEPS = 30
# The last step in (u, v): Newton's error is squared by each step, so that only rounding is left.
REST = 1e-12
# How far outside its patch, in (u, v), rounding may put a stationary point.
OUTSIDE = 1e-9
# The sign of slopes below this part of the height's largest derivatives is rounding.
LEVEL = 1e-9
# Slopes whose coefficients all have one sign, beyond this part of the largest of all, vanish
# nowhere on the patch, nor where rounding puts a point of it outside.
NOWHERE = 1e-6
# Saddles closer together than this part of the atlas's size are one.
SAME = 1e-7


def saddles_between(atlas: Atlas, low: float, high: float, near: Array) -> list[AtlasPoint]:
    """Return the saddles of the height between two heights, the nearest to a position first.

    Parameters
    ----------
    atlas : Atlas
    low, high : float
        Heights along the atlas's way up.
    near : ndarray, shape (3,)

    Returns
    -------
    list of AtlasPoint
        Each saddle once. They lie inside patches or on seams; without any, corners of patches
        between the two heights are returned.
    """
    up = atlas.axes.up_vector
    heights = project(atlas.control_points) @ up
    inside = (heights.min(axis=(1, 2)) <= high) & (heights.max(axis=(1, 2)) >= low)
    patches = np.flatnonzero(inside)
    found = [*_in_patches(atlas, patches), *_on_seams(atlas, patches)]
    corners = [
        AtlasPoint(int(p), float(u), float(v)) for p in patches for u in (0, 1) for v in (0, 1)
    ]
    for candidates in (found, corners):
        positions = np.array([atlas.position(point) for point in candidates]).reshape(-1, 3)
        height = positions @ atlas.axes.up_vector
        rows = np.flatnonzero((height >= low) & (height <= high))
        rows = rows[np.argsort(np.linalg.norm(positions[rows] - near, axis=1), kind="stable")]
        # On a seam, each of its patches has the same saddle.
        apart = np.linalg.norm(positions[rows, None] - positions[rows], axis=-1)
        again = np.tril(apart <= SAME * float(np.abs(atlas.points).max()), -1).any(axis=1)
        if len(rows):
            return [candidates[row] for row in rows[~again]]
    return []


def _in_patches(atlas: Atlas, patches: Ints) -> Iterator[AtlasPoint]:
    """Yield the points in patches where the height has no gradient and an indefinite Hessian."""
    nets = _height_nets(atlas, patches)
    level = [_may_vanish(np.diff(nets, axis=axis).reshape(len(nets), -1)) for axis in (1, 2)]
    patches = patches[level[0] & level[1]]
    side = (np.arange(STARTS) + 0.5) / STARTS
    grid = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2)
    row = np.repeat(patches, len(grid))
    place = np.tile(grid, (len(patches), 1))
    busy = np.arange(len(row))
    for _ in range(STEPS):
        slope, bend = _slopes(atlas, row[busy], place[busy])
        determinant = bend[:, 0, 0] * bend[:, 1, 1] - bend[:, 0, 1] ** 2
        bend[determinant == 0.0] = np.eye(2)
        step = np.linalg.solve(bend, slope[..., None])[..., 0]
        # Steps are no longer than a patch's width, so that no search is lost for good.
        size = np.abs(step).max(axis=1)
        step *= np.minimum(1.0, 0.5 / np.maximum(size, 1e-300))[:, None]
        place[busy] = np.clip(place[busy] - step, -1.0, 2.0)
        busy = busy[size > REST]
    rests = np.ones(len(row), dtype=np.bool_)
    rests[busy] = False
    slope, bend = _slopes(atlas, row, place)
    rests &= ((place >= -OUTSIDE) & (place <= 1.0 + OUTSIDE)).all(axis=1)
    rests &= np.linalg.det(bend) < 0.0
    for number in np.flatnonzero(rests):
        u, v = np.clip(place[number], 0.0, 1.0).tolist()
        yield AtlasPoint(int(row[number]), u, v)


def _height_nets(atlas: Atlas, patches: Ints) -> Array:
    """Return the coefficients of the heights of patches, shape (k, m + 1, m + 1).

    Those of rational patches are quotients, which have none: theirs are zero.
    """
    nets = atlas.control_points[patches]
    if nets.shape[-1] == 4:
        return np.zeros(nets.shape[:-1])
    return np.asarray(nets @ atlas.axes.up_vector)


def _may_vanish(slopes: Array) -> Bools:
    """Return whether slopes may be zero somewhere, by their coefficients (..., k)."""
    least = NOWHERE * np.abs(slopes).max(initial=0.0)
    return np.asarray((slopes.min(axis=-1) <= least) & (slopes.max(axis=-1) >= -least))


def _slopes(atlas: Atlas, patch: Ints, place: Array) -> tuple[Array, Array]:
    """Return the gradients (k, 2) and the Hessians (k, 2, 2) of the height by (u, v)."""
    s = derivatives(atlas.control_points[patch], place, order=2) @ atlas.axes.up_vector
    bend = np.stack([s[:, 2, 0], s[:, 1, 1], s[:, 1, 1], s[:, 0, 2]], axis=1).reshape(-1, 2, 2)
    return np.stack([s[:, 1, 0], s[:, 0, 1]], axis=1), bend


def _on_seams(atlas: Atlas, patches: Ints) -> Iterator[AtlasPoint]:
    """Yield points where the height is least along a seam and falls to both sides, or reversed."""
    neighbors = topology(atlas).neighbors
    level = _may_vanish(np.diff(sides_of(_height_nets(atlas, patches)), axis=2))
    chosen = {(int(patches[row]), int(side)) for row, side in np.argwhere(level)}
    seams = [place for place, over in neighbors.over.items() if place in chosen and len(over) == 1]
    for number, along in zip(*_level_places(atlas, seams), strict=True):
        patch, side = seams[number]
        crossing = neighbors.over[patch, side][0]
        axis = EDGES[side].fixed_axis
        here = AtlasPoint(patch, *on_side(side, along))
        there = next(s.place for s in neighbors.steps(here) if s.crossing == crossing)
        rows = np.array([here.patch, there.patch])
        slope, bend = _slopes(atlas, rows, np.array([here[1:], there[1:]]))
        curvature = bend[0, 1 - axis, 1 - axis]
        other = EDGES[crossing.to_side]
        inwards = np.array(
            [
                (1.0 - 2.0 * edge.fixed_value) * slope[row, edge.fixed_axis]
                for row, edge in enumerate((EDGES[side], other))
            ]
        )
        least = LEVEL * float(np.abs(slope).max() + np.abs(bend).max())
        falls = inwards.max() < -least and curvature > 0.0
        rises = inwards.min() > least and curvature < 0.0
        if falls or rises:
            yield here


def _level_places(atlas: Atlas, seams: Sequence[tuple[int, int]]) -> tuple[list[int], list[float]]:
    """Return where the height has no slope along sides of patches.

    These are the numbers of the sides, and parameters in (0, 1).
    """
    patch, side = np.array(seams, dtype=np.int64).reshape(-1, 2).T

    def slope(along: Array, rows: Ints) -> Array:
        slopes = _slopes(atlas, patch[rows], parameters_on_sides(side[rows], along))[0]
        return np.asarray(slopes[np.arange(len(rows)), 1 - AXIS[side[rows]]])

    t = np.linspace(0.0, 1.0, SAMPLES + 1)
    every = np.arange(len(patch)).repeat(len(t))
    value = slope(np.tile(t, len(patch)), every).reshape(-1, len(t))
    row, step = np.nonzero(value[:, 1:] * value[:, :-1] < 0.0)
    root = roots_between(
        lambda along, which: slope(along, row[which]),
        *(t[step], t[step + 1], value[row, step], value[row, step + 1]),
        REST,
    )
    # A place that is met exactly, as in the middle of a symmetric seam.
    exact, at = np.nonzero(value[:, 1:-1] == 0.0)
    return [*row.tolist(), *exact.tolist()], [*root.tolist(), *t[1 + at].tolist()]
