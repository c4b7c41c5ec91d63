"""The line along which a piece is cut out: its sew line, with an allowance for each side."""

from typing import Any

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.pattern.planar import shapely

# How far, in allowances, a corner of the cut line may stand out; sharper ones are cut off.
MITRE = 2.5
# The sine of the angle from which a border turns at a corner rather than runs on. Where it runs on
# with another allowance, the cut line has a step.
CORNER = 0.5
# A border that turns by less, as a sine, is straight.
STRAIGHT = 1e-6
# In millimeters: the grid on which the parts of an area are put together.
GRID = 1e-6


def widened(ring: Array, allowance: Array, fold: Array | None = None) -> Any:
    """Return the area inside a ring and within the allowances outside its sides.

    Parameters
    ----------
    ring : ndarray, shape (n, 2)
        Counterclockwise, not closed.
    allowance : ndarray, shape (n,)
        Of the side from each point to the next.
    fold : ndarray, shape (2, 2), optional
        Both ends of a straight side beyond which there is nothing.

    Returns
    -------
    shapely.Polygon

    Notes
    -----
    At a corner, both sides are moved outwards and prolonged until they meet, whatever their
    allowances are: the wider one ends where the narrower one is cut.
    """
    ring, allowance = _without_straight(ring, allowance)
    along = _along(ring)
    out = np.stack([along[:, 1], -along[:, 0]], axis=1)
    shift = allowance[:, None] * out
    ends = np.roll(ring, -1, axis=0)
    strips = shapely.polygons(np.stack([ring, ends, ends + shift, ring + shift], axis=1))
    before = np.roll(np.arange(len(ring)), 1)
    turn = _turns(along)
    # Each with the allowances on both sides of it.
    parts = [*zip(strips, allowance, allowance, strict=True)]
    trims = []
    for corner in np.flatnonzero(turn > STRAIGHT):
        one, other = int(before[corner]), int(corner)
        meeting = np.asarray(np.linalg.solve(out[[one, other]], allowance[[one, other]]))
        early = bool(meeting @ along[one] < 0.0), bool(meeting @ along[other] > 0.0)
        if any(early) and turn[corner] < CORNER:
            continue
        fill = _fill(meeting, shift[[one, other]], early)
        if len(fill) > 2:
            filled = shapely.polygons(ring[corner] + np.array(fill))
            parts.append((filled, allowance[one], allowance[other]))
        for wide, narrow, cut in ((one, other, early[0]), (other, one, early[1])):
            if cut:
                place = ring[corner] + shift[narrow]
                beyond = _beyond(place, along[narrow], out[narrow], allowance.max())
                trims.append((allowance[wide], beyond))
    for width, beyond in trims:
        parts = [
            (shapely.difference(part, beyond) if one == other == width else part, one, other)
            for part, one, other in parts
        ]
    sewn = shapely.make_valid(shapely.polygons(ring))
    every = [sewn, *(part for part, one, other in parts if one or other)]
    # On a grid, since rounding would leave cracks between strips, which end at the sew line.
    area = shapely.union_all(every, grid_size=GRID)
    return largest(
        area if fold is None else shapely.intersection(area, _side_of(fold, area), grid_size=GRID)
    )


def _along(ring: Array) -> Array:
    along = np.roll(ring, -1, axis=0) - ring
    return np.asarray(along / np.linalg.norm(along, axis=1)[:, None])


def _turns(along: Array) -> Array:
    """Return the sine by which a border turns at the start of each side, positive at a corner."""
    before = np.roll(along, 1, axis=0)
    return np.asarray(before[:, 0] * along[:, 1] - before[:, 1] * along[:, 0])


def _without_straight(ring: Array, allowance: Array) -> tuple[Array, Array]:
    """Return a border without the points at which neither it nor its allowance changes."""
    kept = np.arange(len(ring))
    while True:
        along = _along(ring[kept])
        onwards = (along * np.roll(along, 1, axis=0)).sum(axis=1) > 0.0
        same = allowance[kept] == np.roll(allowance[kept], 1)
        idle = same & onwards & (np.abs(_turns(along)) <= STRAIGHT)
        # Every other one at a time, so that a slow bend does not pass for straight.
        idle &= ~(np.roll(idle, 1) & (np.arange(len(kept)) % 2 == 1))
        if not idle.any() or len(kept) - idle.sum() < 3:
            return ring[kept], allowance[kept]
        kept = kept[~idle]


def largest(area: Any) -> Any:
    """Return the largest part of an area, without holes, counterclockwise."""
    parts = [part for part in shapely.get_parts(area) if part.geom_type == "Polygon"]
    part = max(parts, key=shapely.area)
    return shapely.orient_polygons(shapely.polygons(shapely.get_exterior_ring(part)))


def _fill(meeting: Array, shifts: Array, early: tuple[bool, bool]) -> list[Array]:
    """Return the area between the strips on both sides of a corner, from the corner."""
    most, reach = MITRE * np.linalg.norm(shifts, axis=1).max(), np.linalg.norm(meeting)
    points = [np.zeros(2)]
    if not early[0]:
        points.append(shifts[0])
    if reach > most:
        points += [shift + most / reach * (meeting - shift) for shift in shifts]
    else:
        points.append(meeting)
    if not early[1]:
        points.append(shifts[1])
    return points


def _side_of(fold: Array, area: Any) -> Any:
    """Return the side of a fold, far and wide, on which the middle of an area is."""
    along = fold[1] - fold[0]
    middle = shapely.get_coordinates(shapely.centroid(area))[0] - fold[0]
    inward = np.array([-along[1], along[0]])
    inward = inward * np.sign(inward @ middle) / np.linalg.norm(along)
    far = shapely.length(area)
    along = far * along / np.linalg.norm(along)
    corners = [fold[0] - along, fold[1] + along, fold[1] + along + far * inward]
    return shapely.polygons(np.array([*corners, fold[0] - along + far * inward]))


def _beyond(place: Array, along: Array, out: Array, allowance: float) -> Any:
    """Return what lies beyond a side that was moved outwards, near a corner."""
    reach = 2.0 * MITRE * allowance
    corners = [place - reach * along, place + reach * along]
    corners += [corners[1] + reach * out, corners[0] + reach * out]
    return shapely.polygons(np.array(corners))
