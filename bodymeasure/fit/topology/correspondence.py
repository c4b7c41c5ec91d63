"""Correspondences: which points of a mesh with a fixed topology make the vertices of our bodies."""

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from scipy.sparse import csr_matrix

from bodymeasure._typing import Array, Ints
from bodymeasure.fit.topology.surface import close_to_samples


class Gives(StrEnum):
    """What the map of a topology gives: control vertices, or points that our surface is to have."""

    VERTICES = "control vertices"
    SAMPLES = "points of the surface at the vertices and in the middle of the quads"


@dataclass(frozen=True, eq=False)
class Topology:
    """A sparse linear map from the vertices of one topology to our quad mesh.

    Parameters
    ----------
    name : str
        What the topology is called, ``"hm08"`` for instance.
    edges : ndarray of int, shape (k, 2)
        Edges that a mesh must have to be of this topology, by which it is recognized.
    points : csr_matrix, shape (13380, n) or (26758, n)
        Rows that add up to 1, for the first n vertices of a mesh.
    gives : Gives
        What the rows are.
    source : str
        A sentence that says where the correspondence comes from.
    accuracy : float
        RMS distance in meters of an atlas from the surface that the topology's mesh describes, on
        the bodies on which the topology was made or tried.
    """

    name: str
    edges: Ints
    points: csr_matrix
    gives: Gives
    source: str
    accuracy: float

    @property
    def count(self) -> int:
        """How many vertices a mesh must have at least."""
        return int(self.points.shape[1])


def mapped_vertices(vertices: Array, topology: Topology) -> Array:
    """Return the control vertices of our quad mesh for a mesh of a topology.

    Parameters
    ----------
    vertices : ndarray, shape (n or more, 3)
        In any unit and axes, which the result has, too.
    topology : Topology

    Returns
    -------
    ndarray, shape (13380, 3)
    """
    places = np.asarray(topology.points @ vertices[: topology.count])
    return close_to_samples(places) if topology.gives is Gives.SAMPLES else places


def edge_keys(edges: Ints, count: int) -> Ints:
    """Return one number for each of some edges, the same in both directions."""
    low, high = np.sort(edges, axis=1).T
    return np.asarray(low * count + high)
