"""Where a mapped body stands: upright, facing the front, on the floor, whatever its file's axes."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.axes import DIRECTIONS, unit_vector
from bodymeasure.errors import FitError
from bodymeasure.fit.model import body_model, skeleton
from bodymeasure.fit.topology.posture import rigid

# The trunk hardly bends in a standing pose, so that it says which way the body stands.
TRUNK = ("Hips", "LHipJoint", "RHipJoint", "LowerBack", "Spine", "Spine1")
PELVIS = ("Hips", "LHipJoint", "RHipJoint")
# Bodies from infants to giants, in meters; a wrong unit is at least 2.5 times off.
HEIGHTS = (0.4, 2.6)
# A trunk whose squares are so many times those of its mirror image is mirrored: posed bodies of the
# space have 0.02 to 0.07 of them.
MIRRORED = 1.0


class Placed(NamedTuple):
    """How a body's coordinates become those of its atlas: ``turn @ x + shift``, in meters.

    Parameters
    ----------
    turn : ndarray, shape (3, 3)
    shift : ndarray, shape (3,)
    up : str
        The axis of the file that is up.
    lean : float
        Angle in degrees between that axis and the trunk's own.
    """

    turn: Array
    shift: Array
    up: str
    lean: float


def placed(vertices: Array, surface: Array, up: str | None, source: str) -> Placed:
    """Return how a body is to be turned and moved.

    Parameters
    ----------
    vertices : ndarray, shape (13380, 3)
        Control vertices in meters, along the axes of the file.
    surface : ndarray, shape (n, 3)
        The points of which the lowest is to be at z = 0.
    up : str or None
        The axis that is up, or None to take the one that suits the trunk.
    source : str
        Names the file in errors.

    Raises
    ------
    FitError
        If the body has not the size of one, or left and right are exchanged.
    """
    model = body_model()
    extent = float(np.linalg.norm(np.ptp(surface, axis=0), ord=np.inf))
    if not HEIGHTS[0] < extent < HEIGHTS[1]:
        raise FitError(
            f"{source}: the body is {extent:.3g} m long; expected {HEIGHTS[0]} to {HEIGHTS[1]} m; "
            "give the unit of the file's coordinates"
        )
    trunk, pelvis = _share(TRUNK), _share(PELVIS)
    _require_sides(vertices, trunk, source)
    turn = rigid(vertices, model.mean, trunk)[0]
    upwards = turn[2]
    found = up or max(DIRECTIONS, key=lambda each: float(unit_vector(each) @ upwards))
    axis = unit_vector(found)
    lean = float(np.degrees(np.arccos(np.clip(axis @ upwards, -1.0, 1.0))))
    if lean > 60.0:
        raise FitError(
            f"{source}: the trunk points {lean:.0f} degrees away from {found}, which is said to be "
            "up; give the axis that is up, or none to have it found"
        )
    # The front is that of the pelvis, turned level.
    to_front = rigid(vertices, model.mean, pelvis)[0][1]
    back = to_front - (to_front @ axis) * axis
    back /= np.linalg.norm(back)
    turn = np.stack([np.cross(back, axis), back, axis])
    hips = turn @ (pelvis @ vertices / pelvis.sum())
    shift = np.array([-hips[0], -hips[1], -float((surface @ turn[2]).min())])
    return Placed(turn, shift, found, lean)


def _share(bones: tuple[str, ...]) -> Array:
    """Weight of each vertex, by its area and its share in some bones."""
    numbers = [skeleton().number(name) for name in bones]
    share = np.asarray(skeleton().weights[:, numbers].sum(axis=1)).ravel()
    return share * body_model().vertex_weight


def _require_sides(vertices: Array, trunk: Array, source: str) -> None:
    """Refuse a body whose left is right."""
    mean = body_model().mean
    rests = []
    for sign in (1.0, -1.0):
        body = vertices * np.array([sign, 1.0, 1.0])
        turn, shift = rigid(body, mean, trunk)
        rests.append(float(trunk @ ((body @ turn.T + shift - mean) ** 2).sum(axis=1)))
    if rests[0] > MIRRORED * rests[1]:
        raise FitError(
            f"{source}: left and right are exchanged: the mesh is mirrored; export it without "
            "mirroring, as happens with axes of the wrong hand"
        )
