"""The body's own surface: vertices moved smoothly until the limit surface follows the scan."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from scipy.sparse import csc_matrix, csr_matrix, diags, identity, kron
from scipy.sparse.linalg import splu
from scipy.spatial import cKDTree

from bodymeasure._typing import Array, Ints
from bodymeasure.fit.model import body_model, limit_matrix
from bodymeasure.fit.solving.cloud import Cloud
from bodymeasure.fit.solving.progress import Report
from bodymeasure.fit.solving.refined import near_covered, refined, umbrella
from bodymeasure.fit.solving.state import normals_at, normals_of
from bodymeasure.fit.solving.step import AGREE

# Stiffness in each step, in multiples of what suits the scan's noise; each data row has weight 1.
STEPS = (5.0, 1.0, 1.0)
# How far a vertex of a body that the space does not have departs from the mean of its neighbors, in
# meters, and the limits of the stiffness that follows.
DEPARTURE = 1.7e-4
SOFTEST, STIFFEST = 0.3, 1000.0
# Without these, vertices slide along the skin, and landmarks with them.
TANGENTIAL, ANYWHERE = 0.1, 0.002
# Near a picked landmark the skin may slide by this part of that weight, within so many meters.
NEAR_PICK, SLIDING = 0.04, 0.1
# In multiples of the stiffness, which would keep a single vertex with its neighbors.
PICK_WEIGHT = 10.0
# A scan point's plane is the mean of so many, weighted by a Gaussian of so many meters.
AVERAGED, WIDTH = 12, 0.005
# Distances in meters that are taken for noise, and those beyond which nothing is matched.
SIGMA, REACH = 0.006, 0.02
# Rings of vertices around the part that the atlas covers.
RINGS = 3


class Planes(NamedTuple):
    """Planes of the scan: points and unit normals, both (n, 3), and weights, (n,)."""

    points: Array
    normals: Array
    weights: Array


def followed(
    vertices: Array, cloud: Cloud, grain: float, picks: Mapping[int, Array], report: Report
) -> Array:
    """Return the vertices moved so that the limit surface follows the scan.

    Parameters
    ----------
    vertices : ndarray, shape (13380, 3)
        Of the body of the space, in the scan's frame and pose.
    cloud : Cloud
    grain : float
        Variance of the noise of the scan's vertices times the area of one; see `grain_of`.
    picks : mapping of int to ndarray of shape (3,)
        Where the limit positions of some vertices should lie.
    report : Report

    Returns
    -------
    ndarray, shape (13380, 3)
    """
    free = near_covered(RINGS)
    surface = refined()
    rows = np.flatnonzero(np.diff(surface.matrix[:, free].indptr) > 0)
    matrix = surface.matrix[rows]
    moving = matrix[:, free].tocsr()
    roughness = umbrella()[:, free]
    stiff = kron(roughness.T @ roughness, identity(3), format="csc")
    area = _area(vertices) / len(surface.covered)
    suitable = float(np.clip(grain / area / DEPARTURE**2, SOFTEST, STIFFEST))
    held, pulled = _regularized(vertices, free, picks, PICK_WEIGHT * max(1.0, suitable))
    displacement = np.zeros((len(free), 3))
    for number, stiffness in enumerate(suitable * np.array(STEPS)):
        moved = vertices.copy()
        moved[free] += displacement
        points = matrix @ moved
        planes = _planes(points, normals_at(surface.matrix @ moved, surface.quads)[rows], cloud)
        gaps = np.einsum("nd,nd->n", planes.normals, points - planes.points)
        weights = planes.weights / (1.0 + (gaps / SIGMA) ** 2) ** 2
        # Linear in the displacement: the gap at none, from that at the present one.
        start = gaps - np.einsum("nd,nd->n", planes.normals, moving @ displacement)
        across = _by_planes(moving, planes.normals)
        weighted = across.T @ diags(weights)
        system = weighted @ across + stiffness * stiff + held
        right = -(weighted @ start) + pulled
        factors = splu(
            csc_matrix(system), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True}
        )
        displacement = factors.solve(right).reshape(-1, 3)
        report((number + 1) / len(STEPS))
    result = vertices.copy()
    result[free] += displacement
    return result


def _regularized(
    vertices: Array, free: Ints, picks: Mapping[int, Array], weight: float
) -> tuple[csc_matrix, Array]:
    """What holds the vertices in their places, and what pulls them to the picks."""
    normals = normals_of(limit_matrix() @ vertices)[free]
    tangential = np.full(len(free), TANGENTIAL)
    pulled = np.zeros((len(free), 3))
    attraction = csr_matrix((len(free), len(free)))
    if picks:
        wanted = np.stack(list(picks.values()))
        limits = limit_matrix()[np.array(list(picks))]
        near = cKDTree(vertices[list(picks)]).query(vertices[free])[0] < NEAR_PICK
        tangential[near] *= SLIDING
        chosen = limits[:, free]
        attraction = weight * (chosen.T @ chosen)
        pulled = weight * (chosen.T @ (wanted - limits @ vertices))
    across = np.eye(3) - normals[:, :, None] * normals[:, None, :]
    blocks = tangential[:, None, None] * across + ANYWHERE * np.eye(3)
    at = np.arange(len(free))
    held = csr_matrix((len(free) * 3, len(free) * 3))
    rows = np.broadcast_to(3 * at[:, None, None] + np.arange(3)[:, None], blocks.shape)
    columns = np.broadcast_to(3 * at[:, None, None] + np.arange(3), blocks.shape)
    held = csr_matrix((blocks.ravel(), (rows.ravel(), columns.ravel())), shape=held.shape)
    return (held + kron(attraction, identity(3))).tocsc(), pulled.ravel()


def _planes(points: Array, normals: Array, cloud: Cloud) -> Planes:
    """The planes of the scan that points of the body should lie on."""
    distance, near = cloud.tree.query(points, k=AVERAGED, distance_upper_bound=REACH + WIDTH)
    known = np.isfinite(distance)
    near = np.where(known, near, 0)
    agree = np.einsum("nkd,nd->nk", cloud.normals[near], normals) > AGREE
    weights = np.where(known & agree, np.exp(-0.5 * _squares(distance, known)), 0.0)
    total = weights.sum(axis=1)
    shares = weights / np.maximum(total, 1e-300)[:, None]
    normal = np.einsum("nk,nkd->nd", shares, cloud.normals[near])
    size = np.linalg.norm(normal, axis=1)
    normal /= np.maximum(size, 1e-12)[:, None]
    # On a curved surface, a neighbor lies as far below the plane at a point as the point lies below
    # the plane at the neighbor: the mean of both distances is that of the surface.
    steps, both = (
        points[:, None] - cloud.points[near],
        0.5 * (normal[:, None] + cloud.normals[near]),
    )
    heights = np.einsum("nk,nkd,nkd->n", shares, steps, both)
    center = points - heights[:, None] * normal
    first = np.where(known[:, 0], distance[:, 0], np.inf)
    used = (total > 0.0) & (first < REACH) & ~cloud.at_rim[near[:, 0]] & (size > AGREE)
    return Planes(center, normal, used.astype(float))


def _squares(distance: Array, known: Array) -> Array:
    """Squares of how much farther each point is than the first, in widths."""
    finite = np.where(known, distance, 0.0)
    return np.asarray((finite**2 - finite[:, :1] ** 2) / WIDTH**2)


def _by_planes(moving: csr_matrix, normals: Array) -> csr_matrix:
    """The matrix from displacements, (vertices x 3), to movements along the normals."""
    parts = [kron(diags(normals[:, axis]) @ moving, np.eye(3)[axis]) for axis in range(3)]
    return (parts[0] + parts[1] + parts[2]).tocsr()


def _area(vertices: Array) -> float:
    """The surface of a body, in square meters."""
    corners = vertices[body_model().quads]
    crossed = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    return float(0.5 * np.linalg.norm(crossed, axis=1).sum())
