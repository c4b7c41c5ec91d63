"""The pose and the shape of a body whose vertices are known: joint angles and coefficients."""

from functools import cache
from typing import NamedTuple

import numpy as np
from scipy.sparse import csr_matrix
from scipy.spatial.transform import Rotation

from bodymeasure._typing import Array, Ints
from bodymeasure.fit.model import (
    body_model,
    bones_of,
    coefficients_of,
    pose_derivatives,
    shape_derivatives,
    skeleton,
    skinned,
    turned,
    unposed,
)
from bodymeasure.fit.solving.step import FREE, SPREADS

# The pelvis turns as it likes, in radians.
ANY_TURN = 3.0
# Every so many vertices carry the fit: some 360, on all bones.
EVERY = 37
# Bodies leave the space by some millimeters, and skins differ at joints.
RESIDUAL = 0.002
ROUNDS = 8
# Joints that turn by less in a round have settled.
SETTLED = 1e-3


class Posture(NamedTuple):
    """A body's shape and pose.

    Parameters
    ----------
    coefficients : ndarray, shape (120,)
        In standard deviations.
    rotations : ndarray, shape (31, 3)
        Rotation vectors of the joints.
    shift : ndarray, shape (3,)
        How far the pelvis is moved, meters.
    residual : float
        RMS distance of the body's vertices from those of the body in the space, meters.
    """

    coefficients: Array
    rotations: Array
    shift: Array
    residual: float

    def a_pose(self, vertices: Array) -> Array:
        """Return the body's vertices with the pose undone."""
        return unposed(vertices, self.coefficients, self.rotations, self.shift)


def posture_of(vertices: Array) -> Posture:
    """Return the pose and the shape of a body, by Gauss and Newton's method.

    Parameters
    ----------
    vertices : ndarray, shape (13380, 3)
        Control vertices in meters, z up, front = -y, in a pose near the A-pose.
    """
    part, joints, spread = _part()
    target = vertices[part.numbers]
    rotations, coefficients = np.zeros((len(skeleton().names), 3)), np.zeros(len(part.components))
    turn, shift = rigid(body_model().mean, vertices, body_model().vertex_weight)
    rotations[0] = Rotation.from_matrix(turn).as_rotvec()
    # The pelvis turns about its joint.
    joint = skeleton().mean[0]
    shift = shift + turn @ joint - joint
    prior = np.concatenate([np.ones(len(coefficients)), np.repeat(spread**-2.0, 3), np.zeros(3)])
    for _ in range(ROUNDS):
        rest = part.mean + np.tensordot(coefficients, part.components, 1)
        bones = bones_of(coefficients, rotations, shift)
        missing = (target - skinned(rest, bones, part.weights)).reshape(-1)
        by_shape = shape_derivatives(part.components, bones, part.weights)
        by_pose = pose_derivatives(rest, bones, part.weights, joints)
        by_shift = np.broadcast_to(np.eye(3), (len(target), 3, 3))
        rows = [each.reshape(len(missing), -1) for each in (by_shape, by_pose, by_shift)]
        matrix = np.concatenate(rows, axis=1) / RESIDUAL
        held = np.concatenate([coefficients, rotations[joints].reshape(-1), np.zeros(3)])
        # Turns are small rotations after the joint's own, whose prior is that of the sum.
        step = np.linalg.solve(
            matrix.T @ matrix + np.diag(prior), matrix.T @ (missing / RESIDUAL) - prior * held
        )
        shape, turns, moved = np.split(step, [len(coefficients), len(step) - 3])
        rotations = turned(rotations, bones, joints, turns.reshape(-1, 3))
        coefficients, shift = coefficients + shape, shift + moved
        if np.abs(turns).max() < SETTLED:
            break
    apart = unposed(vertices, coefficients, rotations, shift)
    coefficients = coefficients_of(apart)
    model = body_model()
    left = apart - model.mean - np.tensordot(coefficients, model.components, 1)
    residual = float(
        np.sqrt(model.vertex_weight @ (left**2).sum(axis=1) / model.vertex_weight.sum())
    )
    return Posture(coefficients, rotations, shift, residual)


def rigid(first: Array, second: Array, weights: Array) -> tuple[Array, Array]:
    """Return the rotation (3, 3) and the shift (3,) that take points closest to others."""
    share = weights / weights.sum()
    from_middle, to_middle = share @ first, share @ second
    product = (second - to_middle).T @ (share[:, None] * (first - from_middle))
    left, _, right = np.linalg.svd(product)
    signs = np.array([1.0, 1.0, np.sign(np.linalg.det(left @ right))])
    turn = left @ (signs[:, None] * right)
    return turn, to_middle - turn @ from_middle


class _Part(NamedTuple):
    numbers: Ints
    mean: Array
    components: Array
    weights: csr_matrix


@cache
def _part() -> tuple[_Part, Ints, Array]:
    model, bones = body_model(), skeleton()
    numbers = np.arange(0, len(model.mean), EVERY)
    joints = np.array([bones.number(name) for name in FREE])
    part = _Part(
        numbers,
        model.mean[numbers],
        np.ascontiguousarray(model.components[:, numbers]),
        bones.weights[numbers],
    )
    return part, joints, np.array([ANY_TURN, *SPREADS.values()])
