"""Loops cut at the armpits by two vertical planes, their gaps bridged by straight lines."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.section import BridgedLoop, SectionLoop, part, sign_changes


def cut_loop(
    loop: SectionLoop, left: Array, bounds: tuple[float, float]
) -> SectionLoop | BridgedLoop:
    """Return what lies of a closed loop between two planes, its gaps bridged by straight lines.

    Parameters
    ----------
    loop : SectionLoop
    left : ndarray, shape (3,)
        The direction to the wearer's left, which is the planes' normal.
    bounds : tuple of two float
        The coordinates in this direction at which the left and the right plane cut.

    Returns
    -------
    SectionLoop or BridgedLoop
        The loop itself, if it lies between the planes as it is.

    Raises
    ------
    InputError
        If the loop is open, lies beyond a plane, or reaches beyond one of them only.
    """
    if not loop.closed:
        raise InputError(
            "the section is open: it ends on the boundary of the atlas, so that nothing closed is "
            "left of it; choose a plane that cuts the body all round"
        )
    cuts = [_crossings(loop, left, bound) for bound in bounds]
    across = loop.positions @ left
    if not any(len(places) for places in cuts) and bounds[1] < across.mean() < bounds[0]:
        return loop
    for side, bound, places in zip(("left", "right"), bounds, cuts, strict=True):
        if not len(places):
            raise InputError(
                f"the {side} plane that is to cut the loop, at {bound:.4g} {loop.unit} to the "
                f"left, misses it: the loop reaches from {across.max():.4g} to "
                f"{across.min():.4g}; choose the armpits to cut at, and a height at which the arms "
                "are part of the loop"
            )
    places = np.sort(np.concatenate(cuts))
    ends = np.append(places[1:], places[0] + loop.count)
    middle = loop.positions_at((0.5 * (places + ends)) % loop.count) @ left
    kept = np.flatnonzero((middle < bounds[0]) & (middle > bounds[1]))
    return BridgedLoop(tuple(part(loop, float(places[i]), float(ends[i])) for i in kept))


def _crossings(loop: SectionLoop, left: Array, bound: float) -> Array:
    return sign_changes(loop, lambda positions: np.asarray(positions @ left - bound))
