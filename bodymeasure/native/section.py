"""Points on the pieces of plane sections, compiled."""

import ctypes
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.native.library import address, doubles, kernels


class _SectionPieces(ctypes.Structure):
    """`SectionPieces` of ``section_points.cpp``."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("count", "points", "side", "coordinates")),
        *((name, ctypes.c_void_p) for name in ("patch", "axis", "start", "span", "low", "high")),
        *((name, ctypes.c_void_p) for name in ("fraction", "nets", "distances", "normal")),
    )


class CutPatches(NamedTuple):
    """Patches and the plane that cuts them; see `section.pieces.CutSurface`.

    Parameters
    ----------
    nets : ndarray, shape (patches, m + 1, m + 1, 3 or 4)
        Of degrees up to `MOST_DEGREE`.
    distances : ndarray, shape (patches, m + 1, m + 1)
    normal : ndarray, shape (3,)
    """

    nets: Array
    distances: Array
    normal: Array


class Graphs(NamedTuple):
    """Pieces of a section, of shape (k,) each; see `section.pieces.Pieces`."""

    patch: Ints
    axis: Ints
    start: Array
    span: Array
    low: Array
    high: Array


def section_points(
    patches: CutPatches, graphs: Graphs, fraction: Array
) -> tuple[Array, Array, Array]:
    """Return parameters (k, n, 2), positions and velocities (k, n, 3) at fractions (k, n)."""
    nets, distances, normal, fraction = doubles(*patches, fraction)
    patch, axis = (np.ascontiguousarray(each, np.int64) for each in graphs[:2])
    start, span, low, high = doubles(*graphs[2:])
    count, points = fraction.shape
    result = np.empty((count, points, 2)), *np.empty((2, count, points, 3))
    pieces = _SectionPieces(
        count,
        points,
        *nets.shape[2:],
        *map(address, (patch, axis, start, span, low, high, fraction, nets, distances, normal)),
    )
    kernels().bodymeasure_section_points(ctypes.byref(pieces), *map(address, result))
    return result
