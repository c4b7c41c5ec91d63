"""Edges of patches, and which patches share them."""

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array, Bools, Ints


class Edge(NamedTuple):
    """One side of a patch: its name, and the parameter that is fixed on it.

    The edge runs in the direction in which the other parameter grows.
    """

    name: str
    fixed_axis: int
    fixed_value: float


EDGES = (
    Edge("u = 0", 0, 0.0),
    Edge("u = 1", 0, 1.0),
    Edge("v = 0", 1, 0.0),
    Edge("v = 1", 1, 1.0),
)
# The parameter that is fixed on each side, and its value there.
AXIS = np.array([edge.fixed_axis for edge in EDGES])
VALUE = np.array([edge.fixed_value for edge in EDGES])
# Weights along a seam whose ratios differ by less, relatively, differ by rounding.
SAME_RATIO = 1e-12


@dataclass(frozen=True)
class EdgeTable:
    """The sides of all patches, grouped into distinct edges.

    Parameters
    ----------
    control_index : ndarray of int, shape (patches, 4, degree + 1)
        Numbers of the control points along each side (in the order of `EDGES`), in the direction of
        the growing parameter.
    edge : ndarray of int, shape (patches, 4)
        Number of the distinct edge that each side lies on.
    reversed : ndarray of bool, shape (patches, 4)
        Whether the side runs against its edge.
    sides : ndarray of int, shape (edges,)
        How many sides lie on each edge: 1 on a boundary, 2 on a seam, more where the atlas is not
        a manifold.
    """

    control_index: Ints
    edge: Ints
    reversed: Bools
    sides: Ints

    @property
    def collapsed(self) -> Bools:
        """Which sides have all their control points in one, shape (patches, 4)."""
        return np.asarray((self.control_index == self.control_index[:, :, :1]).all(axis=2))


def edge_table(index: Ints) -> EdgeTable:
    """Group the sides of patches by their control points, in either direction.

    Parameters
    ----------
    index : ndarray of int, shape (patches, degree + 1, degree + 1)
    """
    control_index = sides_of(index)
    rows = control_index.reshape(-1, index.shape[-1])
    backwards = rows[:, ::-1]
    # Lexicographic comparison of each side with its reverse: the first difference decides.
    difference = rows - backwards
    first = np.argmax(difference != 0, axis=1)
    is_reversed = difference[np.arange(len(rows)), first] > 0
    canonical = np.where(is_reversed[:, None], backwards, rows)
    _, edge, sides = np.unique(canonical, axis=0, return_inverse=True, return_counts=True)
    shape = control_index.shape[:2]
    return EdgeTable(
        control_index, edge.reshape(shape), is_reversed.reshape(shape), sides.astype(np.int64)
    )


def parameters_on_sides(side: Ints, along: Array) -> Array:
    """Return the parameters (k, 2) of places on sides."""
    x = np.empty((len(side), 2))
    rows = np.arange(len(side))
    x[rows, AXIS[side]], x[rows, 1 - AXIS[side]] = VALUE[side], along
    return x


def sides_of(nets: NDArray[Any]) -> NDArray[Any]:
    """Return the four sides of nets (patches, k, k, ...) in the order of `EDGES`.

    Their shape is (patches, 4, k, ...), and each runs with the growing parameter.
    """
    return np.stack([nets[:, 0], nets[:, -1], nets[:, :, 0], nets[:, :, -1]], axis=1)


def weights_differ(first: Array, second: Array) -> Bools:
    """Return whether weights along edges, shape (..., k), are not proportional to others."""
    # Weights may be of many magnitudes; logarithms of their quotients are not.
    quotient = np.log(first) - np.log(second)
    return np.asarray(np.ptp(quotient, axis=-1) > SAME_RATIO)
