"""Scans with known truth, made of random bodies that are not quite of the space of bodies.

The body is skinned with other weights than the model's, in a random pose, and its skin is moved by
smooth random bumps that no component has; its limit surface is cut into triangles, decimated, given
noise, turned and moved.
"""

from typing import NamedTuple

import numpy as np
import pyvista as pv
from scipy.sparse import identity

from bodymeasure._typing import Array, Ints
from bodymeasure.fit.model import body_model, bones_of, shaped, skeleton, skinned
from bodymeasure.fit.solving.refined import umbrella
from bodymeasure.fit.solving.state import normals_of
from bodymeasure.subdivision import QuadMesh, limit_positions, subdivide, triangles

SEED = 1913
# Standard deviations of the coefficients, below which few random bodies are folded.
SPREAD = 0.8
# Standard deviations of the joints' turns, in radians.
TURNS = {
    **dict.fromkeys(("LowerBack", "Spine1", "Neck", "Head"), 0.06),
    **dict.fromkeys(("LeftArm", "RightArm"), 0.2),
    **dict.fromkeys(("LeftForeArm", "RightForeArm", "LeftHand", "RightHand"), 0.12),
    **dict.fromkeys(("LeftUpLeg", "RightUpLeg", "LeftLeg", "RightLeg"), 0.06),
}
# RMS of the bumps, and the rounds that smooth them; in meters.
BUMPS, ROUNDS = 1e-3, 60
# Rounds that spread the weights of the skin.
SPREADING = 4


class SyntheticScan(NamedTuple):
    """A scan and its truth.

    Parameters
    ----------
    vertices, triangles : ndarray
        In meters, turned about the vertical and moved.
    truth : ndarray, shape (13380, 3)
        Control vertices of the true body in the same frame.
    """

    vertices: Array
    triangles: Ints
    truth: Array


def synthetic_scan(number: int, *, count: int = 25_000, noise: float = 1e-3) -> SyntheticScan:
    """The scan of a number, of about so many triangles."""
    rng = np.random.default_rng([SEED, number])
    coefficients = SPREAD * rng.standard_normal(120)
    rotations = np.zeros((31, 3))
    for name, spread in TURNS.items():
        rotations[skeleton().number(name)] = spread * rng.standard_normal(3)
    rotations[0, 2] = rng.uniform(0.0, 2.0 * np.pi)
    mean = identity(len(body_model().mean)) - 0.5 * umbrella()
    weights = skeleton().weights
    for _ in range(SPREADING):
        weights = (mean @ weights).tocsr()
    bumps = rng.standard_normal(len(body_model().mean))
    for _ in range(ROUNDS):
        bumps = mean @ bumps
    bumps *= BUMPS / np.sqrt(np.mean(bumps**2))
    at_rest = shaped(coefficients)
    at_rest = at_rest + bumps[:, None] * normals_of(at_rest)
    shift = rng.uniform(-1.0, 1.0, 3)
    truth = skinned(at_rest, bones_of(coefficients, rotations, shift), weights)
    mesh = subdivide(QuadMesh(truth, body_model().quads))
    corners = triangles(mesh.quads)
    surface = pv.make_tri_mesh(limit_positions(mesh), corners.astype(int))
    coarse = surface.decimate(1.0 - count / len(corners))
    faces = np.asarray(coarse.regular_faces, dtype=np.int64)
    places = np.asarray(coarse.points, dtype=float)
    normals = np.asarray(coarse.compute_normals(split_vertices=False).point_data["Normals"])
    return SyntheticScan(
        places + noise * rng.standard_normal((len(places), 1)) * normals, faces, truth
    )
