"""Taut tapes in a plane of symmetry, from the exact section of the body by that plane."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.section import Plane, SectionLoop, plane_section

# Samples of each arc. The arcs between bridges are measured exactly, and the ends of bridges are
# known to a step, of which only the cube enters the length.
SAMPLES = 1200


def profile_hull(atlas: Atlas, start: AtlasPoint, end: AtlasPoint) -> float:
    """The length of a tape drawn taut over the median profile, the shorter way around."""
    first, last = atlas.position(start), atlas.position(end)
    loop = plane_section(atlas, Plane(first, np.array([1.0, 0.0, 0.0]))).nearest(first)
    begin, finish = sorted(_place(loop, position) for position in (first, last))
    arcs = [_arc(begin, finish)]
    if loop.closed:
        arcs.append(_arc(finish, begin + float(len(loop.pieces))))
    lengths = [_travelled(loop, arc)[-1] for arc in arcs]
    return _taut(loop, arcs[int(np.argmin(lengths))])


def _place(loop: SectionLoop, position: Array) -> float:
    """The place on a loop that is closest to a position."""
    count = float(len(loop.pieces))
    place, width = 0.5 * count, 0.5 * count
    for steps in (2000, *(40,) * 10):
        places = np.clip(np.linspace(place - width, place + width, steps + 1), 0.0, count)
        gap = np.linalg.norm(loop.positions_at(places) - position, axis=1)
        place, width = float(places[np.argmin(gap)]), 4.0 * width / steps
    assert gap.min() < 1e-9
    return place


def _arc(begin: float, finish: float) -> Array:
    """Places on a loop from one place onwards to another."""
    # The kinks between pieces are corners of the hull, or of hollows.
    kinks = np.arange(np.floor(begin) + 1.0, np.ceil(finish))
    return np.unique(np.concatenate([np.linspace(begin, finish, SAMPLES + 1), kinks]))


def _travelled(loop: SectionLoop, places: Array) -> Array:
    count = float(len(loop.pieces))
    turns = np.floor(places / count) * loop.closed
    rest = places - turns * count
    way = turns * loop.length + loop.arc_length_at(rest)
    return np.asarray(way - way[0])


def _taut(loop: SectionLoop, places: Array) -> float:
    """The length of the chain that turns only towards the body: arcs of the profile and bridges."""
    whole = loop.positions[:, 1:]
    area = (whole[:, 0] * np.roll(whole[:, 1], -1) - whole[:, 1] * np.roll(whole[:, 0], -1)).sum()
    count = float(len(loop.pieces))
    flat = loop.positions_at(places - np.floor(places / count) * loop.closed * count)[:, 1:]
    way = _travelled(loop, places)
    chain: list[int] = []
    for k in range(len(flat)):
        while len(chain) > 1:
            one, two = flat[chain[-1]] - flat[chain[-2]], flat[k] - flat[chain[-1]]
            if np.sign(area) * (one[0] * two[1] - one[1] * two[0]) > 0.0:
                break
            chain.pop()
        chain.append(k)
    corners = np.array(chain)
    chords = np.linalg.norm(np.diff(flat[corners], axis=0), axis=1)
    arcs = np.diff(way[corners])
    return float(np.where(np.diff(corners) == 1, arcs, chords).sum())
