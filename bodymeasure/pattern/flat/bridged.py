"""Cloth over hollows, which it bridges, as under a bust or in the small of the back."""

from dataclasses import replace

import numpy as np
import scipy

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.normals import unit_normals
from bodymeasure.atlas.queries.outside import outward_sign
from bodymeasure.pattern.cloth.cloth import Cloth
from bodymeasure.pattern.flat.remesh import Remeshed

# The tension along the body, as a part of that round it: clothes hang down more than they pull.
ALONG = 0.1
# In meters: over what width the ways are evened out in which cloth is lifted.
EVEN = 0.06
# Rounds in which the places are found where the cloth lies on the body.
ROUNDS = 40


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
    Vertices move outwards by d >= 0, so that the energy of tension
    ``1/2 integral |dX_h|^2 + ALONG |dX_v|^2`` is least, where h and v run round the body and along
    it: an obstacle problem, quadratic in d, which a primal-dual active set solves in a few rounds.
    They move along normals that are evened out, since those under an overhanging bust point down,
    and not away from the hollow.
    """
    places = mesh.places
    positions, normals = cloth.positions(*places), cloth.normals(*places)
    nets = cloth.atlas.control_points[places.patch]
    outward = outward_sign(cloth.atlas) * unit_normals(nets, places.parameters[:, None])[:, 0]
    normals = normals * np.sign((normals * outward).sum(axis=1))[:, None]
    upwards = cloth.atlas.axes.up_vector
    stiffness = _stiffness(positions, mesh.triangles, upwards, ALONG)
    weights = stiffness.tocoo()
    ways = _evened(positions, mesh.triangles, normals, EVEN / cloth.atlas.unit.meters)
    if fold is not None:
        vertices = np.concatenate([mesh.edges[fold][0][:1], *(c[1:] for c in mesh.edges[fold])])
        ways[vertices] = _upright(positions[vertices], normals[vertices], ways[vertices])
    same = (ways[weights.row] * ways[weights.col]).sum(axis=1)
    hessian = scipy.sparse.coo_array(
        (weights.data * same, (weights.row, weights.col)), shape=weights.shape
    ).tocsr()
    slope = ((stiffness @ positions) * ways).sum(axis=1)
    free = np.ones(len(positions), dtype=np.bool_)
    for number, chains in enumerate(mesh.edges):
        for chain in chains:
            if number != fold:
                free[chain] = False
    if fold is not None:
        ends = mesh.edges[fold][0][0], mesh.edges[fold][-1][-1]
        free[[*ends]] = False
    lift = _lifted(hessian, slope, free)
    moved = positions + lift[:, None] * ways
    turned = _turned(moved, mesh.triangles, lift, normals)
    before, after = (positions, normals), (moved, turned)
    edges = [[*steps] for steps in mesh.steps]
    if fold is not None:
        edges[fold] = [
            step * _length(*after, chain) / _length(*before, chain)
            for step, chain in zip(mesh.steps[fold], mesh.edges[fold], strict=True)
        ]
    darts = [
        step * _length(*after, chain) / _length(*before, chain)
        for step, chain in zip(mesh.dart_steps, mesh.darts, strict=True)
    ]
    return replace(
        mesh,
        steps=tuple(tuple(steps) for steps in edges),
        dart_steps=tuple(darts),
        surface=(moved, turned),
        lift=lift,
    )


def _stiffness(
    positions: Array, triangles: Ints, upwards: Array, tension: float
) -> scipy.sparse.csr_array:
    """Return the quadratic form of tension in one coordinate of the vertices."""
    corners = positions[triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    doubled = np.linalg.norm(normal, axis=1, keepdims=True)
    normal = normal / doubled
    # The gradient of the hat function of a corner, from the side that lies opposite.
    sides = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)
    gradients = np.cross(normal[:, None], sides) / doubled[:, None]
    round_body = np.cross(upwards, normal)
    size = np.linalg.norm(round_body, axis=1, keepdims=True)
    # On a level place, round the body is wherever it is.
    flat = size < 1e-6
    round_body = np.where(flat, np.roll(upwards, 1), round_body / np.where(flat, 1.0, size))
    across = (gradients * round_body[:, None]).sum(axis=2)
    along = (gradients * np.cross(normal, round_body)[:, None]).sum(axis=2)
    blocks = across[:, :, None] * across[:, None] + tension * along[:, :, None] * along[:, None]
    blocks *= 0.5 * doubled[:, :, None]
    rows, columns = np.repeat(triangles, 3, axis=1).ravel(), np.tile(triangles, (1, 3)).ravel()
    shape = (len(positions), len(positions))
    return scipy.sparse.coo_array((blocks.ravel(), (rows, columns)), shape=shape).tocsr()


def _lifted(hessian: scipy.sparse.csr_array, slope: Array, free: Bools) -> Array:
    """Return the least of ``1/2 d H d + slope d`` with d >= 0, and 0 where it is not free."""
    lift = np.zeros(len(slope))
    off = free & (slope < 0.0)
    for _ in range(ROUNDS):
        lift[:] = 0.0
        rows = np.flatnonzero(off)
        if len(rows):
            lift[rows] = scipy.sparse.linalg.splu(hessian[rows][:, rows].tocsc()).solve(
                -slope[rows]
            )
        force = hessian @ lift + slope
        # Off the body where it is lifted, or where the tension pulls it off.
        following = free & np.where(off, lift > 0.0, force < 0.0)
        if (following == off).all():
            break
        off = following
    return np.maximum(lift, 0.0)


def _evened(positions: Array, triangles: Ints, normals: Array, width: float) -> Array:
    """Return normals that are evened out over a width, so that none points down under a bust."""
    stiffness = _stiffness(positions, triangles, np.array([0.0, 0.0, 1.0]), 1.0)
    corners = positions[triangles]
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(faces, axis=1) / 6.0
    mass = np.bincount(triangles.ravel(), weights=np.repeat(area, 3), minlength=len(positions))
    system = scipy.sparse.diags_array(mass) + width**2 * stiffness
    even = scipy.sparse.linalg.splu(system.tocsc()).solve(mass[:, None] * normals)
    return np.asarray(even / np.linalg.norm(even, axis=1, keepdims=True))


def _upright(positions: Array, normals: Array, ways: Array) -> Array:
    """Return ways at a fold that do not lean to a side, where the other half pulls as much."""
    aside = np.cross(normals, np.gradient(positions, axis=0))
    aside /= np.linalg.norm(aside, axis=1, keepdims=True)
    ways = ways - (ways * aside).sum(axis=1, keepdims=True) * aside
    return np.asarray(ways / np.linalg.norm(ways, axis=1, keepdims=True))


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


def _length(positions: Array, normals: Array, chain: Ints) -> float:
    """Return the length of a chain of arcs."""
    chord = np.diff(positions[chain], axis=0)
    size = np.linalg.norm(chord, axis=1)
    turn = (np.diff(normals[chain], axis=0) * chord).sum(axis=1) / size
    return float((size * (1.0 + turn**2 / 24.0)).sum())
