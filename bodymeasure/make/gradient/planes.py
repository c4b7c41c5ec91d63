"""What moves the plane of a tape: the landmarks that it is laid through."""

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.chart.body import Body
from bodymeasure.make.gradient.pull import Pull
from bodymeasure.make.gradient.sections import InPlane


def pull_level(pull: Pull, found: InPlane, normal: Array, at: str) -> None:
    """Add the derivatives with respect to a landmark with which a plane is shifted."""
    pull.at(at, float(found.rate.sum()) * normal)


def pull_turned(pull: Pull, found: InPlane, ends: tuple[str, str], body: Body, foot: Array) -> None:
    """Add what turns a plane that is square to the line between two landmarks, about a foot."""
    line = body.position(ends[1]) - body.position(ends[0])
    turn = found.rate @ (found.positions - foot) / float(np.linalg.norm(line))
    pull.at(ends[0], turn)
    pull.at(ends[1], -turn)


def pull_tilted(
    pull: Pull, found: InPlane, through: tuple[str, str], body: Body, level: Array
) -> None:
    """Add the derivatives with respect to two landmarks of a plane that is level in a direction."""
    first, second = (body.position(name) for name in through)
    line = first - second
    normal = np.cross(level, line)
    normal /= np.linalg.norm(normal)
    # Either landmark turns the plane about the level line through the other.
    across = line - (line @ level) * level
    share = (found.positions - second) @ across / (across @ across)
    for name, weights in zip(through, (share, 1.0 - share), strict=True):
        pull.at(name, float(found.rate @ weights) * normal)
