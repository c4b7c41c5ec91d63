"""The length of a path made of elements, its error, and where that comes from."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.geodesic.elements.index import path_index
from bodymeasure.geodesic.elements.joints import joint_errors
from bodymeasure.geodesic.elements.path import ElementPath
from bodymeasure.geodesic.elements.pieces import pieces_of
from bodymeasure.geodesic.lengths.length import Length
from bodymeasure.geodesic.surfaces.protocol import Surface

# Where more of a path than this part of its length is rough, nothing is known: the surface is
# singular all along it, as one that is collapsed to a line.
MOST_ROUGH = 0.1


class ElementLength(NamedTuple):
    """The length of a path made of elements, a batch of one, and what is known of its parts.

    Parameters
    ----------
    length : Length
        Its residual is the largest geodesic curvature of an element, times the element's length.
    lengths : ndarray, shape (elements,)
        The length of each element.
    error : ndarray, shape (elements,)
        The error that each element makes, with half of that of its joints.
    bend : ndarray, shape (elements, points)
        The size of the geodesic curvature at the quadrature points, times the speed.
    """

    length: Length
    lengths: Array
    error: Array
    bend: Array


def measure_elements(surface: Surface, path: ElementPath, held: Bools) -> ElementLength:
    """Return the length of a path and its error.

    Parameters
    ----------
    surface : Surface
        The surface of one problem.
    path : ElementPath
    held : ndarray of bool, shape (elements, 2, DEGREE + 1)
        The coordinates of the nodes that their bounds hold.
    """
    pieces = pieces_of(surface, path, held)
    joints, free = joint_errors(surface, pieces, held)
    error = pieces.error
    error[:-1] += 0.5 * joints
    error[1:] += 0.5 * joints
    rough = pieces.lengths[pieces.rough].sum()
    known = bool(np.isfinite(error.sum()) and rough <= MOST_ROUGH * pieces.lengths.sum())
    residual = np.nan_to_num(np.where(pieces.smooth, pieces.single.residual, 0.0))
    length = Length(
        raw=np.array([pieces.lengths.sum()]),
        correction=np.array([pieces.correction.sum() if known else 0.0]),
        error=np.array([error.sum() if known else np.inf]),
        residual=np.array([residual.max()]),
        index=np.array([path_index(pieces, free)]),
        trusted=np.array([known]),
    )
    bend = np.abs(pieces.kappa * pieces.speed).T
    return ElementLength(length, pieces.lengths, error, bend)
