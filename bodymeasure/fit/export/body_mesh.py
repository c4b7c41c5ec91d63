"""The fitted quad mesh as other programs take it: texture coordinates, parts and skin weights."""

from functools import cache
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.fit.model import body_model, skeleton
from bodymeasure.fit.model.space import DATA

# The parts of the body that files group faces by, and their bones. Left and right are the wearer's.
PARTS = {
    "torso": (
        *("Hips", "LHipJoint", "RHipJoint", "LowerBack", "Spine", "Spine1"),
        *("LeftShoulder", "RightShoulder"),
    ),
    "neck": ("Neck", "Neck1"),
    "head": ("Head",),
    "left_upper_arm": ("LeftArm",),
    "left_forearm": ("LeftForeArm",),
    "left_hand": ("LeftHand", "LThumb", "LeftFingerBase", "LeftHandFinger1"),
    "right_upper_arm": ("RightArm",),
    "right_forearm": ("RightForeArm",),
    "right_hand": ("RightHand", "RThumb", "RightFingerBase", "RightHandFinger1"),
    "left_thigh": ("LeftUpLeg",),
    "left_shin": ("LeftLeg",),
    "left_foot": ("LeftFoot", "LeftToeBase"),
    "right_thigh": ("RightUpLeg",),
    "right_shin": ("RightLeg",),
    "right_foot": ("RightFoot", "RightToeBase"),
}


class BodyMesh(NamedTuple):
    """A body's quads, in meters, y up, front = +z, as glTF has it and most programs expect.

    Parameters
    ----------
    vertices : ndarray, shape (13380, 3)
    joints : ndarray, shape (31, 3)
        The places of the bones, in the same axes.
    name, described : str
        What the body is called, and a sentence on the mesh.
    """

    vertices: Array
    joints: Array
    name: str
    described: str


class Texture(NamedTuple):
    """The texture coordinates of MakeHuman's hm08, which its skins are painted for.

    Parameters
    ----------
    places : ndarray, shape (14517, 2)
        u to the right, v upwards, both within 0 and 1.
    quads : ndarray of int, shape (13378, 4)
        The place of each corner of each quad.
    """

    places: Array
    quads: Ints


@cache
def texture() -> Texture:
    """The texture coordinates, read once."""
    with np.load(DATA / "hm08.npz") as data:
        return Texture(data["texture"].astype(float), data["texture_quads"].astype(np.int64))


@cache
def quad_parts() -> Ints:
    """Return the number in `PARTS` of the part that each quad belongs to by its bones' shares."""
    names = skeleton().names
    of_bone = np.zeros((len(names), len(PARTS)))
    for number, bones in enumerate(PARTS.values()):
        of_bone[[names.index(bone) for bone in bones], number] = 1.0
    shares = skeleton().weights @ of_bone
    return np.asarray(shares[body_model().quads].sum(axis=1).argmax(axis=1))


def to_gltf(points: Array) -> Array:
    """Turn points from z up and front = -y to y up and front = +z."""
    return np.stack([points[..., 0], points[..., 2], -points[..., 1]], axis=-1)
