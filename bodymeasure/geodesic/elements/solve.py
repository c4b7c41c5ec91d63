"""Shortest paths made of elements, which are cut where the length is not known well enough.

The path of least energy in the patch is found for a few elements along a polygon; then those
elements that make most of the error are cut, and the path is found again. A single polynomial has
to follow the sharpest bend of a path with its whole length, and where an arc along an edge begins
no polynomial converges quickly. Elements become short there, and stay long elsewhere.
"""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.geodesic.contact.joined import ContactPath
from bodymeasure.geodesic.contact.legs import Contact, End
from bodymeasure.geodesic.elements.cuts import cuts
from bodymeasure.geodesic.elements.descent import least_energy
from bodymeasure.geodesic.elements.measure import ElementLength, measure_elements
from bodymeasure.geodesic.elements.path import (
    DEGREE,
    OVERSHOOT,
    ElementPath,
    from_polygon,
)
from bodymeasure.geodesic.elements.rival import NO_RIVAL, Rival
from bodymeasure.geodesic.solving.protocol import EdgeContact
from bodymeasure.geodesic.spaces.elements import element_space
from bodymeasure.geodesic.surfaces.protocol import Surface

FIRST_ELEMENTS, MOST_ELEMENTS = 8, 160
# The most steps of Newton's method with the same elements, the work of measuring a path in such
# steps, and the most work, each step counted once for each element: a third of a second.
MOST_STEPS, MEASURED, MOST_WORK = 60, 5, 5200
# The relative error that is good enough where the one that is asked for needs too much work.
GOOD_ENOUGH = 1e-6
# A path that is still longer than a known one by this many times what the latest cuts took off
# its length will not become shorter.
FALLS = 10.0
# Cuts that leave more of the error than this have come to what rounding leaves.
STAYS = 0.7
# How far a path that an edge holds may leave the patch between its nodes, in u or v. That becomes
# part of its error, and the path that is returned is cut off there.
OUTSIDE = 1e-7
# No element has a smaller part of the length.
LEAST_PART = 1e-15


class ElementResult(NamedTuple):
    """What became of a polygon.

    Parameters
    ----------
    path : ContactPath or None
        None if the length is not known well enough within the budget of elements and steps, or if
        the path was given up because a shorter one is known.
    least : float
        The length that the path will not fall below, as far as the latest cuts show.
    """

    path: ContactPath | None
    least: float


class _Found(NamedTuple):
    path: ElementPath
    measured: ElementLength
    held: Bools


def solve_elements(
    surface: Surface,
    polygon: Array,
    poles: tuple[End, End],
    *,
    tolerance: float,
    rival: Rival = NO_RIVAL,
) -> ElementResult:
    """Find the shortest path near a polygon.

    Parameters
    ----------
    surface : Surface
        The surface of one problem.
    polygon : ndarray, shape (m + 1, 2)
        The polygon to start from, in the patch.
    poles : pair of End
        The collapsed edges, `legs.Pole`, on which the path's ends lie.
    tolerance : float
        The relative error of the length that is asked for.
    rival : Rival
        Another path; longer ones, and the same again, are not wanted.
    """
    path = from_polygon(surface, polygon, FIRST_ELEMENTS)
    best: _Found | None = None
    work, before, least = 0, np.inf, 0.0
    while len(path.widths) <= MOST_ELEMENTS and work < MOST_WORK:
        path, minimum = least_energy(surface, path, _idle(path, poles), MOST_STEPS)
        work += (minimum.iterations + MEASURED) * len(path.widths)
        held = path.by_element(minimum.held)
        measured = measure_elements(surface, path, held)
        length = float(measured.length.raw[0])
        if not np.isfinite(length):
            break
        before, least = length, length - FALLS * abs(before - length)
        if least > rival.length:
            return ElementResult(None, least)
        if rival.is_reached_by(surface, path, measured.lengths):
            return ElementResult(None, rival.length)
        path = path.weighted(np.maximum(measured.lengths, LEAST_PART * length))
        # What an edge holds is right only where the path is at rest.
        settled = minimum.converged or not held.any()
        if settled and path.outside.max() <= (OUTSIDE if held.any() else OVERSHOOT):
            stays = best is not None and bool(
                measured.length.error[0] > STAYS * best.measured.length.error[0]
            )
            if best is None or measured.length.error < best.measured.length.error:
                best = _Found(path, measured, held)
            good = best.measured.length.is_known_to(GOOD_ENOUGH)[0]
            if measured.length.is_known_to(tolerance)[0] or (stays and good):
                break
        if settled or not measured.length.is_known_to(GOOD_ENOUGH)[0]:
            path = path.split(cuts(path, measured, held, tolerance * length))
    if best is None or not best.measured.length.is_known_to(GOOD_ENOUGH)[0]:
        return ElementResult(None, max(least, 0.0))
    return ElementResult(_joined(best), least)


def _idle(path: ElementPath, poles: tuple[End, End]) -> Bools:
    """The unknowns that stay what they are: the ends, but for where a path leaves a pole."""
    idle = np.zeros((DEGREE * len(path.widths) + 1, 2), bool)
    for node, pole in zip((0, -1), poles, strict=True):
        idle[node] = True
        if pole is not None:
            idle[node, 1 - pole.axis] = False
    return idle.ravel()


def _joined(found: _Found) -> ContactPath:
    """The path in the form of others."""
    path = found.path
    edges = np.concatenate([[0.0], np.cumsum(path.widths)])
    edges[-1] = 1.0
    values = np.ascontiguousarray(path.unknowns.reshape(-1, 2).T)
    touching: Bools = np.zeros(values.shape, bool)
    for number, own in enumerate(found.held | path.held_throughout[:, :, None]):
        touching[:, number * DEGREE : number * DEGREE + DEGREE + 1] |= own
    space = element_space(edges, DEGREE)
    return ContactPath(space, values, found.measured.length, _contacts(values, touching))


def _contacts(values: Array, touching: Bools) -> tuple[EdgeContact, ...]:
    """The edges that nodes run along, in order."""
    found: list[tuple[int, EdgeContact]] = []
    for axis in (0, 1):
        for value in (0.0, 1.0):
            rows: Ints = np.flatnonzero(touching[axis] & (values[axis] == value))
            for run in np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1):
                if len(run):
                    start, end = values[1 - axis, run[[0, -1]]].tolist()
                    contact = EdgeContact(Contact(axis, value).name, start, end)
                    found.append((int(run[0]), contact))
    return tuple(contact for _, contact in sorted(found, key=lambda item: item[0]))
