"""Derivatives of tapes along the skin, and of those drawn taut from point to point."""

from itertools import pairwise

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.bezier import derivatives
from bodymeasure.chart.body import Body
from bodymeasure.chart.kinds.base import Measured
from bodymeasure.chart.kinds.surface.closed import ClosedMeasure
from bodymeasure.chart.kinds.surface.path import PathMeasure
from bodymeasure.chart.landmarks.paths import leg_between
from bodymeasure.chart.tapes import TapeKind
from bodymeasure.geodesic import AtlasPath
from bodymeasure.geodesic.across.pieces.part import PathPiece
from bodymeasure.make.gradient.chain import bends
from bodymeasure.make.gradient.pull import Pull
from bodymeasure.measure import closed_geodesic

# Gauss nodes on each piece of a path, on which the integrand is smooth.
NODES = 24


def pull_leg(pull: Pull, path: AtlasPath, names: tuple[str, str] | None) -> None:
    """Add the derivatives of the length of a geodesic.

    Parameters
    ----------
    pull : Pull
    path : AtlasPath
    names : (str, str), optional
        The landmarks at its ends; a closed geodesic has none.

    Notes
    -----
    On each piece, the length changes by the integral of the tangent times the slope of the skin's
    movement along the path; where it ends at a landmark that moves in another way than the skin, by
    the tangent times the difference.
    """
    nodes, shares = np.polynomial.legendre.leggauss(NODES)
    times = 0.5 + 0.5 * nodes
    pieces = [piece for piece in path.pieces if piece.length > 0.0]
    for piece in pieces:
        at, slopes, tangents = _along(path, piece, times)
        patch = np.full(len(at), piece.patch)
        for axis, order in enumerate(((1, 0), (0, 1))):
            pull.skin(patch, at, 0.5 * (shares * slopes[:, axis])[:, None] * tangents, order)
    if names is None or not pieces:
        return
    for name, piece, time, sign in (
        (names[0], pieces[0], 0.0, -1.0),
        (names[1], pieces[-1], 1.0, 1.0),
    ):
        at, _, tangents = _along(path, piece, np.array([time]))
        pull.at(name, sign * tangents[0])
        pull.skin(np.array([piece.patch]), at, -sign * tangents)


def _along(path: AtlasPath, piece: PathPiece, times: Array) -> tuple[Array, Array, Array]:
    """Return parameters, their slopes and unit tangents at some fractions of a piece."""
    at, slopes = piece.space.matrices(times)[:2] @ piece.values.T
    at = np.clip(at, 0.0, 1.0)
    jet = derivatives(path.atlas.control_points[piece.patch], at, order=1)
    velocity = slopes[:, :1] * jet[:, 1, 0] + slopes[:, 1:] * jet[:, 0, 1]
    return at, slopes, velocity / np.linalg.norm(velocity, axis=1, keepdims=True)


def pull_path(pull: Pull, body: Body, found: Measured, definition: PathMeasure) -> None:
    """Add the derivatives of the length of a path through landmarks."""
    if definition.tape == "taut":
        _pull_taut(pull, body, found, definition)
        return
    for names in pairwise(definition.through):
        path = leg_between(body.atlas, *(body.point(name) for name in names))
        pull_leg(pull, path, names)


def pull_closed(pull: Pull, body: Body, found: Measured, definition: ClosedMeasure) -> None:  # noqa: ARG001
    """Add the derivatives of the length of a closed geodesic, wherever it was laid."""
    path = closed_geodesic(body.atlas, body.point(definition.at), on_failure="status")
    pull_leg(pull, path, None)


def _pull_taut(pull: Pull, body: Body, found: Measured, definition: PathMeasure) -> None:
    tape = next(tape for tape in found.tapes if tape.kind is TapeKind.TAUT)
    weights = bends(tape.points)
    held = [
        int(np.linalg.norm(tape.points - body.position(name), axis=1).argmin())
        for name in definition.through
    ]
    # A tape that returns to its start is held at both of its ends.
    held[0], held[-1] = 0, len(weights) - 1
    for name, node in zip(definition.through, held, strict=True):
        pull.at(name, weights[node])
    touching = np.asarray(tape.normals.any(axis=1))
    touching[held] = False
    rows = np.flatnonzero(touching)
    if len(rows):
        points, _ = closest_points(body.atlas, tape.points[rows])
        patch = np.array([point.patch for point in points])
        parameters = np.array([[point.u, point.v] for point in points])
        pull.skin(patch, parameters, weights[rows])
