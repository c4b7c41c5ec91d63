r"""Arcs of paths along an edge of their patch: their lengths, and whether they are pressed there.

A shortest path is held by an edge only where it would leave the patch if it could. There its
acceleration, as far as it is tangential to the surface and normal to the path, points out of the
patch: it is the multiplier of the constraint, which must have that sign all along the arc (the
conditions of Karush, Kuhn and Tucker).
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.geodesic.contact.joined import SolvedLeg
from bodymeasure.geodesic.contact.legs import Contact
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.spaces.quadrature import Quadrature
from bodymeasure.geodesic.surfaces.protocol import Surface

# The number of Gauss points of a piece of an arc, and of each half; their difference gives the
# error. Pieces that are not exact are halved, at most so often: beside a point where the speed
# changes sharply, only those there are.
POINTS, MOST_ROUNDS = 24, 40
# The relative rounding error of a length.
ROUNDING = 1e-15
# The angle by which an arc may bend inwards over its whole length: an edge that is a geodesic
# itself presses nothing, and must not be refused for rounding errors.
UNPRESSED = 1e-6
# Along the edge the parameter is a linear function.
DEGREE = 2


class EdgeArc(NamedTuple):
    """An arc, whether it is pressed against its edge all along, and whether nowhere it is."""

    solved: SolvedLeg
    is_pressed: bool
    is_geodesic: bool


def edge_arc(surface: Surface, contact: Contact, begin: Array, end: Array) -> EdgeArc:
    """Return the arc along an edge between two points, at constant speed in its parameter.

    Parameters
    ----------
    surface : Surface
        The surface of one problem.
    contact : Contact
        The edge.
    begin, end : ndarray, shape (2,)
        Points (u, v) on it.
    """
    space = polynomial_space(DEGREE)
    values = begin[:, None] + (end - begin)[:, None] * space.nodes
    values[:, -1] = end
    edges, rounds = np.array([0.0, 1.0]), 0
    while True:
        arcs = _halves(surface, contact, edges, begin, end)
        error = np.abs(arcs.whole - arcs.halves)
        total, rounds = arcs.halves.sum(), rounds + 1
        far = error > ROUNDING * total / len(error)
        if not far.any() or rounds == MOST_ROUNDS:
            break
        middles = (edges[1:] + edges[:-1])[far] / 2.0
        edges = np.sort(np.concatenate([edges, middles]))
    raw = np.array([total])
    length = Length(
        raw=raw,
        correction=np.zeros(1),
        error=2.0 * error.sum() + ROUNDING * raw,
        residual=np.zeros(1),
        index=np.zeros(1, np.int64),
        trusted=np.ones(1, bool),
    )
    pressed, geodesic = (bool((turn <= UNPRESSED).all()) for turn in (arcs.turn, np.abs(arcs.turn)))
    return EdgeArc(SolvedLeg(space, values, length), pressed, geodesic)


class _Halves(NamedTuple):
    """The lengths of pieces of an arc as wholes and as two halves, and how far it turns inwards."""

    whole: Array
    halves: Array
    turn: Array


def _halves(surface: Surface, contact: Contact, edges: Array, begin: Array, end: Array) -> _Halves:
    middles = (edges[1:] + edges[:-1]) / 2.0
    lengths = []
    for each in (edges, np.sort(np.concatenate([edges, middles]))):
        rule = Quadrature(each, POINTS)
        places = begin + rule.points[:, None] * (end - begin)
        jet = surface.jet(places[None], 2)[:, :, 0]
        velocity = jet[1] * (end - begin)[0] + jet[2] * (end - begin)[1]
        speed = np.sqrt((velocity * velocity).sum(axis=0))
        lengths.append((rule.weights * speed).reshape(len(middles), -1).sum(axis=1))
    whole, halves = lengths
    along = 1 - contact.axis
    turn = _inward_turn(
        jet[1 + contact.axis] * contact.inwards,
        jet[3 + 2 * along] * (end - begin)[along] ** 2,
        velocity,
    )
    return _Halves(whole, halves, turn)


def edge_curvatures(surface: Surface, contacts: Sequence[Contact], places: Array) -> Array:
    """Return the sizes of the geodesic curvatures of edges.

    Parameters
    ----------
    surface : Surface
        The patch of each edge.
    contacts : sequence of Contact
        The edges.
    places : ndarray, shape (edges, 2)
        Points (u, v) on them.
    """
    row, axis = np.arange(len(places)), np.array([contact.axis for contact in contacts])
    inwards = np.array([contact.inwards for contact in contacts])
    jet = surface.jet(places[:, None], 2)[:, :, :, 0]
    velocity = jet[2 - axis, :, row].T
    turn = _inward_turn(jet[1 + axis, :, row].T * inwards, jet[5 - 2 * axis, :, row].T, velocity)
    with np.errstate(divide="ignore", invalid="ignore"):
        curvature = np.abs(turn) / np.linalg.norm(velocity, axis=0)
    return np.asarray(np.nan_to_num(curvature))


def _inward_turn(across: Array, acceleration: Array, velocity: Array) -> Array:
    """The angles by which arcs turn into their patches for each unit of their parameters.

    All have shape (3, ...); what leads across an edge leads into the patch.
    """
    square = (velocity * velocity).sum(axis=0)
    # Where the edge stands still it has no turn.
    with np.errstate(divide="ignore", invalid="ignore"):
        inward = across - velocity * (across * velocity).sum(axis=0) / square
        inward /= np.sqrt((inward * inward).sum(axis=0))
        turn = (acceleration * inward).sum(axis=0) / np.sqrt(square)
    return np.asarray(np.nan_to_num(turn))
