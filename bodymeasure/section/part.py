"""Parts of a section's curves: from one place on them to another."""

from dataclasses import fields, replace

import numpy as np

from bodymeasure.section.loop import SectionLoop
from bodymeasure.section.pieces import Pieces


def turned(loop: SectionLoop) -> SectionLoop:
    """Return a curve run from its end to its start: place p is at ``count - p``."""
    count = loop.count
    rows = np.arange(count)[::-1]
    pieces = loop.pieces.take(rows).between(np.ones(count), np.zeros(count))
    return replace(loop, pieces=pieces, piece_length=loop.piece_length[::-1])


def part(loop: SectionLoop, first: float, last: float) -> SectionLoop:
    """Return the part of a curve from one place forwards to another, an open curve.

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
    length[inner] = loop.surface.lengths(pieces.take(inner))
    return replace(loop, pieces=pieces, piece_length=length, closed=False)


def joined(parts: tuple[SectionLoop, ...]) -> SectionLoop:
    """Return the pieces of several curves of one section as one, whether or not they meet."""
    pieces = Pieces(
        *(
            np.concatenate([getattr(each.pieces, field.name) for each in parts])
            for field in fields(Pieces)
        )
    )
    length = np.concatenate([each.piece_length for each in parts])
    return replace(parts[0], pieces=pieces, piece_length=length, closed=False)
