"""Bodies in a pose, and back in the A-pose: linear blend skinning.

A vertex x in the A-pose goes to the mean, by the weights of its bones j, of
``R_j (x - rest_j) + place_j``, where R_j is the turn of the bone and its joint goes from rest_j to
place_j. The turn of a joint is that of its parent times its own.
"""

from typing import NamedTuple

import numpy as np
from scipy.sparse import csr_matrix
from scipy.spatial.transform import Rotation

from bodymeasure._typing import Array
from bodymeasure.fit.model.skeleton import skeleton
from bodymeasure.fit.model.space import shaped


class Bones(NamedTuple):
    """The bones of a body in a pose.

    Parameters
    ----------
    turns : ndarray, shape (31, 3, 3)
        Rotation of each bone out of the A-pose.
    places : ndarray, shape (31, 3)
        Joints in the pose.
    rest : ndarray, shape (31, 3)
        Joints in the A-pose.
    """

    turns: Array
    places: Array
    rest: Array


def bones_of(coefficients: Array, rotations: Array, shift: Array | None = None) -> Bones:
    """Return the bones of a body.

    Parameters
    ----------
    coefficients : ndarray, shape (k,)
    rotations : ndarray, shape (31, 3)
        Rotation vector of each joint in its parent's frame, radians.
    shift : ndarray, shape (3,), optional
        How far the pelvis is moved.
    """
    bones, rest = skeleton(), skeleton().joints_of(coefficients)
    turns, places = Rotation.from_rotvec(rotations).as_matrix(), rest.copy()
    places[0] += 0.0 if shift is None else shift
    for joint, parent in enumerate(bones.parents):
        if parent >= 0:
            places[joint] = places[parent] + turns[parent] @ (rest[joint] - rest[parent])
            turns[joint] = turns[parent] @ turns[joint]
    return Bones(turns, places, rest)


def skinned(points: Array, bones: Bones, weights: csr_matrix | None = None) -> Array:
    """Return points of a body in the A-pose as its bones carry them.

    Parameters
    ----------
    points : ndarray, shape (n, 3)
    bones : Bones
    weights : csr_matrix, shape (n, 31), optional
        Shares of the bones; those of the vertices if not given.
    """
    turns, shifts = _blended(bones, weights)
    return np.asarray(np.einsum("nij,nj->ni", turns, points) + shifts)


def unskinned(points: Array, bones: Bones, weights: csr_matrix | None = None) -> Array:
    """Return points of a posed body in the A-pose: the inverse of `skinned`."""
    turns, shifts = _blended(bones, weights)
    return np.asarray(np.linalg.solve(turns, (points - shifts)[..., None])[..., 0])


def posed(coefficients: Array, rotations: Array, shift: Array | None = None) -> Array:
    """Return the vertices of a body of the space in a pose.

    Parameters
    ----------
    coefficients : ndarray, shape (k,)
        In standard deviations.
    rotations : ndarray, shape (31, 3)
        Rotation vector of each joint in its parent's frame, radians.
    shift : ndarray, shape (3,), optional

    Returns
    -------
    ndarray, shape (13380, 3)
    """
    return skinned(shaped(coefficients), bones_of(coefficients, rotations, shift))


def unposed(
    vertices: Array, coefficients: Array, rotations: Array, shift: Array | None = None
) -> Array:
    """Return the vertices of a posed body in the A-pose.

    Parameters
    ----------
    vertices : ndarray, shape (13380, 3)
        They need not be in the space.
    coefficients, rotations, shift
        As of `posed`; the coefficients say where the joints are.
    """
    return unskinned(vertices, bones_of(coefficients, rotations, shift))


def _blended(bones: Bones, weights: csr_matrix | None) -> tuple[Array, Array]:
    """The linear part, (n, 3, 3), and the shift, (n, 3), of each point."""
    shares = skeleton().weights if weights is None else weights
    turned = np.einsum("jik,jk->ji", bones.turns, bones.rest)
    turns = shares @ bones.turns.reshape(-1, 9)
    return turns.reshape(-1, 3, 3), shares @ (bones.places - turned)
