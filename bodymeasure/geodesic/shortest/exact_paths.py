"""Polygons at rest made exact: the geodesic that each stands for, or the path along edges."""

from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.contact.degrees import DEGREES, degrees_wanted, leave_for_certain
from bodymeasure.geodesic.contact.joined import ContactPath
from bodymeasure.geodesic.contact.legs import End, Pole
from bodymeasure.geodesic.contact.solve import solve_contact_path
from bodymeasure.geodesic.lengths.coincident import TIMES
from bodymeasure.geodesic.lengths.measure import measure_length
from bodymeasure.geodesic.shortest.descent import descend
from bodymeasure.geodesic.shortest.polygon_energy import polygon_lengths
from bodymeasure.geodesic.solving.newton import newton
from bodymeasure.geodesic.solving.protocol import Piece
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.protocol import Surface

# Newton steps on each: polygons are near enough that those that converge do so in fewer.
MOST_STEPS = 8
# A path may leave its patch by this much, in u or v: more than rounding errors of a path along the
# edge, less than anything that could be measured.
OUTSIDE = 1e-9
# A path that is further than this from its polygon, in u or v, is another than was meant.
ASTRAY = 0.1
# An edge this long, on a patch of size 1, is a point but for rounding errors.
COLLAPSED = 1e-14
# And so it is if it is this part of the error that is asked for: paths from its points differ in
# length by no more than it is long, which is added to their error.
SMALL = 0.1
# Rounding errors of lengths, relative, generously.
ROUNDING = 1e-9
# Points of a polygon this close to an edge, in u or v, are on it: where the edge is a geodesic
# itself nothing presses them, and rounding errors would tell which of them touch.
TOUCHING = 1e-12
# Edges of the polygons whose pattern of contacts is read, in turn.
FINE_EDGES = (64, 256)


class Polished(NamedTuple):
    """What became of polygons.

    Parameters
    ----------
    pieces : tuple of Piece
        Paths; their problems are the polygons' numbers.
    doubt : ndarray, shape (polygons,)
        The least length of a path that was not found; infinite where it was.
    """

    pieces: tuple[Piece, ...]
    doubt: Array


def polish(surface: Surface, polygons: Array, tolerance: float) -> Polished:
    """Exact paths near polygons at rest.

    Those that touch no edge are solved by collocation, all at once; the others, and those for which
    that fails, leg by leg, with their contacts read from finer polygons.

    Parameters
    ----------
    surface : Surface
    polygons : ndarray, shape (polygons, m + 1, 2)
        As `descend` returns them.
    tolerance : float
        Relative error asked for.
    """
    poles, doubts = zip(
        *(_poles(surface, polygons[:, place], tolerance) for place in (0, -1)), strict=True
    )
    touches = ((polygons <= 0.0) | (polygons >= 1.0))[:, 1:-1].any(axis=(1, 2))
    fixed = np.array([pole is None and other is None for pole, other in zip(*poles, strict=True)])
    pieces = _collocated(surface, polygons, np.flatnonzero(~touches & fixed), tolerance)
    left = _without(np.arange(len(polygons)), pieces)
    doubt = np.full(len(polygons), np.inf)
    for edges in FINE_EDGES:
        if len(left) == 0:
            break
        part = surface.take(left)
        fine = _on_edges(descend(part, _refined(polygons[left], edges)))
        length = polygon_lengths(part, fine)
        doubt[left] = length
        for row, polygon, least in zip(left, fine, length, strict=True):
            own = surface.take(np.array([row]))
            path = solve_contact_path(own, polygon, (poles[0][row], poles[1][row]), tolerance)
            # No path is shorter than the shortest polygon.
            if path is not None and path.measured.raw[0] >= least * (1.0 - ROUNDING):
                pieces.append(_as_piece(row, path, doubts[0][row] + doubts[1][row]))
                doubt[row] = np.inf
        left = _without(left, pieces)
    return Polished(tuple(pieces), doubt)


def _poles(surface: Surface, points: Array, tolerance: float) -> tuple[list[End], Array]:
    """Of points, shape (polygons, 2), the collapsed edges that they lie on, and their lengths."""
    result: list[End] = [None] * len(points)
    length = np.zeros(len(points))
    for axis in (0, 1):
        for value in (0.0, 1.0):
            here = np.flatnonzero(points[:, axis] == value)
            edge = np.full((len(here), len(TIMES), 2), value)
            edge[:, :, 1 - axis] = TIMES
            speeds = np.linalg.norm(surface.take(here).jet(edge, 1)[2 - axis], axis=0)
            for row, speed in zip(here, speeds.max(axis=1, initial=0.0), strict=True):
                if speed <= max(COLLAPSED, SMALL * tolerance):
                    result[row], length[row] = Pole(axis, value), max(COLLAPSED, speed)
    return result, length


def _collocated(surface: Surface, polygons: Array, rows: Ints, tolerance: float) -> list[Piece]:
    """Paths of some of the polygons that have no contact, each on the first space that serves."""
    times = np.linspace(0.0, 1.0, polygons.shape[1])
    pieces: list[Piece] = []
    every, wanted = rows, np.zeros(len(polygons))
    for degree in DEGREES:
        rows = _without(every, pieces)
        rows = rows[wanted[rows] <= degree]
        if len(rows) == 0:
            continue
        space = polynomial_space(degree)
        start = (_spline(degree, polygons.shape[1]) @ polygons[rows]).swapaxes(1, 2)
        part = surface.take(rows)
        found = newton(part, space, start, max_iterations=MOST_STEPS)
        measured = measure_length(part, space, found.values)
        path = (found.values @ space.matrices(times)[0].T).swapaxes(1, 2)
        exact = found.converged & measured.is_known_to(tolerance)
        gone = exact & leave_for_certain(space, found.values, measured)
        good = exact & ~space.leaves_patch(found.values, OUTSIDE)
        good &= np.abs(path - polygons[rows]).max(axis=(1, 2)) <= ASTRAY
        piece = Piece(rows, space, found.values, measured, good, found.singular)
        pieces.append(piece.take(np.flatnonzero(good)))
        next_degrees = degrees_wanted(degree, measured, tolerance)
        wanted[rows] = np.where(found.converged, next_degrees, degree + 1)
        wanted[rows[gone]] = np.inf
    return pieces


@lru_cache(maxsize=16)
def _spline(degree: int, vertices: int) -> Array:
    """From a polygon's vertices to a smooth path at the nodes of a polynomial space."""
    times = np.linspace(0.0, 1.0, vertices)
    nodes = polynomial_space(degree).nodes
    return np.asarray(CubicSpline(times, np.eye(vertices))(nodes))


def _without(rows: Ints, pieces: list[Piece]) -> Ints:
    """Those rows that have no piece yet."""
    return np.setdiff1d(rows, np.concatenate([rows[:0], *(piece.problems for piece in pieces)]))


def _refined(polygons: Array, edges: int) -> Array:
    """Polygons with another number of edges."""
    old, new = np.linspace(0.0, 1.0, polygons.shape[1]), np.linspace(0.0, 1.0, edges + 1)
    result: Array = np.stack([np.interp(new, old, row) for row in np.eye(len(old))], 1) @ polygons
    return result


def _on_edges(polygons: Array) -> Array:
    """Polygons whose points all but on an edge are on it; the ends stay."""
    result = polygons.copy()
    inner = result[:, 1:-1]
    inner[inner < TOUCHING] = 0.0
    inner[inner > 1.0 - TOUCHING] = 1.0
    return result


def _as_piece(row: np.int64, found: ContactPath, doubt: float) -> Piece:
    """The path of one polygon; `doubt` is added to its error."""
    measured = replace(found.measured, error=found.measured.error + doubt)
    return Piece(
        problems=np.array([row]),
        space=found.space,
        values=found.values[None],
        measured=measured,
        converged=np.ones(1, bool),
        singular=np.zeros(1, bool),
        contacts=found.contacts,
    )
