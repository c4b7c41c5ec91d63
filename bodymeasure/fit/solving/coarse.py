"""Where a fit begins: which way the body stands and looks, how tall it is, where its arms are."""

from itertools import product

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from bodymeasure._typing import Array
from bodymeasure.fit.model import body_model, skeleton
from bodymeasure.fit.solving.cloud import Cloud
from bodymeasure.fit.solving.progress import Report
from bodymeasure.fit.solving.state import State, Surface, even_vertices, surface_of
from bodymeasure.fit.solving.step import AGREE, Settings, stepped

# Poses that are tried: turns about the vertical, arms raised by so many radians, and parts of the
# head and neck, in meters, that a scan cut off at the top may lack.
TURNS = 8
ARMS = (0.0, 0.7, -0.45)
LACKING = (0.0, 0.16)
# Where the second axis is so long against the first, the arms are spread, and it may be the height.
SPREAD_ARMS = 0.45
# The numbers of poses that are refined, and that are refined to the end.
REFINED, FINISHED = 12, 4
# Gauss-Newton steps before the rest is dropped.
FIRST = 4
# Distances that count as half a fault, in meters.
FAULT = 0.05
SCANNED, VERTICES = 1200, 750
# Gauss-Newton steps with the sigmas in meters from coarse to fine.
SIGMAS = np.geomspace(0.22, 0.04, 10)
JOINTS = ("Hips", "LeftArm", "RightArm", "LeftForeArm", "RightForeArm", "LeftUpLeg", "RightUpLeg")
COMPONENTS = 6
PRIOR = 1.5
# The shoulder's grid, radians, and the sigmas of the steps that refine it.
ABDUCTION = np.linspace(-0.9, 0.9, 7)
FLEXION = np.array([-0.4, 0.0, 0.4])
ARM_SIGMAS = (0.08, 0.06, 0.05, 0.04)
# An arm is put elsewhere if that lowers the fault by more than this part.
BETTER = 0.02


def coarse_start(
    cloud: Cloud, up: Array | None, front: Array | None, report: Report
) -> tuple[State, float]:
    """Return a body near a scan, and how badly it fits: 0.4 to 0.6 for a body, 1.4 for none.

    Parameters
    ----------
    cloud : Cloud
    up, front : ndarray, shape (3,), optional
        Unit vectors, where the user says them.
    report : Report
        Called with the part that is done.
    """
    rng = np.random.default_rng(2)
    scanned, vertices = cloud.some(SCANNED, rng), even_vertices(VERTICES)
    tried = []
    for direction in [up] if up is not None else _possible_up(cloud):
        tried += _standing(cloud, direction, front)
    scored = [(fault(surface_of(each), cloud), number) for number, each in enumerate(tried)]
    states = [tried[number] for _, number in sorted(scored)[:REFINED]]
    for part, (sigmas, kept) in enumerate(((SIGMAS[:FIRST], FINISHED), (SIGMAS[FIRST:], 1))):
        for sigma in sigmas:
            settings = Settings(float(sigma), PRIOR, COMPONENTS, JOINTS)
            states = [stepped(each, cloud, settings, vertices, scanned) for each in states]
        scored = [(fault(surface_of(each), cloud), number) for number, each in enumerate(states)]
        scored = sorted(scored)[:kept]
        states = [states[number] for _, number in scored]
        report((part + 1) / 3)
    score, state = scored[0][0], states[0]
    for side in ("Left", "Right"):
        score, state = _arm(state, score, cloud, side)
    return state, score


def fault(surface: Surface, cloud: Cloud) -> float:
    """Return how badly a body fits, from 0 to 2: the mean of squares that stop at a limit.

    Both ways are added, from the scan to the body and back. Where normals do not agree, points are
    as bad as far away.
    """
    rng = np.random.default_rng(3)
    scanned, vertices = cloud.some(SCANNED, rng), even_vertices(VERTICES)
    there, here = cloud.tree.query(surface.points[vertices])
    agree = np.einsum("nd,nd->n", cloud.normals[here], surface.normals[vertices]) > AGREE
    forth = np.where(agree, there**2 / (FAULT**2 + there**2), 1.0).mean()
    some = even_vertices(4 * VERTICES)
    there, here = cKDTree(surface.points[some]).query(cloud.points[scanned])
    agree = np.einsum("nd,nd->n", cloud.normals[scanned], surface.normals[some[here]]) > AGREE
    back = np.where(agree, there**2 / (FAULT**2 + there**2), 1.0).mean()
    return float(forth + back)


def _possible_up(cloud: Cloud) -> list[Array]:
    """Both senses of the longest axis, and of the second one where it is nearly as long."""
    centered = cloud.points - cloud.points.mean(axis=0)
    variances, axes = np.linalg.eigh(centered.T @ centered / len(centered))
    longest = [axes[:, 2], -axes[:, 2]]
    if variances[1] > SPREAD_ARMS * variances[2]:
        longest += [axes[:, 1], -axes[:, 1]]
    return longest


def _standing(cloud: Cloud, up: Array, front: Array | None) -> list[State]:
    """Bodies that stand where the scan does, in all poses that are tried."""
    # Turns the model's axes, z up and front = -y, into the scan's.
    ahead = front if front is not None else np.eye(3)[np.argmin(np.abs(up))]
    ahead = ahead - (ahead @ up) * up
    ahead /= np.linalg.norm(ahead)
    base = Rotation.from_matrix(np.stack([np.cross(up, ahead), -ahead, up], axis=1))
    heights = cloud.points @ up
    low, high = np.percentile(heights, [0.05, 99.95])
    middle = cloud.points.mean(axis=0)
    at_rest = surface_of(State(np.zeros(120), np.zeros((31, 3)), np.zeros(3)))
    taller = np.zeros(120)
    taller[0] = 1.0
    grown = surface_of(State(taller, np.zeros((31, 3)), np.zeros(3)))
    stature, gain = np.ptp(at_rest.points[:, 2]), np.ptp(grown.points[:, 2])
    result = []
    turns = [0.0] if front is not None else 2.0 * np.pi * np.arange(TURNS) / TURNS
    for turn, raised, lacking in product(turns, ARMS, LACKING):
        coefficients = np.zeros(120)
        coefficients[0] = np.clip((high - low + lacking - stature) / (gain - stature), -4.0, 4.0)
        rotations = np.zeros((31, 3))
        whole = base * Rotation.from_rotvec([0.0, 0.0, turn])
        rotations[0] = whole.as_rotvec()
        rotations[skeleton().number("LeftArm")] = [0.0, -raised, 0.0]
        rotations[skeleton().number("RightArm")] = [0.0, raised, 0.0]
        state = State(coefficients, rotations, np.zeros(3))
        points = surface_of(state).points
        shift = middle - body_model().vertex_weight @ points
        shift += (low - (points @ up).min() - shift @ up) * up
        result.append(State(coefficients, rotations, shift))
    return result


def _arm(state: State, score: float, cloud: Cloud, side: str) -> tuple[float, State]:
    """Look for an arm anew, all else held, and return the better fit."""
    joint = skeleton().number(f"{side}Arm")
    tried: list[tuple[float, int, State]] = []
    for abduction, flexion in product(ABDUCTION, FLEXION):
        rotations = state.rotations.copy()
        sign = -1.0 if side == "Left" else 1.0
        turn = Rotation.from_rotvec([0.0, sign * abduction, 0.0]) * Rotation.from_rotvec(
            [flexion, 0.0, 0.0]
        )
        rotations[joint] = (turn * Rotation.from_rotvec(rotations[joint])).as_rotvec()
        each = State(state.coefficients, rotations, state.shift)
        tried.append((fault(surface_of(each), cloud), len(tried), each))
    rng = np.random.default_rng(4)
    scanned, vertices = cloud.some(SCANNED, rng), even_vertices(VERTICES)
    best = (score, state)
    for _, _, begun in sorted(tried)[:2]:
        each = begun
        for sigma in ARM_SIGMAS:
            settings = Settings(sigma, PRIOR, COMPONENTS, JOINTS)
            each = stepped(each, cloud, settings, vertices, scanned)
        found = fault(surface_of(each), cloud)
        if found < best[0] - BETTER * score:
            best = (found, each)
    return best
