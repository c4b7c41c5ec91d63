"""Fixed linear maps on the body's mesh: its surface after one subdivision, and the smoothness."""

from functools import cache
from typing import NamedTuple

import numpy as np
from scipy.sparse import csr_matrix, diags, identity, vstack

from bodymeasure._typing import Array, Ints
from bodymeasure.fit.model import body_model
from bodymeasure.fit.model.limits import limit_weights
from bodymeasure.subdivision import QuadMesh, subdivide


class Refined(NamedTuple):
    """The body's limit surface at the vertices of the mesh subdivided once.

    Parameters
    ----------
    matrix : csr_matrix, shape (m, 13380)
        Takes the vertices to the limit positions.
    quads : ndarray of int, shape (4 x 13378, 4)
    covered : ndarray of bool, shape (m,)
        Which of the positions belong to a quad that the atlas covers.
    """

    matrix: csr_matrix
    quads: Ints
    covered: Array


@cache
def refined() -> Refined:
    """The surface after one subdivision."""
    model = body_model()
    mesh = QuadMesh(model.mean, model.quads)
    finer = subdivide(mesh)
    matrix = limit_weights(finer.quads) @ _subdivision(mesh)
    covered = np.zeros(len(finer.vertices), dtype=bool)
    covered[finer.quads[np.repeat(model.covered, 4)]] = True
    return Refined(matrix.tocsr(), finer.quads, covered)


@cache
def umbrella() -> csr_matrix:
    """The umbrella Laplacian: each vertex less the mean of its neighbors, (13380, 13380)."""
    ends = QuadMesh(body_model().mean, body_model().quads).edges.ends
    count = len(body_model().mean)
    rows, columns = np.concatenate([ends, ends[:, ::-1]]).T
    beside = csr_matrix((np.ones(len(rows)), (rows, columns)), shape=(count, count))
    valence = np.asarray(beside.sum(axis=1)).ravel()
    return (identity(count) - diags(1.0 / valence) @ beside).tocsr()


def near_covered(rings: int) -> Ints:
    """Return the vertices of the quads that the atlas covers, and some rings around them."""
    model = body_model()
    inside = np.zeros(len(model.mean), dtype=bool)
    inside[model.quads[model.covered]] = True
    for _ in range(rings):
        inside[model.quads[inside[model.quads].any(axis=1)]] = True
    return np.flatnonzero(inside)


def _subdivision(mesh: QuadMesh) -> csr_matrix:
    """One step of Catmull-Clark subdivision of a closed mesh; see `subdivide`."""
    quads, edges, count = mesh.quads, mesh.edges, len(mesh.vertices)
    faces = _means(quads, count)
    midpoints = _means(edges.ends, count)
    sides = csr_matrix(
        (np.full(quads.size, 0.5), (edges.of_side.ravel(), np.repeat(np.arange(len(quads)), 4)))
    )
    valence = np.bincount(quads.ravel()).astype(float)
    at_vertices = diags(1.0 / valence) @ _incidence(quads, count).T
    along = diags(1.0 / valence) @ _incidence(edges.ends, count).T
    moved = diags(1.0 / valence) @ (at_vertices @ faces + 2.0 * (along @ midpoints))
    moved = moved + diags((valence - 3.0) / valence)
    return vstack([moved, 0.5 * (midpoints + sides @ faces), faces]).tocsr()


def _incidence(members: Ints, count: int) -> csr_matrix:
    rows = np.repeat(np.arange(len(members)), members.shape[1])
    shape = (len(members), count)
    return csr_matrix((np.ones(members.size), (rows, members.ravel())), shape=shape)


def _means(members: Ints, count: int) -> csr_matrix:
    return _incidence(members, count) / members.shape[1]
