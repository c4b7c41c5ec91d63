"""The scenes that pictures and windows show, as plain arrays."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.chart import TapeKind
from bodymeasure.mesh.tubes import Mesh


class PathKind(Enum):
    """A state of a path's length; the value is its caption in a legend."""

    COMPARED = "difference from libigl exact"
    NOT_COMPARED = "length not compared"
    NO_LENGTH = "no length"


@dataclass(frozen=True)
class Surface:
    """Triangles of a tessellated atlas.

    Parameters
    ----------
    points : ndarray, shape (n, 3)
        Vertices, in the atlas's unit; each patch has its own.
    normals : ndarray, shape (n, 3)
        Unit normals at the vertices, of either orientation.
    triangles : ndarray of int, shape (m, 3)
    patch : ndarray of int, shape (m,)
        Number of the patch that each triangle is part of.
    faded : ndarray of bool, shape (n,)
        Whether a vertex belongs to the surroundings of what is shown, to be drawn paler.
    """

    points: Array
    normals: Array
    triangles: Ints
    patch: Ints
    faded: Bools


@dataclass(frozen=True)
class Polylines:
    """Curves on a surface.

    Parameters
    ----------
    points : ndarray, shape (n, k, 3)
        Points along each curve, in the atlas's unit; NaN where a curve has a gap.
    normals : ndarray, shape (n, k, 3)
        Unit normals of the surface there, to lift a curve off the surface by.
    """

    points: Array
    normals: Array


@dataclass(frozen=True)
class Paths:
    """Diagonal paths, and what to color them by.

    Parameters
    ----------
    lines : Polylines
        One curve a path.
    patch, diagonal : ndarray of int, shape (n,)
        Number of the patch, and which of its diagonals: 0 runs from (0, 0) to (1, 1), 1 from
        (1, 0) to (0, 1).
    kind : ndarray of PathKind, shape (n,)
    value : ndarray, shape (n,)
        Relative difference from libigl exact, without its sign; NaN unless the kind is COMPARED.
    """

    lines: Polylines
    patch: Ints
    diagonal: Ints
    kind: NDArray[np.object_]
    value: Array


@dataclass(frozen=True)
class Label:
    """A short text at a point of space."""

    position: Array
    text: str


@dataclass(frozen=True)
class BodyScene:
    """A measured body, or a part of it, ready to be drawn.

    Parameters
    ----------
    surface : Surface
    edges : Polylines
        Edges of patches, each seam once.
    faded_edges : Polylines
        Edges of the surroundings, to be drawn paler.
    paths : Paths
    labels : tuple of Label
    """

    surface: Surface
    edges: Polylines
    faded_edges: Polylines
    paths: Paths
    labels: tuple[Label, ...] = ()


class TapeTube(NamedTuple):
    """A tape as a tube of any width.

    Parameters
    ----------
    base, offset : ndarray, shape (n, 3)
        At a radius r of contact tapes, the vertices are ``base + r * offset``.
    mesh : Mesh
        Normals, triangles and colors.
    """

    base: Array
    offset: Array
    mesh: Mesh


@dataclass(frozen=True, eq=False)
class TapeLine:
    """A tape as it is drawn: a curve of evenly spaced points.

    Parameters
    ----------
    number : int
        The number of its measurement in the pictures.
    key, group : str
        Key and group of its measurement.
    kind : TapeKind
    points : ndarray, shape (k, 3)
        In the atlas's unit; a closed tape ends at its first point.
    normals : ndarray, shape (k, 3)
        Vectors away from the body: of length 1 where the tape lies on it, 0 where it stands free.
    lift : ndarray, shape (k, 3)
        The same vectors, interpolated where the tape stands free, and smoothed.
    tube : TapeTube
    """

    number: int
    key: str
    group: str
    kind: TapeKind
    points: Array
    normals: Array
    lift: Array
    tube: TapeTube

    @property
    def free(self) -> Bools:
        """Whether the tape stands free of the body at its points, shape (k,)."""
        return free_of_body(self.normals)

    @property
    def through_body(self) -> bool:
        """Whether the tape runs straight through the body, and is drawn over it."""
        return self.kind is TapeKind.STRAIGHT


def free_of_body(normals: Array) -> Bools:
    """Find where a tape with some normals, shape (k, 3), stands free of the body, shape (k,)."""
    return np.asarray(np.linalg.norm(normals, axis=-1) < 0.5)


@dataclass(frozen=True, eq=False)
class TapeScene:
    """A body with the tapes of its measurements, ready to be drawn.

    Parameters
    ----------
    surface : Surface
    size : float
        The body's extent upwards, or a fraction of its largest extent if it is flat. The widths of
        tapes are fractions of it.
    numbers : mapping of str to int
        Number of each measurement that has a value, by its key.
    tapes : tuple of TapeLine
        In the order of their numbers.
    landmarks : mapping of str to tuple of Label
        Landmarks of each measurement, by its key.
    """

    surface: Surface
    size: float
    numbers: Mapping[str, int]
    tapes: tuple[TapeLine, ...]
    landmarks: Mapping[str, tuple[Label, ...]]
