"""The frame of the atlas in that of the scan: upright, facing the front, on the floor."""

from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from bodymeasure._typing import Array
from bodymeasure.atlas.axes import DIRECTIONS, unit_vector
from bodymeasure.fit.model import limit_matrix, skeleton
from bodymeasure.fit.solving.state import State

# A scan's vertical is an axis of its file if the body leans less than this from it, in radians.
LEAN = np.radians(15.0)
# Where the body's lowest point is farther below the scan's than this, in meters, feet are missing.
FEET = 0.02
NO_FEET = (
    "The scan does not reach the floor: where the soles are is a guess, and with it every height; "
    "scan the feet, too."
)


class Frame(NamedTuple):
    """The atlas's frame in that of the scan.

    Parameters
    ----------
    turn : ndarray, shape (3, 3)
    shift : ndarray, shape (3,)
        After the rotation.
    warnings : tuple of str
    """

    turn: Array
    shift: Array
    warnings: tuple[str, ...]


def upright(state: State, given: Array | None) -> tuple[Array, str]:
    """Return which way is up in the scan's frame, and a sentence that says so.

    Parameters
    ----------
    state : State
    given : ndarray, shape (3,), optional
        What the user says.
    """
    if given is not None:
        return given, ""
    bones = state.bones
    feet = [skeleton().number(name) for name in ("LeftFoot", "RightFoot")]
    along = bones.places[skeleton().number("Head")] - bones.places[feet].mean(axis=0)
    along /= np.linalg.norm(along)
    axes = {name: unit_vector(name) for name in DIRECTIONS}
    nearest = max(axes, key=lambda name: float(axes[name] @ along))
    if float(axes[nearest] @ along) > np.cos(LEAN):
        return axes[nearest], f"Found that {nearest} is up."
    return along, "No axis of the file is upright: up is from the feet to the head."


def frame_of(state: State, vertices: Array, up: Array, lowest: float) -> Frame:
    """Return the rotation and the shift from the scan's frame to the atlas's.

    Parameters
    ----------
    state : State
    vertices : ndarray, shape (13380, 3)
    up : ndarray, shape (3,)
    lowest : float
        Height of the scan's lowest point along `up`.
    """
    ahead = -state.bones.turns[0][:, 1]
    ahead = ahead - (ahead @ up) * up
    ahead /= np.linalg.norm(ahead)
    turn = np.stack([np.cross(-ahead, up), -ahead, up])
    body = float((limit_matrix() @ vertices @ up).min())
    has_feet = body > lowest - FEET
    floor = lowest if has_feet else body
    pelvis = turn @ state.bones.places[0]
    home = skeleton().mean[0]
    shift = np.array([home[0] - pelvis[0], home[1] - pelvis[1], -floor])
    return Frame(turn, shift, () if has_feet else (NO_FEET,))


def moved(state: State, turn: Array, shift: Array) -> State:
    """Return a body after a rotation and a shift."""
    rest = state.bones.rest[0]
    rotations = state.rotations.copy()
    whole = Rotation.from_matrix(turn) * Rotation.from_rotvec(state.rotations[0])
    rotations[0] = whole.as_rotvec()
    return State(state.coefficients, rotations, turn @ (rest + state.shift) + shift - rest)
