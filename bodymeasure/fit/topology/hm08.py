"""MakeHuman's base mesh hm08, of which our quad mesh is a part: an exact correspondence, no fit.

The body of hm08 is its first 13,380 vertices; helper geometry, eyes and tongue follow it. On our
bodies 244 of them, at natal cleft, navel and nipples, are smooth as on a dress form: they are
placed so that the sum of the squares of the umbrella Laplacian ``(I - D^-1 W) V`` over the whole
mesh is least while all others stay. That is linear, and whatever stands there in a mesh does not
matter: Anny's default mesh lacks 32 of these vertices.
"""

from functools import cache

import numpy as np
from scipy.sparse import csr_matrix, diags, eye, vstack
from scipy.sparse.linalg import splu

from bodymeasure._typing import Ints
from bodymeasure.fit.model import body_model
from bodymeasure.fit.model.space import DATA
from bodymeasure.fit.topology.correspondence import Gives, Topology

# The vertices of hm08 that Anny's "nudity edits" leave out.
ANNY_LACKS = np.r_[1778:1794, 8450:8466]
# RMS distance of the map's atlases from the limit surface of the mesh: 40 bodies had 0.22 mm in the
# mean, and 0.36 at most.
ACCURACY = 0.25e-3
# The same from the faces: six posed bodies of the space had 0.35 to 0.51 mm, and bodies of Anny,
# whose quads bend more, up to 1.05 mm. What a body is stated with is measured on itself.
FACES_ACCURACY = 0.5e-3
SURFACES = ("hm08", "hm08 faces")
_SOURCE = (
    "Mapped exactly from MakeHuman's base mesh hm08, of which our mesh is the body; natal cleft, "
    "navel and nipples are smoothed."
)
_CONTROL = (
    " The surface is the smooth one of which the mesh is the control mesh, as MakeHuman's is."
)
_FACES = " The surface is as close to the faces of the mesh as it can be."


@cache
def hm08_topologies(faces: bool = False) -> tuple[Topology, ...]:
    """Return the topologies of which hm08's body is a part: all of it, and that of Anny.

    Parameters
    ----------
    faces : bool
        Whether the surface is to be close to the mesh; else it is the one of which the mesh is the
        control mesh, which lies within it.
    """
    return tuple(_part(lacking, faces) for lacking in (np.empty(0, dtype=np.int64), ANNY_LACKS))


@cache
def smoothed_vertices() -> Ints:
    """Return the 244 vertices of our mesh that are smoothed, from 0."""
    with np.load(DATA / "hm08.npz") as data:
        return np.asarray(data["smoothed"], dtype=np.int64)


def _part(lacking: Ints, faces: bool) -> Topology:
    quads = body_model().quads
    there = np.ones(len(body_model().mean), dtype=bool)
    there[lacking] = False
    number = np.cumsum(there) - 1
    # Quads at smoothed vertices do not matter, so that they may be there or not.
    smoothed = np.isin(quads, smoothed_vertices()).any(axis=1)
    kept = quads[~smoothed]
    sides = np.concatenate([kept[:, [corner, (corner + 1) % 4]] for corner in range(4)])
    edges = np.unique(np.sort(number[sides], axis=1), axis=0)
    return Topology(
        name=SURFACES[1] if faces else SURFACES[0],
        edges=edges,
        points=(_samples() if faces else _smoothing())[:, there],
        gives=Gives.SAMPLES if faces else Gives.VERTICES,
        source=_SOURCE + (_FACES if faces else _CONTROL),
        accuracy=FACES_ACCURACY if faces else ACCURACY,
    )


@cache
def _samples() -> csr_matrix:
    """The map, (26758, 13380), to the vertices, smoothed, and to the middles of the quads."""
    quads = body_model().quads
    rows, weights = np.repeat(np.arange(len(quads)), 4), np.full(4 * len(quads), 0.25)
    shape = (len(quads), len(body_model().mean))
    middles = csr_matrix((weights, (rows, quads.ravel())), shape=shape)
    return vstack([_smoothing(), middles @ _smoothing()]).tocsr()


@cache
def _smoothing() -> csr_matrix:
    """The map, (13380, 13380), that keeps all vertices but those that it smooths."""
    quads, count, inner = body_model().quads, len(body_model().mean), smoothed_vertices()
    corners, following = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
    links = csr_matrix((np.ones(len(corners)), (corners, following)), shape=(count, count))
    links = ((links + links.T) > 0).astype(float)
    laplacian = eye(count) - diags(1.0 / np.asarray(links.sum(axis=1)).ravel()) @ links
    squares = (laplacian.T @ laplacian).tocsr()
    outer = np.setdiff1d(np.arange(count), inner)
    beside = squares[inner][:, outer].tocsc()
    used = np.flatnonzero(np.diff(beside.indptr))
    weights = splu(squares[inner][:, inner].tocsc()).solve(-beside[:, used].toarray())
    rows, columns = np.repeat(inner, len(used)), np.tile(outer[used], len(inner))
    kept = csr_matrix((np.ones(len(outer)), (outer, outer)), shape=(count, count))
    result = kept + csr_matrix((weights.ravel(), (rows, columns)), shape=(count, count))
    # Each of the four regions takes of its own surroundings alone.
    result.data[np.abs(result.data) < 1e-14] = 0.0
    result.eliminate_zeros()
    return result.tocsr()
