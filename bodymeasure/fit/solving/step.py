"""One step of Gauss and Newton: a body's shape and pose moved towards a scan."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.fit.model import skeleton, turned
from bodymeasure.fit.solving.cloud import Cloud
from bodymeasure.fit.solving.state import State, Surface, surface_of

# How far joints turn out of the A-pose, standard deviations in radians; the pelvis is free.
SPREADS = {
    **dict.fromkeys(("LowerBack", "Spine", "Spine1"), 0.15),
    **dict.fromkeys(("Neck", "Neck1", "Head"), 0.2),
    **dict.fromkeys(("LeftShoulder", "RightShoulder"), 0.12),
    **dict.fromkeys(("LeftArm", "RightArm"), 0.6),
    **dict.fromkeys(("LeftForeArm", "RightForeArm"), 0.35),
    **dict.fromkeys(("LeftHand", "RightHand"), 0.25),
    **dict.fromkeys(("LeftUpLeg", "RightUpLeg"), 0.25),
    **dict.fromkeys(("LeftLeg", "RightLeg"), 0.2),
    **dict.fromkeys(("LeftFoot", "RightFoot"), 0.25),
}
FREE = ("Hips", *SPREADS)
# Cosine of the angle within which normals agree, 72 degrees.
AGREE = 0.31
# Turns of a joint in one step, in radians: beyond, the linear model of the pose is wrong.
LARGEST_TURN = 0.35
# The weight of the prior is meant for so many residuals.
RESIDUALS = 1700
# Matches farther than so many sigmas have no weight to speak of.
_FAR = 6.0


class Settings(NamedTuple):
    """What one step does.

    Parameters
    ----------
    sigma : float
        Distances in meters that are taken for noise.
    prior : float
        Weight of the shape's and the pose's plausibility.
    components : int
        How many components of the shape move.
    joints : tuple of str
        The joints that turn.
    """

    sigma: float
    prior: float
    components: int
    joints: tuple[str, ...] = FREE


@dataclass(frozen=True, eq=False)
class Matches:
    """Points of the body and the planes of the scan that they should lie on.

    Parameters
    ----------
    rows : ndarray of int, shape (n,)
        Vertices of the body.
    normals : ndarray, shape (n, 3)
    gaps : ndarray, shape (n,)
        Signed distance of the vertex from the plane.
    """

    rows: Ints
    normals: Array
    gaps: Array


def stepped(state: State, cloud: Cloud, settings: Settings, vertices: Ints, scanned: Ints) -> State:
    """Return a body after one step.

    Parameters
    ----------
    state : State
    cloud : Cloud
    settings : Settings
    vertices, scanned : ndarray of int
        Vertices of the body, and points of the scan, that are matched with the other side.
    """
    surface = surface_of(state)
    found = matches(surface, cloud, vertices, scanned, _FAR * settings.sigma)
    return _moved(state, surface, found, settings)


def matches(surface: Surface, cloud: Cloud, vertices: Ints, scanned: Ints, reach: float) -> Matches:
    """Match points of the body with the scan, and the other way round, where normals agree."""
    distance, nearest = cloud.tree.query(surface.points[vertices], distance_upper_bound=reach)
    kept = np.isfinite(distance)
    forth, there = vertices[kept], nearest[kept]
    kept = ~cloud.at_rim[there]
    forth, there = forth[kept], there[kept]
    distance, back = surface.tree().query(cloud.points[scanned], distance_upper_bound=reach)
    kept = np.isfinite(distance)
    rows = np.concatenate([forth, back[kept]])
    there = np.concatenate([there, scanned[kept]])
    normals = cloud.normals[there]
    agree = np.einsum("nd,nd->n", normals, surface.normals[rows]) > AGREE
    rows, normals, there = rows[agree], normals[agree], there[agree]
    gaps = np.einsum("nd,nd->n", normals, surface.points[rows] - cloud.points[there])
    return Matches(rows, normals, gaps)


def _moved(state: State, surface: Surface, found: Matches, settings: Settings) -> State:
    """Solve the normal equations of the weighted residuals and of the prior."""
    frame = skeleton()
    count = settings.components
    joints = np.array([frame.number(name) for name in settings.joints])
    by_shape, by_turn = surface.derivatives(found.rows, count, joints)
    jacobian = np.concatenate(
        [
            np.einsum("nd,ndk->nk", found.normals, by_shape),
            np.einsum("nd,ndjk->njk", found.normals, by_turn).reshape(len(found.rows), -1),
            found.normals,
        ],
        axis=1,
    )
    weights = 1.0 / (1.0 + (found.gaps / settings.sigma) ** 2) ** 2
    size = jacobian.shape[1]
    weighted = jacobian * weights[:, None]
    matrix, right = weighted.T @ jacobian, -(weighted.T @ found.gaps)
    prior = settings.prior * settings.sigma**2 * max(len(found.rows), 1) / RESIDUALS
    shape = np.arange(count)
    matrix[shape, shape] += prior
    right[:count] -= prior * state.coefficients[:count]
    for place, (name, joint) in enumerate(zip(settings.joints, joints, strict=True)):
        if name in SPREADS:
            weight = prior / SPREADS[name] ** 2
            at = count + 3 * place + np.arange(3)
            # The rotation vector changes by the turn, seen in the parent's frame.
            parent = surface.bones.turns[frame.parents[joint]]
            matrix[at, at] += weight
            right[at] -= weight * parent @ state.rotations[joint]
    # Where nothing was matched, nothing moves.
    matrix[np.arange(size), np.arange(size)] += 1e-9 * max(1.0, float(np.trace(matrix)) / size)
    solution = np.linalg.solve(matrix, right)
    turns = solution[count:-3].reshape(-1, 3)
    angles = np.linalg.norm(turns, axis=1, keepdims=True)
    turns *= np.minimum(1.0, LARGEST_TURN / np.maximum(angles, 1e-12))
    coefficients = state.coefficients.copy()
    coefficients[:count] += solution[:count]
    rotations = turned(state.rotations, surface.bones, joints, turns)
    return State(coefficients, rotations, state.shift + solution[-3:])
