"""The region of a body inside its curves: found by flooding, and its border in order."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import AtlasPoint
from bodymeasure.atlas.components import connected_components
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


def region_inside(cloth: Cloth, mesh: CutMesh, inside: AtlasPoint, names: list[str]) -> Region:
    """Return the part of a mesh round a point, up to the curves.

    Parameters
    ----------
    cloth : Cloth
        On which the positions are.
    mesh : CutMesh
    inside : AtlasPoint
    names : list of str
        The names of the curves, for messages.

    Raises
    ------
    InputError
        If the region is no disk that all curves bound in turn; the message names the curves.
    """
    label = _parts(mesh)
    part = label[_triangle_at(mesh, inside)]
    kept = label == part
    vertex, curve = mesh.vertex[kept], mesh.curve[kept]
    start, stop = vertex, np.roll(vertex, -1, axis=1)
    halves = dict(
        zip(
            zip(start.ravel().tolist(), stop.ravel().tolist(), strict=True),
            curve.ravel().tolist(),
            strict=True,
        )
    )
    if len(halves) < start.size:
        raise InputError("patches of the piece face different ways; `bodymeasure check` says which")
    border = {pair: number for pair, number in halves.items() if pair[::-1] not in halves}
    both = sorted({names[n] for (a, b), n in halves.items() if n >= 0 and (b, a) in halves})
    if both:
        listed = ", ".join(map(repr, both))
        raise InputError(
            f"the piece lies on both sides of its edge {listed}, so that the edges do not "
            "enclose it; check that they follow one another round the piece, and 'inside'"
        )
    if -1 in border.values():
        raise InputError(
            "the piece reaches the open end of the body (neck, wrist or ankle), so that its edges "
            "do not enclose it; check 'inside', and the order of the edges"
        )
    chains, order = _chains(border)
    numbers = np.unique(vertex)
    edges = len(halves) - (len(halves) - len(border)) // 2
    if len(numbers) - edges + len(vertex) != 1 or sorted(order) != list(range(len(names))):
        found = ", ".join(repr(names[number]) for number in order)
        raise InputError(
            f"the edges do not bound one piece in turn (round 'inside' there are {found}); an edge "
            "crosses another, or 'inside' lies outside the piece"
        )
    first = order.index(0)
    chains, order = chains[first:] + chains[:first], order[first:] + order[:first]
    local = np.full(int(numbers.max()) + 1, -1, dtype=np.int64)
    local[numbers] = np.arange(len(numbers))
    corners = mesh.positions(cloth, kept)
    positions = np.empty((len(numbers), 3))
    positions[local[vertex].ravel()] = corners.reshape(-1, 3)
    return Region(
        mesh.patch[kept],
        mesh.parameters[kept],
        local[vertex],
        positions,
        tuple(local[np.array(chain)] for chain in chains),
        tuple(order),
    )


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
