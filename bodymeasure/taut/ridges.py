"""Nodes of a string that are pinned to ridges, the seams over which the skin turns sharply.

Between two nodes on either side of a ridge a string cuts through the body, and pulls itself to
where it cuts the deepest. A node on the ridge itself keeps it out: both patches' tangent planes
hold it, so that it can only slide along the seam, for as long as the string presses on both.
"""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.seams import AXIS, VALUE, parameters_on_sides
from bodymeasure.bezier.power_form import jets
from bodymeasure.taut.skin import BLUNT, Feet, Skin

# The sine of the least angle of a ridge that holds a pin, some three degrees. Over seams that turn
# by less, as those between patches of a body do, short segments are enough.
SHARP = 0.05
# Points of a segment between which a change of patches is looked for, and the halvings that follow,
# so many rounds of some at a time: the places that they may ask for are looked up together.
SAMPLES = 8
ROUNDS, AT_A_TIME = 3, 4
# The most steps of Newton's method along a seam, and the most seams that a node passes at a time.
MAX_STEPS = 12
MAX_SEAMS = 3
# The most seams round a corner that are followed.
MAX_VALENCE = 12


class Pins(NamedTuple):
    """The seams that inner nodes are pinned to: a patch and a side, or -1, both of shape (k,)."""

    patch: Ints
    side: Ints

    @property
    def there(self) -> Bools:
        """Which nodes are pinned."""
        return np.asarray(self.patch >= 0)

    def kept(self, keep: Bools) -> "Pins":
        """Return the pins without those that do not hold any longer."""
        return Pins(np.where(keep, self.patch, -1), np.where(keep, self.side, -1))


def no_pins(count: int) -> Pins:
    """Return pins of nodes none of which is pinned."""
    return Pins(np.full(count, -1), np.full(count, -1))


class RidgeFeet(NamedTuple):
    """Points of ridges, and the tangent planes of both patches there."""

    row: Ints
    pins: Pins
    first: Feet
    second: Feet


def ridge_feet(skin: Skin, positions: Array, pins: Pins) -> RidgeFeet:
    """Return the points of ridges that are closest to the positions (k, 3) of pinned nodes."""
    row = np.flatnonzero(pins.there)
    patch, side, along = _closest(skin, positions[row], pins.patch[row], pins.side[row])
    pins = Pins(pins.patch.copy(), pins.side.copy())
    pins.patch[row], pins.side[row] = patch, side
    x = parameters_on_sides(side, along)
    over, there = skin.entered(patch, x, side)
    first, second = (_feet_at(skin, *place) for place in ((patch, x), (over, there)))
    return RidgeFeet(row, pins, first, second)


def crossings(skin: Skin, nodes: Array, ends: Ints) -> tuple[Ints, Array, Pins]:
    """Return the ridges that the segments between nodes (n + 1, 3) cut through, in order.

    The patches of the nodes' feet are known, shape (n + 1,).

    Returns
    -------
    segment : ndarray of int, shape (m,)
    position : ndarray, shape (m, 3)
        Points of the ridges, near the segments.
    pins : Pins
        Of these m points.
    """
    near = skin.near_ridge[ends]
    differ = np.flatnonzero((ends[1:] != ends[:-1]) & (near[1:] | near[:-1]))
    if not len(differ):
        return differ, np.empty((0, 3)), no_pins(0)
    start, way = nodes[differ], np.diff(nodes, axis=0)[differ]
    t = np.arange(SAMPLES + 1) / SAMPLES
    inside = (start[:, None] + t[:, None] * way[:, None]).reshape(-1, 3)
    patch, x = skin.closest(inside)
    step = np.flatnonzero((patch[1:] != patch[:-1]) & (np.arange(1, len(patch)) % len(t) > 0))
    # Most seams are so smooth that they are no ridges.
    step = step[_may_be_ridge(skin, patch[step], x[step], patch[step + 1])]
    both = np.concatenate([step, step + 1])
    gap = skin.read(inside[both], patch[both], x[both]).gap
    step = step[(gap <= skin.touching).reshape(2, -1).any(axis=0)]
    if not len(step):
        return step, np.empty((0, 3)), no_pins(0)
    row, first = np.divmod(step, len(t))
    low, high, before = t[first], t[first + 1], patch[step]
    for _ in range(ROUNDS):
        low, high = _narrowed(skin, (start[row], way[row]), before, (low, high))
    position = start[row] + high[:, None] * way[row]
    here, _ = skin.closest(start[row] + low[:, None] * way[row])
    after, _ = skin.closest(position)
    joined = skin.to_patch[before] == after[:, None]
    side = joined.argmax(axis=1)
    good = joined.any(axis=1) & (here == before) & (before != after)
    row, before, side, position = row[good], before[good], side[good], position[good]
    before, side, along = _closest(skin, position, before, side)
    sharp = skin.falls(before, side, along) > SHARP
    row, before, side, along = row[sharp], before[sharp], side[sharp], along[sharp]
    place = _curve(skin, before, side, along)[0]
    return differ[row], place, Pins(before, side)


def _may_be_ridge(skin: Skin, patch: Ints, x: Array, other: Ints) -> Bools:
    """Return whether the way from places of some patches to others may lead over a ridge."""
    between = (skin.to_patch[patch] == other[:, None]) & skin.ridge[patch]
    # Where patches share no seam, the way leads over a corner of a third one.
    apart = (skin.to_patch[patch] != other[:, None]).all(axis=1)
    result = apart & skin.ridge[patch].any(axis=1)
    row, side = np.nonzero(between)
    result[row[skin.falls(patch[row], side, x[row, 1 - AXIS[side]]) > BLUNT]] = True
    return np.asarray(result)


def _narrowed(
    skin: Skin, segments: tuple[Array, Array], patch: Ints, bounds: tuple[Array, Array]
) -> tuple[Array, Array]:
    """Return bounds (k,) after some halvings; the upper ones are where a patch ends."""
    start, way = segments
    low, width = bounds[0], bounds[1] - bounds[0]
    parts = 2**AT_A_TIME
    t = low[:, None] + width[:, None] * np.arange(1, parts) / parts
    places = (start[:, None] + t[..., None] * way[:, None]).reshape(-1, 3)
    found, _ = skin.closest(places)
    same = found.reshape(t.shape) == patch[:, None]
    row = np.arange(len(low))
    first, last = np.zeros(len(low), np.int64), np.full(len(low), parts)
    for _ in range(AT_A_TIME):
        middle = (first + last) // 2
        on = same[row, middle - 1]
        first, last = np.where(on, middle, first), np.where(on, last, middle)
    return low + width * first / parts, low + width * last / parts


def _closest(skin: Skin, positions: Array, patch: Ints, side: Ints) -> tuple[Ints, Ints, Array]:
    """Return the closest points of seams, or of sharp ones that go on: patch, side, along."""
    patch, side = patch.copy(), side.copy()
    if not len(patch):
        return patch, side, np.empty(0)
    along, squared = _descend(skin, positions, patch, side)
    for _ in range(MAX_SEAMS):
        moved = False
        for row in np.flatnonzero((along == 0.0) | (along == 1.0)).tolist():
            for other in _round_corner(skin, int(patch[row]), int(side[row]), float(along[row])):
                one = np.array([other[0]]), np.array([other[1]])
                there, closer = _descend(skin, positions[[row]], *one)
                if closer[0] < squared[row] * (1.0 - 1e-12) and skin.falls(*one, there)[0] > SHARP:
                    patch[row], side[row] = other
                    along[row], squared[row], moved = there[0], closer[0], True
        if not moved:
            break
    return patch, side, along


def _round_corner(skin: Skin, patch: int, side: int, along: float) -> list[tuple[int, int]]:
    """Return the other seams that meet where a seam ends, as patches and sides."""
    found: list[tuple[int, int]] = []
    for first in (True, False):
        here, by, x = patch, side, parameters_on_sides(np.array([side]), np.array([along]))
        if not first:
            to, x = skin.entered(np.array([patch]), x, np.array([side]))
            here, by = int(to[0]), int(skin.to_side[patch, side])
        for _ in range(MAX_VALENCE):
            axis = 1 - AXIS[by]
            by = int(
                np.flatnonzero(np.equal(AXIS, axis) & np.equal(VALUE, np.round(x[0, axis])))[0]
            )
            if skin.to_patch[here, by] < 0 or (here, by) in found:
                break
            if (here, by) == (patch, side):
                return found
            found.append((here, by))
            to, x = skin.entered(np.array([here]), x, np.array([by]))
            here, by = int(to[0]), int(skin.to_side[here, by])
            if (here, by) == (patch, side):
                return found[:-1]
    return found


def _descend(skin: Skin, positions: Array, patch: Ints, side: Ints) -> tuple[Array, Array]:
    """Return the closest points of seams: their parameters (k,), and the squared distances."""
    grid = np.linspace(0.0, 1.0, SAMPLES + 1)
    count = len(grid)
    places = _curve(skin, patch.repeat(count), side.repeat(count), np.tile(grid, len(patch)))[0]
    tried = ((places.reshape(len(patch), count, 3) - positions[:, None]) ** 2).sum(axis=2)
    along = grid[tried.argmin(axis=1)]
    for _ in range(MAX_STEPS):
        point, velocity, bend = _curve(skin, patch, side, along)
        offset = point - positions
        slope = (offset * velocity).sum(axis=1)
        square = (velocity * velocity).sum(axis=1)
        curved = square + (offset * bend).sum(axis=1)
        step = -slope / np.maximum(np.where(curved > 0.1 * square, curved, square), 1e-300)
        new = np.clip(along + np.clip(step, -1.0 / SAMPLES, 1.0 / SAMPLES), 0.0, 1.0)
        done = np.abs(new - along).max(initial=0.0) < 1e-15
        along = new
        if done:
            break
    offset = _curve(skin, patch, side, along)[0] - positions
    return along, (offset * offset).sum(axis=1)


def _curve(skin: Skin, patch: Ints, side: Ints, along: Array) -> tuple[Array, Array, Array]:
    """Return points of seams, and their first and second derivatives, each (k, 3)."""
    s = jets(skin.coefficients[patch], parameters_on_sides(side, along))
    by_v = (AXIS[side] == 0)[:, None]
    return (
        s[:, 0, 0],
        np.where(by_v, s[:, 0, 1], s[:, 1, 0]),
        np.where(by_v, s[:, 0, 2], s[:, 2, 0]),
    )


def _feet_at(skin: Skin, patch: Ints, x: Array) -> Feet:
    position, normal, bend = skin.frame(patch, x)
    nothing = np.zeros(len(patch))
    return Feet(patch, x, position, normal, nothing, nothing, bend)
