"""A tensor product B-spline surface cut into its Bezier patches."""

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import LARGEST_DEGREE, FileFaces
from bodymeasure.atlas.faces import rectangles
from bodymeasure.bezier import BezierPieces, bezier_pieces, restrict
from bodymeasure.errors import InputError

# An end of the wanted part that is this close to a knot, as a part of the surface's range, is that
# knot up to rounding.
ROUNDING = 1e-5


class DegreeError(InputError):
    """A surface is of a degree that cannot be read; the others of its file can."""


class SplinePatches(NamedTuple):
    """The patches of a surface.

    Parameters
    ----------
    nets, weights : list of ndarray, each of shape (m + 1, n + 1, 3) and (m + 1, n + 1)
        One for each patch; those along v follow each other.
    corners : ndarray, shape (patches, 3, 2)
        The parameters of the surface at (0, 0), (1, 0) and (0, 1) on each patch.
    """

    nets: list[Array]
    weights: list[Array]
    corners: Array


def spline_patches(
    points: Array,
    weights: Array,
    degrees: tuple[int, int],
    knots: tuple[Array, Array],
    ranges: Sequence[tuple[float, float]] | None = None,
) -> SplinePatches:
    """Return the Bezier patches of a B-spline surface, rational or not.

    Parameters
    ----------
    points : ndarray, shape (rows, columns, 3)
        Control points; u runs along the first axis.
    weights : ndarray, shape (rows, columns)
        They are equal if the surface is not rational.
    degrees : tuple of int
        In u and v.
    knots : tuple of ndarray
        In u and v, with all repetitions at the ends.
    ranges : sequence of tuple of float, optional
        Start and end in u and in v, if only that part of the surface is wanted.

    Returns
    -------
    SplinePatches

    Raises
    ------
    DegreeError
        If a degree is above 9.
    InputError
        If the knots or the range of a direction are wrong.
    """
    if max(degrees) > LARGEST_DEGREE:
        raise DegreeError(
            f"has the degrees {degrees[0]} and {degrees[1]}; only degrees up to {LARGEST_DEGREE} "
            "can be read; reduce the degree where it was made"
        )
    # Files may hold many thousands of surfaces that are patches already.
    own = tuple(map(_range_of_one_piece, degrees, (vector.tobytes() for vector in knots)))
    is_net = points.shape[:2] == (degrees[0] + 1, degrees[1] + 1) and None not in own
    if is_net and (ranges is None or own == tuple(ranges)):
        return SplinePatches([points], [weights], _corners_of_one(own))
    is_rational = bool((weights != weights.flat[0]).any())
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        factor = weights[..., None]
        net = np.concatenate([points * factor, factor], axis=-1) if is_rational else points
        along_u = _pieces(net, degrees[0], knots[0], "u")
        along_v = _pieces(along_u.control_points.transpose(2, 0, 1, 3), degrees[1], knots[1], "v")
        nets = along_v.control_points.transpose(2, 0, 3, 1, 4)
        breaks = along_u.breaks, along_v.breaks
        if ranges is not None:
            nets, breaks = _clipped(nets, breaks, ranges)
        corners = rectangles(*breaks)
        patches = nets.reshape(-1, *nets.shape[2:])
        if is_rational:
            places = list(patches[..., :3] / patches[..., 3:])
            return SplinePatches(places, list(patches[..., 3]), corners)
    same = np.broadcast_to(weights.flat[0], patches.shape[:-1])
    return SplinePatches(list(patches), list(same), corners)


@lru_cache(maxsize=64)
def _corners_of_one(ranges: tuple[tuple[float, float], ...]) -> Array:
    start, end = (np.array([each]) for each in ranges)
    corners = rectangles(start, end)
    corners.flags.writeable = False
    return corners


@lru_cache(maxsize=64)
def _range_of_one_piece(degree: int, knot_bytes: bytes) -> tuple[float, float] | None:
    """Return where a spline begins and ends, if it is a single Bezier piece as it stands."""
    start, *inner, end = np.frombuffer(knot_bytes).tolist()
    if start < end and inner == [start] * degree + [end] * degree:
        return start, end
    return None


def _pieces(net: Array, degree: int, knots: Array, direction: str) -> BezierPieces:
    try:
        return bezier_pieces(net, degree, knots)
    except InputError as error:
        raise InputError(f"in {direction}: {error}") from None


@lru_cache(maxsize=64)
def clamped_knots(degree: int, breaks: tuple[float, ...]) -> Array:
    """Return the knots of successive Bezier pieces: each `degree` times, the ends once more."""
    times = np.full(len(breaks), degree)
    times[[0, -1]] += 1
    knots = np.repeat(breaks, times)
    knots.flags.writeable = False
    return knots


def _clipped(
    nets: Array, breaks: tuple[Array, Array], ranges: Sequence[tuple[float, float]]
) -> tuple[Array, tuple[Array, Array]]:
    """The part of patches (pieces_u, pieces_v, m + 1, n + 1, k) in a rectangle, and its breaks."""
    kept, lower, upper, inner = [], [], [], []
    for direction, pieces, (start, end) in zip("uv", breaks, ranges, strict=True):
        start, end = (_rounded(pieces, bound) for bound in (start, end))
        if not pieces[0, 0] <= start < end <= pieces[-1, 1]:
            raise InputError(
                f"in {direction}: the range from {start:g} to {end:g} is not inside the "
                f"surface's from {pieces[0, 0]:g} to {pieces[-1, 1]:g}"
            )
        inside = (pieces[:, 1] > start) & (pieces[:, 0] < end)
        begin, size = pieces[inside, 0], np.diff(pieces[inside])[:, 0]
        kept.append(inside)
        inner.append(np.clip(pieces[inside], start, end))
        lower.append((np.maximum(begin, start) - begin) / size)
        upper.append((np.minimum(pieces[inside, 1], end) - begin) / size)
    nets = nets[kept[0]][:, kept[1]]
    corner = np.stack(np.meshgrid(*lower, indexing="ij"), axis=-1)
    opposite = np.stack(np.meshgrid(*upper, indexing="ij"), axis=-1)
    cut = (corner != 0.0).any(axis=-1) | (opposite != 1.0).any(axis=-1)
    if cut.any():
        nets = nets.copy()
        nets[cut] = restrict(nets[cut], corner[cut], opposite[cut])
    return nets, (inner[0], inner[1])


def _rounded(pieces: Array, bound: float) -> float:
    """The end of a piece from which a bound differs by rounding, or the bound itself."""
    ends = np.append(pieces[:, 0], pieces[-1, 1])
    nearest = float(ends[np.abs(ends - bound).argmin()])
    return nearest if abs(nearest - bound) <= ROUNDING * (ends[-1] - ends[0]) else bound


def notes_of_refused(refused: Sequence[str], source: str, *, any_read: bool) -> list[str]:
    """Return notes that surfaces are left out; `refused` says of each where it is and why.

    Raises
    ------
    InputError
        If no other surface of the file was read.
    """
    if refused and not any_read:
        raise InputError(f"{source}, {refused[0]}")
    return [f"{each}; it is left out" for each in dict.fromkeys(refused)]


def faces_of_surfaces(
    places: Sequence[str], corners: Sequence[Array], without: Mapping[str, str]
) -> FileFaces:
    """Return the faces that surfaces are.

    Parameters
    ----------
    places : sequence of str
        The place of each patch in the file, by which its surface is named.
    corners : sequence of ndarray
        Those of `SplinePatches` for each surface.
    without : mapping of str to str
        The names of surfaces without parameters, and why they have none.
    """
    names = tuple("" if place in without else place for place in places)
    return FileFaces(names, np.concatenate(corners) if corners else np.empty((0, 3, 2)), without)
