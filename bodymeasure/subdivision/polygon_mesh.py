"""Meshes of polygons, with edges that stay sharp, and how their faces meet."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Self

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.errors import InputError

# Faces that a message names; it counts the others.
_NAMED = 4


@dataclass(frozen=True, eq=False)
class PolygonMesh:
    """A manifold mesh of polygons that all face one way.

    A half-edge is a side of a face, from a corner to the face's next; it has the corner's number.

    Parameters
    ----------
    vertices : ndarray, shape (n, 3)
    corners : ndarray of int
        Vertex numbers round each face, one face after the other.
    sizes : ndarray of int, shape (faces,)
        How many corners each face has.
    creases : ndarray of int, shape (creases, 2)
        Ends of edges that stay sharp.
    face_names : sequence of str, optional
        The names of the faces in errors.
    tagged : sequence of int
        Vertices that are corners by themselves.
    rounded : bool
        Whether the boundary runs smoothly through vertices with one face, which are corners if not.

    Raises
    ------
    InputError
        If a face has fewer than three corners or one twice, faces run through an edge the same way,
        more than two meet at an edge, faces touch at a vertex alone, or a crease is no edge. The
        message names the faces.
    """

    vertices: Array
    corners: Ints
    sizes: Ints
    creases: Ints
    face_names: Sequence[str] = ()
    tagged: Sequence[int] = ()
    rounded: bool = False

    def __post_init__(self) -> None:
        _check_faces(self)
        _check_edges(self)
        _check_fans(self)
        _check_creases(self)

    @cached_property
    def face(self) -> Ints:
        """The face of each corner."""
        return np.repeat(np.arange(len(self.sizes)), self.sizes)

    @cached_property
    def following(self) -> Ints:
        """The next corner round the face of each corner."""
        result = np.arange(1, len(self.corners) + 1)
        ends = np.cumsum(self.sizes)
        result[ends - 1] = ends - self.sizes
        return result

    @cached_property
    def preceding(self) -> Ints:
        """The corner before each round its face."""
        result = np.empty_like(self.following)
        result[self.following] = np.arange(len(result))
        return result

    @cached_property
    def heads(self) -> Ints:
        """The vertex to which each half-edge leads."""
        return self.corners[self.following]

    @cached_property
    def edge(self) -> Ints:
        """Number of the edge of each half-edge."""
        return self._edges[1]

    @cached_property
    def ends(self) -> Ints:
        """Vertex numbers of each edge, the lower first; shape (edges, 2)."""
        return np.stack(np.divmod(self._edges[0], len(self.vertices)), axis=-1)

    @cached_property
    def sides(self) -> Ints:
        """How many faces each edge has: 2, or 1 on the boundary."""
        return np.bincount(self.edge)

    @cached_property
    def sharp(self) -> Bools:
        """Which edges are creases or on the boundary."""
        result = np.asarray(self.sides == 1)
        if len(self.creases):
            result[np.searchsorted(self._edges[0], _key(self, *self.creases.T))] = True
        return result

    @cached_property
    def sector(self) -> Ints:
        """A number for each corner, which corners share that are joined round their vertex.

        Sharp edges part them.
        """
        return joined_corners(self, ~self.sharp)

    @cached_property
    def corner_vertices(self) -> Bools:
        """Vertices that stay where they are, shape (n,), by the rules of OpenSubdiv.

        These are the tagged ones, those at which three or more sharp edges meet, and those on the
        boundary with one face, unless they are rounded.
        """
        result = np.asarray(self._sharp_edges_at > 2)
        result[list(self.tagged)] = True
        if not self.rounded:
            boundary = np.bincount(self.ends[self.sides == 1].ravel(), minlength=len(result))
            result |= (np.bincount(self.corners, minlength=len(result)) == 1) & (boundary == 2)
        return result

    @cached_property
    def crease_vertices(self) -> Bools:
        """Other vertices through which a crease or the boundary runs, shape (n,)."""
        return np.asarray((self._sharp_edges_at == 2) & ~self.corner_vertices)

    @cached_property
    def darts(self) -> Bools:
        """Other vertices at which a crease ends, shape (n,)."""
        return np.asarray((self._sharp_edges_at == 1) & ~self.corner_vertices)

    @cached_property
    def twin(self) -> Ints:
        """The half-edge on the other side of the edge of each, -1 on the boundary."""
        result = np.full(len(self.corners), -1)
        order = np.argsort(self.edge, kind="stable")
        first, second = order[self.sides[self.edge[order]] == 2].reshape(-1, 2).T
        result[first], result[second] = second, first
        return result

    @cached_property
    def _sharp_edges_at(self) -> Ints:
        """How many sharp edges meet at each vertex."""
        return np.bincount(self.ends[self.sharp].ravel(), minlength=len(self.vertices))

    @cached_property
    def _edges(self) -> tuple[Ints, Ints]:
        keys, edge = np.unique(_key(self, self.corners, self.heads), return_inverse=True)
        return keys, edge

    @classmethod
    def unchecked(
        cls, vertices: Array, corners: Ints, sizes: Ints, creases: Ints, **others: Any
    ) -> Self:
        """Return a mesh that is known to be sound, as one made from such a mesh is."""
        result = object.__new__(cls)
        plain = {"face_names": (), "tagged": (), "rounded": False}
        result.__dict__.update(
            plain, vertices=vertices, corners=corners, sizes=sizes, creases=creases, **others
        )
        return result

    def with_vertices(self, vertices: Array) -> Self:
        """Return the mesh with its vertices, shape (n, 3), in other places."""
        result = object.__new__(type(self))
        # What is known of how faces meet stays known.
        result.__dict__.update(self.__dict__, vertices=vertices)
        return result

    def called(self, faces: Sequence[int] | Ints) -> str:
        """Names of faces, for a message."""
        names = [self.face_names[f] if self.face_names else f"face {f}" for f in faces[:_NAMED]]
        more = f" and {len(faces) - _NAMED} more" if len(faces) > _NAMED else ""
        return ", ".join(names) + more


def _key(mesh: PolygonMesh, tail: Ints, head: Ints) -> Ints:
    """A number for each pair of vertices, in either order."""
    return np.asarray(np.minimum(tail, head) * len(mesh.vertices) + np.maximum(tail, head))


def joined_corners(mesh: PolygonMesh, passed: Bools) -> Ints:
    """A number for each corner, the same for those joined over `passed` edges at their vertex."""
    first = np.flatnonzero((mesh.twin >= 0) & passed[mesh.edge])
    second = mesh.twin[first]
    # The twin of a half-edge begins where it ends.
    rows = np.concatenate([first, mesh.following[first]])
    columns = np.concatenate([mesh.following[second], second])
    count = len(mesh.corners)
    links = scipy.sparse.coo_array(
        (np.ones(len(rows), dtype=np.int8), (rows, columns)), shape=(count, count)
    )
    return np.asarray(scipy.sparse.csgraph.connected_components(links, directed=False)[1], np.int64)


def _check_faces(mesh: PolygonMesh) -> None:
    if len(mesh.sizes) == 0:
        raise InputError("the mesh has no face; expected at least one")
    small = np.flatnonzero(mesh.sizes < 3)
    if len(small):
        raise InputError(
            f"{mesh.called(small)}: {mesh.sizes[small[0]]} corners; expected at least 3; remove "
            "what is no face"
        )
    ordered = np.lexsort((mesh.corners, mesh.face))
    same = (np.diff(mesh.corners[ordered]) == 0) & (np.diff(mesh.face[ordered]) == 0)
    if same.any():
        faces = np.unique(mesh.face[ordered][1:][same])
        raise InputError(
            f"{mesh.called(faces)}: a vertex occurs twice; expected each corner once; merge or "
            "remove the face"
        )


def _check_edges(mesh: PolygonMesh) -> None:
    crowded = np.flatnonzero(mesh.sides > 2)
    if len(crowded):
        faces = mesh.face[mesh.edge == crowded[0]]
        raise InputError(
            f"{mesh.called(faces)} share one edge, between the vertices "
            f"{mesh.ends[crowded[0], 0] + 1} and {mesh.ends[crowded[0], 1] + 1}; expected at most "
            "two faces on an edge (a manifold); remove or separate the others"
        )
    forwards = mesh.corners < mesh.heads
    balance = np.bincount(mesh.edge, weights=np.where(forwards, 1.0, -1.0))
    turned = np.flatnonzero((mesh.sides == 2) & (balance != 0.0))
    if len(turned):
        faces = mesh.face[mesh.edge == turned[0]]
        raise InputError(
            f"{mesh.called(faces)} face opposite ways: they run through their common edge, between "
            f"the vertices {mesh.ends[turned[0], 0] + 1} and {mesh.ends[turned[0], 1] + 1}, in the "
            f"same direction ({len(turned)} such edge{'s' if len(turned) > 1 else ''}); reverse "
            "the corners of one of them"
        )


def _check_fans(mesh: PolygonMesh) -> None:
    fan = joined_corners(mesh, np.ones(len(mesh.sides), dtype=np.bool_))
    pairs = np.unique(np.stack([mesh.corners, fan], axis=-1), axis=0)
    fans = np.bincount(pairs[:, 0])
    pinched = np.flatnonzero(fans > 1)
    if len(pinched):
        faces = mesh.face[mesh.corners == pinched[0]]
        raise InputError(
            f"{mesh.called(faces)} touch at vertex {pinched[0] + 1} alone; expected the faces "
            "round each vertex to form one fan; give each fan a vertex of its own"
        )


def _check_creases(mesh: PolygonMesh) -> None:
    if len(mesh.creases):
        keys = _key(mesh, *mesh.creases.T)
        missing = np.flatnonzero(~np.isin(keys, mesh._edges[0]))
        if len(missing):
            tail, head = mesh.creases[missing[0]] + 1
            raise InputError(f"a crease runs from vertex {tail} to {head}, where no edge is")
