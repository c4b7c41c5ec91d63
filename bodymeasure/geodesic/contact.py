"""Shortest paths that touch the boundary of their patch: free pieces and contact arcs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bodymeasure.geodesic.free_piece import Contact, solve_free_piece
from bodymeasure.geodesic.length_error import MeasuredLength, is_good, measure_length
from bodymeasure.geodesic.method import EdgeContact
from bodymeasure.geodesic.piecewise import PiecewisePolynomials
from bodymeasure.geodesic.quadrature import Quadrature
from bodymeasure.geodesic.surface import Surface
from bodymeasure.geodesic.trial_space import TrialSpace

_Array = NDArray[np.float64]

# A piece may leave the box by this much, in u or v, without the pattern being wrong.
OVERSHOOT = 1e-9
# Gauss points of a contact arc, and of its halves, whose difference is its error estimate.
ARC_POINTS = 24


@dataclass(frozen=True)
class Leg:
    """One part of a path: free in the patch, or along an edge.

    Parameters
    ----------
    contact : Contact or None
        The edge it runs along.
    slides : pair of Contact or None
        Of a free leg: on which edges its ends slide.
    first, last : int
        Its points in the polygon that it was read from.
    """

    contact: Contact | None
    slides: tuple[Contact | None, Contact | None]
    first: int
    last: int


def read_legs(points: _Array) -> list[Leg]:
    """The pattern of free legs and contact arcs of a polygon in the box.

    Parameters
    ----------
    points : ndarray, shape (m + 1, 2)
        As `descend` leaves it: on an edge exactly where the edge holds it.

    Returns
    -------
    list of Leg
        In order. A contact arc that begins or ends at an end of the path is fixed there.
    """
    last = len(points) - 1
    arcs: list[tuple[Contact, int, int]] = []
    for axis in (0, 1):
        for value in (0.0, 1.0):
            touching = points[:, axis] == value
            # An end that lies on an edge does not touch it unless the path goes on along it.
            inner = np.flatnonzero(touching[1:-1]) + 1
            for run in np.split(inner, np.flatnonzero(np.diff(inner) > 1) + 1):
                if len(run):
                    first = 0 if run[0] == 1 and touching[0] else int(run[0])
                    final = last if run[-1] == last - 1 and touching[last] else int(run[-1])
                    arcs.append((Contact(axis, value), first, final))
    arcs.sort(key=lambda arc: arc[1])
    legs: list[Leg] = []
    place, held = 0, None
    for contact, first, final in arcs:
        if first > place:
            legs.append(Leg(None, (held, contact), place, first))
        legs.append(Leg(contact, (None, None), first, final))
        place, held = final, contact
    if place < last:
        legs.append(Leg(None, (held, None), place, last))
    return legs


@dataclass(frozen=True)
class ContactPath:
    """A path of several legs.

    Parameters
    ----------
    space : TrialSpace
        Piecewise: one piece a leg, in proportion to their lengths.
    values : ndarray, shape (2, n + 1)
        u and v at the space's nodes.
    measured : MeasuredLength
        Of shape (1,).
    contacts : tuple of EdgeContact
        The edges it runs along, in order.
    """

    space: TrialSpace
    values: _Array
    measured: MeasuredLength
    contacts: tuple[EdgeContact, ...]


def solve_legs(
    surface: Surface,
    points: _Array,
    legs: Sequence[Leg],
    spaces: Sequence[TrialSpace],
    tolerance: float,
) -> ContactPath | None:
    """Each free leg by collocation, each contact arc by quadrature.

    The legs do not depend on one another: where a free leg joins the boundary is told by its
    tangency there, and an arc runs between the ends of its neighbors.

    Parameters
    ----------
    surface : Surface
        Of one problem.
    points : ndarray, shape (m + 1, 2)
        The polygon to start from.
    legs : sequence of Leg
    spaces : sequence of TrialSpace
        Tried in turn for each leg, until its error is below the tolerance.
    tolerance : float
        Relative to the length of the path.

    Returns
    -------
    ContactPath or None
        None if a leg has no solution inside the patch, or an arc would run backwards: then the
        pattern is wrong, or the path needs finer trial spaces.
    """
    solved: list[tuple[TrialSpace, _Array, MeasuredLength] | None] = []
    for leg in legs:
        if leg.contact is None:
            free = _solve_free(surface, points, leg, spaces, tolerance)
            if free is None:
                return None
            solved.append(free)
        else:
            solved.append(None)
    contacts = []
    parts: list[tuple[TrialSpace, _Array, MeasuredLength]] = []
    for number, leg in enumerate(legs):
        found = solved[number]
        if found is not None:
            parts.append(found)
            continue
        assert leg.contact is not None
        before = solved[number - 1] if number > 0 else None
        after = solved[number + 1] if number + 1 < len(legs) else None
        begin = points[leg.first] if before is None else before[1][:, -1]
        end = points[leg.last] if after is None else after[1][:, 0]
        along = 1 - leg.contact.axis
        # From the points beside the arc, since an arc of a single point has no direction itself.
        beside = (max(leg.first - 1, 0), min(leg.last + 1, len(points) - 1))
        forward = points[beside[1], along] - points[beside[0], along]
        if (end[along] - begin[along]) * forward < 0.0:
            return None
        parts.append(_arc(surface, begin, end, spaces[0]))
        contacts.append(EdgeContact(leg.contact.name, float(begin[along]), float(end[along])))
    return _joined(parts, tuple(contacts))


def _solve_free(
    surface: Surface,
    points: _Array,
    leg: Leg,
    spaces: Sequence[TrialSpace],
    tolerance: float,
) -> tuple[TrialSpace, _Array, MeasuredLength] | None:
    polygon = points[leg.first : leg.last + 1]
    times = np.linspace(0.0, 1.0, len(polygon))
    for space in spaces:
        start = np.stack([np.interp(space.nodes, times, polygon[:, axis]) for axis in (0, 1)])
        values = solve_free_piece(surface, space, start, leg.slides)
        if values is None:
            continue
        measured = measure_length(surface, space, values[None])
        inside = not space.leaves_patch(values[None], OVERSHOOT)[0]
        if inside and is_good(measured, tolerance)[0]:
            return space, values, measured
    return None


def _arc(
    surface: Surface, begin: _Array, end: _Array, space: TrialSpace
) -> tuple[TrialSpace, _Array, MeasuredLength]:
    """Along an edge, at constant speed in its parameter."""
    values = begin[:, None] + (end - begin)[:, None] * space.nodes
    values[:, -1] = end
    lengths = []
    for pieces in (1, 2):
        rule = Quadrature(np.linspace(0.0, 1.0, pieces + 1), ARC_POINTS)
        places = begin + rule.points[:, None] * (end - begin)
        jet = surface.jet(places[None], 1)
        velocity = jet[1] * (end - begin)[0] + jet[2] * (end - begin)[1]
        lengths.append(rule.integrate(np.sqrt((velocity * velocity).sum(axis=0)).T))
    length = lengths[1]
    measured = MeasuredLength(
        raw=length,
        correction=np.zeros(1),
        error=2.0 * np.abs(lengths[1] - lengths[0]) + 1e-15 * length,
        residual=np.zeros(1),
        index=np.zeros(1, np.int64),
    )
    return space, values, measured


def _joined(
    parts: Sequence[tuple[TrialSpace, _Array, MeasuredLength]],
    contacts: tuple[EdgeContact, ...],
) -> ContactPath:
    """One path of all parts, each taking as much of [0, 1] as it has of the length."""
    lengths = np.array([measured.raw[0] for _, _, measured in parts])
    edges = np.concatenate([[0.0], np.cumsum(lengths) / lengths.sum()])
    edges[-1] = 1.0
    nodes = [np.array([0.0])]
    values = [parts[0][1][:, :1]]
    total = 1 + sum(space.size for space, _, _ in parts)
    degree = max(space.functions.coefficients.shape[1] for space, _, _ in parts)
    coefficients = np.zeros((3, degree, total, len(parts)), dtype=np.longdouble)
    column = 0
    for number, (space, part, _) in enumerate(parts):
        width = edges[number + 1] - edges[number]
        nodes.append(edges[number] + width * space.nodes[1:])
        values.append(part[:, 1:])
        own = space.functions.coefficients[..., 0]
        chain = np.array([1.0, 1.0 / width, 1.0 / width**2])[:, None, None]
        coefficients[:, : own.shape[1], column : column + space.size + 1, number] = own * chain
        column += space.size
    all_nodes = np.concatenate(nodes)
    all_nodes[-1] = 1.0
    space = TrialSpace(
        nodes=all_nodes,
        condition=max(space.condition for space, _, _ in parts),
        functions=PiecewisePolynomials(edges, coefficients),
        description=" + ".join(space.description for space, _, _ in parts),
    )
    measured = MeasuredLength.of_parts([measured for _, _, measured in parts])
    return ContactPath(space, np.concatenate(values, axis=1), measured, contacts)
