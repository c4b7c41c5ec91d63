"""A piece as an even mesh on the smooth surface, slit along its darts."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.pattern.flat.locate import SkinPlaces


@dataclass(frozen=True, eq=False)
class Chain:
    """Vertices along an edge, a part of one, or a leg of a dart.

    Parameters
    ----------
    vertices : ndarray of int, shape (m + 1,)
    steps : ndarray, shape (m,)
        The exact lengths from one vertex to the next, along the curve on the skin.
    """

    vertices: Ints
    steps: Array

    @property
    def length(self) -> float:
        """The length of the chain."""
        return float(self.steps.sum())

    @property
    def parts(self) -> Array:
        """The part of its length at which each vertex lies, shape (m + 1,)."""
        run = np.concatenate([[0.0], np.cumsum(self.steps)])
        return np.asarray(run / run[-1])


@dataclass(frozen=True, eq=False)
class Leg:
    """Both legs of a dart, each from its foot on the edge to the tip that they share.

    Parameters
    ----------
    before, after : Chain
        The leg at which the edge arrives counterclockwise, and the one from which it goes on.
    """

    before: Chain
    after: Chain


@dataclass(frozen=True, eq=False)
class PieceMesh:
    """A piece as a mesh.

    Parameters
    ----------
    places : SkinPlaces
        Where on the skin the vertices are.
    triangles : ndarray of int, shape (k, 3)
        Counterclockwise.
    sides : ndarray, shape (k, 3)
        The length from each corner of a triangle to the next along the skin.
    edges : tuple of tuple of Chain
        The chains of each edge, counterclockwise: one more than there are darts on it.
    darts : tuple of Leg
    start : ndarray, shape (n, 2)
        The vertices in the layout in which the mesh was made.
    lift : ndarray, shape (n,)
        How far the cloth is from its place on the body, or on the surface with ease, where it
        bridges hollows.
    """

    places: SkinPlaces
    triangles: Ints
    sides: Array
    edges: tuple[tuple[Chain, ...], ...]
    darts: tuple[Leg, ...]
    start: Array
    lift: Array

    @property
    def chains(self) -> tuple[Chain, ...]:
        """All chains of the border, without the legs of darts."""
        return tuple(chain for edge in self.edges for chain in edge)
