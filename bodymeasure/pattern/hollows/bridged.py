"""Cloth over hollows, which it bridges, as under a bust or in the small of the back."""

from dataclasses import replace

import numpy as np
import scipy

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.normals import unit_normals
from bodymeasure.atlas.queries.outside import outward_sign
from bodymeasure.bezier import evaluate
from bodymeasure.pattern.cloth.cloth import Cloth
from bodymeasure.pattern.flat.remesh import Remeshed
from bodymeasure.pattern.hollows.hanging import hanging

# The tension along the body, as a part of that round it: clothes hang down more than they pull.
ALONG = 0.3


def bridged(cloth: Cloth, mesh: Remeshed, fold: int | None) -> Remeshed:
    """Return a mesh whose cloth is lifted from hollows.

    Parameters
    ----------
    cloth : Cloth
    mesh : Remeshed
    fold : int, optional
        The edge that is the fold: it is lifted as well, while all others stay on the body.

    Notes
    -----
    The cloth hangs where its tension ``1/2 integral |dX_h|^2 + ALONG |dX_v|^2`` is least without
    its being in the body, where h and v run round the body and along it. At a fold it does not move
    to a side, where the other half pulls as much.
    """
    places = mesh.places
    positions, normals = cloth.positions(*places), cloth.normals(*places)
    nets = cloth.atlas.control_points[places.patch]
    outward = outward_sign(cloth.atlas) * unit_normals(nets, places.parameters[:, None])[:, 0]
    normals = normals * np.sign((normals * outward).sum(axis=1))[:, None]
    skin, upwards = evaluate(nets, places.parameters), cloth.atlas.axes.up_vector
    stiffness = _stiffness(mesh.flat, mesh.triangles, skin, upwards)
    free, aside = np.ones(len(positions), dtype=np.bool_), np.zeros_like(positions)
    for number, chains in enumerate(mesh.edges):
        vertices = np.concatenate([chains[0][:1], *(chain[1:] for chain in chains)])
        if number == fold:
            across = np.cross(normals[vertices], np.gradient(positions[vertices], axis=0))
            aside[vertices] = across / np.linalg.norm(across, axis=1, keepdims=True)
            vertices = vertices[[0, -1]]
        free[vertices] = False
    moved = hanging(positions, normals, stiffness, free, aside)
    lift = np.linalg.norm(moved - positions, axis=1)
    turned = _turned(moved, mesh.triangles, lift, normals)

    def stretched(step: Array, chain: Ints) -> Array:
        after, before = _lengths(moved, turned, chain), _lengths(positions, normals, chain)
        return np.asarray(step * after / before)

    steps = [*mesh.steps]
    if fold is not None:
        pairs = zip(mesh.steps[fold], mesh.edges[fold], strict=True)
        steps[fold] = tuple(stretched(step, chain) for step, chain in pairs)
    darts = zip(mesh.dart_steps, mesh.darts, strict=True)
    return replace(
        mesh,
        steps=tuple(steps),
        dart_steps=tuple(stretched(step, chain) for step, chain in darts),
        surface=(moved, turned),
        lift=lift,
    )


def _stiffness(
    layout: Array, triangles: Ints, skin: Array, upwards: Array
) -> scipy.sparse.csr_array:
    """Return the quadratic form of tension in one coordinate of the vertices.

    In the layout the mesh is even, also where ease crowds the cloth in a crease; as it is
    conformal, tension that is the same all round has the energy there that it has on the skin.
    """
    corners = layout[triangles]
    # The gradient of the hat function of a corner, from the side that lies opposite.
    sides = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)
    doubled = np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
    gradients = np.stack([-sides[..., 1], sides[..., 0]], axis=2) / doubled[:, None, None]
    one, other = (skin[triangles[:, i]] - skin[triangles[:, 0]] for i in (1, 2))
    area = np.linalg.norm(np.cross(one, other), axis=1)
    # Where the skin is upright, the height grows by the distance along it, and less where it leans.
    rise = np.einsum("kc,kcd->kd", (skin @ upwards)[triangles], gradients)
    rise *= np.sqrt(doubled / area)[:, None]
    rise /= np.maximum(1.0, np.linalg.norm(rise, axis=1, keepdims=True))
    along = np.einsum("kcd,kd->kc", gradients, rise)
    blocks = gradients @ gradients.transpose(0, 2, 1)
    blocks -= (1.0 - ALONG) * along[:, :, None] * along[:, None]
    blocks *= 0.5 * doubled[:, None, None]
    rows, columns = np.repeat(triangles, 3, axis=1).ravel(), np.tile(triangles, (1, 3)).ravel()
    shape = (len(layout), len(layout))
    return scipy.sparse.coo_array((blocks.ravel(), (rows, columns)), shape=shape).tocsr()


def _turned(positions: Array, triangles: Ints, lift: Array, normals: Array) -> Array:
    """Return the normals of a lifted mesh: those of before, where it is not lifted round about."""
    corners = positions[triangles]
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    sums = np.zeros_like(positions)
    lifted = np.zeros(len(positions), dtype=np.bool_)
    for corner in range(3):
        np.add.at(sums, triangles[:, corner], faces)
    lifted[triangles[(lift[triangles] > 0.0).any(axis=1)]] = True
    sums *= np.sign((sums * normals).sum(axis=1))[:, None]
    size = np.linalg.norm(sums, axis=1, keepdims=True)
    return np.where(lifted[:, None], sums / np.where(size > 0.0, size, 1.0), normals)


def _lengths(positions: Array, normals: Array, chain: Ints) -> Array:
    """Return the lengths of a chain of arcs."""
    chord = np.diff(positions[chain], axis=0)
    size = np.linalg.norm(chord, axis=1)
    turn = (np.diff(normals[chain], axis=0) * chord).sum(axis=1) / size
    return np.asarray(size * (1.0 + turn**2 / 24.0))
