"""The region of a body inside its curves: found by flooding, and its border in order."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import AtlasPoint
from bodymeasure.atlas.topology.components import connected_components
from bodymeasure.errors import InputError
from bodymeasure.pattern.cloth.cloth import Cloth
from bodymeasure.pattern.cutting.mesh import CutMesh


@dataclass(frozen=True, eq=False)
class Region:
    """A part of a body that is a disk, as a mesh.

    Parameters
    ----------
    patch : ndarray of int, shape (k,)
    parameters : ndarray, shape (k, 3, 2)
        (u, v) of the corners of each triangle on its patch.
    triangles : ndarray of int, shape (k, 3)
    positions : ndarray, shape (n, 3)
    border : tuple of ndarray of int
        The vertices along each curve, both ends included, with the region on the left.
    order : tuple of int
        The number of the curve of each chain in `border`.
    """

    patch: Ints
    parameters: Array
    triangles: Ints
    positions: Array
    border: tuple[Ints, ...]
    order: tuple[int, ...]


@dataclass(frozen=True, eq=False)
class Bound:
    """An edge that bounds a region.

    Parameters
    ----------
    name : str
    curve : int
        The number of its curve; two edges have one where a tube is slit along it.
    start, end : ndarray, shape (3,)
        Where on the cloth it begins and ends.
    """

    name: str
    curve: int
    start: Array
    end: Array


def region_inside(cloth: Cloth, mesh: CutMesh, inside: AtlasPoint, bounds: list[Bound]) -> Region:
    """Return the part of a mesh round a point, up to the curves.

    Parameters
    ----------
    cloth : Cloth
        On which the positions are.
    mesh : CutMesh
    inside : AtlasPoint
    bounds : list of Bound
        The edges in order round the region, either way.

    Raises
    ------
    InputError
        If the region is no disk that all curves bound in turn; the message names the edges.
    """
    label = _parts(mesh)
    kept = label == label[_triangle_at(mesh, inside)]
    curve = mesh.curve[kept]
    _refuse_sides(mesh.vertex[kept], curve, bounds)
    vertex, first = _slit(mesh.vertex[kept], curve)
    start, stop = vertex, np.roll(vertex, -1, axis=1)
    pairs = zip(start.ravel().tolist(), stop.ravel().tolist(), strict=True)
    halves = dict(zip(pairs, curve.ravel().tolist(), strict=True))
    border = {pair: number for pair, number in halves.items() if pair[::-1] not in halves}
    if -1 in border.values():
        found = _names(bounds, set(border.values()))
        raise InputError(
            "the piece reaches the open end of the body (neck, wrist or ankle), so that its edges "
            f"do not enclose it (round 'inside' there are {found or 'none of them'}); check "
            "'inside', the other edges, and their order"
        )
    chains, order = _chains(border)
    edges = len(halves) - (len(halves) - len(border)) // 2
    positions = mesh.positions(cloth, kept).reshape(-1, 3)[first]
    turned = _in_turn(chains, order, bounds, positions)
    if len(first) - edges + len(vertex) != 1 or turned is None:
        found = _names(bounds, set(order))
        raise InputError(
            f"the edges do not bound one piece in turn (round 'inside' there are {found}); an edge "
            "crosses another, or 'inside' lies outside the piece"
        )
    return Region(
        mesh.patch[kept],
        mesh.parameters[kept],
        vertex,
        positions,
        tuple(np.array(chains[row]) for row, _ in turned),
        tuple(number for _, number in turned),
    )


def _names(bounds: list[Bound], curves: set[int]) -> str:
    """Return the names of the edges that lie on some curves, in the panel's order."""
    return ", ".join(repr(bound.name) for bound in bounds if bound.curve in curves)


def _refuse_sides(vertex: Ints, curve: Ints, bounds: list[Bound]) -> None:
    """Refuse a region whose triangles face different ways, or that an edge does not bound."""
    start, stop = vertex.ravel(), np.roll(vertex, -1, axis=1).ravel()
    size = int(vertex.max()) + 1
    forth, back = start * size + stop, stop * size + start
    if len(np.unique(forth)) < len(forth):
        raise InputError("patches of the piece face different ways; `bodymeasure check` says which")
    inner = np.unique(curve.ravel()[np.isin(forth, back) & (curve.ravel() >= 0)]).tolist()
    both = [
        bounds_of[0].name
        for number in inner
        if len(bounds_of := [bound for bound in bounds if bound.curve == number]) == 1
    ]
    if both:
        listed = ", ".join(map(repr, sorted(both)))
        raise InputError(
            f"the piece lies on both sides of its edge {listed}, so that the edges do not "
            "enclose it; check that they follow one another round the piece, and 'inside'"
        )


def _slit(vertex: Ints, curve: Ints) -> tuple[Ints, Ints]:
    """Return triangles that share vertices only with those next to them where no curve runs.

    The second array has the first corner of each vertex, counted through all triangles.
    """
    start, stop = vertex.ravel(), np.roll(vertex, -1, axis=1).ravel()
    key = np.minimum(start, stop) * (int(vertex.max()) + 1) + np.maximum(start, stop)
    free = np.flatnonzero(curve.ravel() < 0)
    order = free[np.argsort(key[free], kind="stable")]
    same = key[order[1:]] == key[order[:-1]]
    one, other = order[:-1][same], order[1:][same]
    after_one, after_other = (3 * (side // 3) + (side + 1) % 3 for side in (one, other))
    label = connected_components(
        np.concatenate([one, after_one]), np.concatenate([after_other, other]), vertex.size
    )
    _, first, number = np.unique(label, return_index=True, return_inverse=True)
    return number.reshape(vertex.shape), first


def _in_turn(
    chains: list[list[int]], order: list[int], bounds: list[Bound], positions: Array
) -> list[tuple[int, int]] | None:
    """Return chains and the edges that they are, from the first edge on; None if they are others.

    Where two edges have one curve, the ends of the chains tell which is which.
    """
    count = len(bounds)
    best: tuple[float, list[tuple[int, int]]] | None = None
    if len(chains) != count:
        return None
    for first in range(count):
        for way in (1, -1):
            turned = [((first + step) % count, (way * step) % count) for step in range(count)]
            if any(order[row] != bounds[number].curve for row, number in turned):
                continue
            away = 0.0
            for row, number in turned:
                ends = [bounds[number].start, bounds[number].end][::way]
                there = positions[[chains[row][0], chains[row][-1]]]
                away += float(np.linalg.norm(there - ends, axis=1).sum())
            if best is None or away < best[0]:
                best = away, turned
    return None if best is None else best[1]


def _parts(mesh: CutMesh) -> Ints:
    """Return the number of the part of each triangle, as curves cut them."""
    start, stop = mesh.vertex, np.roll(mesh.vertex, -1, axis=1)
    low, high = np.minimum(start, stop).ravel(), np.maximum(start, stop).ravel()
    key = low * (int(high.max()) + 1) + high
    free = np.flatnonzero(mesh.curve.ravel() < 0)
    order = free[np.argsort(key[free], kind="stable")]
    same = key[order[1:]] == key[order[:-1]]
    first, second = order[:-1][same] // 3, order[1:][same] // 3
    return connected_components(first, second, len(mesh.vertex))


def _triangle_at(mesh: CutMesh, point: AtlasPoint) -> int:
    rows = np.flatnonzero(mesh.patch == point.patch)
    part = barycentric(mesh.parameters[rows], np.array([point.u, point.v]))
    return int(rows[part.min(axis=1).argmax()])


def barycentric(triangles: Array, point: Array) -> Array:
    """Return the barycentric coordinates (..., 3) of points (..., 2) in triangles (..., 3, 2)."""
    a, b, c = (triangles[..., corner, :] for corner in range(3))
    one, other, way = b - a, c - a, point - a
    area = one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0]
    second = (way[..., 0] * other[..., 1] - way[..., 1] * other[..., 0]) / area
    third = (one[..., 0] * way[..., 1] - one[..., 1] * way[..., 0]) / area
    return np.stack([1.0 - second - third, second, third], axis=-1)


def _chains(border: dict[tuple[int, int], int]) -> tuple[list[list[int]], list[int]]:
    """Return the vertices along each curve and the curves, in order round the border."""
    after = {start: (stop, curve) for (start, stop), curve in border.items()}
    here = next(iter(after))
    loop = []
    for _ in range(len(after)):
        stop, curve = after[here]
        loop.append((here, stop, curve))
        here = stop
        if here == loop[0][0]:
            break
    changes = [i for i, step in enumerate(loop) if step[2] != loop[i - 1][2]]
    if len(loop) < len(border) or not changes:
        return [[step[0] for step in loop]], [loop[0][2]]
    loop = loop[changes[0] :] + loop[: changes[0]]
    chains: list[list[int]] = []
    order: list[int] = []
    for start, stop, curve in loop:
        if not order or order[-1] != curve:
            order.append(curve)
            chains.append([start])
        chains[-1].append(stop)
    return chains, order
