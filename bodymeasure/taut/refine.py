"""The length of a taut string: nodes where they are needed, arcs for segments that touch."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.taut.skin import Skin
from bodymeasure.taut.string import String, relax

# Segments whose error is larger than this part of the length are divided.
SEGMENT_TOLERANCE = 3e-9
# The most parts into which a segment is divided at a time.
MOST_PARTS = 8
# Every spring has at least this part of the length.
LEAST_WEIGHT = 1e-9
# A node that is guessed to touch has at least this part of the largest pressure.
TINY_PRESSURE = 1e-6


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


def segment_lengths(skin: Skin, nodes: Array) -> SegmentLengths:
    """Return the lengths of the arcs over the skin that a string's segments cut short.

    Notes
    -----
    An arc that rises by s over its chord c is c + 8 s^2 / (3 c) long, up to the fourth order in
    s / c; two such arcs over the halves, and extrapolation, leave the sixth.
    """
    chords = np.diff(nodes, axis=0)
    c = np.linalg.norm(chords, axis=1)
    fractions = np.array([0.25, 0.5, 0.75])
    inner = nodes[:-1, None] + fractions[:, None] * chords[:, None]
    depth = skin.feet(inner.reshape(-1, 3)).depth.reshape(-1, 3)
    middle = depth[:, 1]
    size = np.maximum(c, np.finfo(np.float64).tiny)
    one = c + 8.0 * middle**2 / (3.0 * size)
    half = np.hypot(0.5 * c, middle)
    rise = np.maximum(0.0, depth[:, [0, 2]] - 0.5 * middle[:, None])
    two = 2.0 * half + (8.0 * rise**2 / 3.0).sum(axis=1) / np.maximum(half, 0.5 * size)
    return SegmentLengths(two + (two - one) / 15.0, np.abs(two - one), middle)


def divided(skin: Skin, string: String, now: SegmentLengths, parts: Ints) -> String:
    """Return the string with each segment divided into a number of parts, at rest again."""
    segment = np.repeat(np.arange(len(parts)), parts)
    fraction = np.concatenate([np.arange(count) / count for count in parts])
    nodes = string.nodes[segment] + fraction[:, None] * np.diff(string.nodes, axis=0)[segment]
    nodes = np.concatenate([nodes, string.nodes[-1:]])
    # Springs as long as their segments now are pull equally, so that what they minimize is the
    # length; equal ones would not where nodes cannot slide over a kink.
    chords = np.linalg.norm(np.diff(nodes, axis=0), axis=1)
    weights = np.maximum(chords / chords.sum(), LEAST_WEIGHT)
    # The force on a node is its share of the string's turn.
    old = np.concatenate([[0.0], string.pressure, [0.0]])
    start = fraction == 0.0
    presses = now.depth > 0.0
    share = np.maximum(0.5 * (old[:-1] + old[1:]), TINY_PRESSURE * (old.max() + 1e-300))
    pressure = np.where(start, old[:-1][segment], (presses * share)[segment]) / parts[segment]
    return relax(skin, nodes, weights, pressure[1:])


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
