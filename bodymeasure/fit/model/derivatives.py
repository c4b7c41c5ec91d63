"""Derivatives of posed points by the coefficients of the shape and by turns of the joints."""

import numpy as np
from scipy.sparse import csr_matrix
from scipy.spatial.transform import Rotation

from bodymeasure._typing import Array, Ints
from bodymeasure.fit.model.posing import Bones
from bodymeasure.fit.model.skeleton import skeleton


def shape_derivatives(components: Array, bones: Bones, weights: csr_matrix) -> Array:
    """Return how points of a posed body move with the coefficients.

    Parameters
    ----------
    components : ndarray, shape (k, n, 3)
        How one standard deviation of the first k components moves the points in the A-pose.
    bones : Bones
    weights : csr_matrix, shape (n, 31)
        Shares of the bones in the points.

    Returns
    -------
    ndarray, shape (n, 3, k)
    """
    frame = skeleton()
    rest = frame.components[: len(components)]
    places = rest.copy()
    for joint, parent in enumerate(frame.parents):
        if parent >= 0:
            along = rest[:, joint] - rest[:, parent]
            places[:, joint] = places[:, parent] + along @ bones.turns[parent].T
    # What the joints' own movement adds to the turned components.
    added = places - np.einsum("jik,cjk->cji", bones.turns, rest)
    turns = (weights @ bones.turns.reshape(-1, 9)).reshape(-1, 3, 3)
    moved = np.matmul(turns, components.transpose(1, 2, 0))
    shifts = weights @ added.transpose(1, 2, 0).reshape(len(frame.parents), -1)
    return np.asarray(moved + shifts.reshape(moved.shape))


def pose_derivatives(points: Array, bones: Bones, weights: csr_matrix, joints: Ints) -> Array:
    """Return how points of a posed body move with small turns of the joints.

    Parameters
    ----------
    points : ndarray, shape (n, 3)
        In the A-pose.
    bones : Bones
    weights : csr_matrix, shape (n, 31)
    joints : ndarray of int, shape (m,)

    Returns
    -------
    ndarray, shape (n, 3, m, 3)
        The last axis is that of a small rotation vector w about the posed joint, in the world's
        axes: ``w x sum_d weight_d (x_d - place)``, over the bones d that the joint carries, with
        x_d the point as bone d carries it.
    """
    frame = skeleton()
    shares = weights.toarray()
    offsets = bones.places - np.einsum("jik,jk->ji", bones.turns, bones.rest)
    carried = points @ bones.turns.reshape(-1, 3).T + offsets.ravel()
    carried = shares[..., None] * carried.reshape(len(points), -1, 3)
    chains = frame.carries[joints].T.astype(float)
    arms = np.matmul(carried.transpose(0, 2, 1), chains).transpose(0, 2, 1)
    arms -= (shares @ chains)[..., None] * bones.places[joints]
    # The matrix of w x arm, by w.
    x, y, z = np.moveaxis(arms, -1, 0)
    zero = np.zeros_like(x)
    rows = [[zero, z, -y], [-z, zero, x], [y, -x, zero]]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=1)


def turned(rotations: Array, bones: Bones, joints: Ints, steps: Array) -> Array:
    """Return the rotation vectors of the joints after small turns in the world's axes.

    Parameters
    ----------
    rotations : ndarray, shape (31, 3)
    bones : Bones
        The bones with these rotations.
    joints : ndarray of int, shape (m,)
    steps : ndarray, shape (m, 3)
        Rotation vectors, about the posed joints.

    Returns
    -------
    ndarray, shape (31, 3)
    """
    parents = skeleton().parents[joints]
    # A joint's own turn follows its parent's, in the parent's frame.
    frames = np.where(parents[:, None, None] >= 0, bones.turns[parents], np.eye(3))
    local = np.einsum("mji,mj->mi", frames, steps)
    result = rotations.copy()
    own = Rotation.from_rotvec(local) * Rotation.from_rotvec(rotations[joints])
    result[joints] = own.as_rotvec()
    return result
