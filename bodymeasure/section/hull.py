"""The perimeter of a loop's convex hull: the length of a tape drawn taut around it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from bodymeasure.errors import InputError
from bodymeasure.section.loop import SectionLoop

# Samples a piece to begin with: they have to tell hollows apart, not to measure them.
SAMPLES = 12
# Parts into which the steps beside a bridge's ends are cut each round.
CUTS = 8
# Of a piece: where the ends of bridges are known so well, their lengths are to rounding, since an
# error e of a tangent's foot changes the perimeter by some e^3.
FINEST = 1e-6
# Of the length: hollows that save less are not worth a closer look.
NEGLIGIBLE = 1e-14
# Sine of an angle: rounding of the finest steps stays below, and hollows so shallow save a 1e-12th.
STRAIGHT = 1e-6
# Relative. By so much may corners in the loop's order go round longer than in the hull's.
ORDER_TOLERANCE = 1e-9


class Hull(NamedTuple):
    """The convex hull of a closed loop.

    Parameters
    ----------
    length : float
        Its perimeter: at most the loop's length.
    error_estimate : float
    bridges : ndarray, shape (k, 2, 3)
        Ends of the straight parts that span hollows.
    """

    length: float
    error_estimate: float
    bridges: NDArray[np.float64]


def convex_hull(loop: SectionLoop) -> Hull:
    """Convex hull of a closed loop in its plane, from the smooth curve.

    Parameters
    ----------
    loop : SectionLoop

    Returns
    -------
    Hull

    Raises
    ------
    InputError
        If the loop is open, or crosses itself.

    Notes
    -----
    The hull consists of arcs of the loop, whose lengths are known, and bridges over its hollows.
    Bridges are found on samples, and the samples beside their ends refined until they are exact.
    What each saves, the arc less the chord, is taken off the loop's length.
    """
    if not loop.closed:
        raise InputError(
            "the section is open: it ends on the boundary of the atlas, so a tape around it has no "
            "length; choose a plane that cuts the body all round, or join the patches' edges"
        )
    frame = loop.surface.plane.frame()
    place = np.arange(SAMPLES * len(loop.pieces)) / SAMPLES
    flat = loop.positions_at(place) @ frame.T
    previous = np.inf
    for _ in range(20):
        corners = _hull_corners(flat)
        first, last = corners, np.roll(corners, -1)
        saved = _saved(loop, place, flat, first, last)
        total = loop.length - float(saved.sum())
        hollow = saved > NEGLIGIBLE * loop.length
        # Skipped ends of pieces that save nothing may be kinks, whose hollows show on finer steps.
        skips = (last - first) % len(place) > 1
        skips &= hollow | (np.floor(place[first]) != np.floor(place[last]))
        ends = np.concatenate([first[skips], last[skips]])
        steps = np.concatenate([ends - 1, ends, _concave_steps(loop, place, flat, corners)])
        new = _between(place, np.unique(steps % len(place)), float(len(loop.pieces)))
        if not len(new):
            break
        previous = total
        place, order = np.unique(np.concatenate([place, new]), return_index=True)
        flat = np.concatenate([flat, loop.positions_at(new) @ frame.T])[order]
    change = abs(previous - total) if np.isfinite(previous) else 0.0
    spans = np.stack([place[first[hollow]], place[last[hollow]]], axis=1)
    bridges = loop.positions_at(spans.ravel()).reshape(-1, 2, 3)
    return Hull(total, loop.error_estimate + change, bridges)


def _hull_corners(flat: NDArray[np.float64]) -> NDArray[np.int64]:
    """Samples on the convex hull, in the loop's order."""
    try:
        corners = scipy.spatial.ConvexHull(flat).vertices.astype(np.int64)
    except scipy.spatial.QhullError:
        raise InputError(
            "the section is as flat as a line, so it has no convex hull; move or tilt the plane"
        ) from None
    ordered = np.sort(corners)
    around, along = (_perimeter(flat[rows]) for rows in (corners, ordered))
    if along > around * (1.0 + ORDER_TOLERANCE):
        raise InputError(
            "the section crosses itself, so that a tape around it has no clear path; check the "
            "atlas for parts that intersect, or move the plane"
        )
    return ordered


def _perimeter(corners: NDArray[np.float64]) -> float:
    return float(np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1).sum())


def _saved(
    loop: SectionLoop,
    place: NDArray[np.float64],
    flat: NDArray[np.float64],
    first: NDArray[np.int64],
    last: NDArray[np.int64],
) -> NDArray[np.float64]:
    """Arc less chord from each corner to the next, shape (corners,); 0 from sample to sample."""
    span = (last - first) % len(place)
    rows = np.flatnonzero(span > 1)
    result = np.zeros(len(first))
    at = loop.arc_length_at(place[np.concatenate([first[rows], last[rows]])])
    arc = at[len(rows) :] - at[: len(rows)]
    arc = np.where(last[rows] < first[rows], arc + loop.length, arc)
    chord = np.linalg.norm(flat[last[rows]] - flat[first[rows]], axis=1)
    # No arc is shorter than its chord, but for rounding.
    result[rows] = np.maximum(arc - chord, 0.0)
    return result


def _concave_steps(
    loop: SectionLoop,
    place: NDArray[np.float64],
    flat: NDArray[np.float64],
    corners: NDArray[np.int64],
) -> NDArray[np.int64]:
    """Steps from corner to next sample that may hide a hollow: the loop turns inwards in them.

    Either at an end, against the chord, or at a kink between two pieces.
    """
    on_hull = np.zeros(len(place), dtype=np.bool_)
    on_hull[corners] = True
    steps = np.flatnonzero(on_hull & np.roll(on_hull, -1))
    row = place[steps].astype(np.int64)
    after = np.append(place[1:], float(len(loop.pieces)))[steps]
    fraction = np.asarray(np.stack([place[steps], after], axis=1) - row[:, None], dtype=np.float64)
    _, _, velocity = loop.surface.points(loop.pieces.take(row), fraction)
    direction = velocity @ loop.surface.plane.frame().T
    chord = np.roll(flat, -1, axis=0)[steps] - flat[steps]

    anticlockwise = np.sign(_cross(flat, np.roll(flat, -1, axis=0)).sum())
    into, out_of = (
        anticlockwise * _sine(*pair)
        for pair in ((direction[:, 0], chord), (chord, direction[:, 1]))
    )
    concave = (into < -STRAIGHT) | (out_of < -STRAIGHT)
    following = np.roll(steps, -1) == (steps + 1) % len(place)
    kink = anticlockwise * _sine(direction[:, 1], np.roll(direction[:, 0], -1, axis=0))
    concave |= following & (kink < -STRAIGHT)
    # The hollow of a kink reaches into the step after it, too.
    return np.concatenate([steps[concave], steps[concave] + 1])


def _cross(first: NDArray[np.float64], second: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])


def _sine(first: NDArray[np.float64], second: NDArray[np.float64]) -> NDArray[np.float64]:
    size = np.linalg.norm(first, axis=1) * np.linalg.norm(second, axis=1)
    sine = np.divide(_cross(first, second), size, out=np.zeros_like(size), where=size > 0.0)
    return np.asarray(sine)


def _between(
    place: NDArray[np.float64], steps: NDArray[np.int64], period: float
) -> NDArray[np.float64]:
    """New places in some steps from sample to sample, but in those that are fine."""
    start = place[steps]
    width = (place[(steps + 1) % len(place)] - start) % period
    coarse = width > FINEST
    parts = np.arange(1, CUTS) / CUTS
    return np.asarray((start[coarse, None] + width[coarse, None] * parts) % period).ravel()
