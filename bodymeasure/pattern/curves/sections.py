"""Edges of pieces along plane sections."""

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.errors import InputError
from bodymeasure.pattern.curves.skin_curve import Run, SkinCurve, on_sides, steps_of
from bodymeasure.section import Plane, SectionLoop, nearest_place, plane_section, turned
from bodymeasure.section import part as part_of_loop

# Part of the body's size by which an end may be off the curve: the plane leads through the ends,
# so that it is rounding, and the move of a plane off a seam.
NEAR = 1e-7
# Steps by Newton's method from a length to its place, from the chord of a piece's samples.
STEPS = 4


def section_curve(
    atlas: Atlas,
    plane: Plane,
    ends: tuple[AtlasPoint, AtlasPoint],
    via: AtlasPoint | None = None,
) -> SkinCurve:
    """Return the part of a plane section from one point to another.

    Parameters
    ----------
    atlas : Atlas
    plane : Plane
        It holds both points.
    ends : tuple of AtlasPoint
    via : AtlasPoint, optional
        Of both ways round, the one that passes nearer to this point is taken; the shorter way if
        not given.

    Raises
    ------
    InputError
        If the plane cuts both points in different curves.
    """
    start, end = (atlas.position(point) for point in ends)
    loop = plane_section(atlas, plane).nearest(start)
    first, last = nearest_place(loop, start), nearest_place(loop, end)
    size = float(np.ptp(atlas.points, axis=0).max())
    away = np.linalg.norm(loop.positions_at(np.array([first, last])) - [start, end], axis=1)
    if away.max() > NEAR * size:
        raise InputError(
            "the plane cuts both ends in different curves; choose another plane, such as one "
            "through three landmarks on one part of the body"
        )
    ways = _ways(loop, first, last)
    if via is None:
        chosen = min(ways, key=lambda way: way.length)
    else:
        target = atlas.position(via)
        chosen = min(ways, key=lambda way: np.linalg.norm(way.positions - target, axis=1).min())
    return _curve(atlas, chosen).with_ends(*ends)


def _ways(loop: SectionLoop, first: float, last: float) -> list[SectionLoop]:
    """Return the parts of a curve that lead from one place to another."""
    count = float(loop.count)
    if not loop.closed:
        if last >= first:
            return [part_of_loop(loop, first, last)]
        return [part_of_loop(turned(loop), count - first, count - last)]
    back, backwards = turned(loop), (count - first, count - last)
    return [
        part_of_loop(curve, one, other if other > one else other + count)
        for curve, (one, other) in ((loop, (first, last)), (back, backwards))
    ]


def _curve(atlas: Atlas, loop: SectionLoop) -> SkinCurve:
    kept = np.flatnonzero(loop.piece_length > 0.0)
    lengths = loop.piece_length[kept]
    pieces = loop.pieces.take(kept)
    runs = []
    for row, length in enumerate(lengths.tolist()):
        fraction = np.linspace(0.0, 1.0, steps_of(length, atlas.unit.meters) + 1)
        one = pieces.take(np.array([row]))
        parameters = loop.surface.parameters(one, fraction[None])[0]
        runs.append(Run(int(one.patch[0]), on_sides(parameters)))
    bounds = np.concatenate([[0.0], np.cumsum(lengths)])

    def places(arc: Array) -> tuple[Ints, Array]:
        arc = np.clip(arc, 0.0, bounds[-1])
        row = np.clip(np.searchsorted(bounds, arc, side="right") - 1, 0, len(lengths) - 1)
        wanted = arc - bounds[row]
        here = pieces.take(row)
        fraction = wanted / lengths[row]
        for _ in range(STEPS):
            run = loop.surface.lengths(here.between(np.zeros(len(row)), fraction))
            velocity = loop.surface.points(here, fraction[:, None])[2][:, 0]
            fraction = fraction - (run - wanted) / np.linalg.norm(velocity, axis=1)
            fraction = np.clip(fraction, 0.0, 1.0)
        return here.patch, loop.surface.parameters(here, fraction[:, None])[:, 0]

    return SkinCurve(float(bounds[-1]), tuple(runs), places, bounds[1:-1])
