"""What a picture shows, as plain arrays that any renderer can draw."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from bodymeasure.chart import TapeKind


class PathKind(Enum):
    """What is known of a path's length; the value is its caption in a legend."""

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
        Number of the patch that each triangle lies on.
    faded : ndarray of bool, shape (n,)
        Whether a vertex belongs to the surroundings of what is shown, to be drawn paler.
    """

    points: NDArray[np.float64]
    normals: NDArray[np.float64]
    triangles: NDArray[np.int64]
    patch: NDArray[np.int64]
    faded: NDArray[np.bool_]


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

    points: NDArray[np.float64]
    normals: NDArray[np.float64]


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
    patch: NDArray[np.int64]
    diagonal: NDArray[np.int64]
    kind: NDArray[np.object_]
    value: NDArray[np.float64]


@dataclass(frozen=True)
class Label:
    """A short text at a point of space."""

    position: NDArray[np.float64]
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


@dataclass(frozen=True, eq=False)
class TapeLine:
    """A tape as it is drawn: a curve of evenly spaced points.

    Parameters
    ----------
    number : int
        Of its measurement, as the labels say it.
    key, group : str
        Of its measurement.
    kind : TapeKind
    points : ndarray, shape (k, 3)
        In the atlas's unit; a closed tape ends at its first point.
    normals : ndarray, shape (k, 3)
        Vectors away from the body; of length 1 where the tape lies on it, 0 where it stands free.
    lift : ndarray, shape (k, 3)
        The same, but where the tape stands free, turned from the one end to the other.
    """

    number: int
    key: str
    group: str
    kind: TapeKind
    points: NDArray[np.float64]
    normals: NDArray[np.float64]
    lift: NDArray[np.float64]

    @property
    def free(self) -> NDArray[np.bool_]:
        """Where the tape stands free of the body, shape (k,)."""
        return np.asarray(np.linalg.norm(self.normals, axis=-1) < 0.5)

    @property
    def through_body(self) -> bool:
        """Whether it runs straight, whatever lies in its way, and is drawn over the body."""
        return self.kind is TapeKind.STRAIGHT


@dataclass(frozen=True, eq=False)
class TapeScene:
    """A body with the tapes of its measurements, ready to be drawn.

    Parameters
    ----------
    surface : Surface
    size : float
        Of the body: its extent upwards, or a fraction of its largest if it is flat. Widths of tapes
        are said in it.
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
