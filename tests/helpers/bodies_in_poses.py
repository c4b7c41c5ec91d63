"""Bodies of the space in poses near the A-pose, the same on every machine."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.fit.model import posed, skeleton

# Radians: one standard deviation of each angle of some joints.
TURNS = {
    "LeftArm": 0.35,
    "RightArm": 0.35,
    "LeftForeArm": 0.2,
    "RightForeArm": 0.2,
    "LeftUpLeg": 0.12,
    "RightUpLeg": 0.12,
    "Spine": 0.08,
    "Head": 0.1,
}


def body_in_pose(number: int) -> tuple[Array, Array, Array]:
    """Vertices, coefficients and rotations of the random body of a number."""
    rng = np.random.default_rng([13, number])
    coefficients = 0.9 * rng.standard_normal(120)
    rotations = np.zeros((len(skeleton().names), 3))
    for name, spread in TURNS.items():
        rotations[skeleton().number(name)] = spread * rng.standard_normal(3)
    return posed(coefficients, rotations), coefficients, rotations
