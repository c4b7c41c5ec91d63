"""Notches and drill holes."""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.pattern.definitions.panels import Panel
from bodymeasure.pattern.files.places import is_backwards, notched_parts
from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.pattern.planar import shapely

if TYPE_CHECKING:
    from bodymeasure.pattern.files.drawn import DrawnDart, DrawnEdge

# In millimeters: the depth of a notch, which stays outside the sew line where there is an
# allowance, the least depth, and the distance of the notches of a pair.
DEPTH, LEAST_DEPTH, PAIR = 5.0, 2.5, 6.0
# In millimeters: notches nearer than this to the foot of a dart are left out.
BESIDE = 12.0
# The part of an allowance that a notch may take.
SHARE = 0.6
# Points nearer than this, in millimeters, are one.
SAME = 1e-6


class Notch(NamedTuple):
    """A notch.

    Parameters
    ----------
    edge : str
        The edge on which it is.
    sewn : ndarray, shape (2,)
        The place on the sew line that it marks.
    line : ndarray, shape (2, 2)
        The notch, from the cut line inwards.
    """

    edge: str
    sewn: Array
    line: Array


def hole_of(one: Array, other: Array, before: float) -> Array:
    """Return where a hole marks a dart, on its middle line, so far before its tip."""
    feet, tip = 0.5 * (one[0] + other[0]), one[-1]
    along = feet - tip
    length = float(np.linalg.norm(along))
    return np.asarray(tip + along * min(before / length, 0.5))


def notches_of(
    pattern: Pattern,
    panel: Panel,
    lines: "tuple[tuple[DrawnEdge, ...], tuple[DrawnDart, ...]]",
    cut: Array,
) -> tuple[Notch, ...]:
    """Return the notches of a piece, with its cut line: on seams, and at the feet of darts.

    What is said of one side of a seam holds for all sides: they are notched at the same lengths,
    counted from the same end.
    """
    edges, darts = lines
    parts_of = notched_parts(pattern)
    double = {edge.name for edge in panel.edge if (edge.notch or panel.notch) == "double"}
    ring = shapely.linearrings(np.concatenate([part for edge in edges for part in edge.parts]))
    # Outside is on the right of an edge, unless the piece's atlas faces inwards.
    out = 1.0 if shapely.is_ccw(ring) else -1.0
    feet = [leg[0] for dart in darts for leg in dart.legs]
    found = []
    for edge in edges:
        parts = () if edge.is_fold else parts_of.get((panel.name, edge.name), ())
        if is_backwards(panel, [edge.name for edge in edges]):
            parts = tuple(1.0 - part for part in parts)
        apart = (-0.5 * PAIR, 0.5 * PAIR) if edge.name in double else (0.0,)
        chain = _Chain(edge.parts)
        places = [part * edge.length + shift for part in parts for shift in apart]
        for place in places:
            point, along = chain.at(place)
            # The feet of a dart are notched, and need no other notch beside them.
            if all(np.linalg.norm(point - foot) > BESIDE for foot in feet):
                found.append(_notch(edge, point, out * along, cut))
        for part in edge.parts:
            for end, along in ((part[0], part[1] - part[0]), (part[-1], part[-1] - part[-2])):
                if any(np.abs(end - foot).max() < SAME for foot in feet):
                    found.append(_notch(edge, end, out * along, cut))
    return tuple(found)


class _Chain:
    """The places along an edge by their lengths from its start."""

    def __init__(self, parts: tuple[Array, ...]) -> None:
        self._starts = np.concatenate([part[:-1] for part in parts])
        self._steps = np.concatenate([np.diff(part, axis=0) for part in parts])
        sizes = np.linalg.norm(self._steps, axis=1)
        self._lengths = np.concatenate([[0.0], np.cumsum(sizes)])

    def at(self, length: float) -> tuple[Array, Array]:
        """Return the point at a length, and the direction there."""
        number = int(np.searchsorted(self._lengths, length, side="right")) - 1
        number = min(max(number, 0), len(self._steps) - 1)
        step = self._steps[number]
        part = (length - self._lengths[number]) / np.linalg.norm(step)
        return self._starts[number] + part * step, step


def _notch(edge: "DrawnEdge", place: Array, along: Array, cut: Array) -> Notch:
    """Return the notch at a place of an edge: from where its normal meets the cut line, inwards."""
    ring = shapely.linearrings(cut)
    normal = np.array([along[1], -along[0]]) / np.linalg.norm(along)
    start = place
    if edge.allowance > 0.0:
        ray = shapely.linestrings(np.stack([place, place + 4.0 * edge.allowance * normal]))
        met = shapely.get_coordinates(shapely.intersection(ring, ray))
        if len(met):
            start = met[np.linalg.norm(met - place, axis=1).argmin()]
    depth = min(DEPTH, max(SHARE * edge.allowance, LEAST_DEPTH))
    return Notch(edge.name, place, np.stack([start, start - depth * normal]))
