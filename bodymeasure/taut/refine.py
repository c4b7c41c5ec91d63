"""The length of a taut string: nodes where they are needed, arcs for segments that touch."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.taut.ridges import Pins, crossings, no_pins
from bodymeasure.taut.skin import Feet, Skin
from bodymeasure.taut.string import String, relax
from bodymeasure.taut.takeoffs import TakeoffLengths, Takeoffs, takeoff_lengths, takeoffs

# Segments whose error is larger than this part of the length are divided.
SEGMENT_TOLERANCE = 3e-9
# The most parts into which a segment is divided at a time.
MOST_PARTS = 8
# Every spring has at least this part of the length.
LEAST_WEIGHT = 1e-9
# A node that is guessed to touch has at least this part of the largest pressure.
TINY_PRESSURE = 1e-6
# A ridge is crossed on a pin if that is closer to the crossing than this part of the segment.
SAME_PIN = 1e-2
# Spans between pins pull equally if their tensions differ by less than this part, and are weighed
# anew at most so often.
BALANCED = 1e-5
MOST_BALANCINGS = 12


# The part of the way from a ridge at which the normal of the patch beyond is taken.
ASIDE = 1e-4
# The part of the corrections beside takeoffs that counts as their error.
DOUBT = 0.1


class SegmentLengths(NamedTuple):
    """A string's segments, measured over the skin.

    Parameters
    ----------
    length, error : ndarray, shape (n,)
        The length of each segment's arc, and its error.
    depth : ndarray, shape (n,)
        The depth of the segment's middle inside the skin; 0 outside.
    """

    length: Array
    error: Array
    depth: Array


def segment_lengths(skin: Skin, string: String) -> SegmentLengths:
    """Return the lengths of the arcs over the skin that a string's segments cut short.

    Beside takeoffs, the last segment holds all that the arc and the tangent differ by.

    Notes
    -----
    An arc that rises by s over its chord c is c + 8 s^2 / (3 c) long, up to the fourth order in
    s / c; two such arcs over the halves, and extrapolation, leave the sixth.
    """
    nodes = string.nodes
    chords = np.diff(nodes, axis=0)
    c = np.linalg.norm(chords, axis=1)
    fractions = np.array([0.25, 0.5, 0.75])
    inner = (nodes[:-1, None] + fractions[:, None] * chords[:, None]).reshape(-1, 3)
    beside, places = _places_beside(string)
    at = np.concatenate([np.arange(len(c)).repeat(3), beside.base, beside.last])
    feet = skin.feet(np.concatenate([inner, *places]), string.near(at))
    depth = feet.depth[: len(inner)].reshape(-1, 3)
    middle = depth[:, 1]
    size = np.maximum(c, np.finfo(np.float64).tiny)
    one = c + 8.0 * middle**2 / (3.0 * size)
    half = np.hypot(0.5 * c, middle)
    rise = np.maximum(0.0, depth[:, [0, 2]] - 0.5 * middle[:, None])
    two = 2.0 * half + (8.0 * rise**2 / 3.0).sum(axis=1) / np.maximum(half, 0.5 * size)
    length, error = two + (two - one) / 15.0, np.abs(two - one)
    rows = np.arange(len(inner), len(feet.depth)).reshape(2, -1)
    base, other = map(feet.rows, rows)
    _with_takeoffs(takeoff_lengths(nodes, (base, other), beside), beside, length, error)
    return SegmentLengths(length, error, middle)


def _places_beside(string: String) -> tuple[Takeoffs, list[Array]]:
    """Return a string's takeoffs, and two places beside each at which the skin's bend is taken."""
    touching = np.concatenate([[True], string.touching, [True]])
    pinned = np.concatenate([[True], string.pins.there, [True]])
    found = takeoffs(touching, pinned)
    nodes = string.nodes
    # On a ridge, it is the patch to which the string goes on that bends.
    aside = ASIDE * found.bound[:, None] * (nodes[found.far] - nodes[found.base])
    beside = np.sign(found.far - found.base) * (found.last == found.base)
    return found, [nodes[found.base] + aside, nodes[found.last + beside]]


def _with_takeoffs(over: TakeoffLengths, found: Takeoffs, length: Array, error: Array) -> None:
    """Put the lengths beside takeoffs, and their errors, into those of the segments, in place."""
    before = np.concatenate([[0.0], np.cumsum(length)])
    change = over.length - np.abs(before[found.far] - before[found.base])
    change = np.where(over.known, change, 0.0)
    segment = np.where(found.far > found.last, found.last, found.last - 1)
    np.add.at(length, segment, change)
    np.add.at(error, segment, np.where(over.known, over.error, 0.0) + DOUBT * np.abs(change))


def first_string(skin: Skin, nodes: Array) -> String:
    """Return the string through evenly spaced nodes (n + 1, 3) at rest, held on ridges."""
    count = len(nodes) - 2
    bare = no_pins(count), np.zeros(count)
    nodes, pins, _, feet = _pinned(skin, nodes, skin.feet(nodes), *bare)
    weights = _weights(nodes) if pins.there.any() else np.full(count + 1, 1.0 / (count + 1))
    return _balanced(skin, relax(skin, nodes, weights, pins, feet=feet))


def divided(skin: Skin, string: String, now: SegmentLengths, parts: Ints) -> String:
    """Return the string with each segment divided into a number of parts, at rest again."""
    segment = np.repeat(np.arange(len(parts)), parts)
    fraction = np.concatenate([np.arange(count) / count for count in parts])
    nodes = string.nodes[segment] + fraction[:, None] * np.diff(string.nodes, axis=0)[segment]
    nodes = np.concatenate([nodes, string.nodes[-1:]])
    # The force on a node is its share of the string's turn.
    old = np.concatenate([[0.0], string.pressure, [0.0]])
    start = fraction == 0.0
    presses = now.depth > 0.0
    share = np.maximum(0.5 * (old[:-1] + old[1:]), TINY_PRESSURE * (old.max() + 1e-300))
    pressure = np.where(start, old[:-1][segment], (presses * share)[segment]) / parts[segment]
    padded = (np.concatenate([[-1], each]) for each in string.pins)
    pins = Pins(*(np.where(start, each[segment], -1)[1:] for each in padded))
    feet = skin.feet(nodes, string.near(np.append(segment, len(parts))))
    nodes, pins, pressure, inner = _pinned(skin, nodes, feet, pins, pressure[1:])
    return _balanced(skin, relax(skin, nodes, _weights(nodes), pins, pressure, inner))


def _weights(nodes: Array) -> Array:
    """Return springs as long as their segments now are.

    They pull equally, so that what they minimize is the length; equal ones would not where nodes
    cannot slide over a kink.
    """
    chords = np.linalg.norm(np.diff(nodes, axis=0), axis=1)
    return np.asarray(np.maximum(chords / chords.sum(), LEAST_WEIGHT))


def _pinned(
    skin: Skin, nodes: Array, feet: Feet, pins: Pins, pressure: Array
) -> tuple[Array, Pins, Array, Feet | None]:
    """Return nodes, pins and pressures with new nodes on the ridges that segments cut through.

    If there are none, the feet of the inner nodes are returned, too.
    """
    segment, position, new = crossings(skin, nodes, feet.patch)
    if not len(segment):
        return nodes, pins, pressure, feet.rows(slice(1, -1))
    chord = np.linalg.norm(np.diff(nodes, axis=0), axis=1)[segment]
    held = np.concatenate([[False], pins.there, [False]])
    old = np.zeros(len(segment), dtype=np.bool_)
    for end in (segment, segment + 1):
        away = np.linalg.norm(position - nodes[end], axis=1)
        old |= held[end] & (away <= SAME_PIN * chord)
    at, new = segment[~old], Pins(*(each[~old] for each in new))
    return (
        np.insert(nodes, at + 1, position[~old], axis=0),
        Pins(*(np.insert(each, at, more) for each, more in zip(pins, new, strict=True))),
        np.insert(pressure, at, 0.0),
        None,
    )


def _balanced(skin: Skin, string: String) -> String:
    """Return the string with equal tensions on both sides of its pins, where it cannot slide."""
    for _ in range(MOST_BALANCINGS):
        if not string.settled or not string.pins.there.any():
            return string
        span = np.concatenate([[0], np.cumsum(string.pins.there)])
        chords = np.linalg.norm(np.diff(string.nodes, axis=0), axis=1)
        length, weight = np.bincount(span, chords), np.bincount(span, string.weights)
        pull = length / weight * (string.weights.sum() / chords.sum())
        uneven = float(np.abs(pull - 1.0).max())
        # Weights that are off by a part move the string by it, and lengthen it by its square.
        error = string.error + 0.5 * uneven**2 * float(chords.sum())
        if uneven <= BALANCED:
            break
        weights = np.maximum(string.weights * pull[span], LEAST_WEIGHT)
        string = relax(skin, string.nodes, weights / weights.sum(), string.pins, string.pressure)
    return string._replace(error=error)


def parts_of_segments(string: String, now: SegmentLengths, least: int) -> Ints:
    """Return into how many parts to divide each segment: `least`, or more for inaccurate lengths.

    These are the segments over kinks, whose error falls with the square of the number of parts, and
    those in which the string leaves the skin, where a kink may hide between the points in use.
    """
    excess = now.error / (SEGMENT_TOLERANCE * now.length.sum())
    parts = np.ceil(np.sqrt(excess)).astype(np.int64)
    touching = np.concatenate([[True], string.touching, [True]])
    free = ~touching[:-1] | ~touching[1:]
    near = touching[:-1] | touching[1:]
    near[1:] |= touching[:-2]
    near[:-1] |= touching[2:]
    parts[free & near] = MOST_PARTS
    return np.asarray(np.clip(parts, least, MOST_PARTS))
