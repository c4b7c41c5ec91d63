"""The exact paths that polygons at rest stand for: geodesics, or paths along edges."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.geodesic.contact.degrees import LOWER_DEGREES, degrees_wanted, leave_for_certain
from bodymeasure.geodesic.contact.joined import ContactPath
from bodymeasure.geodesic.contact.legs import End, Pole
from bodymeasure.geodesic.contact.solve import solve_contact_paths
from bodymeasure.geodesic.elements.rival import Rival
from bodymeasure.geodesic.elements.solve import solve_elements
from bodymeasure.geodesic.lengths.coincident import TIMES
from bodymeasure.geodesic.lengths.measure import measure_length
from bodymeasure.geodesic.shortest.descent import descend
from bodymeasure.geodesic.shortest.polygon_energy import polygon_lengths
from bodymeasure.geodesic.solving.newton import newton
from bodymeasure.geodesic.solving.protocol import PathBatch
from bodymeasure.geodesic.spaces.polynomials import polynomial_space
from bodymeasure.geodesic.surfaces.protocol import Surface

# The most Newton steps on each space: polygons are so near their paths that those that converge do
# so in fewer.
MOST_STEPS = 8
# A path may leave its patch by this much, in u or v: more than rounding errors of a path along the
# edge, less than anything that could be measured.
OUTSIDE = 1e-9
# A path that is further than this from its polygon, in u or v, is not the one it stands for.
MAX_DISTANCE = 0.1
# An edge of at most this length, on a patch of size 1, is a point except for rounding errors.
COLLAPSED = 1e-14
# An edge as short as this part of the error that is asked for is a point as well: paths from its
# points differ in length by no more than the edge is long, which is added to their error.
SMALL = 0.1
# A generous bound of the rounding errors of lengths, relative to them.
ROUNDING = 1e-9
# Each leg of a path is known to the tolerance, in parts of its own length; so is the whole. The
# errors of joints come to that.
PARTS = 2.0
# Points of a polygon this close to an edge, in u or v, are taken to be on it: nothing presses them
# to an edge that is a geodesic itself, and rounding errors would decide which of them touch it.
TOUCHING = 1e-12
# The number of edges of the polygons whose pattern of contacts is read.
FINE_EDGES = 64


class ExactPaths(NamedTuple):
    """The paths that polygons stand for, as far as they were found.

    Parameters
    ----------
    batches : tuple of PathBatch
        The paths; their problems are the polygons' numbers.
    unsolved : ndarray, shape (polygons,)
        Lengths that the paths that were not found do not fall below, and infinity for the others.
    """

    batches: tuple[PathBatch, ...]
    unsolved: Array


def exact_paths(
    surface: Surface,
    polygons: Array,
    known: Array,
    curves: Sequence[Callable[[], Array]],
    tolerance: float,
) -> ExactPaths:
    """Find the exact paths near polygons at rest.

    Paths of polygons that touch no edge are solved by collocation, all at once. The others, and
    those for which that fails, are solved leg by leg, with their contacts read from finer polygons,
    and if that fails, too, as paths made of elements.

    Parameters
    ----------
    surface : Surface
    polygons : ndarray, shape (polygons, m + 1, 2)
        As `descend` returns them.
    known : ndarray, shape (polygons,)
        The lengths of other paths; longer ones are not wanted.
    curves : sequence of callables
        For each polygon, what returns the other path, (u, v) at equal distances, shape (k + 1, 2);
        NaN if that is no minimum, or there is none. Few are asked.
    tolerance : float
        Relative error asked for.
    """
    poles, widths = zip(
        *(_poles(surface, polygons[:, place], tolerance) for place in (0, -1)), strict=True
    )
    touches = ((polygons <= 0.0) | (polygons >= 1.0))[:, 1:-1].any(axis=(1, 2))
    fixed = np.array([pole is None and other is None for pole, other in zip(*poles, strict=True)])
    batches = _collocated(surface, polygons, np.flatnonzero(~touches & fixed), tolerance)
    left = _without(np.arange(len(polygons)), batches)
    unsolved = np.full(len(polygons), np.inf)
    if len(left) == 0:
        return ExactPaths(tuple(batches), unsolved)
    part = surface.take(left)
    fine = _on_edges(descend(part, _refined(polygons[left], FINE_EDGES)))
    least = polygon_lengths(part, fine)
    every_ends = [(poles[0][row], poles[1][row]) for row in left]
    paths = solve_contact_paths(part, [*fine], every_ends, tolerance)
    for row, path, ends, shortest in zip(left, paths, every_ends, least, strict=True):
        if path is None or not _is_good(path, shortest, tolerance):
            own = surface.take(np.array([row]))
            rival = Rival(float(known[row]), own.jet(curves[row]()[None], 0)[0, :, 0].T)
            path, reached = solve_elements(
                own, polygons[row], ends, tolerance=tolerance, rival=rival
            )
            if path is None:
                unsolved[row] = max(shortest, reached)
        if path is not None:
            batches.append(_as_batch(row, path, widths[0][row] + widths[1][row]))
    return ExactPaths(tuple(batches), unsolved)


def _is_good(path: ContactPath, shortest: float, tolerance: float) -> bool:
    """Whether the length of a path is known, and not shorter than the shortest polygon."""
    known = path.length.is_known_to(PARTS * tolerance)[0]
    return bool(known and path.length.raw[0] >= shortest * (1.0 - ROUNDING))


def _poles(surface: Surface, points: Array, tolerance: float) -> tuple[list[End], Array]:
    """The collapsed edges on which points, shape (polygons, 2), lie, and these edges' lengths."""
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


def _collocated(surface: Surface, polygons: Array, rows: Ints, tolerance: float) -> list[PathBatch]:
    """The paths of some polygons without contact, each on the first space that serves."""
    times = np.linspace(0.0, 1.0, polygons.shape[1])
    batches: list[PathBatch] = []
    every, wanted = rows, np.zeros(len(polygons))
    for degree in LOWER_DEGREES:
        rows = _without(every, batches)
        rows = rows[wanted[rows] <= degree]
        if len(rows) == 0:
            continue
        space = polynomial_space(degree)
        start = (_spline(degree, polygons.shape[1]) @ polygons[rows]).swapaxes(1, 2)
        part = surface.take(rows)
        found = newton(part, space, start, max_iterations=MOST_STEPS)
        length = measure_length(part, space, found.values)
        path = (found.values @ space.matrices(times)[0].T).swapaxes(1, 2)
        exact = found.converged & length.is_known_to(tolerance)
        gone = exact & leave_for_certain(space, found.values, length)
        good = exact & ~space.leaves_patch(found.values, OUTSIDE)
        good &= np.abs(path - polygons[rows]).max(axis=(1, 2)) <= MAX_DISTANCE
        batch = PathBatch(rows, space, found.values, length, good, found.singular)
        batches.append(batch.take(np.flatnonzero(good)))
        next_degrees = degrees_wanted(degree, length, tolerance)
        wanted[rows] = np.where(found.converged, next_degrees, degree + 1)
        wanted[rows[gone]] = np.inf
    return batches


@lru_cache(maxsize=16)
def _spline(degree: int, vertices: int) -> Array:
    """The matrix from a polygon's vertices to a smooth path at a polynomial space's nodes."""
    times = np.linspace(0.0, 1.0, vertices)
    nodes = polynomial_space(degree).nodes
    from scipy.interpolate import CubicSpline  # A slow import.

    return np.asarray(CubicSpline(times, np.eye(vertices))(nodes))


def _without(rows: Ints, batches: list[PathBatch]) -> Ints:
    """The rows of polygons whose paths were not found yet."""
    return np.setdiff1d(rows, np.concatenate([rows[:0], *(batch.problems for batch in batches)]))


def _refined(polygons: Array, edges: int) -> Array:
    """The same polygons with another number of edges."""
    old, new = np.linspace(0.0, 1.0, polygons.shape[1]), np.linspace(0.0, 1.0, edges + 1)
    result: Array = np.stack([np.interp(new, old, row) for row in np.eye(len(old))], 1) @ polygons
    return result


def _on_edges(polygons: Array) -> Array:
    """The polygons, with the inner points that almost touch an edge put onto it."""
    result = polygons.copy()
    inner = result[:, 1:-1]
    inner[inner < TOUCHING] = 0.0
    inner[inner > 1.0 - TOUCHING] = 1.0
    return result


def _as_batch(row: np.int64, found: ContactPath, error: float) -> PathBatch:
    """The path of one polygon, with something added to its error."""
    return PathBatch(
        problems=np.array([row]),
        space=found.space,
        values=found.values[None],
        length=replace(found.length, error=found.length.error + error),
        converged=np.ones(1, bool),
        singular=np.zeros(1, bool),
        contacts=found.contacts,
    )
