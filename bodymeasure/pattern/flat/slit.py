"""Meshes slit along their darts, with the lengths of their sides along the skin."""

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.topology.components import connected_components
from bodymeasure.pattern.cloth.cloth import Cloth
from bodymeasure.pattern.flat.mesh import Chain, Leg, PieceMesh
from bodymeasure.pattern.flat.remesh import Remeshed


def slit(cloth: Cloth, mesh: Remeshed) -> PieceMesh:
    """Slit a mesh along its darts.

    Notes
    -----
    A side's length is that of an arc with the curvature of the surface, ``c (1 + (h k)^2 / 24)``
    for a chord c, where h k is the change of the normal along it: of fourth order, so that the size
    of the triangles costs nothing. Sides on edges and darts have the exact lengths of their curves.
    """
    triangles = mesh.triangles.copy()
    origin = np.arange(len(mesh.flat))
    edges = [[*chains] for chains in mesh.edges]
    legs = []
    for vertices, step in zip(mesh.darts, mesh.dart_steps, strict=True):
        right = _right_of(triangles, vertices)
        copies = np.concatenate([len(origin) + np.arange(len(vertices) - 1), vertices[-1:]])
        new = np.arange(len(origin))
        new[vertices] = copies
        triangles[right] = new[triangles[right]]
        origin = np.concatenate([origin, vertices[:-1]])
        for chains in edges:
            for number in range(1, len(chains)):
                if chains[number][0] == vertices[0]:
                    chains[number] = np.concatenate([copies[:1], chains[number][1:]])
        legs.append(Leg(Chain(vertices, step), Chain(copies, step)))
    places = mesh.places.take(origin)
    if mesh.surface is None:
        positions, normals = cloth.positions(*places), cloth.normals(*places)
    else:
        positions, normals = (each[origin] for each in mesh.surface)
    way = np.roll(triangles, -1, axis=1)
    chord = positions[way] - positions[triangles]
    length = np.linalg.norm(chord, axis=2)
    turn = np.einsum("kcd,kcd->kc", normals[way] - normals[triangles], chord) / length
    sides = length * (1.0 + turn**2 / 24.0)
    bounding = tuple(
        tuple(Chain(c, s) for c, s in zip(cs, ss, strict=True))
        for cs, ss in zip(edges, mesh.steps, strict=True)
    )
    exact = [
        *(c for edge in bounding for c in edge),
        *(c for leg in legs for c in (leg.before, leg.after)),
    ]
    return PieceMesh(
        places,
        triangles,
        _with_exact(sides, triangles, exact),
        bounding,
        tuple(legs),
        mesh.flat[origin],
        np.zeros(len(origin)) if mesh.lift is None else mesh.lift[origin],
    )


def _right_of(triangles: Ints, vertices: Ints) -> Ints:
    """Return the triangles at a chain that lie on its right, from its first vertex to its tip."""
    inner = vertices[:-1]
    near = np.flatnonzero(np.isin(triangles, inner).any(axis=1))
    start, stop = triangles[near], np.roll(triangles[near], -1, axis=1)
    size = int(triangles.max()) + 1
    key = (np.minimum(start, stop) * size + np.maximum(start, stop)).ravel()
    low, high = np.minimum(vertices[:-1], vertices[1:]), np.maximum(vertices[:-1], vertices[1:])
    usable = np.isin(start, inner) | np.isin(stop, inner)
    usable = usable.ravel() & ~np.isin(key, low * size + high)
    rows = np.flatnonzero(usable)
    rows = rows[np.argsort(key[rows], kind="stable")]
    same = key[rows[1:]] == key[rows[:-1]]
    label = connected_components(rows[:-1][same] // 3, rows[1:][same] // 3, len(near))
    # The side along which a triangle on the left runs is the chain's own first one.
    left = ((start == vertices[0]) & (stop == vertices[1])).any(axis=1)
    return np.asarray(near[label != label[np.flatnonzero(left)[0]]])


def _with_exact(sides: Array, triangles: Ints, chains: list[Chain]) -> Array:
    known = {}
    for chain in chains:
        pairs = zip(chain.vertices[:-1].tolist(), chain.vertices[1:].tolist(), strict=True)
        for pair, step in zip(pairs, chain.steps.tolist(), strict=True):
            known[min(pair), max(pair)] = step
    result = sides.copy()
    start, stop = triangles, np.roll(triangles, -1, axis=1)
    size = int(triangles.max()) + 1
    key = np.minimum(start, stop) * size + np.maximum(start, stop)
    keys = np.array([low * size + high for low, high in known])
    order = np.argsort(keys)
    keys, values = keys[order], np.array([*known.values()])[order]
    at = np.searchsorted(keys, key).clip(max=len(keys) - 1)
    found = keys[at] == key
    result[found] = values[at[found]]
    return result
