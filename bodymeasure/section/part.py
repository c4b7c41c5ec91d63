"""Parts of a section's curves: from one place on them to another."""

from collections.abc import Callable
from dataclasses import fields, replace

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.section.curve import Curve
from bodymeasure.section.loop import SectionLoop
from bodymeasure.section.pieces import MORE_NODES, Pieces

# Samples a piece. A graph over one parameter of a bicubic patch turns but little.
SAMPLES = 24
# Parts into which the steps about a place are cut each round, and rounds: 1/24 of a piece shrinks
# to rounding.
CUTS = 32
ROUNDS = 10
# Steps at most to a change of sign, each of which at least halves its bracket: to rounding. Some
# five are usual.
STEPS = 54
# Of a place, in pieces: what rounding leaves of it.
FINEST = 1e-15


def turned(loop: SectionLoop) -> SectionLoop:
    """The same curve run from its end to its start: place p is at ``count - p``."""
    count = loop.count
    rows = np.arange(count)[::-1]
    pieces = loop.pieces.take(rows).between(np.ones(count), np.zeros(count))
    return replace(loop, pieces=pieces, piece_length=loop.piece_length[::-1])


def part(loop: SectionLoop, first: float, last: float) -> SectionLoop:
    """The part of a curve from one place forwards to another, an open curve.

    Parameters
    ----------
    loop : SectionLoop
    first, last : float
        Places, as in `SectionLoop.positions_at`. Along a closed curve `last` may be up to one round
        more than `first`, and so more than the number of pieces.
    """
    rows = np.arange(int(first), int(np.ceil(last)))
    start = np.clip(first - rows, 0.0, 1.0)
    stop = np.clip(last - rows, 0.0, 1.0)
    cut = loop.pieces.take(rows % loop.count)
    length = loop.piece_length[rows % loop.count].copy()
    pieces = cut.between(start, stop)
    inner = np.flatnonzero((start > 0.0) | (stop < 1.0))
    length[inner] = loop.surface.lengths(pieces.take(inner), MORE_NODES)
    return replace(loop, pieces=pieces, piece_length=length, closed=False)


def joined(parts: tuple[SectionLoop, ...]) -> SectionLoop:
    """The pieces of several curves of one section in one, whether or not they meet."""
    pieces = Pieces(
        *(
            np.concatenate([getattr(each.pieces, field.name) for each in parts])
            for field in fields(Pieces)
        )
    )
    length = np.concatenate([each.piece_length for each in parts])
    return replace(parts[0], pieces=pieces, piece_length=length, closed=False)


def sample_places(loop: Curve) -> Array:
    """Places close together along a curve, shape (n,), its end included."""
    return np.asarray(np.arange(SAMPLES * loop.count + 1) / SAMPLES)


def nearest_place(loop: Curve, position: ArrayLike) -> float:
    """The place of a curve that is nearest to a position."""
    target, end = np.asarray(position, dtype=np.float64), float(loop.count)

    def apart(place: Array) -> Array:
        return np.asarray(np.linalg.norm(loop.positions_at(place) - target, axis=1))

    place = sample_places(loop)
    best, width = float(place[np.argmin(apart(place))]), 1.0 / SAMPLES
    offsets = np.arange(-CUTS, CUTS + 1) / CUTS
    for _ in range(ROUNDS):
        tried = best + width * offsets
        tried = tried % end if loop.closed else np.clip(tried, 0.0, end)
        best = float(tried[np.argmin(apart(tried))])
        width /= CUTS
    return best


def sign_changes(loop: SectionLoop, height: Callable[[Array], Array]) -> Array:
    """Places at which a function of the position changes its sign, in order, shape (n,).

    Parameters
    ----------
    loop : SectionLoop
    height : callable
        From positions (n, 3) to numbers (n,); zero counts as positive.

    Notes
    -----
    C. Ridders, "A new algorithm for computing a single root", IEEE Trans. Circuits Syst. 26 (1979).
    """
    place = sample_places(loop)
    value = height(loop.positions_at(place))
    rows = np.flatnonzero((value[1:] < 0.0) != (value[:-1] < 0.0))
    low, high, at_low, at_high = place[rows], place[rows + 1], value[rows], value[rows + 1]
    root = np.where(np.abs(at_low) < np.abs(at_high), low, high)
    for _ in range(STEPS):
        middle = 0.5 * (low + high)
        at_middle = height(loop.positions_at(middle))
        scale = np.sqrt(at_middle**2 - at_low * at_high)
        shift = np.sign(at_low - at_high) * np.divide(
            at_middle, scale, out=np.zeros_like(scale), where=scale > 0.0
        )
        previous, root = root, np.clip(middle + (middle - low) * shift, low, high)
        at_root = height(loop.positions_at(root))
        for place, value in ((middle, at_middle), (root, at_root)):
            inside = (place > low) & (place < high)
            before = inside & ((value < 0.0) == (at_low < 0.0))
            after = inside & ~before
            low, at_low = np.where(before, place, low), np.where(before, value, at_low)
            high, at_high = np.where(after, place, high), np.where(after, value, at_high)
        if (np.abs(root - previous) <= FINEST * loop.count).all():
            break
    return np.asarray(root)
